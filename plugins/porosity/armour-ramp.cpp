// Porosity of a gravel bed under an armour layer: phi0 below the trough of the layer, 1 above its crest, and between them a
// linear ramp that cubic splines smooth at both ends: riffle/armour_bed.hpp, Kazemi (2017) section 6.2.1. It is the porosity
// of the reference armour-bed-column with the same words.
// With inflow_porosity it is that at every height up to x = transition_from, and passes linearly to the bed's until
// transition_to: the inlet of Kazemi (2017), section 6.2.4.2, for inflow-porous.
// Not in it: the roughness of the bed along x; the ramp stands for its mean.
#include <riffle/armour_bed.hpp>
#include <riffle/porosity.hpp>
#include <riffle/services.hpp>
#include <string>

struct ArmourRamp {
  static constexpr auto id = "armour-ramp", kind = "porosity", version = "1.0.0";
  static constexpr auto summary = "Porosity of an armoured gravel bed: a smooth ramp between trough and crest";
  static constexpr auto source = "Kazemi (2017) section 6.2.1";
  static constexpr auto leaves_out = "the roughness of the bed along x";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("crest", "m", 1, -1e6, 1e6, "z_c: highest level of the roughness layer", RIFFLE_REQUIRED),
      riffle::real("trough", "m", 0, -1e6, 1e6, "z_t: lowest level of the roughness layer", RIFFLE_REQUIRED),
      riffle::real("middle", "m", 0, -1e6, 1e6, "z_m: middle of the ramp; that of the layer if not given"),
      riffle::real("porosity", "1", 0.22, 0, 1, "phi0 of the bed below the trough", RIFFLE_ABOVE_MIN),
      riffle::real("ramp_fraction", "1", 0.5, 0, 1, "thickness of the ramp over that of the layer", RIFFLE_ABOVE_MIN),
      riffle::real("inflow_porosity", "1", 1, 0, 1, "phi of a porous inlet; none unless given", RIFFLE_ABOVE_MIN),
      riffle::real("transition_from", "m", 0, -1e6, 1e6, "X1: where the porosity of the inlet ends"),
      riffle::real("transition_to", "m", 0, -1e6, 1e6, "X2: from where it is that of the bed")};
  using passes = riffle::PorosityPasses<ArmourRamp>;

  explicit ArmourRamp(const riffle::Values& v)
      : inlet(v.given("inflow_porosity") ? v.number("inflow_porosity") : 0),
        from(v.number("transition_from")),
        to(v.number("transition_to")) {
    if (inlet > 0 && !(from < to))
      throw std::invalid_argument("an inflow_porosity needs transition_from below transition_to, got " +
                                  std::to_string(from) + " m and " + std::to_string(to) + " m");
    bed.trough = v.number("trough");
    bed.crest = v.number("crest");
    bed.middle = v.given("middle") ? v.number("middle") : 0.5 * (bed.trough + bed.crest);
    bed.porosity = v.number("porosity");
    bed.ramp_fraction = v.number("ramp_fraction");
    bed.bottom = bed.trough - 1;  // porosity does not depend on it
  }
  void connect(const riffle_services& s) {
    domain.services = &s;
    riffle::require_level_within_domain(s, "trough", bed.trough);
    riffle::require_level_within_domain(s, "crest", bed.crest);
    check_armour_bed(bed, {});
  }
  [[nodiscard]] double porosity(const std::array<double, 3>& x) const {
    const int up = domain.services != nullptr ? domain.services->dim - 1 : 1;
    const double of_bed = bed.porosity_at(x[static_cast<std::size_t>(up)]);
    if (!(inlet > 0) || x[0] >= to) return of_bed;
    const double part = x[0] <= from ? 0 : (x[0] - from) / (to - from);
    return (1 - part) * inlet + part * of_bed;
  }
  riffle::ArmourBed bed;
  double inlet, from, to;  // none where inlet is 0
  riffle::PorousDomain domain;
};

RIFFLE_PLUGIN(ArmourRamp)
