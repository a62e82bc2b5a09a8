// Walls of fixed particles that take their pressure from the water before them.
//
//   p_w = sum_j V_j (p_j + rho_j g . (x_w - x_j)) W / sum_j V_j W   over the water;   0 where there is none, and not below
//         0 with clamp = true
//
// So the pressure in a wall continues that of the water, up to its weight, in the same step: less noise than walls whose
// density follows from continuity, and no memory of what has passed. Adami, Hu & Adams (2012), eq. 27, for walls at rest.
// Not in it: free slip, and walls that move.
#include <riffle/wall_particles.hpp>
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct AdamiWall {
  static constexpr auto id = "adami-wall", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Walls of fixed particles with the pressure of the water before them";
  static constexpr auto source = "Adami, Hu & Adams (2012) eq. 27";
  static constexpr auto leaves_out = "free slip, moving walls";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      RIFFLE_WALL_FACE_PARAMETERS, riffle::boolean("clamp", true, "pressure never below 0, so that walls do not pull"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000,
                        "acceleration of gravity, against the last axis")};

  static constexpr riffle_field kernel_share =
      riffle::scalar_field("wall_kernel_share", "1", "sum over the water of V W, at a wall particle");
  static constexpr riffle_field pressure_share =
      riffle::scalar_field("wall_pressure_share", "kg.m-1.s-2", "sum over the water of V p W, continued to the wall");

  struct Gather {
    static constexpr auto pass_name = "pressure before walls";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t targets = RIFFLE_WALL, sources = wc::water;
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel), riffle::at_j(wc::particle_volume),
                                            riffle::at_j(f::pressure), riffle::at_j(f::density),
                                            riffle::pair(f::separation)};
    static constexpr riffle_write writes[] = {riffle::sum(kernel_share), riffle::sum(pressure_share)};
    static void run(const AdamiWall& s, const riffle::Block& b) {
      const double *w = b.in(0), *volume = b.in(1), *p = b.in(2), *rho = b.in(3), *z = b.in(4, b.dim() - 1);
      const double g = s.gravity;
      double *share = b.out(0), *sum = b.out(1);
      RIFFLE_EACH(k, b) {
        share[k] = volume[k] * w[k];
        sum[k] = volume[k] * w[k] * (p[k] - rho[k] * g * z[k]);
      }
    }
  };
  struct Set {
    static constexpr auto pass_name = "pressure of walls";
    static constexpr std::uint32_t targets = RIFFLE_WALL;
    static constexpr riffle_read reads[] = {riffle::at_i(kernel_share), riffle::at_i(pressure_share)};
    static constexpr riffle_write writes[] = {riffle::set(wc::wall_pressure)};
    static void run(const AdamiWall& s, const riffle::Block& b) {
      const double lowest = s.clamp ? 0.0 : -1e300;
      RIFFLE_EACH(k, b) {
        const double share = b.in(0)[k], p = share > 1e-12 ? b.in(1)[k] / share : 0.0;
        b.out(0)[k] = p > lowest ? p : lowest;
      }
    }
  };
  using passes = riffle::Passes<Gather, Set>;

  explicit AdamiWall(const riffle::Values& v) : faces(v), clamp(v.flag("clamp")), gravity(v.number("gravity")) {}
  void connect(const riffle_services& s) { services = &s; }
  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double spacing = riffle::wall_spacing(e, *services);
    const riffle::WallLayers layers(faces, *services, spacing, e.reach[0]);
    riffle::add_wall_particles(e, RIFFLE_WALL, layers.places(), gravity, spacing);
  }

  riffle::WallFaces faces;
  bool clamp;
  double gravity;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(AdamiWall)
