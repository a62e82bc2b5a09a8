// Serre (Green-Naghdi) equations from a discrete Lagrangian: shallow water with the pressure of vertical
// acceleration, which makes waves disperse. With what swe-variational has (riffle/variational_shallow.hpp),
//
//   L = sum_i V_i [ u_i^2 / 2 + (dh_i/dt)^2 / 6 - g h_i / 2 ],     dh_i/dt = sum_j D_ij u_j,   D_ij = dh_i / dx_j
//   (V + 1/3 D^T V D) a = V a_hydrostatic - 1/3 D^T V Q,           Q = (dD/dt) u
//
// one symmetric positive definite banded solve per evaluation. Momentum is kept to round-off (D 1 = 0), energy to the error
// in time. In the continuum 1/3 h^2 (D a + Q) = B1 + B2 + B3, the Boussinesq terms of Diwakar & Mohapatra (2024) eqs 1-3
// over h: following the water, B1 + B2 = -(h^3 / 3) D(u_x)/Dt, and a_x = D(u_x)/Dt + u_x^2. `terms` takes any of the three:
//
//   N = h^2 / 3 [ t1 D a + (t1 + t3) Q / 2 + (t1 - t2) h u u_xx ]          (all three: D a + Q)
//
// Single terms are not invariant under a moving frame, and B3 without B1 is backward diffusion wherever the flow expands.
// Slope and curvature of a bed take part in the vertical acceleration with all three terms (riffle/bed_motion.hpp).
// With eta = 1 and the cubic spline it is cheapest and best. Not in it: a varying width; friction acts outside the solve.
// Where it fails: dam breaks of depth ratio 0.3 and below without `breaking`; water of very different volumes side by side.
#include <algorithm>
#include <cmath>
#include <riffle/bed_motion.hpp>
#include <riffle/dispersion_system.hpp>
#include <riffle/variational_shallow.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace f = riffle::fields;
namespace v = riffle::variational;

struct Serre {
  static constexpr auto id = "serre", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Serre equations: shallow water with dispersion, one banded solve per evaluation";
  static constexpr auto source =
      "Serre (1953); Green & Naghdi (1976); terms after Diwakar & Mohapatra (2024) eqs 1-3, in consistent form";
  static constexpr auto leaves_out = "varying width";
  static constexpr std::uint32_t dims = 1u << 1;

  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.8, 10,
                        "eta: smoothing length over spacing, everywhere and always; 1 or 2"),
      riffle::real("support_tolerance", "1", 1e-8, 1e-14, 1e-3, "relative error of l A = eta V that is left"),
      riffle::integer("support_iterations", 50, 1, 1000, "largest number of Newton iterations per evaluation"),
      riffle::choice("terms", "B1+B2+B3|B1+B2|B1+B3|B2+B3|B1|B2|B3|none", "B1+B2+B3",
                     "which terms of the vertical acceleration; in a manifest also [\"B1\", \"B2\"]"),
      riffle::boolean("allow_ill_posed", false, "run B3 without B1, which is ill-posed where the flow expands"),
      riffle::choice("bed_terms", "on|off", "on",
                     "off: the bed acts by gravity alone, as it does with fewer than all three terms"),
      riffle::choice("dispersion", "everywhere|where-needed|off", "everywhere",
                     "where the terms act; where-needed: where the non-hydrostatic ratio is above `threshold`"),
      riffle::real("threshold", "1", 0.001, 0, 10,
                   "where-needed: ratio 2 |d2h/dt2| / (3 g) above which the terms act; 0.01 is coarser"),
      riffle::real("buffer", "1", 2, 0, 1000, "where-needed: depths by which that region is widened"),
      riffle::real("rest", "1", 1e-8, 0, 1e-3,
                   "where-needed: water at rest stays so, and costs nothing, below this acceleration over g"),
      riffle::choice("breaking", "off|on", "off",
                     "on: hydrostatic, and more viscous, where water rises too fast, as in a bore that breaks"),
      riffle::real("breaking_start", "1", 0.5, 0, 10, "dh/dt over sqrt(g h) at which water begins to break"),
      riffle::real("breaking_stop", "1", 0.15, 0, 10, "and below which it no longer breaks"),
      riffle::real("breaking_alpha", "1", 1, 0, 10, "linear viscosity where water breaks"),
      riffle::real("breaking_beta", "1", 2, 0, 10, "quadratic viscosity where water breaks")};
  static constexpr riffle_field initial[] = {f::depth, f::velocity};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};
  static constexpr riffle_iteration iterations[] = {
      {sizeof(riffle_iteration), 0, "support", &v::support_error, "support_tolerance", "support_iterations"}};
  static constexpr riffle_refusal refuses[] = {
      {sizeof(riffle_refusal), 0, "width", nullptr, "the vertical acceleration is derived for a constant width"},
      {sizeof(riffle_refusal), 0, "boundary", "inflow", "its particles have no part in the solve; use mirror-wall"},
      {sizeof(riffle_refusal), 0, "boundary", "outflow", "its particles have no part in the solve; use mirror-wall"}};

  static constexpr riffle_field hydrostatic =
      riffle::vector_field("hydrostatic_acceleration", "m.s-2",
                           "acceleration without the pressure of vertical acceleration", RIFFLE_ACCUMULATES);
  static constexpr const riffle_field& force = hydrostatic;
  static constexpr const riffle_field& pressure = v::pressure_factor;
  static constexpr riffle_field side = riffle::vector_field("side", "1", "1, and -1 for images in a mirror");
  static constexpr riffle_field entry =
      riffle::scalar_field("depth_gradient", "1", "-dh_i / dx_j of a neighbour", RIFFLE_PER_PAIR);
  static constexpr riffle_field diagonal = riffle::scalar_field("own_depth_gradient", "1", "dh_i / dx_i");
  static constexpr riffle_field s_own = riffle::scalar_field("sum_own", "1", "sum V W_x");
  static constexpr riffle_field s_rise = riffle::scalar_field("sum_rise", "m.s-1", "sum V W_x u_ij");
  static constexpr riffle_field s_tt = riffle::scalar_field("sum_tt", "m.s-2", "sum V W_xx u_ij^2");
  static constexpr riffle_field s_tr = riffle::scalar_field("sum_tr", "m.s-1", "sum V (2 W_x + x_ij W_xx) u_ij");
  static constexpr riffle_field s_r = riffle::scalar_field("sum_r", "m", "sum V r W_r");
  static constexpr riffle_field s_rr = riffle::scalar_field("sum_rr", "m", "sum V r^2 W_rr");
  static constexpr riffle_field u_xx = riffle::scalar_field("velocity_curvature", "m.s-1", "depth times u_xx");
  static constexpr riffle_field depth_rate = riffle::scalar_field("depth_rate", "m.s-1", "dh/dt following the water");
  static constexpr riffle_field source_term =
      riffle::scalar_field("dispersion_source", "m.s-2", "what velocities alone give of 3 N / h^2");
  static constexpr riffle_field vertical =
      riffle::scalar_field("vertical_acceleration", "m.s-2", "d2h/dt2 following the water");
  static constexpr riffle_field ratio = riffle::scalar_field(
      "nonhydrostatic_ratio", "1", "2 |d2h/dt2| / (3 g): pressure of vertical acceleration over hydrostatic pressure");
  static constexpr riffle_field active =
      riffle::scalar_field("dispersion_active", "1", "1 where the terms of vertical acceleration act, else 0");
  static constexpr riffle_field breaks = riffle::scalar_field("breaking", "1", "1 where water breaks, else 0");

  struct Sides {
    static constexpr auto pass_name = "sides of mirrors";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure)};
    static constexpr riffle_write writes[] = {riffle::set(side)};
    static void run(const Serre&, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = 1;
    }
  };

  static constexpr auto dispersive = "dispersion=everywhere|where-needed";

  struct Gradients {  // row i of D, but for its diagonal
    static constexpr auto pass_name = "gradients of depth";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
    static constexpr std::uint32_t neighbours = RIFFLE_EITHER;  // as momentum, so that they share its pairs
    static constexpr auto when = dispersive;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::pair(f::separation),
                                            riffle::at_i(f::kernel_gradient), riffle::at_i(v::pressure_factor),
                                            riffle::at_j(side)};
    static constexpr riffle_write writes[] = {riffle::set(entry, RIFFLE_KEEP)};
    static void run(const Serre&, const riffle::Block& b) {
      const double *volume = b.in(0), *dx = b.in(1), *gradient = b.in(2), *factor = b.in(3), *side_j = b.in(4);
      RIFFLE_EACH(k, b) b.out(0)[k] = volume[k] * gradient[k] * factor[k] * dx[k] * side_j[k];
    }
  };
  // All derivatives of A = sum V W in time and l follow from those in r, because W is 1 / l times a shape of r / l:
  // W_l = -(W + r W_r) / l,  W_rl = -(2 W_r + r W_rr) / l,  W_ll = (2 W + 4 r W_r + r^2 W_rr) / l^2.
  struct Derivatives {
    static constexpr auto pass_name = "derivatives of depth";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
    static constexpr std::uint32_t neighbours = RIFFLE_EITHER;  // as momentum, so that they share its pairs
    static constexpr auto when = dispersive;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume),          riffle::difference(f::velocity),
                                            riffle::pair(f::separation),      riffle::pair(f::distance_squared),
                                            riffle::at_i(f::kernel_gradient), riffle::at_i(f::kernel_drr)};
    static constexpr riffle_write writes[] = {riffle::sum(s_own), riffle::sum(s_rise), riffle::sum(s_tt),
                                              riffle::sum(s_tr),  riffle::sum(s_r),    riffle::sum(s_rr)};
    static void run(const Serre&, const riffle::Block& b) {
      const double *volume = b.in(0), *du = b.in(1), *dx = b.in(2), *r2 = b.in(3), *gradient = b.in(4), *w_rr = b.in(5);
      double *own = b.out(0), *rise = b.out(1), *tt = b.out(2), *tr = b.out(3), *first = b.out(4), *second = b.out(5);
      RIFFLE_EACH(k, b) {
        const double slope = volume[k] * gradient[k], bend = volume[k] * w_rr[k], approach = du[k] * dx[k];
        own[k] = slope * dx[k];
        rise[k] = slope * approach;
        tt[k] = bend * du[k] * du[k];
        tr[k] = (2 * slope + bend) * approach;
        first[k] = slope * r2[k];
        second[k] = bend * r2[k];
      }
    }
  };
  struct Curvature {  // u_xx = 2 sum_j V_j / h u_ij F: only where B1 and B2 do not go together
    static constexpr auto pass_name = "curvature of velocity";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
    static constexpr auto when = "terms=B1+B3|B2+B3|B1|B2";
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::difference(f::velocity),
                                            riffle::at_i(f::kernel_gradient)};
    static constexpr riffle_write writes[] = {riffle::sum(u_xx)};
    static void run(const Serre&, const riffle::Block& b) {
      const double *volume = b.in(0), *du = b.in(1), *gradient = b.in(2);
      RIFFLE_EACH(k, b) b.out(0)[k] = 2 * volume[k] * du[k] * gradient[k];
    }
  };

  struct Source {
    static constexpr auto pass_name = "rate of depth";
    static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
    static constexpr auto when = dispersive;
    static constexpr riffle_read reads[] = {riffle::at_i(s_own),
                                            riffle::at_i(s_rise),
                                            riffle::at_i(s_tt),
                                            riffle::at_i(s_tr),
                                            riffle::at_i(s_r),
                                            riffle::at_i(s_rr),
                                            riffle::at_i(v::pressure_factor),
                                            riffle::at_i(f::depth),
                                            riffle::at_i(u_xx, RIFFLE_OPTIONAL),
                                            riffle::at_i(f::velocity)};
    static constexpr riffle_write writes[] = {riffle::set(depth_rate), riffle::set(source_term), riffle::set(diagonal)};
    static void run(const Serre& s, const riffle::Block& b) {
      const double *own = b.in(0), *rise = b.in(1), *tt = b.in(2), *tr = b.in(3), *first = b.in(4), *second = b.in(5);
      const double *factor = b.in(6), *h = b.in(7), *u = b.in(9);
      const double* curvature = b.has(8) ? b.in(8) : nullptr;
      double *dh = b.out(0), *source = b.out(1), *own_gradient = b.out(2);
      const double both = 0.5 * (s.t1 + s.t3), odd = s.t1 - s.t2;
      RIFFLE_EACH(k, b) {
        const double hdot = factor[k] * rise[k], rate = hdot / h[k];  // dl/dt = -l rate: l h is constant
        const double a_l = -(h[k] + first[k]), a_ll = 2 * h[k] + 4 * first[k] + second[k];  // times l, l^2
        const double q = factor[k] * (tt[k] + 2 * tr[k] * rate + (a_ll + 2 * a_l) * rate * rate);
        dh[k] = hdot;
        source[k] = both * q;
        own_gradient[k] = factor[k] * own[k];
      }
      if (curvature != nullptr) RIFFLE_EACH(k, b) source[k] += odd * u[k] * curvature[k];
    }
  };

  static constexpr auto with_bed_terms = "bed_terms=on";

  struct Breaking {  // dissipation of a bore that breaks, in the form of v::Momentum
    static constexpr auto pass_name = "dissipation where water breaks";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
    static constexpr std::uint32_t neighbours = RIFFLE_EITHER;
    static constexpr auto when = "breaking=on";
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume),
                                            riffle::pair(f::separation),
                                            riffle::pair(f::approach),
                                            riffle::pair(f::distance_squared),
                                            riffle::at_i(f::kernel_gradient),
                                            riffle::at_j(f::kernel_gradient),
                                            riffle::at_i(v::dissipation_factor),
                                            riffle::at_j(v::dissipation_factor),
                                            riffle::at_i(f::wave_speed),
                                            riffle::at_j(f::wave_speed),
                                            riffle::mean(f::smoothing_length),
                                            riffle::mean(f::depth),
                                            riffle::at_i(breaks, RIFFLE_PREVIOUS),
                                            riffle::at_j(breaks, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {riffle::sum(hydrostatic)};
    static void run(const Serre& s, const riffle::Block& b) {
      const double *volume = b.in(0), *dx = b.in(1), *approach = b.in(2), *r2 = b.in(3), *fi = b.in(4), *fj = b.in(5);
      const double *qi = b.in(6), *qj = b.in(7), *ci = b.in(8), *cj = b.in(9), *l = b.in(10), *h = b.in(11);
      const double *breaks_i = b.in(12), *breaks_j = b.in(13);
      double* a = b.out(0);
      RIFFLE_EACH(k, b) {
        const double nearing = approach[k] < 0 ? approach[k] : 0.0, share = 0.5 * (breaks_i[k] + breaks_j[k]);
        const double mu = l[k] * nearing / (r2[k] + 0.01 * l[k] * l[k]);
        const double viscous = (-s.alpha * 0.5 * (ci[k] + cj[k]) * mu + s.beta * mu * mu) * share;
        a[k] = -0.5 * volume[k] * dx[k] * viscous * h[k] * (qi[k] * fi[k] + qj[k] * fj[k]);
      }
    }
  };

  struct Solve {
    static constexpr auto pass_name = "solve for acceleration";
    static constexpr auto pass_type = RIFFLE_PASS_GLOBAL;
    static constexpr auto when = dispersive;
    static constexpr riffle_read reads[] = {riffle::pair(entry),
                                            riffle::at_i(diagonal),
                                            riffle::at_i(hydrostatic),
                                            riffle::at_i(source_term),
                                            riffle::at_i(f::volume),
                                            riffle::at_i(f::depth),
                                            riffle::at_i(f::position),
                                            riffle::at_i(depth_rate),
                                            riffle::at_i(ratio, RIFFLE_PREVIOUS),
                                            riffle::at_i(active, RIFFLE_PREVIOUS),
                                            riffle::at_i(breaks, RIFFLE_PREVIOUS),
                                            riffle::at_i(f::velocity),
                                            riffle::at_i(riffle::bed_motion::gradient, RIFFLE_OPTIONAL),
                                            riffle::at_i(riffle::bed_motion::source, RIFFLE_OPTIONAL),
                                            riffle::at_i(riffle::bed_motion::inertia, RIFFLE_OPTIONAL),
                                            riffle::at_i(riffle::bed_motion::push, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration), riffle::set(vertical), riffle::set(ratio),
                                              riffle::set(active), riffle::set(breaks)};
    static void run(const Serre& s, const riffle::Block& b, const riffle_pairs& pairs);
  };
  struct Hydrostatic {
    static constexpr auto pass_name = "hydrostatic acceleration alone";
    static constexpr auto when = "dispersion=off";
    static constexpr riffle_read reads[] = {riffle::at_i(hydrostatic)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const Serre&, const riffle::Block& b) { RIFFLE_EACH(k, b) b.out(0)[k] += b.in(0)[k]; }
  };
  using passes = riffle::Passes<v::Start<Serre>, Sides, v::Section<Serre>, v::Support<Serre>, v::Momentum<Serre>,
                                v::BedSlope<Serre>, Gradients, Derivatives, Curvature, Source,
                                riffle::bed_motion::Pass<Serre>, Breaking, Solve, Hydrostatic>;

  using votes = riffle::Votes<v::Acoustic<Serre>>;

  explicit Serre(const riffle::Values& values)
      : gravity(values.number("gravity")),
        smoothing_ratio(values.number("smoothing_ratio")),
        threshold(values.number("threshold")),
        buffer(values.number("buffer")),
        rest(values.number("rest")),
        start(values.number("breaking_start")),
        stop(values.number("breaking_stop")),
        alpha(values.number("breaking_alpha")),
        beta(values.number("breaking_beta")) {
    const std::string terms = values.word("terms");
    t1 = terms.find("B1") != std::string::npos ? 1 : 0;
    t2 = terms.find("B2") != std::string::npos ? 1 : 0;
    t3 = terms.find("B3") != std::string::npos ? 1 : 0;
    where_needed = std::string(values.word("dispersion")) == "where-needed";
    breaking = std::string(values.word("breaking")) == "on";
    if (t3 != 0 && t1 == 0 && values.number("allow_ill_posed") == 0)
      throw std::invalid_argument("terms = \"" + terms +
                                  "\" is ill-posed in expansion: B3 without B1 is u_t = -(2/3) h^2 u_x u_xx, backward "
                                  "diffusion wherever u_x > 0; add B1, or set allow_ill_posed = true to see it fail");
    if (stop > start) throw std::invalid_argument("breaking_stop must not be above breaking_start");
  }
  void connect(const riffle_services& services) { terrain = services; }

  double gravity, smoothing_ratio, reference_width = 1, threshold, buffer, rest, start, stop, alpha, beta;
  double t1 = 0, t2 = 0, t3 = 0;
  bool where_needed = false, breaking = false;
  riffle_services terrain{};
};

struct Work {
  riffle::DispersionSystem system;
  std::vector<char> quiet, on, broken, wide;
  std::vector<double> product, own, source;
};

void Serre::Solve::run(const Serre& s, const riffle::Block& b, const riffle_pairs& pairs) {
  const std::int64_t n = b.size();
  const double *entries = b.in(0), *own = b.in(1), *given = b.in(2), *source = b.in(3), *volume = b.in(4);
  const double *depth = b.in(5), *x = b.in(6), *rate = b.in(7), *before = b.in(8), *was_active = b.in(9);
  const double *was_breaking = b.in(10), *u = b.in(11);
  double *acceleration = b.out(0), *vertical_out = b.out(1), *ratio_out = b.out(2), *active_out = b.out(3);
  double* breaks_out = b.out(4);
  const auto size = static_cast<std::size_t>(n);
  thread_local Work kept;  // memory from call to call
  Work& work = kept;
  riffle::DispersionSystem& system = work.system;
  const bool over_bed = s.t1 * s.t2 * s.t3 != 0 && b.has(12);
  if (over_bed) {
    work.own.assign(own, own + n);
    work.source.assign(source, source + n);
    RIFFLE_EACH(k, b) work.own[static_cast<std::size_t>(k)] += b.in(12)[k];
    RIFFLE_EACH(k, b) work.source[static_cast<std::size_t>(k)] += b.in(13)[k];
    own = work.own.data();
    source = work.source.data();
  }
  // Water at rest whose acceleration is round-off, or nearly so: it stays at rest, to the last bit.
  work.quiet.assign(size, 0);
  char* quiet = work.quiet.data();
  if (s.where_needed) {
    const double least = s.rest * s.gravity;
    for (std::int64_t i = 0; i < n; ++i) {
      const int still = u[i] == 0 ? 1 : 0, unmoved = std::abs(source[i]) < least ? 1 : 0;
      quiet[i] = static_cast<char>(still & unmoved & (std::abs(given[i]) < least ? 1 : 0));
    }
  }
  system.read(pairs, own, entries, n, work.quiet);
  work.on.assign(size, s.where_needed ? 0 : 1);
  work.product.resize(size);
  std::fill_n(breaks_out, n, 0.0);
  const double to_ratio = 2 / (3 * s.gravity);
  if (s.where_needed) system.multiply(given, work.product.data());
  for (const auto& [first, last] : system.stretches()) {
    char* on = work.on.data();
    if (s.where_needed) {
      const double* product = work.product.data();
      for (std::int64_t i = first; i < last; ++i) {
        const double r = was_active[i] > 0 ? before[i] : to_ratio * std::abs(product[i] + source[i]);
        on[i] = r > s.threshold ? 1 : 0;
      }
      riffle::widen(on, x, depth, s.buffer, first, last, work.wide);
    }
    if (!s.breaking) continue;
    for (std::int64_t i = first; i < last; ++i) {
      const double speed = rate[i] / std::sqrt(s.gravity * depth[i]);
      breaks_out[i] = speed > (was_breaking[i] == 1 ? s.stop : s.start) ? 1 : 0;
    }
    work.broken.assign(size, 0);
    for (std::int64_t i = first; i < last; ++i) work.broken[static_cast<std::size_t>(i)] = breaks_out[i] > 0 ? 1 : 0;
    riffle::widen(work.broken.data(), x, depth, 1, first, last, work.wide);
    for (std::int64_t i = first; i < last; ++i) {
      if (work.broken[static_cast<std::size_t>(i)] == 0) continue;
      on[i] = 0;
      if (breaks_out[i] == 0) breaks_out[i] = 0.999;  // only those that broke themselves go on breaking
    }
  }

  const double* solved =
      system.solve(s.t1, work.on, volume, given, source, over_bed ? b.in(14) : nullptr, over_bed ? b.in(15) : nullptr);
  if (solved == nullptr)
    throw std::runtime_error(s.t3 != 0 && s.t1 == 0
                                 ? "terms with B3 but without B1 are ill-posed in expansion, and the flow has blown up"
                                 : "the matrix of the vertical acceleration is not positive definite: the depth or the "
                                   "gradients of it are no numbers any more");
  system.multiply(solved, vertical_out);
  std::fill_n(ratio_out, n, 0.0);
  std::fill_n(active_out, n, 0.0);
  for (const auto& [first, last] : system.stretches()) {
    const char* on = work.on.data();
    for (std::int64_t i = first; i < last; ++i) {
      const bool rests = quiet[i] != 0 && on[i] == 0;
      acceleration[i] += rests ? 0.0 : solved[i];
      vertical_out[i] = rests ? 0.0 : vertical_out[i] + source[i];
      ratio_out[i] = to_ratio * std::abs(vertical_out[i]);
      active_out[i] = on[i];
    }
  }
}

RIFFLE_PLUGIN(Serre)
