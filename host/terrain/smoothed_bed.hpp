// The bed as a summation depth sees it: averaged with the kernel of the particle,
//
//   b_s(x, l) = integral b(X) W(x - X, l) dX,   b_s' = integral b'(X) W(x - X, l) dX.
//
// A lake at rest over a step or a hump is balanced by the slope of this bed, not by that of the bed itself: the particles
// next to a step feel it as far as their kernel reaches. The bed is known by its rises on a fine lattice, each standing in
// the middle of its cell, or where it jumps; a particle sums over the cells within its support, and where the slope is
// constant throughout it (a flat bed above all) it sums nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "host/terrain/terrain.hpp"

namespace riffle {

class SmoothedBed {
 public:
  // W(r, l) of n pairs, with the inverse smoothing length: the kernel plugin.
  using Kernel = std::function<void(std::int64_t n, const double* r, const double* inverse_l, double* w)>;
  // Known from low to high; beyond, the bed is taken to be flat. `spacing`: of the lattice, a small part of the smallest
  // smoothing length. `support`: kappa; `integral`: of W over the line, by which the averages are divided.
  SmoothedBed(const Terrain& terrain, double low, double high, double spacing, Kernel kernel, double support,
              double integral);

  [[nodiscard]] double slope(double x, double smoothing_length) const;
  [[nodiscard]] double level(double x, double smoothing_length) const;
  [[nodiscard]] double curvature(double x, double smoothing_length) const;  // of b_s, at constant smoothing length

 private:
  struct Window {
    std::int64_t first, last;  // cells [first, last) within the support
  };
  [[nodiscard]] Window window(double x, double reach) const;
  // The slope that is the same throughout the support, if it is.
  [[nodiscard]] std::optional<double> constant_slope(double x, double reach, Window cells) const;
  // sum over k in [first, last) of value(k) W(x - place(k), l), over the integral of W
  template <class Value, class Place>
  [[nodiscard]] double mean(double x, double smoothing_length, Window range, const Value& value,
                            const Place& place) const;
  void find_jump(const Terrain& terrain, std::size_t cell);
  void tabulate_share();
  [[nodiscard]] double share(double q) const;

  double low_, spacing_;
  Kernel kernel_;
  double support_, integral_;
  std::vector<double> level_;        // at the faces of the cells
  std::vector<double> rise_;         // over each cell
  std::vector<double> place_;        // of that rise
  std::vector<std::int64_t> alike_;  // the first cell behind this one whose slope is another
  std::vector<double> share_;        // of the kernel left of q = -support ... support
};

}  // namespace riffle
