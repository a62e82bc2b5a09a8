// A shallow-water reference (gives depth and velocity in one dimension), looked at point by point.
#pragma once

#include <map>
#include <string>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {

struct WaterState {
  double depth = 0, velocity = 0, depth_scale = 0, velocity_scale = 0;
  bool defined = false;
};

class ReferenceCase {
 public:
  ReferenceCase(const std::string& id, const std::map<std::string, double>& given)
      : instance_(plugin("reference", id), 1, given) {}
  [[nodiscard]] WaterState at(double x, double time) const {
    WaterState s;
    const riffle_points points{sizeof(riffle_points), 1, 1, {&x, nullptr, nullptr}, time};
    double *const values[] = {&s.depth, &s.velocity}, *const scales[] = {&s.depth_scale, &s.velocity_scale};
    std::uint8_t defined = 2;
    riffle_error error{sizeof(riffle_error), {}};
    const auto status =
        instance_.table().evaluate_reference(instance_.self(), &points, values, scales, &defined, &error);
    if (status != RIFFLE_OK || defined > 1) throw std::runtime_error(error.message);
    s.defined = defined == 1;
    return s;
  }

 private:
  Instance instance_;
};

}  // namespace riffle::contract
