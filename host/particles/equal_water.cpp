#include "host/particles/equal_water.hpp"

#include <algorithm>
#include <cmath>

namespace riffle {
namespace {

constexpr double samples_per_spacing = 8;

// Samples of the plane, `u` across the strips and `v` along them, in middles of small cells.
class Plane {
 public:
  Plane(const Case& scene, const Water& water, const PorosityAt& porosity, std::size_t across)
      : scene_(scene), water_(water), porosity_(porosity), u_(across), v_(1 - across) {
    for (const std::size_t axis : {u_, v_}) {
      const double length = scene.upper[axis] - scene.lower[axis];
      count_[axis] =
          static_cast<std::int64_t>(std::ceil(length / scene.placement.spacing * samples_per_spacing - 1e-9));
      step_[axis] = length / static_cast<double>(count_[axis]);
    }
  }
  [[nodiscard]] std::int64_t count_across() const { return count_[u_]; }
  [[nodiscard]] double step_across() const { return step_[u_]; }
  [[nodiscard]] double step_along() const { return step_[v_]; }
  [[nodiscard]] double across(std::int64_t k) const {
    return scene_.lower[u_] + (static_cast<double>(k) + 0.5) * step_[u_];
  }
  [[nodiscard]] double along(std::int64_t k) const {
    return scene_.lower[v_] + (static_cast<double>(k) + 0.5) * step_[v_];
  }
  // Porosity along the strip at u, 0 where it is dry.
  [[nodiscard]] std::vector<double> open_to_water(double u) const {
    const auto n = static_cast<std::size_t>(count_[v_]);
    std::vector<double> at(n, u), along_it(n), depth(n), phi(n, 1.0);
    for (std::size_t k = 0; k < n; ++k) along_it[k] = along(static_cast<std::int64_t>(k));
    const double *x = u_ == 0 ? at.data() : along_it.data(), *z = u_ == 0 ? along_it.data() : at.data();
    water_.depth(count_[v_], x, nullptr, z, depth.data());
    if (porosity_) porosity_(count_[v_], x, z, phi.data());
    for (std::size_t k = 0; k < n; ++k) phi[k] = depth[k] > 0 ? phi[k] : 0;
    return phi;
  }

 private:
  const Case& scene_;
  const Water& water_;
  const PorosityAt& porosity_;
  std::size_t u_, v_;
  std::array<std::int64_t, 2> count_{};
  std::array<double, 2> step_{};
};

// How much the porosity of the wet part changes from one sample to the next along its strips.
double changes_along(const Plane& plane) {
  double sum = 0;
  for (std::int64_t k = 0; k < plane.count_across(); k += static_cast<std::int64_t>(samples_per_spacing)) {
    const std::vector<double> phi = plane.open_to_water(plane.across(k));
    for (std::size_t m = 1; m < phi.size(); ++m) {
      if (phi[m] > 0 && phi[m - 1] > 0) sum += std::abs(phi[m] - phi[m - 1]);
    }
  }
  return sum;
}

}  // namespace

PlacedParticles place_equal_water(const Case& scene, const Water& water, const PorosityAt& porosity) {
  const double spacing = scene.placement.spacing;
  const Plane upright(scene, water, porosity, 0), level(scene, water, porosity, 1);
  const std::size_t u = changes_along(upright) > changes_along(level) ? 1 : 0;
  const Plane& plane = u == 0 ? upright : level;

  // Strips: sum of sqrt(phi) / spacing across them.
  std::vector<double> running{0};
  for (std::int64_t k = 0; k < plane.count_across(); ++k) {
    double sum = 0, wet = 0;
    for (const double phi : plane.open_to_water(plane.across(k))) sum += phi, wet += phi > 0 ? 1 : 0;
    running.push_back(running.back() + std::sqrt(wet > 0 ? sum / wet : 1) * plane.step_across() / spacing);
  }
  const double strips = std::max(1.0, std::round(running.back()));
  const auto face = [&](double k) {
    const double wanted = k / strips * running.back();
    const auto at = std::upper_bound(running.begin() + 1, running.end() - 1, wanted);
    const double part = (wanted - *(at - 1)) / (*at - *(at - 1));
    return scene.lower[u] + (static_cast<double>(at - running.begin() - 1) + part) * plane.step_across();
  };

  PlacedParticles placed;
  for (double k = 0; k < strips; ++k) {
    const double from = face(k), to = face(k + 1), middle = 0.5 * (from + to);
    const std::vector<double> phi = plane.open_to_water(middle);
    double total = 0;
    for (const double share : phi) total += share * plane.step_along() * (to - from);
    const double cells = std::round(total / (spacing * spacing));
    if (!(cells > 0)) continue;
    const double each = total / cells;
    double passed = 0, next = 0.5 * each;
    for (std::size_t m = 0; m < phi.size(); ++m) {
      const double here = phi[m] * plane.step_along() * (to - from);
      for (; here > 0 && passed + here >= next * (1 - 1e-14) && next < total; next += each) {
        const double v =
            plane.along(static_cast<std::int64_t>(m)) + ((next - passed) / here - 0.5) * plane.step_along();
        placed.x[u].push_back(middle);
        placed.x[1 - u].push_back(v);
        double at = 1;  // mass is density, porosity and cell: so the cell at the porosity of the place
        if (porosity) porosity(1, u == 0 ? &middle : &v, u == 0 ? &v : &middle, &at);
        placed.cell_measure.push_back(each / at);
      }
      passed += here;
    }
  }
  return placed;
}

}  // namespace riffle
