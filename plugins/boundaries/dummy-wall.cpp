// Walls of fixed particles whose density follows from continuity, as that of the water does.
//
//   drho_w/dt = rho_w sum_j V_j (u_w - phi_j / phi_w u_j) . x_wj F   over the water,   then rho_w = max(rho_w, rho0)
//
// Water that comes nearer compresses them and is pushed back; they have no velocity, so with a viscosity water does not
// slip. Without the limit (clamp = false) walls from which water departs pull at it, and thin layers stick to them.
// Kazemi (2017), section 3.2.2, whose three layers are too few for a support above three spacings: layers = 0 takes as
// many as the support needs. Not in it: free slip, and walls that move.
#include <riffle/wall_particles.hpp>
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct DummyWall {
  static constexpr auto id = "dummy-wall", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Walls of fixed particles with the density of continuity";
  static constexpr auto source = "Dalrymple & Knio (2001); Kazemi (2017) section 3.2.2";
  static constexpr auto leaves_out = "free slip, moving walls; pressure at the wall lags behind that of the water";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      RIFFLE_WALL_FACE_PARAMETERS,
      riffle::boolean("clamp", true, "density never below rho0, so that walls do not pull"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity"),
      riffle::inherited("density", "kg.m-3", "fluid.density", 0, 1e5, "reference density rho0", RIFFLE_ABOVE_MIN)};

  struct Continuity {
    static constexpr auto pass_name = "density of walls";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t targets = RIFFLE_WALL, sources = wc::water;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::at_i(f::density), riffle::pair(f::approach)};
    static constexpr riffle_write writes[] = {riffle::sum(f::density_rate)};
    static void run(const DummyWall&, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *rho = b.in(2), *approach = b.in(3);
      double* rate = b.out(0);
      RIFFLE_EACH(k, b) rate[k] = rho[k] * volume[k] * (gradient[k] * approach[k]);
    }
  };
  // What water of another porosity than the wall's brings besides; the wall is at rest.
  struct PorousContinuity : Continuity {
    static constexpr auto pass_name = "density of porous walls";
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::at_i(f::density),         riffle::pair(f::approach),
                                            riffle::at_i(f::porosity),        riffle::at_j(f::porosity)};
    static void run(const DummyWall&, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *rho = b.in(2), *approach = b.in(3);
      const double *phi_i = b.in(4), *phi_j = b.in(5);
      double* rate = b.out(0);
      RIFFLE_EACH(k, b)
      rate[k] = (phi_j[k] / phi_i[k] - 1) * rho[k] * volume[k] * (gradient[k] * approach[k]);
    }
  };
  using passes = riffle::Passes<Continuity, PorousContinuity>;

  explicit DummyWall(const riffle::Values& v)
      : faces(v), clamp(v.flag("clamp")), gravity(v.number("gravity")), rho0(v.number("density")) {}
  void connect(const riffle_services& s) { services = &s; }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double spacing = riffle::wall_spacing(e, *services);
    const riffle::WallLayers layers(faces, *services, spacing, e.reach[0]);
    riffle::add_wall_particles(e, RIFFLE_WALL, layers.places(), gravity, spacing);
  }
  void edit(const riffle_editor& e) const {
    if (!clamp) return;
    const double* rho = e.read(e.context, "density", 0);
    double* written = nullptr;
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (e.role[k] != RIFFLE_WALL || rho[k] >= rho0) continue;
      if (written == nullptr) written = e.write(e.context, "density", 0);
      written[k] = rho0;
    }
  }

  riffle::WallFaces faces;
  bool clamp;
  double gravity, rho0;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(DummyWall)
