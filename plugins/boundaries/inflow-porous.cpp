// Inflow of a given discharge through a porous inlet, for flow over and within a permeable bed, whose profile nobody knows.
//
//   U0 = q / (phi_in H_in),   H_in = level - z_b,   p hydrostatic below the level                        Kazemi (2017) eq. 6.8
//
// The same intrinsic velocity at every height, by rows of buffer particles in a medium of one porosity phi_in; the porosity of
// the scene then passes from phi_in to that of the bed (armour-ramp with inflow_porosity and a transition), and the water finds
// its profile within the transition and some depths beyond. The level is higher than the channel's, by what the transition
// costs: phi_in = 0.75 and H_in = H_p + 1.5 (z_ws - z_t) in the source.
// Not in it: water that leaves through it (it is taken out), three dimensions, periodic along x.
#include <riffle/buffer_rows.hpp>
#include <riffle/sdk.hpp>
#include <string>
#include <vector>

struct InflowPorous {
  static constexpr auto id = "inflow-porous", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Open end in the vertical plane with one velocity at every height of a porous inlet";
  static constexpr auto source = "Kazemi (2017) section 6.2.4.2, eq. 6.8";
  static constexpr auto leaves_out = "water that flows back out, three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr std::int32_t state_size = 2;  // depth [m] and rows of the buffer
  static constexpr riffle_parameter parameters[] = {
      riffle::function("discharge", "m2.s-1", 0, "q into the domain, per metre of width", RIFFLE_REQUIRED),
      riffle::function("level", "m", 0, "of the water at the inlet, above that of the channel", RIFFLE_REQUIRED),
      RIFFLE_OPEN_END_PARAMETERS("x_min")};

  explicit InflowPorous(const riffle::Values& v)
      : end(v, RIFFLE_INFLOW), discharge(v.function("discharge")), level(v.function("level")) {}
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    if (e.read(e.context, "porosity", 0) == nullptr)
      throw std::invalid_argument(
          "a porous inlet needs a plugin of kind porosity; use inflow-discharge in clear water");
    const double depth = depth_at(e);
    riffle::BufferRows rows(end, e, depth, std::max(1.0, std::round(depth / riffle::OpenEnd::spacing(e))));
    rows.fill(e);
    impose(e, rows);
    end.press_floor(e, rows.level(), end.add_floor(e));
  }
  void edit(const riffle_editor& e) const {
    if (e.state[1] == 0) return;  // no water at t = 0
    riffle::BufferRows rows(end, e, e.state[0], e.state[1]);
    if (rows.empty())
      throw std::invalid_argument("its buffer particles are gone; it cannot stand beside periodic along x");
    rows.pass_on(e);
    rows.become(e, depth_at(e));
    impose(e, rows);
    check_porosity(e, rows);
    end.press_floor(e, rows.level(), rows.particles());
  }

  [[nodiscard]] double depth_at(const riffle_editor& e) const {
    const double at = end.value(level, 0, e.time);
    if (at > end.bed()) return at - end.bed();
    throw std::invalid_argument("the level must be above the bed at " + std::to_string(end.bed()) + " m, and is " +
                                std::to_string(at) + " m at t = " + std::to_string(e.time) + " s");
  }
  void impose(const riffle_editor& e, riffle::BufferRows& rows) const {
    const double q = end.value(discharge, 0, e.time);
    if (!(q >= 0))
      throw std::invalid_argument("the discharge must not be negative, and is " + std::to_string(q) +
                                  " m2/s at t = " + std::to_string(e.time) + " s");
    double open = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) open += rows.open_height(e, k);
    rows.write(e, std::vector<double>(rows.size(), q / open), {});
    e.state[0] = rows.depth();
    e.state[1] = static_cast<double>(rows.size());
  }
  static void check_porosity(const riffle_editor& e, const riffle::BufferRows& rows) {
    const double lowest = rows.open_height(e, 0), highest = rows.open_height(e, rows.size() - 1);
    if (std::abs(lowest - highest) <= 1e-6 * highest) return;
    throw std::invalid_argument("the porosity must be the same at every height of the inlet, and is " +
                                std::to_string(lowest / rows.height()) + " at the bed and " +
                                std::to_string(highest / rows.height()) +
                                " at the surface; give armour-ramp an inflow_porosity and a transition");
  }

  riffle::OpenEnd end;
  const riffle_function *discharge, *level;
};

RIFFLE_PLUGIN(InflowPorous)
