#include "host/study/advise/column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace riffle {

const PluginChoice* chosen(const Case& scene, const std::string& kind) {
  for (const PluginChoice& choice : scene.plugins) {
    if (choice.kind == kind && choice.id != "none") return &choice;
  }
  return nullptr;
}

bool has_closures_of(const ModelNotes& model, const Case& scene) {
  for (const char* kind : {"drag", "turbulence"}) {
    const PluginChoice* const choice = chosen(scene, kind);
    const auto of_kind = [&](const std::string& name) { return name.rfind(kind, 0) == 0; };
    if (choice == nullptr && std::string(kind) == "turbulence" &&
        std::any_of(model.contains.begin(), model.contains.end(), of_kind))
      return false;  // a column with eddies is no model of water without
    if (choice == nullptr) continue;
    const std::string name = std::string(kind) + ' ' + choice->id;
    if (std::find(model.contains.begin(), model.contains.end(), name) == model.contains.end()) return false;
  }
  return true;
}

std::string column_value(const ModelNotes& model, const ParameterDescription& wanted, const Case& scene,
                         const PlaneScales& scales) {
  std::string source = "." + wanted.name;
  for (const auto& [name, from] : model.from) {
    if (name != wanted.name) continue;
    const std::map<std::string, double> measured{{"depth of the water", scales.depth},
                                                 {"bottom of the water", scales.bottom},
                                                 {"level of the water", scales.bottom + scales.depth},
                                                 {"smallest porosity", scales.smallest_porosity},
                                                 {"driving over gravity", scales.driving / scene.gravity}};
    if (const auto one = measured.find(from); one != measured.end()) return fmt::format("{:.12g}", one->second);
    source = from;
  }
  const std::size_t dot = source.find('.');
  for (const PluginChoice& choice : scene.plugins) {
    if (dot > 0 && choice.kind != source.substr(0, dot)) continue;
    if (dot == 0 && choice.kind != "drag" && choice.kind != "turbulence") continue;
    for (std::size_t p = 0; p < choice.values.size(); ++p) {
      const ParameterValue& value = choice.values[p];
      if (value.name != source.substr(dot + 1)) continue;
      const ParameterType type = choice.description->parameters[p].type;
      if (type == ParameterType::choice && wanted.type == ParameterType::choice) {
        const auto& words = wanted.choices;
        return std::find(words.begin(), words.end(), value.text) != words.end() ? value.text : "";
      }
      if (wanted.type != ParameterType::real) continue;
      if (value.function != nullptr) return fmt::format("{:.12g}", (*value.function)(scene.lower[0]));
      return fmt::format("{:.12g}", value.number);
    }
  }
  return "";
}

}  // namespace riffle
