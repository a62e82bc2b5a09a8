// Standard Parshall flumes: a level floor that narrows, a throat of constant width whose floor falls, and a widening whose
// floor rises again. Dimensions in m after ASTM D1941, ISO 9826 and the Water Measurement Manual of the U.S. Bureau of
// Reclamation, chapter 8 (tabulated with its sources in cases/parshall/standard-dimensions.csv).
//
//        D |\_______________________/| C      plan          level, relative to the crest at the entrance of the throat:
//          |  converging|throat|wide |                      0 upstream, -drop at the end of the throat, -end_drop at the end
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace riffle {

struct ParshallFlume {
  double throat_width;           // W
  double converging_length;      // B, along the axis
  double width_downstream;       // C
  double width_upstream;         // D
  double throat_length;          // F
  double diverging_length;       // G
  double end_drop, throat_drop;  // K, N: below the crest

  // The standard flume of that throat, to the millimetre; throws std::invalid_argument with one sentence otherwise.
  static const ParshallFlume& standard(double throat_width) {
    static constexpr ParshallFlume flumes[] = {{0.229, 0.864, 0.380, 0.575, 0.305, 0.457, 0.076, 0.114},
                                               {0.305, 1.344, 0.610, 0.845, 0.610, 0.915, 0.076, 0.229},
                                               {0.457, 1.420, 0.762, 1.026, 0.610, 0.915, 0.076, 0.229},
                                               {0.610, 1.496, 0.915, 1.207, 0.610, 0.915, 0.076, 0.229},
                                               {0.915, 1.645, 1.220, 1.572, 0.610, 0.915, 0.076, 0.229},
                                               {1.220, 1.795, 1.525, 1.938, 0.610, 0.915, 0.076, 0.229},
                                               {1.525, 1.941, 1.830, 2.303, 0.610, 0.915, 0.076, 0.229},
                                               {1.830, 2.090, 2.135, 2.667, 0.610, 0.915, 0.076, 0.229},
                                               {2.135, 2.240, 2.440, 3.030, 0.610, 0.915, 0.076, 0.229},
                                               {2.440, 2.392, 2.745, 3.400, 0.610, 0.915, 0.076, 0.229}};
    for (const ParshallFlume& flume : flumes) {
      if (std::abs(flume.throat_width - throat_width) < 1e-3) return flume;
    }
    std::ostringstream text;
    text << "throat_width is " << throat_width << " m, but a standard Parshall flume has one of";
    for (const ParshallFlume& flume : flumes) text << (&flume == flumes ? " " : ", ") << flume.throat_width;
    text << " m";
    throw std::invalid_argument(text.str());
  }
};

}  // namespace riffle
