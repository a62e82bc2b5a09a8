// Inflow into a channel: a discharge, and a depth where the flow needs one, imposed by buffer particles.
//
// Subcritical water tells the inlet what happens downstream: the invariant R = u - 2 c, taken from the third and
// sixth water particle, leaves the domain, so with the discharge alone the depth follows from
//   q / h - 2 sqrt(g h) = R,   q = Q / B            (Newton; the root is unique)
// but not below the critical depth (q^2 / g)^(1/3). Supercritical water tells it nothing: depth and discharge are imposed.
// Which of the two holds is found at each step: a depth that makes the inflow supercritical is imposed until the water
// inside is subcritical with a larger specific force q^2 / (g h) + h^2 / 2, that is until a jump has drowned the inlet.
// Buffer particles after Diwakar & Mohapatra (2023), fig. 1b: riffle/channel_end.hpp.
// Not in it: outflow through the inlet (use outflow there), slopes of bed and width beyond the end, more dimensions.
#include <cmath>
#include <riffle/channel_end.hpp>
#include <riffle/sdk.hpp>
#include <string>

struct Inflow {
  static constexpr auto id = "inflow", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Open end that a discharge enters, subcritical or supercritical";
  static constexpr auto source = "Diwakar & Mohapatra (2023) fig. 1b; Riemann invariants as in Vacondio et al. (2012)";
  static constexpr auto leaves_out =
      "water that leaves through it; slope of bed and width beyond the end, where the channel goes on as it ends";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::function("discharge", "m3.s-1", 0, "Q into the domain; per metre of width where the scene has no width",
                       RIFFLE_REQUIRED),
      riffle::function("depth", "m", 0, "depth of supercritical inflow; a subcritical one finds its own"),
      riffle::choice("end", "x_min|x_max", "x_min", "which end of the domain"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN)};
  static constexpr std::int32_t state_size = riffle::ChannelEnd::state_size;

  explicit Inflow(const riffle::Values& v)
      : end(v.word("end") == "x_min", RIFFLE_INFLOW, v.number("gravity")),
        gravity(v.number("gravity")),
        discharge(v.function("discharge")),
        depth(v.given("depth") ? v.function("depth") : nullptr) {}
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    const riffle::FlowState in = end.inside(e);
    if (depth == nullptr && in.depth > 0 && in.velocity > end.wave_speed(in.depth)) {
      throw std::invalid_argument("the flow at its end is supercritical at t = 0 (velocity " +
                                  std::to_string(in.velocity) + " m/s at a depth of " + std::to_string(in.depth) +
                                  " m), so it needs a depth beside the discharge");
    }
    end.impose(e, state(e, in, in));
  }
  void edit(const riffle_editor& e) const { end.impose(e, state(e, end.inside(e), end.at_end(e))); }

  [[nodiscard]] riffle::FlowState state(const riffle_editor& e, riffle::FlowState in, riffle::FlowState at_end) const {
    const double lattice = end.lattice_factor(e), total = end.value(discharge, e.time);
    if (!(total >= 0))
      throw std::invalid_argument("the discharge must not be negative, and is " + std::to_string(total) +
                                  " m3/s at t = " + std::to_string(e.time) + " s; let water out with outflow");
    const double q = lattice * total / end.width();
    const double h = std::max({depth_of(q, at_end.velocity - 2 * end.wave_speed(at_end.depth), in.depth),
                               std::cbrt(q * q / gravity), 1e-6 * in.depth});
    if (depth != nullptr) {
      const double imposed = lattice * end.value(depth, e.time);
      if (!(imposed > 0))
        throw std::invalid_argument("the depth must be above 0, and is " + std::to_string(imposed) +
                                    " m at t = " + std::to_string(e.time) + " s");
      const bool drowned =
          in.velocity < end.wave_speed(in.depth) && end.specific_force(q, h) > end.specific_force(q, imposed);
      if (q / imposed > end.wave_speed(imposed) && !drowned) return {imposed, q / imposed};
    }
    return {h, h > 0 ? q / h : 0.0};
  }

  // h with q / h - 2 sqrt(g h) = invariant.
  [[nodiscard]] double depth_of(double q, double invariant, double guess) const {
    double h = guess > 0 ? guess : std::cbrt(q * q / gravity);
    if (q == 0) return invariant < 0 ? invariant * invariant / (4 * gravity) : 0;
    for (int k = 0; k < 100; ++k) {
      const double f = q / h - 2 * std::sqrt(gravity * h) - invariant;
      const double next = std::max(0.1 * h, h + f / (q / (h * h) + std::sqrt(gravity / h)));
      const bool there = std::abs(next - h) <= 4e-16 * h;
      h = next;
      if (there) break;
    }
    return h;
  }

  riffle::ChannelEnd end;
  double gravity;
  const riffle_function *discharge, *depth;
};

RIFFLE_PLUGIN(Inflow)
