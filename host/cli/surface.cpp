#include "host/cli/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/output/atomic_file.hpp"
#include "host/plugins/call.hpp"

namespace riffle {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Particles near a column of places, from which div r is formed along it.
class ColumnOfWater {
 public:
  ColumnOfWater(const Simulation& simulation, const ActivePlugin& kernel, double support, double x)
      : kernel_(kernel), x_(x) {
    const ParticleStore& store = simulation.store();
    const double *px = store.data("position", 0), *pz = store.data("position", 1);
    const double *volume = store.data("particle_volume"), *l = store.data("smoothing_length");
    for (std::int64_t i = 0; i < store.owned(); ++i) {
      if (store.role_of(i) == 5 || !(std::abs(px[i] - x) < support * l[i])) continue;
      particles_.push_back({px[i], pz[i], volume[i], l[i]});
      if (store.role_of(i) == 0) highest_ = std::max(highest_, pz[i]);
      reach_ = std::max(reach_, support * l[i]);
    }
    std::sort(particles_.begin(), particles_.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  }
  [[nodiscard]] bool dry() const { return !std::isfinite(highest_); }
  [[nodiscard]] double top() const { return highest_ + reach_; }
  [[nodiscard]] double divergence(double z) {
    r_.clear(), inverse_.clear(), volume_.clear();
    auto p = std::lower_bound(particles_.begin(), particles_.end(), z - reach_,
                              [](const auto& a, double value) { return a.z < value; });
    for (; p != particles_.end() && p->z < z + reach_; ++p) {
      r_.push_back(std::hypot(p->x - x_, p->z - z));
      inverse_.push_back(1 / p->l);
      volume_.push_back(p->volume);
    }
    gradient_.assign(r_.size(), 0.0);
    double* out[RIFFLE_KERNEL_OUTPUTS] = {gradient_.data()};
    out[1] = gradient_.data();
    if (r_.empty()) return 0;
    if (may_throw(kernel_.table->evaluate_kernel)(kernel_.self, static_cast<std::int64_t>(r_.size()), r_.data(),
                                                  inverse_.data(), RIFFLE_F, out) != RIFFLE_OK)
      throw std::runtime_error("kernel " + kernel_.id + " fails at the surface");
    double sum = 0;
    for (std::size_t k = 0; k < r_.size(); ++k) sum -= volume_[k] * gradient_[k] * r_[k] * r_[k];
    return sum;
  }

 private:
  struct Particle {
    double x, z, volume, l;
  };
  const ActivePlugin& kernel_;
  double x_, reach_ = 0, highest_ = -std::numeric_limits<double>::infinity();
  std::vector<Particle> particles_;
  std::vector<double> r_, inverse_, volume_, gradient_;
};

}  // namespace

std::vector<double> surface_levels(Simulation& simulation, const std::vector<double>& x) {
  if (simulation.graph().field("particle_volume") < 0 || simulation.store().find("particle_volume") == nullptr)
    throw std::runtime_error("[surface] needs equations that give the field \"particle_volume\"");
  simulation.refresh({"particle_volume"});
  const ActivePlugin& kernel = simulation.graph().plugins()[static_cast<std::size_t>(simulation.graph().kernel())];
  riffle_kernel about{};
  about.size = sizeof about;
  kernel.table->kernel(kernel.self, &about);
  const double step = 0.1 * simulation.scene().placement.spacing, bottom = simulation.scene().lower[1];
  std::vector<double> levels;
  for (const double at : x) {
    ColumnOfWater column(simulation, kernel, about.support, at);
    levels.push_back(none);
    if (column.dry()) continue;
    double above = column.divergence(column.top());
    for (double z = column.top() - step; z > bottom; z -= step) {
      const double here = column.divergence(z);
      if (here >= 1) {
        levels.back() = z + step * (above < 1 ? (here - 1) / (here - above) : 1);
        break;
      }
      above = here;
    }
  }
  return levels;
}

double SurfaceComparison::next(double t) const {
  const auto found = scene_.surface->points.upper_bound(t);
  return found == scene_.surface->points.end() ? std::numeric_limits<double>::infinity() : found->first;
}

void SurfaceComparison::look(Simulation& simulation) {
  const auto measured = scene_.surface->points.find(simulation.time());
  if (measured == scene_.surface->points.end()) return;
  std::vector<double> x, level;
  for (const auto& [at, z] : measured->second) {
    if (at < scene_.lower[0] || at > scene_.upper[0]) continue;
    x.push_back(at);
    level.push_back(z);
  }
  const std::vector<double> computed = surface_levels(simulation, x);
  for (std::size_t k = 0; k < x.size(); ++k) found_.push_back({simulation.time(), x[k], level[k], computed[k]});
}

std::vector<SurfaceError> SurfaceComparison::errors() const {
  std::vector<SurfaceError> all;
  for (const Point& p : found_) {
    if (all.empty() || all.back().time != p.t) all.push_back({p.t, 0, 0, 0});
    SurfaceError& e = all.back();
    if (!std::isfinite(p.computed)) continue;
    e.rmse += (p.computed - p.measured) * (p.computed - p.measured);
    e.bias += p.computed - p.measured;
    ++e.points;
  }
  for (SurfaceError& e : all) {
    e.rmse = std::sqrt(e.rmse / static_cast<double>(e.points));
    e.bias /= static_cast<double>(e.points);
  }
  return all;
}

void SurfaceComparison::write(const std::filesystem::path& file) const {
  std::string text = "# free surface, measured and computed (div r = 1), in s and m\nt,x,measured,computed\n";
  for (const Point& p : found_) text += fmt::format("{},{},{},{}\n", p.t, p.x, p.measured, p.computed);
  write_atomically(file, text);
}

nlohmann::json SurfaceComparison::state() const {
  nlohmann::json list = nlohmann::json::array();
  for (const Point& p : found_) {
    list.push_back({p.t, p.x, p.measured, std::isfinite(p.computed) ? nlohmann::json(p.computed) : nlohmann::json()});
  }
  return list;
}

void SurfaceComparison::restore(const nlohmann::json& state) {
  found_.clear();
  for (const auto& p : state) {
    found_.push_back(
        {p[0].get<double>(), p[1].get<double>(), p[2].get<double>(), p[3].is_null() ? none : p[3].get<double>()});
  }
}

}  // namespace riffle
