// Steady flow of a given discharge over the bed and through the width of the scene, with friction, controls and jumps:
//
//   dH/dx = -S_f,   H = b + h + q^2 / (2 g h^2),   q = Q / B
//
// solved once, as riffle/steady_channel.hpp says: subcritical from downstream, supercritical from an inlet or a control,
// a jump where their momentum functions meet. It is the reference for steps (which conserve head), humps in all three
// regimes, contractions, flumes by the theory of critical flow, and jumps whose place friction determines.
// Errors are relative to h in depth and to sqrt(g h) in velocity, after eq. 17 of Diwakar & Mohapatra (2023).
// Not in it: side walls (h stands for the hydraulic radius), curved streamlines, the length of a jump.
#include <cmath>
#include <memory>
#include <riffle/sdk.hpp>
#include <riffle/steady_channel.hpp>

namespace f = riffle::fields;

struct SteadyFlow {
  static constexpr auto id = "steady-flow", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Steady flow over the bed and width of the scene: backwater curves, controls, jumps";
  static constexpr auto source =
      "Chow (1959) eq. 9-2 and chapter 15; critical-flow theory of humps, throats and flumes";
  static constexpr auto leaves_out =
      "side walls: h stands for the hydraulic radius; curved streamlines; length of a jump";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("discharge", "m3.s-1", 0, 1e6,
                            "Q along +x; per metre of width where the scene has no width", RIFFLE_ABOVE_MIN),
      riffle::real("depth_upstream", "m", 0, 0, 1e4, "of a supercritical inflow; 0: the inflow is subcritical"),
      riffle::real("depth_downstream", "m", 0, 0, 1e4,
                   "of a subcritical outflow; 0: the water falls freely or leaves supercritical"),
      riffle::real("roughness", "s.m-1/3", 0, 0, 1, "Manning's n"),
      riffle::real("friction_factor", "1", 0, 0, 100, "Darcy's f; for Chezy's C give 8 g / C^2"),
      riffle::integer("intervals", 20000, 10, 10000000, "of the integration along the domain"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit SteadyFlow(const riffle::Values& v) {
    data.discharge = v.number("discharge");
    data.depth_upstream = v.number("depth_upstream");
    data.depth_downstream = v.number("depth_downstream");
    data.roughness = v.number("roughness");
    data.friction_factor = v.number("friction_factor");
    data.intervals = static_cast<int>(v.number("intervals"));
    data.gravity = v.number("gravity");
  }

  void connect(const riffle_services& s) {
    data.low = s.low[0];
    data.high = s.high[0];
    data.bed = [s](double x) {
      double level = 0, slope = 0;
      s.bed(s.context, 1, &x, nullptr, &level, &slope, nullptr);
      return level;
    };
    data.width = [s](double x) {
      double width = 1, slope = 0;
      s.width(s.context, 1, &x, &width, &slope);
      return width;
    };
    channel = std::make_unique<riffle::SteadyChannel>(data);
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    for (std::int64_t k = 0; k < points.n; ++k) {
      const auto state = channel ? channel->at(points.x[0][k]) : riffle::SteadyChannel::State{};
      values[0][k] = state.depth;
      values[1][k] = state.velocity;
      scales[0][k] = state.depth;
      scales[1][k] = std::sqrt(data.gravity * state.depth);
      defined[k] = state.depth > 0 ? 1 : 0;
    }
  }
  riffle::SteadyChannel::Data data;
  std::unique_ptr<riffle::SteadyChannel> channel;  // known when the bed is
};

RIFFLE_PLUGIN(SteadyFlow)
