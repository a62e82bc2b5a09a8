// Eddy viscosity after Smagorinsky, of eddies that are smaller than the spacing of the particles (SPS):
//
//   nu_t = (C_s Delta)^2 |S|,   |S| = sqrt(2 S:S)                          Kazemi (2017) eq. 2.17, Gotoh et al. (2001)
//
// Delta is the spacing of the particles at t = 0, or the filter width that is given. With sqrt(S:S) in place of |S| a
// channel would run 10 % faster.
// Not in it: the larger eddies, which the particles must resolve. Over a bed whose roughness is only a drag there are none:
// the flow of a rough channel then keeps accelerating, several times beyond what the mixing length gives. Use that there.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Smagorinsky {
  static constexpr auto id = "smagorinsky", kind = "turbulence", version = "1.0.0";
  static constexpr auto summary = "Eddy viscosity of eddies below the particle spacing, after Smagorinsky";
  static constexpr auto source = "Smagorinsky (1963); Gotoh et al. (2001); Kazemi (2017) eq. 2.17";
  static constexpr auto leaves_out =
      "eddies that the particles do not resolve although they are larger than the spacing";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;

  static constexpr riffle_parameter parameters[] = {
      riffle::real("coefficient", "1", 0.15, 0, 2, "C_s: 0.1 to 0.2, 0.065 near walls"),
      riffle::real("filter_width", "m", 0, 0, 1e3, "Delta; 0: the spacing of the particles at t = 0")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::strain_rate), riffle::at_i(f::cell_measure)};
  static constexpr riffle_write writes[] = {riffle::set(f::eddy_viscosity)};

  explicit Smagorinsky(const riffle::Values& v)
      : coefficient(v.number("coefficient")), width(v.number("filter_width")) {}

  void run(const riffle::Block& b) const {
    const double *strain = b.in(0), *cell = b.in(1);
    double* eddy_viscosity = b.out(0);
    for (std::int64_t k = 0; k < b.size(); ++k) {
      const double delta = width > 0 ? width : b.dim() == 2 ? std::sqrt(cell[k]) : std::cbrt(cell[k]);
      eddy_viscosity[k] = coefficient * coefficient * delta * delta * strain[k];
    }
  }
  double coefficient, width;
};

RIFFLE_PLUGIN(Smagorinsky)
