// What the porous medium is, in one line; author (year), equation. This one is a bed that thins out upwards:
//
//   phi = 1 - (1 - bed) / 2 (1 - tanh((z - level) / thickness))
//
// A porosity gives phi, above 0 and at most 1, at any place. Let it vary over a particle spacing at least.
#include <cmath>
#include <riffle/porosity.hpp>

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "porosity", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here made up";
  static constexpr auto leaves_out = "what it does not contain";
  static constexpr std::uint32_t dims = 1u << 2;

  static constexpr riffle_parameter parameters[] = {
      riffle::real("bed", "1", 0.4, 0, 1, "porosity deep in the bed", RIFFLE_ABOVE_MIN),
      riffle::real("level", "m", 0.03, -1e6, 1e6, "where half of the grains are gone"),
      riffle::real("thickness", "m", 0.01, 0, 1e6, "of the transition", RIFFLE_ABOVE_MIN)};
  using passes = riffle::PorosityPasses<MyPlugin>;

  explicit MyPlugin(const riffle::Values& v)
      : bed(v.number("bed")), level(v.number("level")), thickness(v.number("thickness")) {}

  // phi at x = {x, z}
  [[nodiscard]] double porosity(const std::array<double, 3>& x) const {
    return 1 - (1 - bed) / 2 * (1 - std::tanh((x[1] - level) / thickness));
  }
  double bed, level, thickness;
  riffle::PorousDomain domain;  // connected to the scene, it lets walls ask for the nearest place within the domain
};

RIFFLE_PLUGIN(MyPlugin)
