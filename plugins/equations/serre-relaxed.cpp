// Serre equations without a solve: an extra depth eta follows the depth h of each particle like a stiff spring, and its
// inertia is that of the vertical motion. With what swe-variational has (riffle/variational_shallow.hpp),
//
//   L = sum_i V_i [ u_i^2 / 2 + w_i^2 / 6 - g h_i / 2 - lambda / 6 (eta_i / h_i - 1)^2 ],    lambda = stiffness g depth_scale
//   d eta/dt = w,   dw/dt = lambda / h (1 - eta / h),
//   V a = -D^T V [ g / 2 - lambda / 3 (eta / h - 1) eta / h^2 ],   D_ij = dh_i / dx_j
//
// Favrie & Gavrilyuk (2017), an augmented Lagrangian, on particles. All sums are over pairs, so that it serves where a solve
// would be dear; momentum is kept to round-off. The error is of the order of 1 / stiffness (about 0.6 % of the amplitude of a
// solitary wave at 100), and the step shrinks as 1 / sqrt(stiffness). Not in it: slope and curvature of the bed in the vertical
// acceleration; varying width; a start from `depth_rate` other than that given in [initial] (0 by default: water at rest).
// Where it fails: as serre without `breaking`, at dam breaks of depth ratio 0.3 and below.
#include <algorithm>
#include <cmath>
#include <riffle/variational_shallow.hpp>

namespace f = riffle::fields;
namespace v = riffle::variational;

struct SerreRelaxed {
  static constexpr auto id = "serre-relaxed", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Serre equations by a stiff extra depth: dispersion without a solve";
  static constexpr auto source = "Favrie & Gavrilyuk (2017); Serre (1953)";
  static constexpr auto leaves_out = "slope and curvature of the bed in the vertical acceleration; breaking";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;

  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.8, 10,
                        "eta: smoothing length over spacing, everywhere and always; 1 or 2"),
      riffle::real("support_tolerance", "1", 1e-8, 1e-14, 1e-3, "relative error of l^d A = eta^d V that is left"),
      riffle::integer("support_iterations", 50, 1, 1000, "largest number of Newton iterations per evaluation"),
      riffle::required_real("depth_scale", "m", 0, 1e5, "typical depth, for the stiffness", RIFFLE_ABOVE_MIN),
      riffle::real("stiffness", "1", 100, 1, 1e5, "lambda over g depth_scale: error 1 / stiffness, steps its root")};
  static constexpr riffle_field extra =
      riffle::scalar_field("relaxed_depth", "m", "extra depth that follows the depth", RIFFLE_NOT_NEGATIVE);
  static constexpr riffle_field rate = riffle::scalar_field("depth_rate", "m.s-1", "rate of change of relaxed_depth");
  static constexpr riffle_field spring =
      riffle::scalar_field("relaxation", "m.s-2", "rate of change of depth_rate: how fast water is pushed up");
  static constexpr riffle_field initial[] = {f::depth, f::velocity, rate};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr riffle_evolved evolved[] = {
      riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate), riffle::evolved_field(rate, spring),
      riffle::evolved_field(f::position, f::velocity), riffle::evolved_field(extra, rate)};
  static constexpr riffle_iteration iterations[] = {
      {sizeof(riffle_iteration), 0, "support", &v::support_error, "support_tolerance", "support_iterations"}};
  static constexpr riffle_refusal refuses[] = {
      {sizeof(riffle_refusal), 0, "width", nullptr, "the vertical acceleration is derived for a constant width"}};
  static constexpr const riffle_field& force = f::acceleration;
  static constexpr riffle_field total_factor =
      riffle::scalar_field("total_pressure_factor", "1", "pressure of the water over g h / 2, by Omega");
  static constexpr const riffle_field& pressure = total_factor;

  struct Begin {
    static constexpr auto pass_name = "initial relaxed depth";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::depth)};
    static constexpr riffle_write writes[] = {riffle::set(extra)};
    static void run(const SerreRelaxed&, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = b.in(0)[k];
    }
  };
  struct Relax {
    static constexpr auto pass_name = "relaxation";
    static constexpr riffle_read reads[] = {riffle::at_i(extra), riffle::at_i(f::depth),
                                            riffle::at_i(v::pressure_factor)};
    static constexpr riffle_write writes[] = {riffle::set(total_factor), riffle::set(spring)};
    static void run(const SerreRelaxed& s, const riffle::Block& b) {
      const double *eta = b.in(0), *h = b.in(1), *factor = b.in(2), share = 2 * s.lambda / (3 * s.gravity);
      RIFFLE_EACH(k, b) {
        const double inverse = 1 / h[k], stretch = eta[k] * inverse - 1;
        b.out(0)[k] = factor[k] * (1 - share * stretch * eta[k] * inverse * inverse);
        b.out(1)[k] = -s.lambda * inverse * stretch;
      }
    }
  };
  using passes = riffle::Passes<v::Start<SerreRelaxed>, Begin, v::Section<SerreRelaxed>, v::Support<SerreRelaxed>,
                                Relax, v::Momentum<SerreRelaxed>, v::BedSlope<SerreRelaxed>>;

  struct Acoustic {  // of the stiff waves that carry the relaxation
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::wave_speed)};
    static double limit(const SerreRelaxed& s, const riffle::Block& b) {
      const double *l = b.in(0), *c = b.in(1), stiff = s.lambda / 3;
      double least = riffle::infinity;
      for (std::int64_t k = 0; k < b.size(); ++k) least = std::min(least, l[k] / std::sqrt(c[k] * c[k] + stiff));
      return least;
    }
  };
  using votes = riffle::Votes<Acoustic>;

  explicit SerreRelaxed(const riffle::Values& values)
      : gravity(values.number("gravity")),
        smoothing_ratio(values.number("smoothing_ratio")),
        lambda(values.number("stiffness") * gravity * values.number("depth_scale")) {}
  void connect(const riffle_services& services) { terrain = services; }
  double gravity, smoothing_ratio, lambda, reference_width = 1;
  riffle_services terrain{};
};

RIFFLE_PLUGIN(SerreRelaxed)
