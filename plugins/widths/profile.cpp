// A channel of any width B(x): a function of x in the manifest, as a constant, a formula, piecewise values or a table. It
// must be above 0 throughout the domain, and should have no jumps: the flow is taken as uniform across the channel.
//
// Its slope dB/dx is taken by differences.
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct ProfileWidth {
  static constexpr auto id = "profile", kind = "width", version = "1.0.0";
  static constexpr auto summary = "Channel width as any function of x: formula, piecewise values or table";
  static constexpr auto source = "Given by the manifest";
  static constexpr auto leaves_out = "sloping banks: the section is a rectangle; flow across the channel";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::function("width", "m", 1, "width of the channel along x, above 0", RIFFLE_REQUIRED)};

  explicit ProfileWidth(const riffle::Values& v) : width(*v.function("width")) {}

  void profile(std::int64_t n, const double* x, const double* y, double* value, double* slope_x,
               double* slope_y) const {
    const auto at = [&](std::int64_t count, const double* place, double* out) {
      width.evaluate(width.context, count, place, nullptr, nullptr, 0, out);
    };
    (void)y;
    at(n, x, value);
    if (slope_x != nullptr) riffle::slope_by_differences(n, x, slope_x, at);
    if (slope_y != nullptr) std::fill_n(slope_y, n, 0.0);
  }
  const riffle_function& width;
};

RIFFLE_PLUGIN(ProfileWidth)
