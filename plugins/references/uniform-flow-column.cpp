// Uniform turbulent flow down a slope over a rough, impermeable bed: the balance of momentum at every height, solved once by
// riffle/column.hpp in less than a millisecond. The least model of such a scene, and its reference.
//
//   d/dz [ (nu + l_m^2 |u'|) u' ] + g S0 - 1/2 C_d W_d(z) u |u| / d_s = 0,   u = 0 at the numerical bed
//
// with spheres of diameter d_s whose crest is at R_d above the numerical bed (Kazemi 2017, eqs 3.2-3.4, 3.17) and a mixing
// length of the whole depth (eqs 2.6, 2.9, 3.8). Of discharge, depth and slope two are given. The printed depths of Table
// 3-1 may be read as that above the numerical bed or as that above the crest of the spheres: `depth_above`.
// The axis x lies along the bed. In the water tau + int_z^H a_d dz = rho g S0 (H - z) holds to round-off.
// Not in it: side walls, secondary currents, a smooth bed's viscous sublayer unless the cells resolve it.
#include <algorithm>
#include <optional>
#include <riffle/column_reference.hpp>
#include <riffle/mixing_length.hpp>
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>
#include <utility>

struct UniformFlowColumn {
  static constexpr auto id = "uniform-flow-column", kind = "reference", version = "1.0.0";
  static constexpr auto summary =
      "Uniform turbulent flow over a rough impermeable bed, from the balance at every height";
  static constexpr auto source = "Kazemi (2017) eqs 3.2-3.8, 3.17 in one dimension; Nezu & Rodi (1986) in eq. 2.9";
  static constexpr auto leaves_out = "side walls, secondary currents, the way to the steady state";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("discharge", "m2.s-1", 0, 0, 1e4, "q per metre of width; two of discharge, depth and slope"),
      riffle::real("depth", "m", 0, 0, 1e4, "H of the water; two of discharge, depth and slope"),
      riffle::real("slope", "1", 0, 0, 1, "S0, sine of the angle of the bed; two of discharge, depth and slope"),
      riffle::choice("depth_above", "bed|crest", "bed", "what the depth is measured from: numerical bed or crest"),
      riffle::real("bed_level", "m", 0, -1e6, 1e6, "level of the numerical bed, where the water is at rest"),
      riffle::real("roughness_height", "m", 0, 0, 1e3,
                   "R_d: the crest of the spheres above the numerical bed; 0: smooth"),
      riffle::real("grain_diameter", "m", 0.024, 0, 1e3, "d_s of the spheres", RIFFLE_ABOVE_MIN),
      riffle::real("drag_coefficient", "1", 1, 0, 100, "C_d of eq. 3.4, which has a factor 1/2 besides"),
      riffle::real("kappa", "1", 0.41, 0, 2, "of the mixing length", RIFFLE_ABOVE_MIN),
      riffle::choice("profile", "nezu-rodi|prandtl", "nezu-rodi",
                     "mixing length: eq. 2.9 (3.8 without wake) or eq. 2.6"),
      riffle::real("coles", "1", 0, 0, 2,
                   "Coles' wake parameter Pi of eq. 2.9; 0 as in eq. 3.8, 0.2 after Nezu & Rodi"),
      riffle::inherited("end", "s", "time.end", 0, 1e9, "of the run, for a warning when it is too short"),
      riffle::integer("cells", 400, 12, 10000, "of the column; the error is of second order"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity"),
      riffle::real("density", "kg.m-3", 1000, 0, 1e5, "of the water", RIFFLE_ABOVE_MIN, "fluid.density"),
      riffle::real("viscosity", "m2.s-1", 1e-6, 0, 1e3, "nu of the water", 0, "fluid.viscosity")};
  static constexpr const auto& gives = riffle::column_gives;

  explicit UniformFlowColumn(const riffle::Values& v)
      : rough(v.number("roughness_height")), density(v.number("density")), end(v.number("end")) {
    const double bed = v.number("bed_level"), d = v.number("grain_diameter"), cd = v.number("drag_coefficient");
    const double kappa = v.number("kappa"), coles = v.number("coles");
    column.gravity = v.number("gravity");
    column.viscosity = v.number("viscosity");
    column.bottom = bed;
    column.cells = static_cast<int>(v.number("cells"));
    if (rough > 0) column.interfaces = {bed + rough};
    column.quadratic_drag = [=, r = rough](double z) {
      return riffle::porous_drag::spheres(z - bed, r, d, cd).quadratic;
    };
    const bool prandtl = v.word("profile") == "prandtl";
    column.mixing_length = [=](double z, double level) {
      return prandtl ? riffle::mixing_length::prandtl(z - bed, level - bed, kappa)
                     : riffle::mixing_length::nezu_rodi(z - bed, level - bed, kappa, coles);
    };
    state.level_name = "depth";
    state.level_datum = v.word("depth_above") == "crest" ? bed + rough : bed;
    if (v.given("discharge")) state.discharge = v.number("discharge");
    if (v.given("depth")) state.level = state.level_datum + v.number("depth");
    if (v.given("slope")) state.slope = v.number("slope");
  }

  void connect(const riffle_services& s) {
    if (state.level && !(*state.level > column.bottom + rough)) {
      std::ostringstream text;
      text << "depth: " << *state.level - column.bottom
           << " m of water above the numerical bed do not cover the roughness "
           << "layer of " << rough << " m; the depth must be larger, or roughness_height smaller";
      throw std::invalid_argument(text.str());
    }
    if (auto found = riffle::channel_flow(column, state)) flow.emplace(std::move(*found), column, density);
    if (!flow) return;
    riffle::warn_of_relaxation<UniformFlowColumn>(s, flow->mean_velocity(), column.gravity * flow->flow().slope(), end);
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    std::fill_n(defined, points.n, std::uint8_t{0});
    if (flow) flow->write(points, values, scales, defined);
  }
  double rough, density, end;
  riffle::Column column;
  riffle::ChannelState state;
  std::optional<riffle::ColumnProfile> flow;  // of the scene; none: nothing to compare with
};

RIFFLE_PLUGIN(UniformFlowColumn)
