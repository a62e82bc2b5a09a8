// Uniform flow down a slope as a column: the balance of momentum at every height, over a rough or a porous bed.
//
//   d/dz [ phi (nu + l_m^2 |u'|) u' ] + phi g S0 - phi (k1 u + k2 u |u|) = 0,   u = 0 at the bottom, no stress at the surface
//
// u is the intrinsic velocity, phi the porosity, l_m the mixing length, k1 and k2 the drag of the bed. Kazemi (2017), eq. 3.2
// and eq. 4.46 in one dimension, with the closures of chapters 3 and 6. It is the least model of these scenes, solved in less
// than a millisecond, and with it q = int phi u dz: of discharge, level and slope any two give the third.
//
// Finite volumes: velocities at the middles of cells, stresses at faces, of which some lie on the levels where the drag
// jumps. The discrete balance is the gradient of a convex function of the velocities, whose one minimum Newton's method with
// a line search finds from anywhere; with the discharge given, the slope is the multiplier of that constraint. The level is
// the root of q, which grows with it. Second order in the height of the cells.
//
// Not in it: secondary currents and side walls, and how the flow became uniform.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace riffle {

struct Column {
  double gravity = 9.81, viscosity = 1e-6;  // m/s2, m2/s: above 0
  double bottom = 0;                        // m: level of the wall
  std::vector<double> interfaces;           // m, increasing, above the bottom and below the surface: where drags jump
  int cells = 400;
  std::function<double(double)> porosity;                     // phi(z); none: 1
  std::function<double(double)> linear_drag, quadratic_drag;  // k1(z) [1/s], k2(z) [1/m]; none: 0
  std::function<double(double, double)> mixing_length;        // l_m(z, level of the surface) [m]; none: 0
  // The surface must stand above this level.
  [[nodiscard]] double crest() const { return interfaces.empty() ? bottom : interfaces.back(); }
};

class ColumnFlow {
 public:
  // Each throws std::invalid_argument with one sentence when there is no such flow.
  static ColumnFlow of_slope(const Column& column, double level, double slope);
  static ColumnFlow of_discharge(const Column& column, double level, double discharge);
  static ColumnFlow of_slope_and_discharge(const Column& column, double slope, double discharge);

  [[nodiscard]] double level() const { return face_.back(); }               // m
  [[nodiscard]] double slope() const { return slope_; }                     // sine of the angle
  [[nodiscard]] double discharge() const { return discharge_; }             // m2/s: int phi u dz
  [[nodiscard]] int iterations() const { return iterations_; }              // of Newton's method, the last time
  [[nodiscard]] const std::vector<double>& faces() const { return face_; }  // m, from the bottom up
  [[nodiscard]] const std::vector<double>& velocities() const { return velocity_; }  // m/s, one per cell
  [[nodiscard]] const std::vector<double>& stresses() const { return stress_; }  // m2/s2: phi tau / rho, one per face

  // At a level; those of the ends beyond them.
  [[nodiscard]] double velocity(double z) const { return between(centre_, velocity_, z); }
  [[nodiscard]] double stress(double z) const { return between(face_, stress_, z); }
  [[nodiscard]] double gradient(double z) const { return between(face_, gradient_, z); }
  [[nodiscard]] double eddy_viscosity(double z) const { return between(face_, eddy_viscosity_, z); }
  // Mean of u between two levels, and int phi u dz and int phi (k1 u + k2 u |u|) dz below a level; exact at faces.
  [[nodiscard]] double mean_velocity(double from, double to) const;
  [[nodiscard]] double discharge_below(double z) const { return sum_below(z, porosity_, velocity_); }
  [[nodiscard]] double drag_below(double z) const { return sum_below(z, drag_, {}); }
  // Largest difference, over the faces, between the stress and the weight less the drag of what stands above, over the
  // stress at the bottom without drag.
  [[nodiscard]] double imbalance() const;

 private:
  ColumnFlow(const Column& column, double level);
  void find(bool given_discharge);
  void newton_matrix();
  void rates(double force, std::vector<double>& gradient) const;
  [[nodiscard]] double energy(const std::vector<double>& u, double force) const;
  [[nodiscard]] std::vector<double> solve(std::vector<double> right) const;
  void finish();
  [[nodiscard]] static double between(const std::vector<double>& x, const std::vector<double>& y, double at);
  [[nodiscard]] double sum_below(double z, const std::vector<double>& a, const std::vector<double>& b) const;

  double gravity_, viscosity_, slope_ = 0, discharge_ = 0;
  int iterations_ = 0;
  std::vector<double> face_, centre_, height_, distance_;  // distance_: between the velocities about a face
  std::vector<double> porosity_, linear_, quadratic_, drag_,
      velocity_;  // per cell: means of phi, phi k1, phi k2, phi A
  std::vector<double> face_porosity_, length_, gradient_, eddy_viscosity_, stress_;  // per face
  std::vector<double> diagonal_, below_;                                             // of Newton's matrix, symmetric
};

inline ColumnFlow::ColumnFlow(const Column& column, double level)
    : gravity_(column.gravity), viscosity_(column.viscosity) {
  const auto fail = [](const std::string& text) { throw std::invalid_argument(text); };
  if (!(viscosity_ > 0)) fail("the viscosity must be above 0, for without it nothing holds the water at the bottom");
  if (!(level > column.crest())) fail("the water surface must lie above the crest of the bed");
  std::vector<double> ends{column.bottom};
  ends.insert(ends.end(), column.interfaces.begin(), column.interfaces.end());
  ends.push_back(level);
  // A fixed share of the cells for each part, so that the discharge is a continuous function of the level.
  const std::size_t parts = ends.size() - 1;
  const auto share = static_cast<std::size_t>(std::max(column.cells / static_cast<int>(parts + 1), 4));
  face_.push_back(column.bottom);
  for (std::size_t p = 0; p < parts; ++p) {
    if (!(ends[p + 1] > ends[p])) fail("levels of a column must increase");
    const std::size_t n = p + 1 < parts ? share : 2 * share;
    for (std::size_t k = 1; k < n; ++k) {
      face_.push_back(ends[p] + (ends[p + 1] - ends[p]) * static_cast<double>(k) / static_cast<double>(n));
    }
    face_.push_back(ends[p + 1]);
  }
  const std::size_t n = face_.size() - 1;
  const auto value = [](const std::function<double(double)>& f, double z, double otherwise) {
    return f ? f(z) : otherwise;
  };
  constexpr double point[] = {0.069431844202973712, 0.330009478207571868, 0.669990521792428132, 0.930568155797026288};
  constexpr double weight[] = {0.173927422568726929, 0.326072577431273071, 0.326072577431273071, 0.173927422568726929};
  for (std::size_t i = 0; i < n; ++i) {
    height_.push_back(face_[i + 1] - face_[i]);
    centre_.push_back(0.5 * (face_[i] + face_[i + 1]));
    double phi = 0, linear = 0, quadratic = 0;
    for (std::size_t k = 0; k < 4; ++k) {  // Gauss and Legendre
      const double z = face_[i] + point[k] * height_[i], here = value(column.porosity, z, 1);
      if (!(here > 0 && here <= 1)) fail("the porosity must be above 0 and at most 1 at every level");
      phi += weight[k] * here;
      linear += weight[k] * here * value(column.linear_drag, z, 0);
      quadratic += weight[k] * here * value(column.quadratic_drag, z, 0);
    }
    porosity_.push_back(phi);
    linear_.push_back(linear);
    quadratic_.push_back(quadratic);
  }
  for (std::size_t f = 0; f <= n; ++f) {
    face_porosity_.push_back(value(column.porosity, face_[f], 1));
    length_.push_back(column.mixing_length ? column.mixing_length(face_[f], level) : 0);
    if (f < n) distance_.push_back(f == 0 ? 0.5 * height_[0] : 0.5 * (height_[f - 1] + height_[f]));
  }
  velocity_.assign(n, 0);
}

// d/du of the energy below: stress at the lower face less that at the upper, and drag less the force, over the cell.
inline void ColumnFlow::rates(double force, std::vector<double>& gradient) const {
  const std::size_t n = velocity_.size();
  gradient.resize(n);
  double below = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = velocity_[i], g = (u - (i > 0 ? velocity_[i - 1] : 0)) / distance_[i];
    const double stress = face_porosity_[i] * (viscosity_ + length_[i] * length_[i] * std::abs(g)) * g;
    if (i > 0) gradient[i - 1] += below - stress;
    gradient[i] = height_[i] * (linear_[i] * u + quadratic_[i] * u * std::abs(u) - porosity_[i] * force);
    below = stress;
  }
  gradient[n - 1] += below;
}

inline double ColumnFlow::energy(const std::vector<double>& u, double force) const {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double g = std::abs(u[i] - (i > 0 ? u[i - 1] : 0)) / distance_[i], v = std::abs(u[i]);
    sum += distance_[i] * face_porosity_[i] * g * g * (viscosity_ / 2 + length_[i] * length_[i] * g / 3);
    sum += height_[i] * (v * v * (linear_[i] / 2 + quadratic_[i] * v / 3) - porosity_[i] * force * u[i]);
  }
  return sum;
}

inline void ColumnFlow::newton_matrix() {
  const std::size_t n = velocity_.size();
  diagonal_.assign(n, 0);
  below_.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double u = velocity_[i], g = std::abs(u - (i > 0 ? velocity_[i - 1] : 0)) / distance_[i];
    const double a = face_porosity_[i] * (viscosity_ + 2 * length_[i] * length_[i] * g) / distance_[i];
    diagonal_[i] += a + height_[i] * (linear_[i] + 2 * quadratic_[i] * std::abs(u));
    if (i == 0) continue;
    diagonal_[i - 1] += a;
    below_[i] = -a;
  }
}

inline std::vector<double> ColumnFlow::solve(std::vector<double> right) const {  // Thomas
  const std::size_t n = right.size();
  std::vector<double> pivot(n);
  pivot[0] = diagonal_[0];
  for (std::size_t i = 1; i < n; ++i) {
    const double m = below_[i] / pivot[i - 1];
    pivot[i] = diagonal_[i] - m * below_[i];
    right[i] -= m * right[i - 1];
  }
  right[n - 1] /= pivot[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) right[i] = (right[i] - below_[i + 1] * right[i + 1]) / pivot[i];
  return right;
}

// Starts from velocity_; with the discharge given these must carry it, and each step then leaves it as it is.
inline void ColumnFlow::find(bool given_discharge) {
  const std::size_t n = velocity_.size();
  std::vector<double> slope, trial(n), step, response, weight(n);
  for (std::size_t i = 0; i < n; ++i) weight[i] = height_[i] * porosity_[i];
  for (iterations_ = 1; iterations_ <= 100; ++iterations_) {
    double force = given_discharge ? 0 : gravity_ * slope_;
    rates(force, slope);
    newton_matrix();
    for (double& s : slope) s = -s;
    step = solve(slope);
    if (given_discharge) {
      response = solve(weight);
      double missing = discharge_, gain = 0;
      for (std::size_t i = 0; i < n; ++i) {
        missing -= weight[i] * (velocity_[i] + step[i]);
        gain += weight[i] * response[i];
      }
      force = missing / gain;
      slope_ = force / gravity_;
      for (std::size_t i = 0; i < n; ++i) step[i] += force * response[i];
    }
    double largest = 0, change = 0, descent = 0;
    rates(force, slope);
    for (std::size_t i = 0; i < n; ++i) {
      largest = std::max(largest, std::abs(velocity_[i] + step[i]));
      change = std::max(change, std::abs(step[i]));
      descent += slope[i] * step[i];
    }
    const double before = energy(velocity_, force);
    double part = 1;
    for (int halved = 0; halved < 60; ++halved, part /= 2) {
      for (std::size_t i = 0; i < n; ++i) trial[i] = velocity_[i] + part * step[i];
      if (energy(trial, force) <= before + 1e-4 * part * descent + 1e-12 * std::abs(before)) break;
    }
    velocity_ = trial;
    if (change <= 1e-11 * largest) break;  // quadratic: what is left is round-off
  }
  if (iterations_ > 100) throw std::invalid_argument("no steady flow was found in this column");
  finish();
}

inline void ColumnFlow::finish() {
  const std::size_t n = velocity_.size();
  discharge_ = 0;
  drag_.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const double u = velocity_[i], g = (u - (i > 0 ? velocity_[i - 1] : 0)) / distance_[i];
    const double eddy = length_[i] * length_[i] * std::abs(g);
    gradient_.push_back(g);
    eddy_viscosity_.push_back(eddy);
    stress_.push_back(face_porosity_[i] * (viscosity_ + eddy) * g);
    drag_.push_back(linear_[i] * u + quadratic_[i] * u * std::abs(u));
    discharge_ += height_[i] * porosity_[i] * u;
  }
  stress_.push_back(0);
  gradient_.push_back(n > 1 ? gradient_[n - 1] : 0);
  eddy_viscosity_.push_back(length_[n] * length_[n] * std::abs(gradient_[n]));
  // To the ends of the water: at rest at the wall, along the last gradient to the surface.
  centre_.insert(centre_.begin(), face_.front());
  centre_.push_back(face_.back());
}

inline double ColumnFlow::between(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const bool cells = y.size() + 2 == x.size();  // velocities: x has the two ends besides
  const auto value = [&](std::size_t k) {
    if (!cells) return y[k];
    if (k == 0) return 0.0;
    if (k + 1 < x.size()) return y[k - 1];
    const std::size_t last = y.size() - 1;
    return y[last] + (y[last] - y[last - 1]) * (x[k] - x[k - 1]) / (x[k - 1] - x[k - 2]);
  };
  if (at <= x.front()) return value(0);
  if (at >= x.back()) return value(x.size() - 1);
  const auto k = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  const double part = (at - x[k - 1]) / (x[k] - x[k - 1]);
  return (1 - part) * value(k - 1) + part * value(k);
}

inline double ColumnFlow::sum_below(double z, const std::vector<double>& a, const std::vector<double>& b) const {
  double sum = 0;
  for (std::size_t i = 0; i < height_.size() && face_[i] < z; ++i) {
    sum += (std::min(z, face_[i + 1]) - face_[i]) * a[i] * (b.empty() ? 1 : b[i]);
  }
  return sum;
}

inline double ColumnFlow::mean_velocity(double from, double to) const {
  return (sum_below(to, velocity_, {}) - sum_below(from, velocity_, {})) / (to - from);
}

inline double ColumnFlow::imbalance() const {
  double above = 0, worst = 0, total = 0;
  for (std::size_t i = height_.size(); i-- > 0;) {
    total += height_[i] * porosity_[i] * gravity_ * slope_;
    above += height_[i] * (porosity_[i] * gravity_ * slope_ - drag_[i]);
    worst = std::max(worst, std::abs(stress_[i] - above));
  }
  return worst / total;
}

inline ColumnFlow ColumnFlow::of_slope(const Column& column, double level, double slope) {
  if (!(slope > 0)) throw std::invalid_argument("slope must be above 0 for a channel that gravity drives");
  ColumnFlow flow(column, level);
  flow.slope_ = slope;
  flow.find(false);
  return flow;
}

inline ColumnFlow ColumnFlow::of_discharge(const Column& column, double level, double discharge) {
  if (!(discharge > 0)) throw std::invalid_argument("discharge must be above 0");
  ColumnFlow flow(column, level);
  double open = 0;
  for (std::size_t i = 0; i < flow.height_.size(); ++i) open += flow.height_[i] * flow.porosity_[i];
  flow.velocity_.assign(flow.height_.size(), discharge / open);
  flow.discharge_ = discharge;
  flow.find(true);
  return flow;
}

inline ColumnFlow ColumnFlow::of_slope_and_discharge(const Column& column, double slope, double discharge) {
  if (!(slope > 0)) throw std::invalid_argument("slope must be above 0 for a channel that gravity drives");
  if (!(discharge > 0)) throw std::invalid_argument("discharge must be above 0");
  const double crest = column.crest();
  // By the logarithms of depth above the crest and of discharge, which are nearly proportional; first U = 8 u*.
  const auto excess = [&](double logarithm) {
    return std::log(of_slope(column, crest + std::exp(logarithm), slope).discharge() / discharge);
  };
  const double thinnest = std::log(1e-6 * (crest - column.bottom) + 1e-9 * (1 + std::abs(crest)));
  double low = std::max(std::log(discharge / (8 * std::sqrt(column.gravity * slope))) / 1.5, thinnest), high = low;
  double at_low = excess(low), at_high = at_low;
  while (at_low > 0 && low > thinnest) {
    high = low, at_high = at_low;
    low = std::max(low - 0.7, thinnest), at_low = excess(low);
  }
  for (int k = 0; k < 40 && at_high < 0; ++k) low = high, at_low = at_high, high += 0.7, at_high = excess(high);
  if (at_low > 0)
    throw std::invalid_argument("the bed alone carries more than this discharge: no level above its crest");
  if (at_high < 0) throw std::invalid_argument("no level carries this discharge at this slope");
  // False position that halves the weight of an end which stays (Illinois).
  int side = 0;
  double middle = high;
  for (int k = 0; k < 100 && high - low > 1e-15; ++k) {
    middle = at_high == at_low ? 0.5 * (low + high) : (low * at_high - high * at_low) / (at_high - at_low);
    if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
    const double here = excess(middle);
    if (std::abs(here) < 1e-14) break;
    if (here < 0) {
      low = middle, at_low = here;
      if (side == -1) at_high /= 2;
      side = -1;
    } else {
      high = middle, at_high = here;
      if (side == 1) at_low /= 2;
      side = 1;
    }
  }
  return of_slope(column, crest + std::exp(middle), slope);
}

}  // namespace riffle
