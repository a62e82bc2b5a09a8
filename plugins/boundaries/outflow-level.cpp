// Outflow from a scene in the vertical plane against a given level of the water, by buffer particles.
//
//   p hydrostatic below the level,   u(z) = that of the water next to the end,   w = 0
//
// Water that crosses the end goes on at its height with that velocity, and is taken out when nobody inside sees it any more.
// Where the water inside stands lower than the level, the buffer pushes back until it does not; where the velocities point
// inwards, water enters at the height of what is there. The level may vary in time: a tide, a gate.
// Source: Federico et al. (2012). Not in it: supercritical outflow, which a level does not reach (use outflow-frozen), waves
// that leave (a level sends them back), a sloping bed beyond the end, three dimensions.
#include <riffle/open_end.hpp>
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
      riffle::choice("end", "x_min|x_max", "x_max", "which end of the domain"),
      riffle::inherited("density", "kg.m-3", "fluid.density", 0, 1e5, "reference density rho0", RIFFLE_ABOVE_MIN)};

  explicit OutflowLevel(const riffle::Values& v)
      : end(v.word("end") == "x_min", RIFFLE_OUTFLOW, v.number("density")), level(v.function("level")) {}
  void connect(const riffle_services& s) { end.connect(s); }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double l = riffle::OpenEnd::spacing(e), top = level_at(e);
    const riffle::EndProfile in = end.inside(e);
    std::vector<std::int64_t> buffer;
    for (double z = end.bed() + 0.5 * l; z < top; z += l) {
      for (double out = 0.5 * l; out < riffle::OpenEnd::width(e); out += l) buffer.push_back(end.add(e, 0, out, z));
    }
    const double* phi = e.read(e.context, "porosity", 0);
    double* mass = e.write(e.context, "mass", 0);
    for (const std::int64_t k : buffer)
      mass[k] =
          (phi != nullptr ? phi[k] : 1) * l * l * end.density(e, top - riffle::OpenEnd::read(e, "position", 1)[k]);
    write(e, buffer, in, top);
    end.press_floor(e, top, end.add_floor(e));
  }

  void edit(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double top = level_at(e), width = riffle::OpenEnd::width(e);
    const riffle::EndProfile in = end.inside(e);
    const bool due = end.due(e, RIFFLE_FLUID, false) || end.due(e, RIFFLE_OUTFLOW, true);
    const double *x = riffle::OpenEnd::read(e, "position", 0), *z = riffle::OpenEnd::read(e, "position", 1);
    std::vector<std::int64_t> buffer;
    for (std::int64_t k = 0; k < e.count; ++k) {
      const double inside = end.inside_by(x[k]);
      if (end.is_buffer(e, k)) {
        if (due && inside < -width)
          e.remove(e.context, k);
        else if (due && inside >= 0)
          e.retag(e.context, k, RIFFLE_FLUID);
        else
          buffer.push_back(k);
      } else if (due && e.role[k] == RIFFLE_FLUID && inside < 0) {
        if (end.is_floor(z[k])) {
          e.remove(e.context, k);
          continue;
        }
        e.retag(e.context, k, RIFFLE_OUTFLOW);
        buffer.push_back(k);
      }
    }
    if (due) refill(e, buffer, in);
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
