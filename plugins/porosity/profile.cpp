// Porosity as any function of place: a constant, a formula, or a measured profile from a CSV file,
//
//   porosity = { csv = "bed.csv", z = "z_m", value = "porosity" }        Kazemi (2017) section 4.4.2 gives phi(z) so
//
// Where it jumps, water at rest will not stay at rest: let it vary over a grain diameter, and no less than a particle spacing.
// Not in it: a transition of its own (regions has one).
#include <riffle/porosity.hpp>

struct PorosityProfile {
  static constexpr auto id = "profile", kind = "porosity", version = "1.0.0";
  static constexpr auto summary = "Porosity as a constant, a formula or a table";
  static constexpr auto source = "Kazemi (2017) section 4.4.2";
  static constexpr auto leaves_out = "a transition of its own: a jump of the function is a jump of the porosity";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::function("porosity", "1", 1, "phi of place, above 0 and at most 1", RIFFLE_REQUIRED)};
  using passes = riffle::PorosityPasses<PorosityProfile>;

  explicit PorosityProfile(const riffle::Values& v) : function(v.function("porosity")) {}
  void connect(const riffle_services& s) { domain.services = &s; }
  [[nodiscard]] double porosity(const std::array<double, 3>& x) const {
    const bool space = domain.services != nullptr && domain.services->dim == 3;
    double phi = 1;
    function->evaluate(function->context, 1, &x[0], space ? &x[1] : nullptr, space ? &x[2] : &x[1], 0, &phi);
    return phi;
  }
  const riffle_function* function;
  riffle::PorousDomain domain;
};

RIFFLE_PLUGIN(PorosityProfile)
