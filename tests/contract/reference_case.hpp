// A shallow-water reference (gives depth and velocity in one dimension), looked at point by point, alone or in a channel.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {

struct WaterState {
  double depth = 0, velocity = 0, depth_scale = 0, velocity_scale = 0;
  bool defined = false;
};

// The scene that a plugin is connected to.
struct Channel {
  double low = 0, high = 1;
  std::function<double(double)> bed = [](double) { return 0.0; }, width = [](double) { return 1.0; };
};

class ReferenceCase {
 public:
  ReferenceCase(const std::string& id, const std::map<std::string, double>& given, Channel channel = {})
      : channel_(std::move(channel)), instance_(plugin("reference", id), 1, given, nullptr) {
    riffle_services services{};
    services.size = sizeof services;
    services.dim = 1;
    services.has_bed = services.has_width = 1;
    services.low[0] = channel_.low;
    services.high[0] = channel_.high;
    services.context = this;
    services.bed = [](const void* context, std::int64_t n, const double* x, const double*, double* level, double*,
                      double*) noexcept {
      for (std::int64_t k = 0; k < n; ++k) level[k] = static_cast<const ReferenceCase*>(context)->channel_.bed(x[k]);
    };
    services.width = [](const void* context, std::int64_t n, const double* x, double* width, double*) noexcept {
      for (std::int64_t k = 0; k < n; ++k) width[k] = static_cast<const ReferenceCase*>(context)->channel_.width(x[k]);
    };
    riffle_error error{sizeof(riffle_error), {}};
    const auto connect = instance_.table().connect;
    if (connect != nullptr && connect(instance_.self(), &services, &error) != RIFFLE_OK) throw Refused(error.message);
  }
  ReferenceCase(const ReferenceCase&) = delete;
  ReferenceCase& operator=(const ReferenceCase&) = delete;

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
  Channel channel_;
  Instance instance_;
};

}  // namespace riffle::contract
