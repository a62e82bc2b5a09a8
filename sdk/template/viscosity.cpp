// What the model is, in one line; author (year), equation. This one is Monaghan (1992), linear term only:
//
//   viscous_pressure = -alpha c_ij mu for approaching pairs, else 0;   mu = l_ij (u_ij . x_ij) / (r^2 + 0.01 l_ij^2)
//
// viscous_pressure is Pi_ij times the mean density or depth of the pair: the equation set divides by it. It must be the
// same for (i, j) and (j, i), and never negative for an approaching pair; `riffle check` looks at both.
#include <algorithm>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;  // what there is to read and write: riffle/fields.h

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "viscosity", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation";
  static constexpr auto leaves_out = "what the model does not contain, and where it fails";

  // name, unit, default, least, largest, meaning
  static constexpr riffle_parameter parameters[] = {
      riffle::real("alpha", "1", 1.0, 0, 100, "linear coefficient: 1 at shocks, 0.01 to 0.1 in smooth flow")};

  // Arrays over pairs, in this order. mean() is of i and j; there are at_i(), at_j(), difference() and pair() as well.
  static constexpr riffle_read reads[] = {riffle::pair(f::approach), riffle::pair(f::distance_squared),
                                          riffle::mean(f::smoothing_length), riffle::mean(f::wave_speed)};
  static constexpr riffle_write writes[] = {riffle::set(f::viscous_pressure)};

  explicit MyPlugin(const riffle::Values& v) : alpha(v.number("alpha")) {}

  void run(const riffle::Block& b) const {
    const double *approach = b.in(0), *r2 = b.in(1), *l = b.in(2), *c = b.in(3);
    double* viscous_pressure = b.out(0);
    RIFFLE_EACH(k, b) {  // a vector loop: select values, do not branch around the formula
      const double closing = approach[k] < 0 ? approach[k] : 0.0;
      const double mu = l[k] * closing / (r2[k] + 0.01 * l[k] * l[k]);
      viscous_pressure[k] = -alpha * c[k] * mu;
    }
  }

  struct Viscous {  // the largest step that this closure bears; without it, time.cfl times the others' limits holds
    static constexpr auto name = "viscous";
    static constexpr std::uint32_t scaled = 0;  // taken as it is, not multiplied by time.cfl
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::wave_speed)};
    static double limit(const MyPlugin& p, const riffle::Block& b) {
      double least = riffle::infinity;
      for (std::int64_t k = 0; k < b.size(); ++k) least = std::min(least, b.in(0)[k] / (p.alpha * b.in(1)[k]));
      return 0.5 * least;
    }
  };
  using votes = riffle::Votes<Viscous>;
  double alpha;
};

RIFFLE_PLUGIN(MyPlugin)
