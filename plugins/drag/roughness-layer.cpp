// Drag of a bed of spheres on the water among them, over the layer between the numerical bed, where the water is at rest, and
// the crest of the spheres:
//
//   a_d = -1/2 C_d W_d u |u| / d_s,   lambda = 1/2 C_d W_d |u| / d_s   [1/s]            Kazemi (2017) eqs 3.3, 3.4, 3.17
//
// W_d is the share of the particle's slice, d_s wide and one spacing thick, that lies in the sphere whose crest is at R_d above
// the bed: without the mean over the spacing the drag would jump as a row of particles passes the crest. The printed stress
// F_d / A_tau is a force per volume: per unit width A_d = l0 and A_tau = d_s l0, so that the spacing drops out of the rest.
// With l0 in place of d_s the drag would grow as the particles are refined.
// R_d is the parameter that matters: d ln U / d ln R_d = -0.8. Table 3-2 of the source has it for twelve flows.
// Not in it: lift, spheres one by one, the dispersion of the flow between them.
#include <cmath>
#include <riffle/height.hpp>
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>
#include <vector>

namespace f = riffle::fields;

struct RoughnessLayer {
  static constexpr auto id = "roughness-layer", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Drag of a bed of spheres in the layer below their crests";
  static constexpr auto source = "Gotoh & Sakai (1999); Kazemi (2017) eqs 3.3, 3.4, 3.17";
  static constexpr auto leaves_out = "lift; single spheres; dispersion of the flow between them";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("roughness_height", "m", 0, 1e3, "R_d: crest of the spheres above the numerical bed"),
      riffle::real("grain_diameter", "m", 0.024, 0, 1e3, "d_s of the spheres", RIFFLE_ABOVE_MIN),
      riffle::real("drag_coefficient", "1", 1, 0, 1e6,
                   "C_d: 0.76 for spheres, 1.36 for cubes; the law has a 1/2 besides"),
      riffle::function("bed_level", "m", 0, "level of the numerical bed")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::position),
                                          riffle::at_i(f::cell_measure)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit RoughnessLayer(const riffle::Values& v)
      : height(v.number("roughness_height")),
        diameter(v.number("grain_diameter")),
        coefficient(v.number("drag_coefficient")),
        bed_level(v.function("bed_level")) {}

  void run(const riffle::Block& b) const {
    const std::vector<double> above = riffle::heights_above(*bed_level, b, 1);
    const double* cell = b.in(2);
    riffle::porous_drag::add(b, [&](std::int64_t k, double speed) {
      const double spacing = b.dim() == 2 ? std::sqrt(cell[k]) : std::cbrt(cell[k]);
      const double z = above[static_cast<std::size_t>(k)];
      return riffle::porous_drag::spheres(z, height, diameter, coefficient, spacing).rate(speed);
    });
  }
  double height, diameter, coefficient;
  const riffle_function* bed_level;
};

RIFFLE_PLUGIN(RoughnessLayer)
