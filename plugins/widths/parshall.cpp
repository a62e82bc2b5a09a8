// The width of a standard Parshall flume along its axis: narrowing to the crest, constant in the throat, widening behind
// it; parallel walls before and after. Dimensions by throat width: riffle/parshall.hpp. It goes with the bed of the same
// name. Not in it: wing walls of the approach, and that the walls' kinks bend the streamlines.
#include <riffle/parshall.hpp>
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct ParshallWidth {
  static constexpr auto id = "parshall", kind = "width", version = "1.0.0";
  static constexpr auto summary = "The width of a standard Parshall flume";
  static constexpr auto source =
      "ASTM D1941; ISO 9826; U.S. Bureau of Reclamation, Water Measurement Manual, chapter 8";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("throat_width", "m", 0.305, 0, 10, "of a standard flume: 0.305 m is the one of 1 ft",
                   RIFFLE_ABOVE_MIN),
      riffle::required_real("crest", "m", -1e6, 1e6, "x of the entrance of the throat")};

  explicit ParshallWidth(const riffle::Values& v)
      : flume(riffle::ParshallFlume::standard(v.number("throat_width"))), crest(v.number("crest")) {}

  void profile(std::int64_t n, const double* x, const double*, double* b, double* slope_x, double* slope_y) const {
    const double narrowing = (flume.throat_width - flume.width_upstream) / flume.converging_length;
    const double widening = (flume.width_downstream - flume.throat_width) / flume.diverging_length;
    riffle::profile_along_x(n, x, b, slope_x, slope_y, [&](double at) {
      const double s = at - crest, beyond = s - flume.throat_length;
      if (s <= -flume.converging_length) return riffle::ProfilePoint{flume.width_upstream, 0};
      if (s <= 0) return riffle::ProfilePoint{flume.throat_width + narrowing * s, narrowing};
      if (beyond <= 0) return riffle::ProfilePoint{flume.throat_width, 0};
      if (beyond <= flume.diverging_length)
        return riffle::ProfilePoint{flume.throat_width + widening * beyond, widening};
      return riffle::ProfilePoint{flume.width_downstream, 0};
    });
  }
  const riffle::ParshallFlume& flume;
  double crest;
};

RIFFLE_PLUGIN(ParshallWidth)
