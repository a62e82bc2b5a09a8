// Outflow from a channel: a depth, a level, or nothing imposed, as the flow allows, by buffer particles.
//
// Velocities count positive into the domain, so the invariant R = u - 2 c, taken from the third and sixth water particle, leaves it.
//   depth, level     u = R + 2 c_d at the imposed depth; where that is faster than its waves, critical: c = -R / 3, as at a
//                    free overfall. Water enters when the depth outside is larger.
//   non-reflecting   u = (R + R_0) / 2, c = (R_0 - R) / 4, with R_0 = u + 2 c of the water at the end at t = 0
//   free             the water inside goes on outside. Right for supercritical outflow; subcritical it imposes nothing,
//                    and the mean depth drifts (docs/stability.md)
// Supercritical outflow takes nothing from outside: whatever the condition, it leaves as it is, unless the imposed depth
// has the larger specific force: then a bore enters, u = u_in + (d - h_in) sqrt(g (d + h_in) / (2 d h_in)).
// Buffer particles after Diwakar & Mohapatra (2023), fig. 1b: riffle/channel_end.hpp.
// Not in it: slopes of bed and width beyond the end, more dimensions.
#include <cmath>
#include <riffle/channel_end.hpp>
#include <riffle/sdk.hpp>
#include <string>

struct Outflow {
  static constexpr auto id = "outflow", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Open end that imposes a depth or a level, lets waves out, or imposes nothing";
  static constexpr auto source = "Diwakar & Mohapatra (2023) fig. 1b; Riemann invariants as in Vacondio et al. (2012)";
  static constexpr auto leaves_out = "slope of bed and width beyond the end, where the channel goes on as it ends";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::choice("condition", "depth|level|non-reflecting|free", "non-reflecting",
                     "what is imposed: a depth or a water level, nothing but the state at t = 0 outside, or nothing"),
      riffle::function("depth", "m", 0, "with condition = \"depth\""),
      riffle::function("level", "m", 0, "of the water, bed included, with condition = \"level\""),
      riffle::choice("end", "x_min|x_max", "x_max", "which end of the domain"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN)};
  // Behind what the end remembers: velocity and depth at t = 0.
  static constexpr std::int32_t remembered = riffle::ChannelEnd::state_size, state_size = remembered + 2;

  explicit Outflow(const riffle::Values& v)
      : end(v.word("end") == "x_min", RIFFLE_OUTFLOW, v.number("gravity")),
        gravity(v.number("gravity")),
        condition(v.word("condition")) {
    for (const char* name : {"depth", "level"}) {
      if (condition == name && !v.given(name))
        throw std::invalid_argument("condition = \"" + condition + "\" needs a " + name);
      if (condition != name && v.given(name))
        throw std::invalid_argument(std::string("a ") + name + " is given, but condition = \"" + condition +
                                    "\" does not use it");
      if (condition == name) imposed = v.function(name);
    }
  }
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    const riffle::FlowState in = end.inside(e);
    e.state[remembered] = in.velocity;
    e.state[remembered + 1] = in.depth;
    if (imposed != nullptr && supercritical(in)) {
      const double d = depth_at(e), q = in.velocity * in.depth;
      if (end.specific_force(q, d) <= end.specific_force(q, in.depth)) {
        const double froude2 = q * in.velocity / (gravity * in.depth * in.depth);
        throw std::invalid_argument("the outflow is supercritical at t = 0 (velocity " + std::to_string(-in.velocity) +
                                    " m/s at a depth of " + std::to_string(in.depth) + " m) and sweeps a depth of " +
                                    std::to_string(d) +
                                    " m away; use condition = \"free\", or a depth above the conjugate one, " +
                                    std::to_string(0.5 * in.depth * (std::sqrt(1 + 8 * froude2) - 1)) + " m");
      }
    }
    end.impose(e, state(e, in, in));
  }
  void edit(const riffle_editor& e) const { end.impose(e, state(e, end.inside(e), end.at_end(e))); }

  [[nodiscard]] bool supercritical(riffle::FlowState in) const {
    return in.depth > 0 && in.velocity <= -end.wave_speed(in.depth);
  }
  [[nodiscard]] double depth_at(const riffle_editor& e) const {
    const double d = end.value(imposed, e.time) - (condition == "level" ? end.bed() : 0.0);
    if (!(d > 0))
      throw std::invalid_argument("the depth must be above 0, and is " + std::to_string(d) +
                                  " m at t = " + std::to_string(e.time) + " s");
    return d;
  }

  [[nodiscard]] riffle::FlowState state(const riffle_editor& e, riffle::FlowState in, riffle::FlowState at_end) const {
    const double lattice = end.lattice_factor(e), leaving = at_end.velocity - 2 * end.wave_speed(at_end.depth);
    if (imposed == nullptr) {
      if (condition == "free" || supercritical(in)) return in;
      const double entering = e.state[remembered] + 2 * end.wave_speed(lattice * e.state[remembered + 1]);
      const double c = std::max(0.25 * (entering - leaving), 1e-3 * end.wave_speed(in.depth));
      return {c * c / gravity, 0.5 * (leaving + entering)};
    }
    const double d = lattice * depth_at(e);
    if (supercritical(in)) {
      const double q = in.velocity * in.depth;
      if (end.specific_force(q, d) <= end.specific_force(q, in.depth)) return in;
      return {d, in.velocity + (d - in.depth) * std::sqrt(0.5 * gravity * (d + in.depth) / (d * in.depth))};
    }
    const double u = leaving + 2 * end.wave_speed(d);
    if (u >= -end.wave_speed(d)) return {d, u};
    const double c = -leaving / 3;
    return {c * c / gravity, -c};
  }

  riffle::ChannelEnd end;
  double gravity;
  std::string condition;
  const riffle_function* imposed = nullptr;
};

RIFFLE_PLUGIN(Outflow)
