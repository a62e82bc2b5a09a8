#include "host/plugins/contracts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/plugins/call.hpp"
#include "host/plugins/descriptor_checks.hpp"
#include "host/plugins/dictionary.hpp"
#include "host/plugins/synthetic_block.hpp"

namespace riffle {
namespace {

constexpr std::int64_t items = 64;  // pairs or particles per made-up block

class PassCheck {
 public:
  PassCheck(const PluginInstance& instance, const riffle_pass& pass, std::vector<std::string>& problems)
      : instance_(instance), pass_(pass), problems_(problems) {}

  void run() {
    const std::size_t before = problems_.size();
    SyntheticScene scene;
    scene.dim = instance_.dim();
    scene.with_self = (pass_.flags & RIFFLE_WITH_SELF) != 0;
    check_scene(scene, "");
    scene.at_rest = true;
    if (problems_.size() == before) check_scene(scene, " of water at rest");
  }

 private:
  void fail(const std::string& what) {
    problems_.push_back(fmt::format("{}: pass \"{}\": {}", instance_.name(), pass_.name, what));
  }

  bool call(const SyntheticBlock& block) {
    riffle_error error = no_error();
    const std::int32_t status = run_pass(pass_, instance_.self(), block.block(), error);
    if (status == RIFFLE_OK) return true;
    fail("fails on made-up numbers: " + message_of(error));
    return false;
  }

  void check_scene(const SyntheticScene& scene, const std::string& of_what) {
    const SyntheticBlock block(scene, pass_, first_items(items));
    if (!call(block) || !check_outputs(block, of_what)) return;
    for (int k = 0; k < block.outputs(); ++k) {
      const std::string field = pass_.writes[k]->field->name;
      if (field == "viscous_pressure") check_viscosity(scene, block, k, of_what);
    }
  }

  // Written, finite, within the array, and where the field is declared so, not negative.
  bool check_outputs(const SyntheticBlock& block, const std::string& of_what) {
    if (const int k = block.overrun_output(); k >= 0) {
      fail(fmt::format("writes past the end of \"{}\"", pass_.writes[k]->field->name));
      return false;
    }
    for (int k = 0; k < block.outputs(); ++k) {
      const riffle_field& field = *pass_.writes[k]->field;
      const FieldDescription* known = dictionary_field(field.name);
      const bool not_negative = (field.flags & RIFFLE_NOT_NEGATIVE) != 0 || (known != nullptr && known->not_negative);
      for (int c = 0; c < block.components(k); ++c) {
        for (std::int64_t p = 0; p < block.size(); ++p) {
          const double value = block.out(k, c)[p];
          // A least or largest over neighbours may say "none" for a pair.
          const bool allowed = std::isfinite(value) || (std::isinf(value) && pass_.writes[k]->how >= RIFFLE_MIN);
          if (!allowed) {
            fail(fmt::format("\"{}\"{} is {}", field.name, of_what,
                             std::isnan(value) ? "no number, or not written" : "infinite"));
            return false;
          }
          if (value < 0 && not_negative) {
            fail(fmt::format("\"{}\"{} is {:.6g}; it must not be negative", field.name, of_what, value));
            return false;
          }
        }
      }
    }
    return true;
  }

  void check_viscosity(SyntheticScene scene, const SyntheticBlock& block, int output, const std::string& of_what) {
    static const riffle_field approach{
        sizeof(riffle_field), RIFFLE_SCALAR, RIFFLE_PER_PAIR, 0, "approach", "m2.s-1", ""};
    scene.swapped = true;
    const SyntheticBlock mirrored(scene, pass_, first_items(items));
    if (!call(mirrored)) return;
    double largest = 0;
    for (std::int64_t p = 0; p < items; ++p) largest = std::max(largest, std::abs(block.out(output)[p]));
    for (std::int64_t p = 0; p < items; ++p) {
      const double ij = block.out(output)[p], ji = mirrored.out(output)[p];
      const double closing = scene.value(approach, RIFFLE_PAIR, 0, p);
      // Round-off of sums taken in another order; a wrong formula is off by far more.
      if (std::abs(ij - ji) > 1e-12 * largest) {
        fail(
            fmt::format("viscous_pressure{} is {:.6g} for (i, j) but {:.6g} for (j, i), so momentum would not be "
                        "conserved",
                        of_what, ij, ji));
        return;
      }
      if (ij * closing > 0) {
        fail(fmt::format("viscous_pressure{} is {:.6g} for a pair that is {}, which feeds kinetic energy", of_what, ij,
                         closing < 0 ? "approaching" : "receding"));
        return;
      }
    }
  }

  const PluginInstance& instance_;
  const riffle_pass& pass_;
  std::vector<std::string>& problems_;
};

}  // namespace

bool is_active(const PluginInstance& instance, const char* when) {
  if (when == nullptr) return true;
  const std::string_view text = when;
  const std::size_t equals = text.find('=');
  for (const ParameterValue& value : instance.values()) {
    if (value.name != text.substr(0, equals)) continue;
    const auto wanted = split_words(text.substr(equals + 1));
    const bool is_word = !value.text.empty();
    return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& word) {
      if (is_word) return word == value.text;
      return word == fmt::format("{}", value.number) || word == (value.number != 0 ? "true" : "false");
    });
  }
  return false;
}

std::vector<std::string> pass_problems(const PluginInstance& instance) {
  std::vector<std::string> problems;
  for (const riffle_pass* pass : Table(instance.table().passes)) {
    if (pass->type == RIFFLE_PASS_GLOBAL || !is_active(instance, pass->when)) continue;
    PassCheck(instance, *pass, problems).run();
  }
  return problems;
}

std::vector<std::string> reference_problems(const PluginInstance& instance) {
  std::vector<std::string> names;  // of the columns: one per component
  for (const riffle_field* field : Table(instance.table().gives)) {
    const int count = components(static_cast<Shape>(field->shape), instance.dim());
    names.insert(names.end(), static_cast<std::size_t>(count), field->name);
  }
  std::vector<std::string> problems;
  for (const double time : {0.0, 0.01, 0.5, 3.0, 100.0}) {
    std::vector<double> x(items), other(items);
    for (std::int64_t k = 0; k < items; ++k) {
      const double s = 2.0 * static_cast<double>(k) / (items - 1) - 1;
      x[static_cast<std::size_t>(k)] = 20 * s * std::abs(s);  // dense around the origin, to 20 m on either side
      other[static_cast<std::size_t>(k)] = 0.5 + 0.4 * s;
    }
    riffle_points points{sizeof(riffle_points), instance.dim(), items, {x.data(), other.data(), other.data()}, time};
    std::vector<std::vector<double>> values(names.size(), std::vector<double>(items, std::nan(""))), scales = values;
    std::vector<double*> value_rows, scale_rows;
    for (auto& row : values) value_rows.push_back(row.data());
    for (auto& row : scales) scale_rows.push_back(row.data());
    std::vector<std::uint8_t> defined(items, 0);
    riffle_error error = no_error();
    const auto status = call_plugin(error, [&] {
      return may_throw(instance.table().evaluate_reference)(instance.self(), &points, value_rows.data(),
                                                            scale_rows.data(), defined.data(), &error);
    });
    if (status != RIFFLE_OK) {
      problems.push_back(fmt::format("{}: fails at t = {} s: {}", instance.name(), time, message_of(error)));
      return problems;
    }
    for (std::size_t c = 0; c < names.size(); ++c) {
      for (std::size_t k = 0; k < defined.size(); ++k) {
        if (defined[k] == 0 || (std::isfinite(values[c][k]) && std::isfinite(scales[c][k]) && scales[c][k] >= 0)) {
          continue;
        }
        problems.push_back(
            fmt::format("{}: says that \"{}\" is defined at x = {:.4g} m, t = {} s, but gives {} with "
                        "scale {}",
                        instance.name(), names[c], x[k], time, values[c][k], scales[c][k]));
        return problems;
      }
    }
  }
  return problems;
}

// Finite where one looks, a width above 0: around the origin, and within what a scene with the defaults would be.
std::vector<std::string> profile_problems(const PluginInstance& instance) {
  std::vector<double> x(items), y(items, 0.0), value(items), slope_x(items), slope_y(items);
  for (std::int64_t k = 0; k < items; ++k) {
    const double s = 2.0 * static_cast<double>(k) / (items - 1) - 1;
    x[static_cast<std::size_t>(k)] = 20 * s * std::abs(s);
  }
  riffle_error error = no_error();
  const auto status = call_plugin(error, [&] {
    return may_throw(instance.table().evaluate_profile)(instance.self(), items, x.data(), y.data(), value.data(),
                                                        slope_x.data(), slope_y.data(), &error);
  });
  if (status != RIFFLE_OK) return {fmt::format("{}: fails: {}", instance.name(), message_of(error))};
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!std::isfinite(value[k]) || !std::isfinite(slope_x[k])) {
      return {fmt::format("{}: must be finite with its slope, gives {} with slope {} at x = {:.4g} m", instance.name(),
                          value[k], slope_x[k], x[k])};
    }
    if (instance.kind() == "width" && !(value[k] > 0)) {
      return {fmt::format("{}: must be above 0, gives {} m at x = {:.4g} m", instance.name(), value[k], x[k])};
    }
  }
  return {};
}

bool has_contract(const std::string& kind) {  // beds and widths are looked at where the scene needs them: Terrain
  return kind == "kernel" || kind == "viscosity" || kind == "drag" || kind == "turbulence" || kind == "reference";
}

std::vector<std::string> contract_problems(const PluginInstance& instance) {
  if (instance.kind() == "kernel") return kernel_problems(instance);
  if (instance.kind() == "reference") return reference_problems(instance);
  if (instance.kind() == "bed" || instance.kind() == "width") return profile_problems(instance);
  return pass_problems(instance);
}

}  // namespace riffle
