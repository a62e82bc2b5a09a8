// Weakly compressible flow in the vertical plane and in space, over solid and porous beds. Sums in volume form:
// riffle/weakly_compressible.hpp.
//
//   drho_i/dt = (rho_i / phi_i) sum_j V_j (phi_i u_i - phi_j u_j) . x_ij F
//   a_i       = (1/rho_i) (- sum_j V_j (P_i + P_j + rho0 Pi_ij) F x_ij + stress) + g
//   P         = c0^2 (rho - rho0)   or   (rho0 c0^2 / 7) ((rho / rho0)^7 - 1);   stress: riffle/viscous_stress.hpp
//
// With pressure = "dynamic" the hydrostatic pressure below `reference_level` is taken out of the pair forces and out of
// gravity, by its exact gradient: pressure forces on a disordered lattice resist shear a little, like a soft solid, and
// in flow down a mild slope that little is most of the bed stress ("lattice locking"). Source of the equations: Kazemi
// (2017) eqs 3.9-3.11, 4.56, 4.57 with the time levels and signs of the printed ones put right.
// Not in it: surface tension, air; density diffusion is the filter delta-sph; shocks want a viscosity.
#include <algorithm>
#include <riffle/services.hpp>
#include <riffle/viscous_stress.hpp>
#include <riffle/weakly_compressible.hpp>
#include <string>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct Wcsph {
  static constexpr auto id = "wcsph", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Weakly compressible flow in the vertical plane and in space, also in pores";
  static constexpr auto source = "Monaghan (1994); Morris et al. (1997); Kazemi (2017) eqs 3.9-3.11, 4.56, 4.57";
  static constexpr auto leaves_out =
      "surface tension and air; without a filter density rings, without a wall plugin water falls out of the domain";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;

  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("sound_speed", "m.s-1", 0, 1e5,
                            "c0: ten times the largest velocity or sqrt(g H) keeps density within 1 %",
                            RIFFLE_ABOVE_MIN),
      riffle::choice("state", "linear|tait", "linear", "pressure of density: proportional, or Tait's with exponent 7"),
      riffle::choice("pressure", "full|dynamic", "full",
                     "dynamic takes the hydrostatic pressure below reference_level out of pair forces and gravity"),
      riffle::real("reference_level", "m", 0, -1e6, 1e6,
                   "level whose hydrostatic pressure is taken out; a support or so below the surface"),
      riffle::choice("stress", "morris|tensor", "morris",
                     "forces of the eddies, by velocity differences of pairs or by the divergence of their stress"),
      riffle::boolean("laminar", false, "the viscosity of the water acts (fluid.viscosity)"),
      riffle::real("bed_slope", "1", 0, -0.999, 0.999,
                   "S0, the sine of the angle by which the x axis descends: gravity is turned, not the scene"),
      riffle::function("body_force_x", "m.s-2", 0, "what else drives the water along x, per mass"),
      riffle::function("surface", "m", 0, "level of the water for a hydrostatic pressure at t = 0; none: all at rho0"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity"),
      riffle::inherited("density", "kg.m-3", "fluid.density", 0, 1e5, "reference density rho0", RIFFLE_ABOVE_MIN),
      riffle::inherited("viscosity", "m2.s-1", "fluid.viscosity", 0, 1e3, "kinematic viscosity of the water"),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10, "smoothing length over spacing")};
  static constexpr riffle_field initial[] = {f::velocity};
  static constexpr const riffle_field* conserved = &f::mass;
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::density, f::density_rate),
                                               riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};

  struct Start {
    static constexpr auto pass_name = "initial mass and density";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure), riffle::at_i(f::position),
                                            riffle::at_i(f::porosity, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::set(f::mass), riffle::set(f::density),
                                              riffle::set(f::smoothing_length), riffle::set(f::wave_speed),
                                              riffle::set(wc::acoustic_diffusivity)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) {
        const double cell = b.in(0)[k], z = b.in(1, b.dim() - 1)[k];
        const double rho = s.density_at_rest(b.in(1, 0)[k], b.dim() == 3 ? b.in(1, 1)[k] : 0, z);
        b.out(0)[k] = (b.has(2) ? b.in(2)[k] : 1) * rho * cell;
        b.out(1)[k] = rho;
        b.out(2)[k] = s.smoothing_ratio * riffle::particle_spacing(s.services, cell, b.dim());
        b.out(3)[k] = s.c0;
        b.out(4)[k] = s.c0 * b.out(2)[k];
      }
    }
  };

  // Reads and writes of the two passes of state: water by its density, walls by wall_pressure where somebody gives it.
  // The mass of a wall particle is that of water in all of its place, so that V = m / rho in porous walls too.
  struct State {
    static constexpr riffle_read reads[] = {riffle::at_i(f::density), riffle::at_i(f::mass), riffle::at_i(f::position),
                                            riffle::at_i(f::porosity, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::set(wc::particle_volume), riffle::set(wc::pair_pressure),
                                              riffle::set(wc::excess_density), riffle::set(wc::diffusing_volume)};
    static void of(const Wcsph& s, const riffle::Block& b, const double* phi, const double* pressure,
                   double diffusing) {
      const double *rho = b.in(0), *m = b.in(1), *z = b.in(2, b.dim() - 1);
      double *volume = b.out(0), *pair = b.out(1), *excess = b.out(2), *spreading = b.out(3);
      const double stratification = s.stratification, weight = s.rho0 * s.removed_gravity;
      RIFFLE_EACH(k, b) {
        volume[k] = m[k] / rho[k] / (phi != nullptr ? phi[k] : 1.0);
        const double below = s.reference_level - z[k];
        pair[k] = (pressure != nullptr ? pressure[k] : s.pressure_of(rho[k])) - weight * (below > 0 ? below : 0.0);
        excess[k] = rho[k] + stratification * z[k];
        spreading[k] = diffusing * volume[k];
      }
    }
  };
  struct StateOfWater : State {
    static constexpr auto pass_name = "state of water";
    static constexpr std::uint32_t targets = wc::water;
    static void run(const Wcsph& s, const riffle::Block& b) { of(s, b, b.has(3) ? b.in(3) : nullptr, nullptr, 1); }
  };
  struct StateOfWalls : State {
    static constexpr auto pass_name = "state of walls";
    static constexpr std::uint32_t targets = wc::solid;
    static constexpr riffle_read reads[] = {riffle::at_i(f::density), riffle::at_i(f::mass), riffle::at_i(f::position),
                                            riffle::at_i(wc::wall_pressure, RIFFLE_OPTIONAL)};
    static void run(const Wcsph& s, const riffle::Block& b) { of(s, b, nullptr, b.has(3) ? b.in(3) : nullptr, 0); }
  };
  struct Pressure {
    static constexpr auto pass_name = "pressure";
    static constexpr std::uint32_t targets = wc::water;
    static constexpr riffle_read reads[] = {riffle::at_i(f::density)};
    static constexpr riffle_write writes[] = {riffle::set(f::pressure)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      RIFFLE_EACH(k, b) b.out(0)[k] = s.pressure_of(b.in(0)[k]);
    }
  };
  struct RestVolume {
    static constexpr auto pass_name = "volume at rest";
    static constexpr std::uint32_t targets = wc::water;
    static constexpr riffle_read reads[] = {riffle::at_i(f::mass), riffle::at_i(f::porosity, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::set(wc::rest_volume)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      const double* phi = b.has(1) ? b.in(1) : nullptr;
      RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] / ((phi != nullptr ? phi[k] : 1.0) * s.rho0);
    }
  };
  struct RestVolumeOfWalls : RestVolume {
    static constexpr auto pass_name = "volume of walls at rest";
    static constexpr std::uint32_t targets = wc::solid;
    static constexpr riffle_read reads[] = {riffle::at_i(f::mass)};
    static void run(const Wcsph& s, const riffle::Block& b) { RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] / s.rho0; }
  };

  struct Continuity {
    static constexpr auto pass_name = "continuity";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::pair(f::approach)};
    static constexpr riffle_write writes[] = {riffle::sum(wc::velocity_divergence)};
    static void run(const Wcsph&, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *approach = b.in(2);
      double* rate = b.out(0);
      RIFFLE_EACH(k, b) rate[k] = volume[k] * gradient[k] * approach[k];
    }
  };
  // What phi_i u_i - phi_j u_j has beyond phi_i (u_i - u_j), over phi_i: (1 - phi_j / phi_i) u_j, with u_j . x from the
  // particle's own velocity and the approach, so that no velocity is fetched from neighbours twice.
  struct PorousContinuity {
    static constexpr auto pass_name = "continuity across porosity";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::at_i(f::velocity),        riffle::pair(f::separation),
                                            riffle::at_i(f::porosity),        riffle::at_j(f::porosity),
                                            riffle::pair(f::approach)};
    static constexpr riffle_write writes[] = {riffle::sum(wc::velocity_divergence)};
    static void run(const Wcsph&, const riffle::Block& b) { b.dim() == 2 ? across<2>(b) : across<3>(b); }
    template <int Dim>
    static void across(const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *phi_i = b.in(4), *phi_j = b.in(5), *approach = b.in(6);
      const double *u = b.in(2, 0), *v = b.in(2, 1), *w = Dim == 3 ? b.in(2, Dim - 1) : u;
      const double *x = b.in(3, 0), *y = b.in(3, 1), *z = Dim == 3 ? b.in(3, Dim - 1) : x;
      double* rate = b.out(0);
      RIFFLE_EACH(k, b) {
        const double own = u[k] * x[k] + v[k] * y[k] + (Dim == 3 ? w[k] * z[k] : 0.0);
        rate[k] = (1 - phi_j[k] / phi_i[k]) * (volume[k] * gradient[k]) * (own - approach[k]);
      }
    }
  };
  struct Compression {
    static constexpr auto pass_name = "compression";
    static constexpr riffle_read reads[] = {riffle::at_i(f::density), riffle::at_i(wc::velocity_divergence),
                                            riffle::at_i(wc::density_spread, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(f::density_rate)};
    static void run(const Wcsph&, const riffle::Block& b) {
      const double *rho = b.in(0), *divergence = b.in(1), *spread = b.has(2) ? b.in(2) : nullptr;
      RIFFLE_EACH(k, b) b.out(0)[k] += rho[k] * divergence[k] + (spread != nullptr ? spread[k] : 0.0);
    }
  };

  struct Momentum {
    static constexpr auto pass_name = "momentum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::mean(wc::pair_pressure), riffle::pair(f::separation),
                                            riffle::pair(f::viscous_pressure, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(wc::pair_force)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      if (b.dim() == 2)
        b.has(4) ? force<2, true>(s, b) : force<2, false>(s, b);
      else
        b.has(4) ? force<3, true>(s, b) : force<3, false>(s, b);
    }
    template <int Dim, bool Viscous>
    static void force(const Wcsph& s, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *pressure = b.in(2);
      const double *x = b.in(3, 0), *y = b.in(3, 1), *z = Dim == 3 ? b.in(3, Dim - 1) : x;
      const double *viscous = Viscous ? b.in(4) : pressure, rho0 = s.rho0;
      double *ax = b.out(0, 0), *ay = b.out(0, 1), *az = Dim == 3 ? b.out(0, Dim - 1) : ax;
      RIFFLE_EACH(k, b) {
        const double push = Viscous ? 2 * pressure[k] + rho0 * viscous[k] : 2 * pressure[k];
        const double a = -push * (volume[k] * gradient[k]);
        ax[k] = a * x[k];
        ay[k] = a * y[k];
        if (Dim == 3) az[k] = a * z[k];
      }
    }
  };

  // Gravity along and across the bed, what else drives the water, and of gravity only the rest where the hydrostatic
  // pressure is taken out.
  struct BodyForce {
    static constexpr auto pass_name = "body force";
    static constexpr riffle_read reads[] = {riffle::at_i(f::position), riffle::at_i(f::density)};
    static constexpr riffle_write writes[] = {riffle::set(wc::body_force)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      const int last = b.dim() - 1;
      const double *x = b.in(0, 0), *y = last == 2 ? b.in(0, 1) : nullptr, *z = b.in(0, last), *rho = b.in(1);
      double *along = b.out(0, 0), *up = b.out(0, last);
      s.driving->evaluate(s.driving->context, b.size(), x, y, z, b.time(), along);
      const double slope = s.gravity * s.bed_slope, normal = s.normal_gravity, removed = s.removed_gravity * s.rho0;
      const double level = s.reference_level;
      RIFFLE_EACH(k, b) {
        along[k] += slope;
        up[k] = (z[k] < level ? removed / rho[k] : 0.0) - normal;
      }
      if (last == 2) RIFFLE_EACH(k, b) b.out(0, 1)[k] = 0;
    }
  };
  struct Acceleration {
    static constexpr auto pass_name = "acceleration";
    static constexpr riffle_read reads[] = {riffle::at_i(wc::body_force), riffle::at_i(wc::pair_force),
                                            riffle::at_i(f::density)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const Wcsph&, const riffle::Block& b) {
      const double* rho = b.in(2);
      for (int c = 0; c < b.dim(); ++c) {
        const double *g = b.in(0, c), *force = b.in(1, c);
        RIFFLE_EACH(k, b) b.out(0, c)[k] += g[k] + force[k] / rho[k];
      }
    }
  };
  using passes = riffle::Passes<Start, StateOfWater, StateOfWalls, Pressure, RestVolume, RestVolumeOfWalls, Continuity,
                                PorousContinuity, Compression, Momentum, wc::LaminarStress<Wcsph>,
                                wc::EddyStress<Wcsph>, BodyForce, Acceleration, wc::VelocityGradient<Wcsph>,
                                wc::StrainRate<Wcsph>, wc::StressTensor<Wcsph>, wc::StressDivergence<Wcsph>,
                                wc::ModelledShearStress<Wcsph>, wc::VirialShearStress<Wcsph>>;

  struct Acoustic {
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::velocity)};
    static double limit(const Wcsph& s, const riffle::Block& b) {
      double least = riffle::infinity;
      const double *l = b.in(0), *u = b.in(1, 0), *v = b.in(1, 1), *w = b.dim() == 3 ? b.in(1, 2) : u, c0 = s.c0;
      const double third = b.dim() == 3 ? 1.0 : 0.0;
      RIFFLE_EACH_LEAST(k, b, least) {
        const double dt = l[k] / (c0 + std::sqrt(u[k] * u[k] + v[k] * v[k] + third * w[k] * w[k]));
        least = dt < least ? dt : least;
      }
      return least;
    }
  };
  // Measured: with eddy viscosities up to ten times those of a channel, stable to 0.1 l^2 / nu_t.
  struct Eddies {
    static constexpr auto name = "eddies";
    static constexpr std::uint32_t scaled = 0;
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::eddy_viscosity)};
    static double limit(const Wcsph& s, const riffle::Block& b) {
      double least = riffle::infinity;
      const double *l = b.in(0), *eddy = b.in(1), nu = s.laminar ? s.nu : 1e-300;
      RIFFLE_EACH_LEAST(k, b, least) {
        const double dt = 0.1 * l[k] * l[k] / (nu + eddy[k]);
        least = dt < least ? dt : least;
      }
      return least;
    }
  };
  struct Laminar {
    static constexpr auto name = "viscous";
    static constexpr auto when = "laminar=true";
    static constexpr std::uint32_t scaled = 0;
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length)};
    static double limit(const Wcsph& s, const riffle::Block& b) {
      double least = riffle::infinity;
      for (std::int64_t k = 0; k < b.size(); ++k) least = std::min(least, b.in(0)[k]);
      return s.nu > 0 ? 0.1 * least * least / s.nu : riffle::infinity;
    }
  };
  using votes = riffle::Votes<Acoustic, Eddies, Laminar>;

  explicit Wcsph(const riffle::Values& v)
      : c0(v.number("sound_speed")),
        rho0(v.number("density")),
        nu(v.number("viscosity")),
        gravity(v.number("gravity")),
        bed_slope(v.number("bed_slope")),
        normal_gravity(gravity * std::sqrt(1 - bed_slope * bed_slope)),
        stratification(c0 > 0 ? rho0 * normal_gravity / (c0 * c0) : 0),
        reference_level(v.number("reference_level")),
        smoothing_ratio(v.number("smoothing_ratio")),
        laminar(v.flag("laminar")),
        tait(v.word("state") == "tait"),
        driving(v.function("body_force_x")),
        surface(v.given("surface") ? v.function("surface") : nullptr) {
    if (v.word("pressure") == "dynamic") {
      if (!v.given("reference_level"))
        throw std::invalid_argument(
            "pressure = \"dynamic\" needs reference_level, below which the hydrostatic pressure is taken out");
      removed_gravity = normal_gravity;
    }
  }

  void connect(const riffle_services& s) { services = &s; }

  [[nodiscard]] double pressure_of(double rho) const {
    if (!tait) return c0 * c0 * (rho - rho0);
    const double ratio = rho / rho0, cube = ratio * ratio * ratio;
    return rho0 * c0 * c0 / 7 * (cube * cube * ratio - 1);
  }
  [[nodiscard]] double density_at_rest(double x, double y, double z) const {
    if (surface == nullptr) return rho0;
    double level = 0;
    surface->evaluate(surface->context, 1, &x, &y, &z, 0, &level);
    const double pressure = rho0 * normal_gravity * std::max(level - z, 0.0);
    return tait ? rho0 * std::pow(1 + 7 * pressure / (rho0 * c0 * c0), 1.0 / 7) : rho0 + pressure / (c0 * c0);
  }

  double c0, rho0, nu, gravity, bed_slope, normal_gravity, stratification, reference_level, smoothing_ratio;
  double removed_gravity = 0;  // of the hydrostatic pressure that is taken out; 0: none is
  bool laminar, tait;
  const riffle_function *driving, *surface;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(Wcsph)
