#include "host/terrain/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "host/plugins/call.hpp"

namespace riffle {

namespace {

void evaluate(const PluginInstance& plugin, std::int64_t n, const double* x, const double* y, double* value,
              double* slope_x, double* slope_y) {
  riffle_error error = no_error();
  const auto status = call_plugin(error, [&] {
    return may_throw(plugin.table().evaluate_profile)(plugin.self(), n, x, y, value, slope_x, slope_y, &error);
  });
  if (status != RIFFLE_OK) throw std::runtime_error(plugin.name() + ": " + message_of(error));
}

// As the boundary calls it, where nothing may be thrown: no number where there is no answer.
template <class Work>
void or_nan(std::int64_t n, std::initializer_list<double*> out, Work work) noexcept {
  try {
    work();
  } catch (...) {
    for (double* o : out) {
      if (o != nullptr) std::fill_n(o, n, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

class DepthBelow : public Function::Implementation {
 public:
  DepthBelow(Function level, const Terrain& terrain) : level_(std::move(level)), terrain_(terrain) {}
  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                double* out) const override {
    level_.evaluate(n, x, y, z, t, out);
    std::vector<double> bed(static_cast<std::size_t>(n));
    terrain_.bed(n, x, y, bed.data(), nullptr, nullptr);
    for (std::int64_t k = 0; k < n; ++k) out[k] = std::max(out[k] - bed[static_cast<std::size_t>(k)], 0.0);
  }

 private:
  Function level_;
  const Terrain& terrain_;
};

}  // namespace

Terrain::Terrain(const Case& scene, const PluginInstance* bed, const PluginInstance* width) : bed_(bed), width_(width) {
  services_.size = sizeof services_;
  services_.dim = scene.dimension;
  services_.has_bed = bed != nullptr ? 1 : 0;
  services_.has_width = width != nullptr ? 1 : 0;
  std::copy(scene.lower.begin(), scene.lower.end(), services_.low);
  std::copy(scene.upper.begin(), scene.upper.end(), services_.high);
  services_.context = this;
  services_.bed = [](const void* c, std::int64_t n, const double* x, const double* y, double* level, double* slope_x,
                     double* slope_y) noexcept {
    or_nan(n, {level, slope_x, slope_y},
           [&] { static_cast<const Terrain*>(c)->bed(n, x, y, level, slope_x, slope_y); });
  };
  services_.width = [](const void* c, std::int64_t n, const double* x, double* width_at, double* slope) noexcept {
    or_nan(n, {width_at, slope}, [&] { static_cast<const Terrain*>(c)->width(n, x, width_at, slope); });
  };
  services_.spacing = scene.placement.spacing;
  services_.starts_from_reference = scene.initial_from_reference.empty() ? 0 : 1;
  services_.warn = [](const void* c, const char* sentence) noexcept {
    auto& all = static_cast<const Terrain*>(c)->warnings_;
    if (sentence != nullptr && std::find(all.begin(), all.end(), sentence) == all.end()) all.emplace_back(sentence);
  };
  check(scene);
}

void Terrain::bed(std::int64_t n, const double* x, const double* y, double* level, double* slope_x,
                  double* slope_y) const {
  if (bed_ != nullptr) {
    evaluate(*bed_, n, x, y, level, slope_x, slope_y);
    return;
  }
  for (double* out : {level, slope_x, slope_y}) {
    if (out != nullptr) std::fill_n(out, n, 0.0);
  }
}

void Terrain::width(std::int64_t n, const double* x, double* width, double* slope) const {
  if (width_ != nullptr) {
    evaluate(*width_, n, x, nullptr, width, slope, nullptr);
    return;
  }
  std::fill_n(width, n, 1.0);
  if (slope != nullptr) std::fill_n(slope, n, 0.0);
}

void Terrain::check(const Case& scene) const {
  constexpr std::int64_t samples = 8193;
  std::vector<double> x(samples), value(samples), slope(samples);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = scene.lower[0] + (scene.upper[0] - scene.lower[0]) * static_cast<double>(k) / (samples - 1);
  }
  const auto require = [&](const PluginInstance& plugin, const char* rule, bool positive) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (std::isfinite(value[k]) && std::isfinite(slope[k]) && (!positive || value[k] > 0)) continue;
      throw std::runtime_error(fmt::format("{}: the {}, got {:.6g} m at x = {:.6g} m", plugin.name(), rule,
                                           std::isfinite(slope[k]) ? value[k] : slope[k], x[k]));
    }
  };
  if (bed_ != nullptr) {
    bed(samples, x.data(), nullptr, value.data(), slope.data(), nullptr);
    require(*bed_, "level of the bed must be finite throughout the domain", false);
  }
  if (width_ != nullptr) {
    width(samples, x.data(), value.data(), slope.data());
    require(*width_, "width of the channel must be above 0 throughout the domain", true);
  }
}

Function depth_below(const Function& level, const Terrain& terrain) {
  return {std::make_shared<DepthBelow>(level, terrain), "level - bed"};
}

}  // namespace riffle
