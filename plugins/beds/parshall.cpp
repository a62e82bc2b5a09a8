// The floor of a standard Parshall flume along its axis: level up to the crest (the entrance of the throat), falling
// through the throat, rising again in the widening, level behind it. Dimensions by throat width: riffle/parshall.hpp. It
// goes with the width of the same name.
#include <riffle/parshall.hpp>
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct ParshallBed {
  static constexpr auto id = "parshall", kind = "bed", version = "1.0.0";
  static constexpr auto summary = "The floor of a standard Parshall flume";
  static constexpr auto source =
      "ASTM D1941; ISO 9826; U.S. Bureau of Reclamation, Water Measurement Manual, chapter 8";
  static constexpr riffle_parameter parameters[] = {
      riffle::real("throat_width", "m", 0.305, 0, 10, "of a standard flume: 0.305 m is the one of 1 ft",
                   RIFFLE_ABOVE_MIN),
      riffle::required_real("crest", "m", -1e6, 1e6, "x of the entrance of the throat"),
      riffle::real("level", "m", 0, -1e4, 1e4, "level of the crest")};

  explicit ParshallBed(const riffle::Values& v)
      : flume(riffle::ParshallFlume::standard(v.number("throat_width"))),
        crest(v.number("crest")),
        level(v.number("level")) {}

  void profile(std::int64_t n, const double* x, const double*, double* b, double* slope_x, double* slope_y) const {
    const double fall = -flume.throat_drop / flume.throat_length;
    const double rise = (flume.throat_drop - flume.end_drop) / flume.diverging_length;
    riffle::profile_along_x(n, x, b, slope_x, slope_y, [&](double at) {
      const double s = at - crest, beyond = s - flume.throat_length;
      if (s <= 0) return riffle::ProfilePoint{level, 0};
      if (beyond <= 0) return riffle::ProfilePoint{level + fall * s, fall};
      if (beyond <= flume.diverging_length)
        return riffle::ProfilePoint{level - flume.throat_drop + rise * beyond, rise};
      return riffle::ProfilePoint{level - flume.end_drop, 0};
    });
  }
  const riffle::ParshallFlume& flume;
  double crest, level;
};

RIFFLE_PLUGIN(ParshallBed)
