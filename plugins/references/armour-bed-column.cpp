// Uniform turbulent flow over and within a bed of gravel under an armour layer: the balance of momentum at every height of
// the porous column, solved once by riffle/column.hpp with the bed of riffle/armour_bed.hpp, as in chapter 6 of Kazemi (2017).
//
//   d/dz [ phi (nu + l_m^2 |u'|) u' ] + phi g S0 - phi (k1 u + k2 u |u|) = 0,   u = 0 at the bottom
//
// Below the trough z_t the drag is Ergun's (eq. 6.1), between trough and crest z_c that of single grains (eq. 6.2); the mixing
// length is that of eq. 6.7, and phi(z) the smoothed ramp of section 6.2.1, or any profile. Of discharge, level of the water
// and slope two are given: the printed data have all three, and with them the flow would need a flume wider than the one used.
// Above the crest the stress is rho g S0 (z_ws - z) whatever the bed is: a check, not a result.
// Not in it: side walls, secondary currents, the small stress nu phi'' u (0.05 % of the velocity).
#include <algorithm>
#include <optional>
#include <riffle/armour_bed.hpp>
#include <riffle/column_reference.hpp>
#include <riffle/sdk.hpp>
#include <stdexcept>
#include <utility>

struct ArmourBedColumn {
  static constexpr auto id = "armour-bed-column", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Uniform turbulent flow over and within an armoured gravel bed, at every height";
  static constexpr auto source = "Kazemi (2017) eqs 4.46, 6.1-6.3, 6.7 and section 6.2.1 in one dimension";
  static constexpr auto leaves_out = "side walls, secondary currents, the way to the steady state";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("crest", "m", -1e6, 1e6, "z_c: highest level of the roughness layer"),
      riffle::required_real("trough", "m", -1e6, 1e6, "z_t: lowest level of the roughness layer"),
      riffle::required_real("bottom", "m", -1e6, 1e6, "z_b: level of the wall under the bed"),
      riffle::real(
          "middle", "m", 0, -1e6, 1e6,
          "z_m: middle of the ramp of the porosity; that of the layer if not given, but 5 mm change q by 13 %"),
      riffle::real("discharge", "m2.s-1", 0, 0, 1e4, "q per metre of width; two of discharge, level and slope"),
      riffle::real("flow_rate", "m3.s-1", 0, 0, 1e6, "Q in place of discharge; needs the width"),
      riffle::real("width", "m", 1, 0, 1e4, "of the channel, for flow_rate", RIFFLE_ABOVE_MIN),
      riffle::real("flume_width", "m", 1, 0, 1e4,
                   "with flow_rate, level and slope: warns where they need a wider channel than this",
                   RIFFLE_ABOVE_MIN),
      riffle::real("level", "m", 0, -1e6, 1e6, "z_ws of the water; two of discharge, level and slope"),
      riffle::real("slope", "1", 0, 0, 1, "S0, sine of the angle of the bed; two of discharge, level and slope"),
      riffle::real("porosity", "1", 0.22, 0, 1, "phi0 of the bed below the trough",
                   RIFFLE_ABOVE_MIN | RIFFLE_BELOW_MAX),
      riffle::function("porosity_profile", "1", 1, "phi(z) in place of the ramp between porosity and 1"),
      riffle::required_real("grain_diameter", "m", 0, 1e3, "d50 of the bed", RIFFLE_ABOVE_MIN),
      riffle::real("ramp_fraction", "1", 0.5, 0, 1, "thickness of the ramp over that of the layer", RIFFLE_ABOVE_MIN),
      riffle::real("drag_coefficient", "1", 0.9, 0, 100,
                   "C_d of eq. 6.2, which has lost the factor 1/2 of eq. 3.4: 0.45 puts it back"),
      riffle::real("c1", "1", 150, 0, 1e5, "viscous coefficient of Ergun's law"),
      riffle::real("c2", "1", 1.75, 0, 1e3, "form coefficient of Ergun's law"),
      riffle::real("length_in_bed", "m", 0.002, 0, 10, "l_mb: mixing length in the bed", RIFFLE_ABOVE_MIN),
      riffle::real("length_offset", "m", 0, -100, 100, "Delta z_0: where it begins to grow, above the trough"),
      riffle::required_real("kappa_rough", "1", 0, 2, "kappa_r: its slope in the layer (0.27 B1, 0.15 B2)"),
      riffle::real("kappa_free", "1", 0.22, 0, 2, "kappa_f: its slope above the crest"),
      riffle::inherited("end", "s", "time.end", 0, 1e9, "of the run, for a warning when it is too short"),
      riffle::integer("cells", 400, 16, 10000, "of the column; the error is of second order"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity"),
      riffle::real("density", "kg.m-3", 1000, 0, 1e5, "of the water", RIFFLE_ABOVE_MIN, "fluid.density"),
      riffle::real("viscosity", "m2.s-1", 1e-6, 0, 1e3, "nu of the water", 0, "fluid.viscosity")};
  static constexpr const auto& gives = riffle::column_gives;

  explicit ArmourBedColumn(const riffle::Values& v)
      : bed{v.number("bottom"),
            v.number("trough"),
            v.number("crest"),
            v.number("middle"),
            v.number("ramp_fraction"),
            v.number("porosity"),
            v.number("grain_diameter"),
            v.number("drag_coefficient"),
            v.number("c1"),
            v.number("c2"),
            v.number("length_in_bed"),
            v.number("length_offset"),
            v.number("kappa_rough"),
            v.number("kappa_free"),
            v.number("gravity"),
            v.number("viscosity"),
            {}},
        density(v.number("density")),
        end(v.number("end")),
        middle_given(v.given("middle") || v.given("porosity_profile")),
        cells(static_cast<int>(v.number("cells"))) {
    if (!v.given("middle")) bed.middle = 0.5 * (bed.trough + bed.crest);
    if (v.given("porosity_profile")) {
      bed.profile = [f = v.function("porosity_profile")](double z) {
        const double x = 0;
        double phi = 1;
        f->evaluate(f->context, 1, &x, nullptr, &z, 0, &phi);
        return phi;
      };
    }
    if (v.given("discharge")) state.discharge = v.number("discharge");
    if (v.given("level")) state.level = v.number("level");
    if (v.given("slope")) state.slope = v.number("slope");
    if (!v.given("flow_rate")) return;
    if (v.given("discharge")) throw std::invalid_argument("discharge: give it or flow_rate with width, not both");
    if (!v.given("width") && v.given("flume_width") && v.given("level") && v.given("slope")) {
      measured = v.number("flow_rate");
      flume_width = v.number("flume_width");
      return;
    }
    if (!v.given("width")) {
      throw std::invalid_argument("flow_rate needs the width of the channel (or give discharge, in m2/s)");
    }
    state.discharge = v.number("flow_rate") / v.number("width");
  }

  void connect(const riffle_services& s) {
    riffle::check_armour_bed(bed, state.level);
    const riffle::Column column = bed.column(cells);
    if (auto found = riffle::channel_flow(column, state)) flow.emplace(std::move(*found), column, density);
    if (flow && riffle::has_lattice(s)) warn_of(s);
  }

  void warn_of(const riffle_services& s) const {
    const double q = flow->flow().discharge(), slope = flow->flow().slope();
    riffle::warn_of_relaxation<ArmourBedColumn>(s, flow->mean_velocity(), bed.gravity * slope, end);
    std::ostringstream text;
    text.precision(3);
    if (!middle_given) {
      text << "middle is not given, taken as that of the layer, " << bed.middle << " m";
      riffle::ArmourBed other = bed;
      other.middle = bed.middle + 0.1 * (bed.crest - bed.trough);
      if (other.middle + other.half_ramp() <= bed.crest) {
        const double then = riffle::ColumnFlow::of_slope(other.column(100), flow->flow().level(), slope).discharge();
        const double now = riffle::ColumnFlow::of_slope(bed.column(100), flow->flow().level(), slope).discharge();
        text << "; " << 1e3 * (other.middle - bed.middle) << " mm more change the discharge by "
             << 100 * (then / now - 1) << " %";
      }
      riffle::warn<ArmourBedColumn>(s, text.str());
      text.str("");
    }
    if (measured > 0 && measured / q > flume_width) {
      text << "a flow rate of " << measured << " m3/s at this level and slope needs a width of " << measured / q
           << " m, more than the flume's " << flume_width << " m: the bed is too rough or the slope too small for it";
      riffle::warn<ArmourBedColumn>(s, text.str());
    }
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    std::fill_n(defined, points.n, std::uint8_t{0});
    if (flow) flow->write(points, values, scales, defined);
  }
  riffle::ArmourBed bed;
  riffle::ChannelState state;
  double density, end, measured = 0, flume_width = 0;
  bool middle_given;
  int cells;
  std::optional<riffle::ColumnProfile> flow;  // of the scene; none: nothing to compare with
};

RIFFLE_PLUGIN(ArmourBedColumn)
