// A gate across the water that is pulled up: rows of wall particles that go away from below, as its lower edge rises.
//
//   z_edge(t) = z_low + (z_high - z_low) min(1, max(0, (t - start) / opening_time))
//
// The gate stands between its upstream face at `position` and position + thickness, over the whole height of the domain, on the
// lattice of the water; there must be no water in it at t = 0. Its particles are walls like those beside it, and have their
// density from the wall plugin of the scene (dummy-wall, adami-wall). A row goes when the edge has passed its middle.
// A dam break with a gate of 0.1 s differs from one without in the first tenths of a second only (Kazemi 2017, section 5.2,
// takes it away at once).
// Not in it: the water that a rising gate drags along, leaks under it, gates that turn or fall.
#include <algorithm>
#include <riffle/wall_particles.hpp>

struct Gate {
  static constexpr auto id = "gate", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "A gate that is pulled up over a given time";
  static constexpr auto source = "rows of wall particles, removed from below";
  static constexpr auto leaves_out =
      "water dragged along by the gate, leaks; walls other than dummy-wall or adami-wall";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("position", "m", -1e6, 1e6, "x of the upstream face"),
      riffle::required_real("thickness", "m", 0, 1e3, "along x: as many rows as fit in; a support holds the water best",
                            RIFFLE_ABOVE_MIN),
      riffle::required_real("opening_time", "s", 0, 1e6, "from the first to the last row", RIFFLE_ABOVE_MIN),
      riffle::real("start", "s", 0, 0, 1e6, "when the gate begins to rise"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity")};

  explicit Gate(const riffle::Values& v)
      : position(v.number("position")),
        thickness(v.number("thickness")),
        opening_time(v.number("opening_time")),
        start(v.number("start")),
        gravity(v.number("gravity")) {}

  void connect(const riffle_services& s) {
    services = &s;
    if (!riffle::has_lattice(s)) return;
    std::ostringstream text;
    if (!(position > s.low[0] && position + thickness < s.high[0])) {
      text << "the gate from x = " << position << " to " << position + thickness << " m must stand within the domain, "
           << s.low[0] << " to " << s.high[0] << " m";
    } else if (thickness < s.spacing) {
      text << "thickness of " << thickness << " m holds no row of particles, which are " << s.spacing << " m apart";
    } else {
      return;
    }
    throw std::invalid_argument(text.str());
  }

  [[nodiscard]] bool within(double x, double z) const {
    return x >= position && x <= position + thickness && z >= services->low[1] && z <= services->high[1];
  }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double l0 = riffle::wall_spacing(e, *services), low = services->low[1];
    const double *x = e.read(e.context, "position", 0), *z = e.read(e.context, "position", 1);
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (e.role[k] != RIFFLE_FLUID || !within(x[k], z[k])) continue;
      throw std::invalid_argument("there is water in the gate, at x = " + std::to_string(x[k]) +
                                  " m, z = " + std::to_string(z[k]) + " m; leave it out with initial.inside");
    }
    std::vector<std::array<double, 3>> places;
    const auto column = [&](double at) { return std::ceil((at - services->low[0]) / l0 - 0.5 - 1e-9); };
    for (double i = column(position); i < column(position + thickness); ++i) {
      for (double k = 0; low + (k + 0.5) * l0 < services->high[1]; ++k) {
        places.push_back({services->low[0] + (i + 0.5) * l0, low + (k + 0.5) * l0, 0});
      }
    }
    riffle::add_wall_particles(e, RIFFLE_WALL, places, gravity, l0);
  }

  void edit(const riffle_editor& e) const {
    const double open = std::clamp((e.time - start) / opening_time, 0.0, 1.0);
    if (!(open > 0) || e.time - e.dt > start + opening_time) return;
    const double edge = open < 1 ? services->low[1] + (services->high[1] - services->low[1]) * open : riffle::infinity;
    const double *x = e.read(e.context, "position", 0), *z = e.read(e.context, "position", 1);
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (e.role[k] == RIFFLE_WALL && z[k] < edge && within(x[k], z[k])) e.remove(e.context, k);
    }
  }

  double position, thickness, opening_time, start, gravity;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(Gate)
