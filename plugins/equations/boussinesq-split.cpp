// The explicit split of Diwakar & Mohapatra (2024) eqs 6-11 in consistent form: hydrostatic accelerations first, then one
// correction by the Boussinesq terms that they and the velocities give,
//
//   V a = V a_h - 1/3 D^T V (D a_h + Q),     D_ij = dh_i / dx_j,   Q = 2 (dh/dt)^2 / h
//
// which is the first step of a series for serre's (V + 1/3 D^T V D) a = V a_h - 1/3 D^T V Q, and replaces 1 / (1 + k^2 h^2 / 3)
// by 1 - k^2 h^2 / 3 for waves of number k as the particles see them. Every wave with k h > sqrt 3 is then driven away from
// rest instead of back, whatever the time step, and viscosity makes it worse: the scheme is ill-posed unless the spacing is
// above about 0.3 to 0.6 depths. That is looked at when the run begins, and refused with the numbers unless allowed. What the
// paper prints in eqs 6 to 11 is dimensionally inconsistent (docs/theory-serre.md) and cannot be run.
// Not in it: a varying width; a bed but by its gravity. Where grids are coarse enough for it, it is no better than shallow
// water: use serre.
#include <algorithm>
#include <cmath>
#include <riffle/variational_shallow.hpp>
#include <sstream>
#include <stdexcept>

namespace f = riffle::fields;
namespace v = riffle::variational;

struct BoussinesqSplit {
  static constexpr auto id = "boussinesq-split", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Boussinesq terms by an explicit split: ill-posed on fine grids, for comparison";
  static constexpr auto source = "Diwakar & Mohapatra (2024) eqs 6-11, in consistent form";
  static constexpr auto leaves_out = "stability where k h of the finest waves is above sqrt 3; use serre";
  static constexpr std::uint32_t dims = 1u << 1;

  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.8, 10,
                        "eta: smoothing length over spacing, everywhere and always"),
      riffle::real("support_tolerance", "1", 1e-8, 1e-14, 1e-3, "relative error of l A = eta V that is left"),
      riffle::integer("support_iterations", 50, 1, 1000, "largest number of Newton iterations per evaluation"),
      riffle::boolean("allow_ill_posed", false, "run although the finest waves grow, to see it fail")};
  static constexpr riffle_field initial[] = {f::depth, f::velocity};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};
  static constexpr riffle_iteration iterations[] = {
      {sizeof(riffle_iteration), 0, "support", &v::support_error, "support_tolerance", "support_iterations"}};
  static constexpr riffle_refusal refuses[] = {
      {sizeof(riffle_refusal), 0, "width", nullptr, "the vertical acceleration is derived for a constant width"}};

  static constexpr riffle_field hydrostatic =
      riffle::vector_field("hydrostatic_acceleration", "m.s-2",
                           "acceleration without the pressure of vertical acceleration", RIFFLE_ACCUMULATES);
  static constexpr const riffle_field& force = hydrostatic;
  static constexpr const riffle_field& pressure = v::pressure_factor;
  static constexpr riffle_field entry =
      riffle::scalar_field("depth_gradient", "1", "-dh_i / dx_j of a neighbour", RIFFLE_PER_PAIR);
  static constexpr riffle_field largest = riffle::scalar_field(
      "largest_wave_number", "1", "k h of the finest waves as the particles see them, at the start");
  static constexpr riffle_field rise = riffle::scalar_field("depth_rate", "m.s-1", "dh/dt following the water");
  static constexpr riffle_field lift = riffle::scalar_field("depth_acceleration", "m.s-2", "D a_h");
  static constexpr riffle_field term =
      riffle::scalar_field("dispersive_factor", "1", "pressure of the terms over g h / 2");

  struct Gradients {
    static constexpr auto pass_name = "gradients of depth";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::pair(f::separation),
                                            riffle::at_i(f::kernel_gradient), riffle::at_i(v::pressure_factor)};
    static constexpr riffle_write writes[] = {riffle::set(entry, RIFFLE_KEEP)};
    static void run(const BoussinesqSplit&, const riffle::Block& b) {
      const double *volume = b.in(0), *dx = b.in(1), *gradient = b.in(2), *factor = b.in(3);
      RIFFLE_EACH(k, b) b.out(0)[k] = volume[k] * gradient[k] * factor[k] * dx[k];
    }
  };
  struct Waves {  // (D u)_i = i sum_j D_ij sin(k x_ij) for u = exp(i k x): its largest size over k is that of k_e h
    static constexpr auto pass_name = "finest waves";
    static constexpr auto pass_type = RIFFLE_PASS_GLOBAL;
    static constexpr riffle_read reads[] = {riffle::pair(entry), riffle::at_i(f::position), riffle::at_i(f::depth),
                                            riffle::at_i(f::smoothing_length)};
    static constexpr riffle_write writes[] = {riffle::set(largest)};
    static void run(const BoussinesqSplit& s, const riffle::Block& b, const riffle_pairs& pairs) {
      if (s.looked) return;
      const double *x = b.in(1), *h = b.in(2), *l = b.in(3);
      std::int64_t worst = 0;
      for (std::int64_t i = 0; i < b.size(); ++i) {
        b.out(0)[i] = 0;
        bool inside = true;
        for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i] + pairs.count[i]; ++k)
          inside = inside && pairs.neighbour[k] < b.size();
        for (int m = 1; m < 64 && inside; ++m) {
          const double number = 3.141592653589793 * m * s.smoothing_ratio / (64 * l[i]);
          double sum = 0;
          for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i] + pairs.count[i]; ++k)
            sum += b.in(0)[k] * std::sin(number * (x[i] - x[pairs.neighbour[k]]));
          b.out(0)[i] = std::max(b.out(0)[i], std::abs(sum));
        }
        if (b.out(0)[i] > b.out(0)[worst]) worst = i;
      }
      s.looked = true;
      if (s.allow || b.size() == 0 || b.out(0)[worst] <= std::sqrt(3.0)) return;
      std::ostringstream text;
      text.precision(4);
      text << "the explicit split is ill-posed here: the largest k h that the particles see is " << b.out(0)[worst]
           << " at x = " << x[worst] << " m (depth " << h[worst] << " m, spacing " << l[worst] / s.smoothing_ratio
           << " m), and waves beyond sqrt 3 = 1.732 grow whatever the time step; use serre, particles at least "
           << l[worst] / s.smoothing_ratio * b.out(0)[worst] / std::sqrt(3.0)
           << " m apart, or allow_ill_posed = true to see it fail";
      throw std::runtime_error(text.str());
    }
  };
  struct Rates {
    static constexpr auto pass_name = "rates of depth";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume),          riffle::pair(f::separation),
                                            riffle::pair(f::approach),        riffle::at_i(f::kernel_gradient),
                                            riffle::at_i(v::pressure_factor), riffle::difference(hydrostatic)};
    static constexpr riffle_write writes[] = {riffle::sum(rise), riffle::sum(lift)};
    static void run(const BoussinesqSplit&, const riffle::Block& b) {
      const double *volume = b.in(0), *dx = b.in(1), *approach = b.in(2), *gradient = b.in(3), *factor = b.in(4);
      const double* da = b.in(5);
      RIFFLE_EACH(k, b) {
        const double w = volume[k] * gradient[k] * factor[k];
        b.out(0)[k] = w * approach[k];
        b.out(1)[k] = w * dx[k] * da[k];
      }
    }
  };
  struct Term {
    static constexpr auto pass_name = "Boussinesq terms";
    static constexpr riffle_read reads[] = {riffle::at_i(rise), riffle::at_i(lift), riffle::at_i(f::depth),
                                            riffle::at_i(v::pressure_factor), riffle::at_i(largest)};
    static constexpr riffle_write writes[] = {riffle::set(term)};
    static void run(const BoussinesqSplit& s, const riffle::Block& b) {
      const double *rate = b.in(0), *second = b.in(1), *h = b.in(2), *factor = b.in(3), share = 2 / (3 * s.gravity);
      RIFFLE_EACH(k, b) b.out(0)[k] = factor[k] * share * (second[k] + 2 * rate[k] * rate[k] / h[k]);
    }
  };
  struct Correction {
    static constexpr auto pass_name = "correction";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t neighbours = RIFFLE_EITHER;
    static constexpr riffle_read reads[] = {
        riffle::at_j(f::volume),          riffle::pair(f::separation), riffle::at_i(f::kernel_gradient),
        riffle::at_j(f::kernel_gradient), riffle::at_i(term),          riffle::at_j(term)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const BoussinesqSplit& s, const riffle::Block& b) {
      const double *volume = b.in(0), *dx = b.in(1), *fi = b.in(2), *fj = b.in(3), *ti = b.in(4), *tj = b.in(5);
      const double half = -0.5 * s.gravity;
      RIFFLE_EACH(k, b) b.out(0)[k] = half * volume[k] * dx[k] * (ti[k] * fi[k] + tj[k] * fj[k]);
    }
  };
  struct Add {
    static constexpr auto pass_name = "hydrostatic part";
    static constexpr riffle_read reads[] = {riffle::at_i(hydrostatic)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const BoussinesqSplit&, const riffle::Block& b) { RIFFLE_EACH(k, b) b.out(0)[k] += b.in(0)[k]; }
  };
  using passes = riffle::Passes<v::Start<BoussinesqSplit>, v::Section<BoussinesqSplit>, v::Support<BoussinesqSplit>,
                                v::Momentum<BoussinesqSplit>, v::BedSlope<BoussinesqSplit>, Gradients, Waves, Rates,
                                Term, Correction, Add>;

  using votes = riffle::Votes<v::Acoustic<BoussinesqSplit>>;

  explicit BoussinesqSplit(const riffle::Values& values)
      : gravity(values.number("gravity")),
        smoothing_ratio(values.number("smoothing_ratio")),
        allow(values.flag("allow_ill_posed")) {}
  void connect(const riffle_services& services) { terrain = services; }
  double gravity, smoothing_ratio, reference_width = 1;
  bool allow;
  mutable bool looked = false;  // by the global pass alone, which runs on one thread
  riffle_services terrain{};
};

RIFFLE_PLUGIN(BoussinesqSplit)
