// Steady flow through porous blocks, by the filter velocity U = phi u and the hydraulic gradient i = a U + b U^2 of
// riffle/porous_drag.hpp: a = k1 / (g phi) [s/m], b = k2 / (g phi^2) [s2/m2].
//
//   uniform     i given:  U = 2 i / (a + sqrt(a^2 + 4 b i))
//   a block     between two levels of water, after Dupuit, on a level bottom and without a seepage face:
//               -dh/dx = a Q / h + b Q^2 / h^2,   x(h) = 1/(a Q) [ H^2/2 - e H + e^2 ln(H + e) ] from H = h to h_up,  e = b Q/a
//
// The integral is taken by quadrature, which does not cancel where e is large. Not in it: curved flow near the faces, and the
// seepage face where the water leaves above the tail water.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "riffle/porous_drag.hpp"

namespace riffle {

struct HydraulicGradient {
  double linear = 0, quadratic = 0;  // a, b
  HydraulicGradient(porous_drag::Coefficients k, double porosity, double gravity)
      : linear(k.linear / (gravity * porosity)), quadratic(k.quadratic / (gravity * porosity * porosity)) {}
  [[nodiscard]] double operator()(double filter_velocity) const {
    return (linear + quadratic * std::abs(filter_velocity)) * filter_velocity;
  }
  [[nodiscard]] double filter_velocity(double gradient) const {
    const double size = std::abs(gradient);
    return 2 * gradient / (linear + std::sqrt(linear * linear + 4 * quadratic * size));
  }
};

class BlockSeepage {
 public:
  // Depths of water on the two sides of a block of this length [m], upstream the deeper one.
  BlockSeepage(HydraulicGradient law, double length, double upstream, double downstream)
      : law_(law), length_(length), up_(upstream), down_(downstream) {
    if (!(length > 0 && downstream > 0 && upstream > downstream)) {
      std::ostringstream text;
      text << "seepage runs from more water to less through a block of a length above 0, got depths of " << upstream
           << " m upstream and " << downstream << " m downstream, length " << length << " m";
      throw std::invalid_argument(text.str());
    }
    // The length that a discharge needs falls with it; between twice and half of a first guess, and further if it must.
    double low = law_.filter_velocity((up_ - down_) / length_) * down_, high = low;
    for (int k = 0; k < 200 && distance(low, down_) < length_; ++k) low /= 2;
    for (int k = 0; k < 200 && distance(high, down_) > length_; ++k) high *= 2;
    for (int k = 0; k < 200 && high - low > 1e-16 * high; ++k) {
      discharge_ = 0.5 * (low + high);
      (distance(discharge_, down_) > length_ ? low : high) = discharge_;
    }
  }
  [[nodiscard]] double discharge() const { return discharge_; }  // m2/s
  // Depth at a distance from the upstream face.
  [[nodiscard]] double depth(double x) const {
    if (x <= 0) return up_;
    if (x >= length_) return down_;
    double low = down_, high = up_, h = up_ + (down_ - up_) * x / length_;
    for (int k = 0; k < 100; ++k) {
      const double excess = distance(discharge_, h) - x;  // falls as h grows
      (excess > 0 ? low : high) = h;
      double next = h + excess * law_(discharge_ / h);
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - h) <= 1e-15 * up_) break;
      h = next;
    }
    return h;
  }

 private:
  // From the upstream face to where the depth is h: int dh / i(Q / h).
  [[nodiscard]] double distance(double discharge, double h) const {
    constexpr double point[] = {0.069431844202973712, 0.330009478207571868, 0.669990521792428132, 0.930568155797026288};
    constexpr double weight[] = {0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                                 0.173927422568726929};
    constexpr int panels = 24;
    double sum = 0;
    for (int p = 0; p < panels; ++p) {
      for (int k = 0; k < 4; ++k) {
        sum += weight[k] * (up_ - h) / panels / law_(discharge / (h + (up_ - h) * (p + point[k]) / panels));
      }
    }
    return sum;
  }

  HydraulicGradient law_;
  double length_, up_, down_, discharge_ = 0;
};

}  // namespace riffle
