#include "host/terrain/smoothed_bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace riffle {

namespace {
constexpr std::int64_t batch = 64;
constexpr int share_cells = 4096;  // between them a cubic: errors of 1e-12
}  // namespace

SmoothedBed::SmoothedBed(const Terrain& terrain, double low, double high, double spacing, Kernel kernel, double support,
                         double integral)
    : low_(low), spacing_(spacing), kernel_(std::move(kernel)), support_(support), integral_(integral) {
  const auto cells = static_cast<std::size_t>(std::max(1.0, std::ceil((high - low) / spacing)));
  std::vector<double> faces(cells + 1);
  for (std::size_t k = 0; k < faces.size(); ++k) faces[k] = low + spacing * static_cast<double>(k);
  level_.resize(faces.size());
  terrain.bed(static_cast<std::int64_t>(faces.size()), faces.data(), nullptr, level_.data(), nullptr, nullptr);
  rise_.resize(cells);
  place_.resize(cells);
  for (std::size_t k = 0; k < cells; ++k) {
    rise_[k] = level_[k + 1] - level_[k];
    place_[k] = 0.5 * (faces[k] + faces[k + 1]);
    if (rise_[k] != 0) find_jump(terrain, k);
  }
  // Two rises are alike when they differ by no more than the round-off of the levels that they come from.
  const auto [least, most] = std::minmax_element(level_.begin(), level_.end());
  const double round_off = 4e-16 * std::max(std::abs(*least), std::abs(*most));
  alike_.resize(cells);
  for (std::size_t k = cells; k-- > 0;) {
    const bool jumps = place_[k] != 0.5 * (faces[k] + faces[k + 1]);
    const bool same = !jumps && k + 1 < cells && std::abs(rise_[k + 1] - rise_[k]) <= round_off &&
                      place_[k + 1] == 0.5 * (faces[k + 1] + faces[k + 2]);
    alike_[k] = jumps ? static_cast<std::int64_t>(k) : same ? alike_[k + 1] : static_cast<std::int64_t>(k) + 1;
  }
  tabulate_share();
}

// Halves the cell again and again towards the larger difference: a smooth bed loses its difference, a jump keeps it.
void SmoothedBed::find_jump(const Terrain& terrain, std::size_t cell) {
  double a = low_ + spacing_ * static_cast<double>(cell), b = a + spacing_;
  double at_a = level_[cell], at_b = level_[cell + 1];
  const double difference = std::abs(at_b - at_a);
  for (int halving = 0;; ++halving) {
    const double middle = a + (b - a) / 2;
    if (!(middle > a && middle < b)) break;
    double at_middle = 0;
    terrain.bed(1, &middle, nullptr, &at_middle, nullptr, nullptr);
    if (std::abs(at_middle - at_a) > std::abs(at_b - at_middle)) {
      b = middle;
      at_b = at_middle;
    } else {
      a = middle;
      at_a = at_middle;
    }
    if (halving >= 5 && std::abs(at_b - at_a) < 0.5 * difference) return;
  }
  place_[cell] = b;
}

// C(q): the part of the kernel that lies left of q smoothing lengths from its centre.
void SmoothedBed::tabulate_share() {
  constexpr std::array<double, 2> node{0.33998104358485626, 0.86113631159405258};
  constexpr std::array<double, 2> weight{0.65214515486254614, 0.34785484513745386};
  const double width = 2 * support_ / share_cells;
  share_.assign(share_cells + 1, 0.0);
  for (std::size_t k = 0; k < share_cells; ++k) {
    const double middle = -support_ + width * (static_cast<double>(k) + 0.5);
    std::array<double, 4> r{}, one{1, 1, 1, 1}, w{};
    for (std::size_t m = 0; m < 2; ++m) {
      r[2 * m] = std::abs(middle - 0.5 * width * node[m]);
      r[2 * m + 1] = std::abs(middle + 0.5 * width * node[m]);
    }
    kernel_(4, r.data(), one.data(), w.data());
    share_[k + 1] = share_[k] + 0.5 * width * (weight[0] * (w[0] + w[1]) + weight[1] * (w[2] + w[3])) / integral_;
  }
  for (double& s : share_) s /= share_.back();
}

double SmoothedBed::share(double q) const {
  if (q <= -support_) return 0;
  if (q >= support_) return 1;
  const double width = 2 * support_ / share_cells, at = (q + support_) / width;
  const auto k = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(share_cells - 1));
  const double t = at - static_cast<double>(k);
  const std::array<double, 2> r{std::abs(-support_ + width * static_cast<double>(k)),
                                std::abs(-support_ + width * static_cast<double>(k + 1))};
  const std::array<double, 2> one{1, 1};
  std::array<double, 2> w{};
  kernel_(2, r.data(), one.data(), w.data());
  const double a = share_[k], b = share_[k + 1], slope_a = width * w[0] / integral_, slope_b = width * w[1] / integral_;
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * slope_a + (3 * t2 - 2 * t3) * b + (t3 - t2) * slope_b;
}

SmoothedBed::Window SmoothedBed::window(double x, double reach) const {
  const auto cells = static_cast<double>(rise_.size());
  const double first = std::clamp(std::floor((x - reach - low_) / spacing_), 0.0, cells);
  const double last = std::clamp(std::ceil((x + reach - low_) / spacing_), 0.0, cells);
  return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

std::optional<double> SmoothedBed::constant_slope(double x, double reach, Window cells) const {
  if (cells.first >= cells.last) return 0.0;
  const auto first = static_cast<std::size_t>(cells.first);
  if (alike_[first] < cells.last) return std::nullopt;
  const double end = low_ + spacing_ * static_cast<double>(rise_.size());
  // a support that ends beyond the lattice feels flat bed there
  if (rise_[first] == 0 || (x - reach >= low_ && x + reach <= end)) return rise_[first] / spacing_;
  return std::nullopt;
}

template <class Value, class Place>
double SmoothedBed::mean(double x, double smoothing_length, Window range, const Value& value,
                         const Place& place) const {
  std::array<double, batch> r{}, inverse{}, w{};
  std::fill(inverse.begin(), inverse.end(), 1 / smoothing_length);
  double sum = 0;
  for (std::int64_t k = range.first; k < range.last; k += batch) {
    const std::int64_t n = std::min(batch, range.last - k);
    for (std::int64_t m = 0; m < n; ++m) {
      r[static_cast<std::size_t>(m)] = std::abs(x - place(static_cast<std::size_t>(k + m)));
    }
    std::fill(r.begin() + n, r.end(), 2 * support_ * smoothing_length);
    kernel_((n + 7) / 8 * 8, r.data(), inverse.data(), w.data());
    for (std::int64_t m = 0; m < n; ++m) {
      sum += value(static_cast<std::size_t>(k + m)) * w[static_cast<std::size_t>(m)];
    }
  }
  return sum / integral_;
}

double SmoothedBed::slope(double x, double smoothing_length) const {
  const double reach = support_ * smoothing_length;
  const Window cells = window(x, reach);
  if (const auto same = constant_slope(x, reach, cells)) return *same;
  return mean(
      x, smoothing_length, cells, [&](std::size_t k) { return rise_[k]; }, [&](std::size_t k) { return place_[k]; });
}

// From face to face the slope of the lattice jumps; those jumps, averaged.
double SmoothedBed::curvature(double x, double smoothing_length) const {
  const double reach = support_ * smoothing_length;
  const Window cells = window(x, reach);
  if (constant_slope(x, reach, cells)) return 0;
  const auto rise = [&](std::size_t k) { return k < rise_.size() ? rise_[k] : 0.0; };
  return mean(
      x, smoothing_length, {cells.first, cells.last + 1},
      [&](std::size_t k) { return (rise(k) - (k > 0 ? rise_[k - 1] : 0.0)) / spacing_; },
      [&](std::size_t k) { return low_ + spacing_ * static_cast<double>(k); });
}

double SmoothedBed::level(double x, double smoothing_length) const {
  const auto [first, last] = window(x, support_ * smoothing_length);
  double sum = level_[static_cast<std::size_t>(first)];
  for (std::int64_t k = first; k < last; ++k) {
    const auto cell = static_cast<std::size_t>(k);
    if (rise_[cell] != 0) sum += rise_[cell] * share((x - place_[cell]) / smoothing_length);
  }
  return sum;
}

}  // namespace riffle
