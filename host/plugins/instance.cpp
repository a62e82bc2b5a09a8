#include "host/plugins/instance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host/plugins/call.hpp"
#include "host/plugins/floating_point.hpp"

namespace riffle {
namespace {

// A function of the manifest as a plugin calls it. What cannot be evaluated is no number, which the host notices.
void evaluate_function(const void* context, std::int64_t n, const double* x, const double* y, const double* z, double t,
                       double* out) noexcept {
  try {
    static_cast<const Function*>(context)->evaluate(n, x, y, z, t, out);
  } catch (...) {
    std::fill_n(out, n, std::numeric_limits<double>::quiet_NaN());
  }
}

class Constant : public Function::Implementation {
 public:
  explicit Constant(double value) : value_(value) {}
  void evaluate(std::int64_t n, const double*, const double*, const double*, double, double* out) const override {
    std::fill_n(out, n, value_);
  }

 private:
  double value_;
};

bool is_allowed(const ParameterDescription& p, double x) {
  return x >= p.min && x <= p.max && !(p.above_min && x == p.min) && !(p.below_max && x == p.max);
}

// A number of everyday size in SI that the parameter's range allows; `rank` makes those of one plugin differ.
double usual_number(const ParameterDescription& p, int rank) {
  const double one = p.type == ParameterType::integer ? 1.0 : 1.0 / rank;
  if (is_allowed(p, one)) return one;
  if (is_allowed(p, p.min)) return p.min;
  if (p.type == ParameterType::integer) return p.min + 1;
  return std::isfinite(p.max) ? p.min + (p.max - p.min) / 2 : std::max(2 * p.min, 1.0);
}

// What a case with a tank of water, one metre in each direction, would have.
const std::map<std::string, double>& usual_quantities() {
  static const std::map<std::string, double> quantities{
      {"fluid.gravity", 9.81}, {"fluid.density", 1000}, {"fluid.viscosity", 1e-6}, {"domain.smoothing_ratio", 1.3},
      {"domain.x_min", 0},     {"domain.y_min", 0},     {"domain.z_min", 0},       {"domain.x_max", 1},
      {"domain.y_max", 1},     {"domain.z_max", 1}};
  return quantities;
}

}  // namespace

const riffle_services& flat_scene(int dim) {
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
  return scenes.at(static_cast<std::size_t>(std::clamp(dim, 1, 3) - 1));
}

PluginInstance::PluginInstance(const Plugin& plugin, int dim, const std::vector<ParameterValue>& values)
    : PluginInstance(plugin, dim, values, &flat_scene(dim)) {}

PluginInstance::PluginInstance(const Plugin& plugin, int dim, const std::vector<ParameterValue>& values,
                               const riffle_services* scene)
    : owner_(plugin.owner),
      table_(plugin.table),
      dim_(dim),
      kind_(plugin.description.kind),
      id_(plugin.description.id),
      values_(std::make_unique<Values>()) {
  const auto& dims = plugin.description.dimensions;
  if (std::find(dims.begin(), dims.end(), dim) == dims.end()) {
    throw PluginError(
        fmt::format("{} works in {} dimension(s) only, the scene has {}", name(), fmt::join(dims, ", "), dim));
  }
  if (values.size() != plugin.description.parameters.size()) {
    throw PluginError(fmt::format("{} has {} parameters, but {} values were given", name(),
                                  plugin.description.parameters.size(), values.size()));
  }
  values_->given = values;
  for (const ParameterValue& value : values_->given) {
    const riffle_function* function = nullptr;
    if (value.function) {
      function = &values_->functions.emplace_back(
          riffle_function{sizeof(riffle_function), 0, value.function.get(), &evaluate_function});
    }
    values_->values.push_back(
        {sizeof(riffle_value), value.given ? 1U : 0U, value.number, value.text.c_str(), function});
  }
  for (const riffle_value& value : values_->values) values_->pointers.push_back(&value);
  values_->pointers.push_back(nullptr);

  riffle_error error = no_error();
  FloatingPointGuard guard;
  call_plugin(error, [&] {
    self_ = {may_throw(table_->create)(dim, values_->pointers.data(), &error), DestroyPlugin{table_->destroy}};
    return RIFFLE_OK;
  });
  const bool changed = guard.restore();
  if (!self_) throw PluginError(fmt::format("{} cannot be created: {}", name(), message_of(error)));
  if (changed) {
    throw PluginError(fmt::format("{} changes the floating-point arithmetic of the whole program in create", name()));
  }
  if (scene != nullptr) connect(*scene);
}

void PluginInstance::connect(const riffle_services& scene) {
  if (table_->connect == nullptr) return;
  riffle_error error = no_error();
  const auto status = call_plugin(error, [&] { return may_throw(table_->connect)(self_.get(), &scene, &error); });
  if (status != RIFFLE_OK) throw PluginError(fmt::format("{}: {}", name(), message_of(error)));
}

void DestroyPlugin::operator()(void* self) const {
  if (self == nullptr) return;
  const FloatingPointGuard guard;
  destroy(self);
}

std::shared_ptr<const Function> shared_constant(double value) {
  return std::make_shared<Function>(std::make_shared<Constant>(value), fmt::format("{}", value));
}

std::vector<ParameterValue> default_values(const PluginDescription& description,
                                           const std::map<std::string, double>& inherited) {
  std::vector<ParameterValue> values;
  int required = 0;
  for (const ParameterDescription& p : description.parameters) {
    ParameterValue value;
    value.name = p.name;
    if (const auto given = inherited.find(p.inherit); given != inherited.end()) {
      value.number = given->second;
    } else if (const auto known = usual_quantities().find(p.inherit); known != usual_quantities().end()) {
      value.number = known->second;
    } else if (p.required || (!p.inherit.empty() && !is_allowed(p, p.fallback))) {
      value.number = usual_number(p, ++required);
    } else {
      value.number = p.fallback;
    }
    if (p.type == ParameterType::choice) {
      const auto word = std::find(p.choices.begin(), p.choices.end(), p.fallback_text);
      value.number = word == p.choices.end() ? 0 : static_cast<double>(word - p.choices.begin());
      value.text = p.choices.at(static_cast<std::size_t>(value.number));
    } else if (p.type == ParameterType::text) {
      value.text = p.fallback_text;
    } else if (p.type == ParameterType::function) {
      value.function = shared_constant(value.number);
    }
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace riffle
