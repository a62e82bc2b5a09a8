#include "tests/contract/loaded.hpp"

#include <algorithm>
#include <array>
#include <boost/dll/shared_library.hpp>
#include <filesystem>
#include <map>
#include <sstream>

namespace riffle::contract {
namespace {

// What a RIFFLE_FUNCTION parameter is by default: its fallback everywhere.
void constant(const void* context, std::int64_t n, const double*, const double*, const double*, double,
              double* out) noexcept {
  std::fill(out, out + n, *static_cast<const double*>(context));
}

std::vector<std::string> words_of(const char* choices) {
  std::vector<std::string> words;
  std::istringstream text(choices);
  for (std::string word; std::getline(text, word, '|');) words.push_back(word);
  return words;
}
double index_of(const char* choices, const std::string& word) {
  const auto words = words_of(choices);
  return static_cast<double>(std::find(words.begin(), words.end(), word) - words.begin());
}
std::string word_at(const char* choices, double index) {
  return words_of(choices).at(static_cast<std::size_t>(index));
}

std::vector<Loaded> load() {
  static std::vector<boost::dll::shared_library> libraries;  // open until the program ends
  std::vector<Loaded> found;
  std::istringstream paths(RIFFLE_PLUGINS);
  for (std::string path; std::getline(paths, path, '|');) {
    libraries.emplace_back(path, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
    const auto& entry = libraries.back().get<const riffle_library>("riffle_plugin_entry");
    for (const riffle_plugin* plugin : entries(entry.plugins)) {
      found.push_back({plugin, std::filesystem::path(path).stem().string()});
    }
  }
  return found;
}

// What parameters inherit from a manifest: those of a tank of water, one metre long.
const std::map<std::string, double>& usual_quantities() {
  static const std::map<std::string, double> quantities{{"fluid.gravity", 9.81},   {"fluid.density", 1000},
                                                        {"fluid.viscosity", 1e-6}, {"domain.smoothing_ratio", 1.3},
                                                        {"domain.x_min", 0},       {"domain.x_max", 1}};
  return quantities;
}

}  // namespace

const riffle_services& flat_metre(int dim) {
  const auto scene_of = [](int dimensions) {
    riffle_services s{};
    s.size = sizeof s;
    s.dim = dimensions;
    std::fill_n(s.high, 3, 1.0);
    s.bed = [](const void*, std::int64_t n, const double*, const double*, double* level, double* slope_x,
               double* slope_y) noexcept {
      for (double* out : {level, slope_x, slope_y}) {
        if (out != nullptr) std::fill_n(out, n, 0.0);
      }
    };
    s.width = [](const void*, std::int64_t n, const double*, double* width, double* slope) noexcept {
      std::fill_n(width, n, 1.0);
      if (slope != nullptr) std::fill_n(slope, n, 0.0);
    };
    return s;
  };
  static const std::array<riffle_services, 3> scenes{scene_of(1), scene_of(2), scene_of(3)};
  return scenes.at(static_cast<std::size_t>(dim - 1));
}

const std::vector<Loaded>& all_plugins() {
  static const std::vector<Loaded> plugins = load();
  return plugins;
}

std::vector<Loaded> plugins_of(const std::string& kind) {
  std::vector<Loaded> found;
  for (const Loaded& loaded : all_plugins()) {
    if (loaded.plugin->kind == kind) found.push_back(loaded);
  }
  return found;
}

const riffle_plugin& plugin(const std::string& kind, const std::string& id) {
  for (const Loaded& loaded : plugins_of(kind)) {
    if (loaded.plugin->id == id) return *loaded.plugin;
  }
  throw std::out_of_range("no " + kind + " \"" + id + "\" is built");
}

std::string test_name(const Loaded& loaded) {
  std::string name = std::string(loaded.plugin->kind) + "_" + loaded.plugin->id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Instance::Instance(const riffle_plugin& plugin, int dim, const std::map<std::string, double>& given,
                   const riffle_services* scene)
    : plugin_(plugin) {
  const auto parameters = entries(plugin.parameters);
  functions_.resize(parameters.size());
  numbers_.resize(parameters.size());
  std::vector<std::string> words(parameters.size());
  std::vector<riffle_value> values;
  std::size_t used = 0;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const riffle_parameter& p = *parameters[k];
    double number = p.type == RIFFLE_CHOICE ? index_of(p.choices, p.fallback_text) : p.fallback;
    if (p.inherit != nullptr && usual_quantities().count(p.inherit) != 0) number = usual_quantities().at(p.inherit);
    if ((p.flags & RIFFLE_REQUIRED) != 0 && (p.flags & RIFFLE_ABOVE_MIN) != 0)
      number = std::min(p.min + 1, p.min / 2 + p.max / 2);
    const auto found = given.find(p.name);
    if (found != given.end()) {
      ++used;
      number = found->second;
    }
    numbers_[k] = number;
    functions_[k] = {sizeof(riffle_function), 0, &numbers_[k], &constant};
    if (p.type == RIFFLE_CHOICE) words[k] = word_at(p.choices, number);
    const char* text = p.type == RIFFLE_CHOICE ? words[k].c_str() : p.fallback_text;
    values.push_back({sizeof(riffle_value), found != given.end() ? 1u : 0u, number, text,
                      p.type == RIFFLE_FUNCTION ? &functions_[k] : nullptr});
  }
  if (used != given.size()) throw std::out_of_range(std::string(plugin.id) + " lacks a parameter that the test gives");
  std::vector<const riffle_value*> pointers;
  for (const riffle_value& value : values) pointers.push_back(&value);
  pointers.push_back(nullptr);
  riffle_error error{sizeof(riffle_error), {}};
  self_ = plugin.create(dim, pointers.data(), &error);
  if (self_ == nullptr) throw Refused(error.message);
  if (scene == nullptr || plugin.connect == nullptr || plugin.connect(self_, scene, &error) == RIFFLE_OK) return;
  plugin.destroy(self_);  // a constructor that throws has no destructor
  throw Refused(error.message);
}

Instance::~Instance() {
  plugin_.destroy(self_);
}

}  // namespace riffle::contract
