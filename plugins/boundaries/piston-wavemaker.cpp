// A wall of fixed rows that moves along x as a piston and makes waves: for a solitary wave of height H in water of depth h0
// by one of the laws of riffle/piston_law.hpp, or as a displacement X(t) from a formula or a table says.
//
//   drho_p/dt = rho_p sum_j V_j (u_p - u_j) . x_pj F   over the water,   rho_p = max(rho_p, rho0),   x_p = x_p(0) + X(t)
//
// It stands at t = 0 with its face on the lower end of the domain in x, and reaches from the bottom to the top of it; the
// floor goes on under it, and stays. The floor itself and the other end are those of dummy-wall, with x_min = false.
// Source: Goring (1978); Kazemi (2017) eqs 5.9, 5.10. Not in it: flaps, absorption of reflected waves, pistons that turn.
// Where it fails: a displacement that jumps hits the water; a stroke beyond half of the domain is refused.
#include <optional>
#include <riffle/piston_law.hpp>
#include <riffle/wall_particles.hpp>
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct PistonWavemaker {
  static constexpr auto id = "piston-wavemaker", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "A wall that moves along x and makes a solitary wave, or what its displacement says";
  static constexpr auto source = "Goring (1978); Kazemi (2017) eqs 5.9, 5.10; the exact wave of the Serre equations";
  static constexpr auto leaves_out = "absorption of reflected waves, flaps; walls other than dummy-wall beside it";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr std::int32_t state_size = 2;  // displacement and velocity after the last step
  static constexpr riffle_parameter parameters[] = {
      riffle::choice("law", "serre|goring|explicit|displacement", "displacement",
                     "serre: waves that keep their shape; explicit: eq. 5.9; displacement: the function of that name"),
      riffle::real("depth", "m", 0, 0, 1e4, "h0: still water at the piston; for the first three"),
      riffle::real("height", "m", 0, 0, 1e4, "H: of the solitary wave; for the first three"),
      riffle::function("displacement", "m", 0, "X(t) of the face, for law = displacement; X(0) counts as 0"),
      riffle::inherited("end", "s", "time.end", 0, 1e9, "until when the stroke is checked"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity"),
      riffle::inherited("density", "kg.m-3", "fluid.density", 0, 1e5, "reference density rho0", RIFFLE_ABOVE_MIN)};

  struct Continuity {
    static constexpr auto pass_name = "density of the piston";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t targets = RIFFLE_PISTON, sources = wc::water;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::at_i(f::density), riffle::pair(f::approach)};
    static constexpr riffle_write writes[] = {riffle::sum(f::density_rate)};
    static void run(const PistonWavemaker&, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *rho = b.in(2), *approach = b.in(3);
      RIFFLE_EACH(k, b) b.out(0)[k] = rho[k] * volume[k] * (gradient[k] * approach[k]);
    }
  };
  using passes = riffle::Passes<Continuity>;

  explicit PistonWavemaker(const riffle::Values& v)
      : displacement(v.function("displacement")),
        end(v.number("end")),
        gravity(v.number("gravity")),
        rho0(v.number("density")) {
    const std::string word = v.word("law");
    driven = v.given("displacement");
    if (word == "displacement") return;
    if (driven) throw std::invalid_argument("displacement is for law = \"displacement\", got law = \"" + word + '"');
    depth = v.number("depth"), height = v.number("height");
    kind_of_law = word == "serre"    ? riffle::PistonLaw::serre
                  : word == "goring" ? riffle::PistonLaw::goring
                                     : riffle::PistonLaw::explicit_law;
    by_law = true;
  }

  void connect(const riffle_services& s) {
    services = &s;
    if (!by_law && !driven && riffle::has_lattice(s)) {
      throw std::invalid_argument(
          "law = \"displacement\" needs displacement, a function of time or a table in CSV; for a solitary wave give "
          "law = \"serre\", depth and height");
    }
    if (by_law) riffle::require_within_domain(s, "depth", depth);
    if (by_law && height > 0.78 * depth) {
      riffle::warn<PistonWavemaker>(s, "a solitary wave higher than 0.78 of its depth breaks, and this one has " +
                                           std::to_string(height / depth));
    }
    if (by_law) law.emplace(kind_of_law, depth, height, gravity);
    const double length = s.high[0] - s.low[0];
    double far = law ? law->stroke() : 0;
    for (int k = 0; !law && k <= 1000; ++k) far = std::max(far, std::abs(place(end * k / 1000)));
    if (far < 0.5 * length) return;
    throw std::invalid_argument("the stroke of the piston, " + std::to_string(far) +
                                " m, must be shorter than half of the tank, which is " + std::to_string(length) +
                                " m long");
  }

  [[nodiscard]] double place(double t) const {
    if (law) return law->displacement(t);
    const double zero = 0;
    double now = 0, first = 0;
    displacement->evaluate(displacement->context, 1, &zero, nullptr, &zero, t, &now);
    displacement->evaluate(displacement->context, 1, &zero, nullptr, &zero, 0, &first);
    return now - first;
  }
  [[nodiscard]] double speed(double t) const {
    if (law) return law->velocity(t);
    const double step = 1e-6 * std::max(end, 1e-3), before = std::max(t - step, 0.0);
    return (place(t + step) - place(before)) / (t + step - before);
  }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double spacing = riffle::wall_spacing(e, *services);
    riffle::WallFaces face;
    face.low[0] = true;
    const riffle::WallLayers column(face, *services, spacing, e.reach[0]);
    std::vector<std::array<double, 3>> piston, corner;
    for (const auto& p : column.places()) {
      if (p[0] < services->low[0]) piston.push_back(p);
    }
    face.low[1] = true;  // under the piston the floor goes on; it stays
    for (const auto& p : riffle::WallLayers(face, *services, spacing, e.reach[0]).places()) {
      if (p[0] < services->low[0] && p[1] < services->low[1]) corner.push_back(p);
    }
    riffle::add_wall_particles(e, RIFFLE_PISTON, piston, gravity, spacing);
    riffle::add_wall_particles(e, RIFFLE_WALL, corner, gravity, spacing);
    e.state[0] = e.state[1] = 0;
  }
  void edit(const riffle_editor& e) const {
    // The integrator has moved them with the velocity of the last step, state[1].
    const double now = place(e.time), by = now - e.state[0] - e.state[1] * e.dt, u = speed(e.time);
    e.state[0] = now;
    e.state[1] = u;
    const double* density = e.read(e.context, "density", 0);
    double *x = e.write(e.context, "position", 0), *velocity = e.write(e.context, "velocity", 0), *written = nullptr;
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (e.role[k] != RIFFLE_PISTON) continue;
      x[k] += by;
      velocity[k] = u;
      if (density[k] >= rho0) continue;
      if (written == nullptr) written = e.write(e.context, "density", 0);
      written[k] = rho0;
    }
    keep_before_the_face(e, services->low[0] + now, u, x, velocity);
  }

  // Rows that move over rows that do not leave a slit between them, and water is pressed into it. None comes nearer to the
  // face than a quarter of a spacing, nor there to the floor: on their own particles stay a third away.
  void keep_before_the_face(const riffle_editor& e, double face, double u, double* x, double* velocity) const {
    const double l0 = riffle::wall_spacing(e, *services), nearest = 0.25 * l0, floor = services->low[1] + nearest;
    double *z = nullptr, *up = nullptr;
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (e.role[k] != RIFFLE_FLUID || x[k] >= face + l0) continue;
      if (x[k] < face + nearest) {
        x[k] = face + nearest;
        velocity[k] = std::max(velocity[k], u);
      }
      if (e.read(e.context, "position", 1)[k] >= floor) continue;
      if (z == nullptr) z = e.write(e.context, "position", 1), up = e.write(e.context, "velocity", 1);
      z[k] = floor;
      up[k] = std::max(up[k], 0.0);
    }
  }

  const riffle_function* displacement;
  double end, gravity, rho0, depth = 0, height = 0;
  riffle::PistonLaw::Kind kind_of_law = riffle::PistonLaw::serre;
  bool by_law = false, driven = false;
  std::optional<riffle::PistonLaw> law;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(PistonWavemaker)
