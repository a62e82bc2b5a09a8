// Porosity as any function of place: a constant, a formula, or a measured profile from a CSV file,
//
//   porosity = { csv = "bed.csv", z = "z_m", value = "porosity" }        Kazemi (2017) section 4.4.2 gives phi(z) so
//
// Where it jumps, water at rest will not stay at rest: let it vary over a grain diameter, and no less than a particle spacing.
// Not in it: a transition of its own (regions has one).
#include <riffle/porosity.hpp>
#include <riffle/services.hpp>

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
  // A porosity that cannot be is found before the run, on a coarse lattice; between its points the pass finds it.
  void connect(const riffle_services& s) {
    domain.services = &s;
    if (!riffle::has_lattice(s)) return;
    constexpr int points = 24;
    std::array<double, 3> x{};
    const auto at = [&](int a, int k) { return s.low[a] + (s.high[a] - s.low[a]) * (k + 0.5) / points; };
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) {
        for (int k = 0; k < (s.dim == 3 ? points : 1); ++k) {
          x = {at(0, i), at(1, j), s.dim == 3 ? at(2, k) : 0};
          riffle::checked_porosity(porosity(x), x, s.dim);
        }
      }
    }
  }
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
