// Outflow from a scene in the vertical plane that keeps what it has: water that crosses the end goes on with the velocity and
// the density that it had there, until nobody inside sees it any more.
//
// It imposes nothing. Right for supercritical outflow, from which nothing comes back; with subcritical flow nobody gives the
// level, and an inflow that imposes neither discharge nor level (inflow-averaged) drifts with it.
// Source: Federico et al. (2012); Kazemi (2017) section 3.1.4.1. Not in it: water that enters, three dimensions.
#include <riffle/buffer_water.hpp>
#include <riffle/sdk.hpp>

struct OutflowFrozen {
  static constexpr auto id = "outflow-frozen", kind = "boundary", version = "1.0.0";
  static constexpr auto summary =
      "Open end in the vertical plane where water keeps what it has, and nothing is imposed";
  static constexpr auto source = "Federico et al. (2012); Kazemi (2017) section 3.1.4.1";
  static constexpr auto leaves_out = "a level: subcritical flow drifts; water that enters, three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr riffle_parameter parameters[] = {RIFFLE_OPEN_END_PARAMETERS("x_max")};

  explicit OutflowFrozen(const riffle::Values& v) : end(v, RIFFLE_OUTFLOW) {}
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const riffle::EndProfile in = end.inside(e);
    const double level = end.bed() + in.depth;
    const auto buffer = riffle::fill_beyond(end, e, level);
    const double* z = riffle::OpenEnd::read(e, "position", 1);
    double* u = e.write(e.context, "velocity", 0);
    for (const std::int64_t k : buffer) u[k] = in.at(in.velocity, z[k]);
    end.press_floor(e, level, end.add_floor(e));
  }
  void edit(const riffle_editor& e) const {
    if (e.count == 0) return;
    bool crossed = false;
    riffle::pass_beyond(end, e, RIFFLE_OUTFLOW, crossed);
    end.press_floor(e, end.bed() + end.inside(e).depth, e.count);
  }

  riffle::OpenEnd end;
};

RIFFLE_PLUGIN(OutflowFrozen)
