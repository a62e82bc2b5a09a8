#include <fmt/format.h>

#include <array>
#include <cmath>

#include "host/plugins/check/checks.hpp"
#include "host/plugins/check/closure.hpp"
#include "host/plugins/unit.hpp"

namespace riffle::check {
namespace {

constexpr std::int64_t count = 64;
// Closures made of products, sums and square roots scale exactly. pow, exp and trigonometric functions round differently
// for different arguments, by some units in the last place; a hidden unit shows at a part in a thousand and more.
constexpr double tolerance = 1e-12;

// A function of the manifest in other units: f'(x', t') = factor f(x' / metre, t' / second).
class Rescaled : public Function::Implementation {
 public:
  Rescaled(std::shared_ptr<const Function> function, UnitScale scale, double factor)
      : function_(std::move(function)), scale_(scale), factor_(factor) {}
  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                double* out) const override {
    for (std::int64_t k = 0; k < n; ++k) {
      const auto at = [&](const double* values) { return values == nullptr ? 0 : values[k] / scale_.metre; };
      out[k] = factor_ * (*function_)(at(x), at(y), at(z), t / scale_.second);
    }
  }

 private:
  std::shared_ptr<const Function> function_;
  UnitScale scale_;
  double factor_;
};

std::vector<ParameterValue> rescaled_defaults(const PluginDescription& description, const UnitScale& scale, int dim) {
  std::vector<ParameterValue> values = default_values(description);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ParameterDescription& p = description.parameters[k];
    const double factor = scale.of(parse_unit(p.unit).value(), dim);
    if (p.type == ParameterType::real) values[k].number *= factor;
    if (p.type != ParameterType::function) continue;
    const auto rescaled = std::make_shared<Rescaled>(values[k].function, scale, factor);
    values[k].function = std::make_shared<Function>(rescaled, "rescaled");
  }
  return values;
}

struct Trial {
  const char* text;
  UnitScale scale;
};
// Powers whose square, cube, fourth and sixth roots are powers of two as well.
constexpr std::array<Trial, 3> trials{
    {{"kilograms", {0x1p12, 1, 1}}, {"metres", {1, 0x1p12, 1}}, {"seconds", {1, 1, 0x1p12}}}};

// Largest error of the closure's outputs relative to their size.
struct Worst {
  double error = 0;
  std::string where;
};

void compare(const Closure& closure, const SyntheticBlock& plain, const SyntheticBlock& rescaled, const Trial& trial,
             int dim, Worst& worst) {
  for (int k = 0; k < plain.outputs(); ++k) {
    const riffle_field& field = closure.output(k);
    const double factor = trial.scale.of(parse_unit(field.unit).value(), dim);
    for (int c = 0; c < plain.components(k); ++c) {
      double squares = 0;
      for (std::int64_t p = 0; p < count; ++p) squares += plain.out(k, c)[p] * plain.out(k, c)[p];
      const double usual = std::sqrt(squares / static_cast<double>(count));
      for (std::int64_t p = 0; p < count; ++p) {
        const double expected = plain.out(k, c)[p], found = rescaled.out(k, c)[p] / factor;
        if (expected == found || (std::isnan(expected) && std::isnan(found))) continue;
        // Where terms cancel, the rounding of the terms is what counts.
        const double error = std::abs(found - expected) / (std::abs(expected) + 1e-3 * usual);
        if (error <= worst.error) continue;
        worst = {std::isfinite(error) ? error : 1e300,
                 fmt::format("{}: \"{}\" [{}]", closure.name, field.name, field.unit)};
      }
    }
  }
}

}  // namespace

Findings check_dimensions(const Plugin& plugin) {
  Findings findings;
  Worst overall;
  bool any = false;
  for (const int dim : plugin.description.dimensions) {
    const PluginInstance instance(plugin, dim, default_values(plugin.description));
    const std::vector<Closure> closures = closures_of(instance);
    any = any || !closures.empty();
    for (const Trial& trial : trials) {
      const PluginInstance other(plugin, dim, rescaled_defaults(plugin.description, trial.scale, dim));
      const std::vector<Closure> rescaled = closures_of(other);
      Worst worst;
      for (std::size_t k = 0; k < closures.size(); ++k) {
        SyntheticScene scene = scene_for(closures[k], dim);
        const SyntheticBlock plain_block(scene, closures[k].pass, first_items(count));
        scene.scale = trial.scale;
        const SyntheticBlock rescaled_block(scene, rescaled[k].pass, first_items(count));
        run(closures[k], plain_block);
        run(rescaled[k], rescaled_block);
        compare(closures[k], plain_block, rescaled_block, trial, dim, worst);
      }
      if (worst.error > overall.error) overall = worst;
      if (worst.error > tolerance) {
        findings.fail(
            fmt::format("{} changes by a factor that its unit does not explain when {} are rescaled (error "
                        "{:.2g} in {}D): a constant in the formula hides a unit, or a declared unit is wrong",
                        worst.where, trial.text, worst.error, dim));
        return findings;  // the others would say the same once more
      }
    }
  }
  if (!any) {
    findings.summary = nothing;
    return findings;
  }
  findings.summary = overall.error == 0
                         ? "scales with kg, m and s exactly as its units say"
                         : fmt::format("scales with kg, m and s as its units say, to {:.1g}", overall.error);
  return findings;
}

}  // namespace riffle::check
