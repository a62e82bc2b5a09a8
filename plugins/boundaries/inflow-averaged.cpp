// Inflow in the vertical plane that imposes nothing: velocity and density of the buffer are those of the water inside.
//
//   node of a buffer particle: at its height, half a spacing inside the end
//   u = sum_j V_j u_j W / sum_j V_j W,   rho = sum_j V_j rho_j W / sum_j V_j W    over the water, W the cubic spline
//
// so that both gradients along x vanish at the end. A particle that enters is followed by one at its height at the back of the
// buffer. The averaged inflow of Kazemi (2017), section 3.1.4.1, eq. 3.16 and fig. 3-3, with outflow-frozen at the other end.
// Where it fails: nothing gives discharge or level. Heads that differ by the thousandth part of the depth between the ends double
// what drives a channel four depths long, and the velocity wanders although as much leaves as enters (docs/results-rough-bed.md);
// use inflow-discharge. Not in it: another height than that at t = 0, water that flows back out (it is taken out).
#include <cmath>
#include <riffle/open_end.hpp>
#include <riffle/sdk.hpp>
#include <vector>

struct InflowAveraged {
  static constexpr auto id = "inflow-averaged", kind = "boundary", version = "1.0.0";
  static constexpr auto summary =
      "Open end in the vertical plane that takes velocity and density from the water inside";
  static constexpr auto source = "Kazemi (2017) section 3.1.4.1, eq. 3.16, fig. 3-3";
  static constexpr auto leaves_out = "discharge and level, without which the flow drifts; three dimensions";
  static constexpr std::uint32_t dims = 1u << 2;
  static constexpr riffle_parameter parameters[] = {
      riffle::integer("layers", 0, 0, 50,
                      "particles of a row in the buffer; 0: as many as the support needs, 3 in the source"),
      RIFFLE_OPEN_END_PARAMETERS("x_min")};

  explicit InflowAveraged(const riffle::Values& v)
      : end(v, RIFFLE_INFLOW), layers(static_cast<int>(v.number("layers"))) {}
  void connect(const riffle_services& s) { end.connect(s); }

  [[nodiscard]] int columns(const riffle_editor& e) const {
    return layers > 0 ? layers
                      : static_cast<int>(std::ceil(riffle::OpenEnd::reach(e) / riffle::OpenEnd::spacing(e))) + 1;
  }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const riffle::EndProfile in = end.inside(e);
    const double l = riffle::OpenEnd::spacing(e), level = end.bed() + in.depth;
    if (!(in.depth > l))
      throw std::invalid_argument("the water at its end must be deeper than a particle at t = 0, and is " +
                                  std::to_string(in.depth) + " m deep");
    std::vector<std::int64_t> buffer;
    for (double z = end.bed() + 0.5 * l; z < level; z += l) {
      const std::int64_t like = end.nearest(e, z);
      for (int c = 0; c < columns(e); ++c) buffer.push_back(end.add(e, like, (c + 0.5) * l, z));
    }
    const double *phi = e.read(e.context, "porosity", 0), *z = riffle::OpenEnd::read(e, "position", 1);
    double *rho = e.write(e.context, "density", 0), *mass = e.write(e.context, "mass", 0);
    for (const std::int64_t k : buffer) {
      rho[k] = end.density(e, level - z[k]);
      mass[k] = rho[k] * l * l * (phi != nullptr ? phi[k] : 1);
    }
    take(e, buffer);
    end.press_floor(e, level, end.add_floor(e));
  }

  void edit(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double l = riffle::OpenEnd::spacing(e), length = columns(e) * l;
    const bool due = end.due(e, RIFFLE_INFLOW, true);
    std::vector<std::int64_t> buffer;
    for (std::int64_t k = 0; k < e.count; ++k) {
      const double inside = end.inside_by(riffle::OpenEnd::read(e, "position", 0)[k]);
      if (e.role[k] == RIFFLE_FLUID && inside < -riffle::OpenEnd::slack * l) {
        e.remove(e.context, k);
      } else if (end.is_buffer(e, k)) {
        if (!due || inside < 0) {
          buffer.push_back(k);
          continue;
        }
        e.retag(e.context, k, RIFFLE_FLUID);
        buffer.push_back(end.add(e, k, length - inside, riffle::OpenEnd::read(e, "position", 1)[k]));
      }
    }
    take(e, buffer);
    end.press_floor(e, end.bed() + end.inside(e).depth, e.count);
  }

  // Means at the nodes; where no water is near, a particle keeps what it has.
  void take(const riffle_editor& e, const std::vector<std::int64_t>& buffer) const {
    const double node = 0.5 * riffle::OpenEnd::spacing(e), l = riffle::OpenEnd::read(e, "smoothing_length")[0];
    const double *x = riffle::OpenEnd::read(e, "position", 0), *z = riffle::OpenEnd::read(e, "position", 1);
    const double *m = riffle::OpenEnd::read(e, "mass"), *eddy = e.read(e.context, "eddy_viscosity", 0);
    double *u = e.write(e.context, "velocity", 0), *w = e.write(e.context, "velocity", 1);
    double* rho = e.write(e.context, "density", 0);
    double* own_eddy = eddy != nullptr ? e.write(e.context, "eddy_viscosity", 0) : nullptr;
    std::vector<std::int64_t> near;
    for (std::int64_t j = 0; j < e.count && e.role[j] == RIFFLE_FLUID; ++j) {
      const double inside = end.inside_by(x[j]);
      if (inside >= 0 && std::abs(inside - node) < 2 * l) near.push_back(j);
    }
    for (const std::int64_t k : buffer) {
      double share = 0, su = 0, sr = 0, se = 0;
      for (const std::int64_t j : near) {
        const double r = std::hypot(end.inside_by(x[j]) - node, z[j] - z[k]) / l;
        if (r >= 2) continue;
        const double v = m[j] / rho[j] * ((2 - r) * (2 - r) * (2 - r) - 4 * std::pow(std::max(1 - r, 0.0), 3));
        share += v;
        su += v * u[j];
        sr += v * rho[j];
        if (eddy != nullptr) se += v * eddy[j];
      }
      w[k] = 0;
      if (!(share > 0)) continue;
      u[k] = su / share;
      rho[k] = sr / share;
      if (own_eddy != nullptr) own_eddy[k] = se / share;
    }
  }

  riffle::OpenEnd end;
  int layers;
};

RIFFLE_PLUGIN(InflowAveraged)
