// Outflow through an imaginary wall: fixed points beyond the end that push with a hydrostatic pressure and nothing else, the less
// the nearer a particle comes, so that it passes; at the end it is taken out.
//
//   O_a = -(1/rho_a) sum_o F_o V_o (P_a + P_o) grad W,   F_o = (X_o - x_a) / 2 h,   P_o = rho0 g (z_b + H_ow - z_o)
//
// Kazemi (2017) eqs 6.10 to 6.12. Velocity and turbulence beyond the end need not be known, which suits porous beds. The height
// H_ow of the wall takes the place of a level: the one that makes the depth uniform is not that of the water, and the source
// finds it by repeated runs. With `search` it is found while the run goes on: dH_ow/dt = (d1 - d2) / search, with the levels
// at two sections by the pressure there; a surface that falls downstream raises the wall. What it came to is in
// `plugins[].state` of the record. Where the pressure is "dynamic" both P are without the hydrostatic one. A floor of
// particles goes on under the wall.
// F_o leaves little of the push: its mean over a kernel is a quarter, so that P_o must be some seven times the pressure of
// the water, and the wall two to three times as high as it, not "90 to 100 %".
// Where it fails: within a support of the end the flow is not that of the channel. Not in it: water that enters, three
// dimensions.
#include <algorithm>
#include <riffle/open_end.hpp>
#include <riffle/sdk.hpp>
#include <riffle/weakly_compressible.hpp>
#include <string>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct OutflowImaginaryWall {
  static constexpr auto id = "outflow-imaginary-wall", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Open end in the vertical plane behind fixed points that push like still water";
  static constexpr auto source = "Kazemi (2017) section 6.2.4.3, eqs 6.10 to 6.12";
  static constexpr auto leaves_out = "velocity and stresses beyond the end; water that enters; three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr std::int32_t state_size = 1;  // height of the wall [m]
  static constexpr riffle_field wall_push =
      riffle::scalar_field("outlet_pressure", "kg.m-1.s-2", "pressure of an imaginary wall at its points");
  static constexpr riffle_field wall_volume =
      riffle::scalar_field("outlet_volume", "md", "volume of the points of an imaginary wall, 0 above its top");
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("height", "m", 0, 1e4, "H_ow above the bed, at t = 0; two to three depths, by eq. 6.12",
                            RIFFLE_ABOVE_MIN),
      riffle::real("search", "s", 0, 0, 1e6, "time scale of the search for the height of uniform depth; 0: it stays"),
      riffle::real("first_section", "m", 0, -1e6, 1e6, "search: x of the upstream section"),
      riffle::real("second_section", "m", 0, -1e6, 1e6, "search: x of the downstream section"),
      riffle::inherited("reference_level", "m", "equations.reference_level", -1e6, 1e6, "of pressure = dynamic"),
      riffle_parameter{sizeof(riffle_parameter), RIFFLE_CHOICE, 0, 0, "pressure", "1", "of the equations",
                       "full|dynamic", "equations.pressure", 0, 0, 0, "full"},
      RIFFLE_OPEN_END_PARAMETERS("x_max")};

  struct Start {
    static constexpr auto pass_name = "imaginary wall at t = 0";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure)};
    static constexpr riffle_write writes[] = {riffle::set(wall_push), riffle::set(wall_volume)};
    static void run(const OutflowImaginaryWall&, const riffle::Block& b) {
      RIFFLE_EACH(k, b) b.out(0)[k] = b.out(1)[k] = 0;
    }
  };
  struct Push {
    static constexpr auto pass_name = "imaginary wall";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t targets = RIFFLE_FLUID, sources = RIFFLE_PROBE;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient),  riffle::at_j(wall_volume),
                                            riffle::at_i(wc::pair_pressure),   riffle::at_j(wall_push),
                                            riffle::at_i(f::smoothing_length), riffle::at_i(f::position),
                                            riffle::pair(f::separation)};
    static constexpr riffle_write writes[] = {riffle::sum(wc::pair_force)};
    static void run(const OutflowImaginaryWall& s, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *pi = b.in(2), *po = b.in(3), *l = b.in(4), *x = b.in(5, 0);
      const double *dx = b.in(6, 0), *dz = b.in(6, 1), at = s.end.x(), inward = s.end.inward();
      double *ax = b.out(0, 0), *az = b.out(0, 1);
      RIFFLE_EACH(k, b) {
        const double part = inward * (x[k] - at) / (2 * l[k]), low = part > 0 ? part : 0, factor = low < 1 ? low : 1;
        const double a = -factor * (pi[k] + po[k]) * (volume[k] * gradient[k]);
        ax[k] = a * dx[k];
        az[k] = a * dz[k];
      }
    }
  };
  using passes = riffle::Passes<Start, Push>;

  explicit OutflowImaginaryWall(const riffle::Values& v)
      : end(v, RIFFLE_OUTFLOW),
        height(v.number("height")),
        search(v.number("search")),
        first(v.number("first_section")),
        second(v.number("second_section")),
        removed(v.word("pressure") == "dynamic" ? v.number("reference_level") : -1e300),
        rho0(v.number("density")),
        weight(rho0 * v.number("gravity") * std::sqrt(1 - v.number("bed_slope") * v.number("bed_slope"))) {}
  void connect(const riffle_services& s) {
    services = &s;
    end.connect(s);
    if (!(search > 0)) return;
    const double a = end.inside_by(first), b = end.inside_by(second), length = s.high[0] - s.low[0];
    if (!(a > b && b > 0 && a < length))
      throw std::invalid_argument(
          "search needs first_section upstream of second_section, both in the domain; got x = " +
          std::to_string(first) + " m and " + std::to_string(second) + " m");
  }

  void begin(const riffle_editor& e) const {
    e.state[0] = height;
    if (e.count == 0) return;
    const double l = riffle::OpenEnd::spacing(e), top = services->high[1];
    std::int64_t last = 0;
    for (double out = 0.5 * l; out < riffle::OpenEnd::reach(e); out += l) {
      for (double z = end.bed() + 0.5 * l; z < top; z += l) {
        last = e.add(e.context, RIFFLE_PROBE, 0);
        e.write(e.context, "position", 0)[last] = end.x() - end.inward() * out;
        e.write(e.context, "position", 1)[last] = z;
        for (int c = 0; c < 2; ++c) e.write(e.context, "velocity", c)[last] = 0;
        raise(e, last, height);
      }
    }
    end.press_floor(e, end.bed() + height, end.add_floor(e));
  }

  void edit(const riffle_editor& e) const {
    if (search > 0) {
      const double level = e.state[0] + e.dt / search * (end.head_at(e, first) - end.head_at(e, second));
      e.state[0] = std::max(level, riffle::OpenEnd::spacing(e));
      for (std::int64_t k = 0; k < e.count; ++k) {
        if (e.role[k] == RIFFLE_PROBE && end.inside_by(riffle::OpenEnd::read(e, "position", 0)[k]) < 0)
          raise(e, k, e.state[0]);
      }
      end.press_floor(e, end.bed() + e.state[0], e.count);
    }
    if (!end.due(e, RIFFLE_FLUID, false)) return;
    const double* x = riffle::OpenEnd::read(e, "position", 0);
    for (std::int64_t k = 0; k < e.count && e.role[k] == RIFFLE_FLUID; ++k) {
      if (end.inside_by(x[k]) < 0) e.remove(e.context, k);
    }
  }

  // What the wall of height h has at point k: its row counts by the share that is below the top.
  void raise(const riffle_editor& e, std::int64_t k, double h) const {
    const double z = riffle::OpenEnd::read(e, "position", 1)[k], l = riffle::OpenEnd::spacing(e);
    const double below = end.bed() + h - z;
    e.write(e.context, "outlet_volume", 0)[k] = l * l * std::clamp(below / l + 0.5, 0.0, 1.0);
    e.write(e.context, "outlet_pressure", 0)[k] = weight * (std::max(below, 0.0) - std::max(removed - z, 0.0));
  }

  riffle::OpenEnd end;
  double height, search, first, second, removed, rho0, weight;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(OutflowImaginaryWall)
