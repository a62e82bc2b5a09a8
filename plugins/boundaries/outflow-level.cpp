// Outflow from a scene in the vertical plane against a given level of the water, by buffer particles.
//
//   p hydrostatic below the level,   u(z) = that of the water next to the end,   w = 0
//
// Water that crosses the end goes on at its height with that velocity, and is taken out when nobody inside sees it any more.
// Where the water inside stands lower than the level, the buffer pushes back until it does not; where the velocities point
// inwards, water enters at the height of what is there. The level may vary in time: a tide, a gate.
// Source: Federico et al. (2012). Not in it: supercritical outflow, which a level does not reach (use outflow-frozen), waves
// that leave (a level sends them back), a sloping bed beyond the end, three dimensions.
#include <riffle/buffer_water.hpp>
#include <riffle/sdk.hpp>
#include <string>
#include <vector>

struct OutflowLevel {
  static constexpr auto id = "outflow-level", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Open end in the vertical plane that imposes a water level";
  static constexpr auto source = "Federico et al. (2012)";
  static constexpr auto leaves_out = "absorption of waves, supercritical outflow, three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr riffle_parameter parameters[] = {
      riffle::function("level", "m", 0, "of the water at the end, bed included", RIFFLE_REQUIRED),
      RIFFLE_OPEN_END_PARAMETERS("x_max")};

  explicit OutflowLevel(const riffle::Values& v) : end(v, RIFFLE_OUTFLOW), level(v.function("level")) {}
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double top = level_at(e);
    const riffle::EndProfile in = end.inside(e);
    write(e, riffle::fill_beyond(end, e, top), in, top);
    end.press_floor(e, top, end.add_floor(e));
  }

  void edit(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double top = level_at(e);
    const riffle::EndProfile in = end.inside(e);
    bool crossed = false;
    std::vector<std::int64_t> buffer = riffle::pass_beyond(end, e, RIFFLE_OUTFLOW, crossed);
    if (crossed) refill(e, buffer, in);
    write(e, buffer, in, top);
    end.press_floor(e, top, e.count);
  }

  // Where water comes in, particles follow it at the outer edge of the buffer, as far up as it has any.
  void refill(const riffle_editor& e, std::vector<std::int64_t>& buffer, const riffle::EndProfile& in) const {
    const double l = riffle::OpenEnd::spacing(e), width = riffle::OpenEnd::width(e);
    const double *x = riffle::OpenEnd::read(e, "position", 0), *z = riffle::OpenEnd::read(e, "position", 1);
    std::vector<std::int64_t> outermost;
    for (const std::int64_t k : buffer) {
      const auto row = static_cast<std::size_t>((z[k] - end.bed()) / l);
      if (row >= outermost.size()) outermost.resize(row + 1, -1);
      if (outermost[row] < 0 || end.inside_by(x[k]) < end.inside_by(x[outermost[row]])) outermost[row] = k;
    }
    for (const std::int64_t k : outermost) {
      if (k < 0) continue;
      const double at = riffle::OpenEnd::read(e, "position", 1)[k];
      if (!(end.inward() * in.at(in.velocity, at) > 0)) continue;
      double out = -end.inside_by(riffle::OpenEnd::read(e, "position", 0)[k]);
      for (out += l; out <= width; out += l) buffer.push_back(end.add(e, k, out, at));
    }
  }

  [[nodiscard]] double level_at(const riffle_editor& e) const {
    const double at = end.value(level, 0, e.time);
    if (at > end.bed()) return at;
    throw std::invalid_argument("the level must be above the bed at " + std::to_string(end.bed()) + " m, and is " +
                                std::to_string(at) + " m at t = " + std::to_string(e.time) + " s");
  }
  void write(const riffle_editor& e, const std::vector<std::int64_t>& buffer, const riffle::EndProfile& in,
             double top) const {
    const double* z = riffle::OpenEnd::read(e, "position", 1);
    double *u = e.write(e.context, "velocity", 0), *w = e.write(e.context, "velocity", 1);
    double* rho = e.write(e.context, "density", 0);
    double* eddy =
        e.read(e.context, "eddy_viscosity", 0) != nullptr ? e.write(e.context, "eddy_viscosity", 0) : nullptr;
    for (const std::int64_t k : buffer) {
      u[k] = in.at(in.velocity, z[k]);
      w[k] = 0;
      rho[k] = end.density(e, top - z[k]);
      if (eddy != nullptr) eddy[k] = in.at(in.eddy_viscosity, z[k]);
    }
  }

  riffle::OpenEnd end;
  const riffle_function* level;
};

RIFFLE_PLUGIN(OutflowLevel)
