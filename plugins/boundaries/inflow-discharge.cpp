// Inflow of a given discharge in the vertical plane, by rows of buffer particles that move with imposed velocities.
//
//   u(z) = q s(z) / sum_k phi_k s(z_k) dz,   p hydrostatic below the level,   level = that of the water inside, unless given
//
// s, the shape of the profile, is that of the water inside, or `velocity`. Taken next to the end it keeps what it has, errors
// included, for nearly nothing changes on so short a way; taken from `shape_distance` downstream it becomes that of the developed
// flow. The rows share the depth evenly, so that
// what enters per second is q whatever the level; a row comes or goes when they have become a spacing thicker or thinner by
// three quarters. The level follows that inside within a time of sqrt(d / g) by default: with the discharge fixed, depth
// and slope of the surface find themselves, while an end that takes velocity *and* pressure from inside drifts
// (inflow-averaged). Subcritical inflow needs no level; supercritical does.
// Source: buffers after Federico et al. (2012), with the discharge imposed as in Kazemi (2017) section 6.2.4.
// Not in it: water that leaves through it (it is taken out), a sloping bed beyond the end, three dimensions, periodic along x.
#include <riffle/buffer_rows.hpp>
#include <riffle/sdk.hpp>
#include <string>
#include <vector>

struct InflowDischarge {
  static constexpr auto id = "inflow-discharge", kind = "boundary", version = "1.0.0";
  static constexpr auto summary =
      "Open end in the vertical plane that a discharge enters, at the depth of the water inside";
  static constexpr auto source = "Federico et al. (2012); Kazemi (2017) section 6.2.4";
  static constexpr auto leaves_out = "water that flows back out, three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr std::int32_t state_size = 2;  // depth [m] and rows of the buffer
  static constexpr riffle_parameter parameters[] = {
      riffle::function("discharge", "m2.s-1", 0, "q into the domain, per metre of width", RIFFLE_REQUIRED),
      riffle::function("velocity", "m.s-1", 0,
                       "shape of the profile over z, of any scale; that of the water inside if not given"),
      riffle::real("shape_distance", "m", 0, 0, 1e6,
                   "how far inside the shape is taken: as far as the flow is uniform"),
      riffle::function("level", "m", 0, "of the water at the end; that of the water inside if not given"),
      riffle::real("relaxation", "s", 0, 0, 1e6, "time in which the buffer follows the water inside; 0: sqrt(d / g)"),
      RIFFLE_OPEN_END_PARAMETERS("x_min")};

  explicit InflowDischarge(const riffle::Values& v)
      : end(v, RIFFLE_INFLOW),
        relaxation(v.number("relaxation")),
        shape_distance(v.number("shape_distance")),
        gravity(v.number("gravity")),
        discharge(v.function("discharge")),
        velocity(v.given("velocity") ? v.function("velocity") : nullptr),
        level(v.given("level") ? v.function("level") : nullptr) {}
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const riffle::EndProfile in = end.inside(e);
    const double depth = level != nullptr ? level_at(e) : in.depth, l = riffle::OpenEnd::spacing(e);
    if (!(depth > l))
      throw std::invalid_argument("the water at its end must be deeper than a particle at t = 0, and is " +
                                  std::to_string(depth) + " m deep; give a level");
    riffle::BufferRows rows(end, e, depth, std::max(1.0, std::round(depth / l)));
    rows.fill(e);
    impose(e, end.inside(e, shape_distance), rows, 1);
    end.press_floor(e, rows.level(), end.add_floor(e));
  }

  void edit(const riffle_editor& e) const {
    if (e.state[1] == 0) return;  // no water at t = 0
    const riffle::EndProfile in = end.inside(e);
    const double lag = relaxation > 0 ? relaxation : std::sqrt(e.state[0] / gravity), part = std::min(1.0, e.dt / lag);
    const double depth = level != nullptr ? level_at(e) : e.state[0] + part * (in.depth - e.state[0]);
    riffle::BufferRows rows(end, e, e.state[0], e.state[1]);
    if (rows.empty())
      throw std::invalid_argument("its buffer particles are gone; it cannot stand beside periodic along x");
    rows.pass_on(e);
    rows.become(e, depth);
    impose(e, shape_distance > 0 ? end.inside(e, shape_distance) : in, rows, part);
    end.press_floor(e, rows.level(), rows.particles());
  }

  [[nodiscard]] double level_at(const riffle_editor& e) const {
    const double depth = end.value(level, 0, e.time) - end.bed();
    if (depth > 0) return depth;
    throw std::invalid_argument("the level must be above the bed at " + std::to_string(end.bed()) + " m, and is " +
                                std::to_string(depth + end.bed()) + " m at t = " + std::to_string(e.time) + " s");
  }

  // Velocities that carry the discharge, and water at rest's density.
  void impose(const riffle_editor& e, const riffle::EndProfile& in, riffle::BufferRows& rows, double part) const {
    const double q = end.value(discharge, 0, e.time);
    if (!(q >= 0))
      throw std::invalid_argument("the discharge must not be negative, and is " + std::to_string(q) +
                                  " m2/s at t = " + std::to_string(e.time) + " s; let water out with outflow-level");
    std::vector<double> u = rows.velocities(e, end.inward());
    double sum = 0;
    for (std::size_t k = 0; k < u.size(); ++k) {
      const double z = rows.middle(k),
                   shape = velocity != nullptr ? end.value(velocity, z, e.time) : end.inward() * in.at(in.velocity, z);
      u[k] = std::max(0.0, velocity != nullptr ? shape : u[k] + part * (shape - u[k]));
      sum += u[k] * rows.open_height(e, k);
    }
    double open = 0;
    for (std::size_t k = 0; k < u.size(); ++k) open += rows.open_height(e, k);
    for (double& value : u) value = sum > 1e-6 * std::sqrt(gravity) ? value * q / sum : q / open;  // at rest: all alike
    rows.write(e, u, in);
    e.state[0] = rows.depth();
    e.state[1] = static_cast<double>(u.size());
  }

  riffle::OpenEnd end;
  double relaxation, shape_distance, gravity;
  const riffle_function *discharge, *velocity, *level;
};

RIFFLE_PLUGIN(InflowDischarge)
