// Run-up of a solitary wave on a plane beach, after Synolakis (1987): the highest level above the water at rest that a wave of
// height H, from water of depth d, reaches on a slope of angle beta,
//
//   R / d = 2.831 sqrt(cot beta) (H / d)^(5/4)          for sqrt(H / d) well above 0.288 tan beta, and waves that do not break
//
// 2.831 is 8 sqrt(pi sqrt 3) max_x sum_n (-1)^(n+1) n^(3/2) x^n, of linear waves over a level bottom and the nonlinear
// shoreline of Carrier and Greenspan. A wave breaks as it runs up where H / d is above 0.8183 (cot beta)^(-10/9); then, and on
// rough or porous slopes, it stays below this law.
#pragma once

#include <cmath>

namespace riffle::run_up {

inline double solitary_wave(double height, double depth, double cot_beta) {
  return depth * 2.831 * std::sqrt(cot_beta) * std::pow(height / depth, 1.25);
}
// Largest height [m] of a wave that does not break on its way up.
inline double breaking_height(double depth, double cot_beta) {
  return depth * 0.8183 * std::pow(cot_beta, -10.0 / 9);
}
inline bool is_valid(double height, double depth, double cot_beta) {
  return std::sqrt(height / depth) > 0.288 / cot_beta && height < breaking_height(depth, cot_beta);
}

}  // namespace riffle::run_up
