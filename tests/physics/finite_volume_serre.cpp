// An independent solver of the Serre equations for cross-checks: finite volumes on a fixed grid, in conservation form,
//
//   h_t + (h u)_x = 0,   G = h u (1 + h_x b_x + h b_xx / 2 + b_x^2) - (h^3 u_x / 3)_x
//   G_t + (G u + g h^2/2 - 2/3 h^3 u_x^2 + h^2 u u_x b_x)_x = -1/2 h^2 u u_x b_xx + h u^2 b_x b_xx - g h b_x
//
// over a bed b, a hill HEIGHT exp(-((x - PLACE)/LENGTH)^2).
// Le Metayer, Gavrilyuk & Hank (2010); Zoppou, Roberts & Pitt (2017). Velocities come from G by a tridiagonal solve,
// h and G at faces by Koren's third-order limiter (1993), fluxes after Kurganov, Noelle & Petrova (2001), time by
// SSP-RK3. It shares no line and no formula with the equation set `serre`: no particles, no kernel, no Lagrangian.
//
//   finite_volume_serre LEFT RIGHT WIDTH CELLS TIME [HEIGHT PLACE LENGTH]
//
// prints "x,depth,velocity" and a line per cell for -100 m < x < 100 m, with at first a level of (LEFT + RIGHT)/2 -
// (LEFT - RIGHT)/2 tanh(x / WIDTH) of water at rest. Ends are walls, which waves must not reach.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace finite_volume_serre {

using Row = std::vector<double>;
constexpr double g = 9.81;

struct Hill {
  double height = 0, place = 0, length = 1;
  [[nodiscard]] double at(double x) const { return height * std::exp(-away(x) * away(x)); }
  [[nodiscard]] double slope(double x) const { return -2 * away(x) / length * at(x); }
  [[nodiscard]] double bend(double x) const { return (4 * away(x) * away(x) - 2) / (length * length) * at(x); }
  [[nodiscard]] double away(double x) const { return (x - place) / length; }
};

class Solver {
 public:
  Solver(double left, double right, double width, std::size_t cells, const Hill& hill)
      : hill_(hill),
        n_(cells),
        dx_(200.0 / static_cast<double>(cells)),
        h_(cells),
        momentum_(cells, 0.0),
        u_(cells, 0.0) {
    for (std::size_t i = 0; i < n_; ++i) {
      const double a = place(i) - 0.5 * dx_, b = a + dx_;  // means over cells: tanh has a closed integral
      const auto rise = [&](double x) { return std::abs(x) / width + std::log1p(std::exp(-2 * std::abs(x) / width)); };
      h_[i] = 0.5 * (left + right) - 0.5 * (left - right) * width * (rise(b) - rise(a)) / dx_;
      h_[i] -= (hill_.at(a) + 4 * hill_.at(place(i)) + hill_.at(b)) / 6;  // Simpson
    }
  }
  [[nodiscard]] double place(std::size_t i) const { return -100 + (static_cast<double>(i) + 0.5) * dx_; }
  [[nodiscard]] const Row& depth() const { return h_; }
  [[nodiscard]] const Row& velocity() const { return u_; }

  void run(double end) {
    Row dh, dm;
    for (double t = 0; t < end;) {
      velocities();
      double fastest = 0;
      for (std::size_t i = 0; i < n_; ++i) fastest = std::max(fastest, std::abs(u_[i]) + std::sqrt(g * h_[i]));
      const double dt = std::min(0.4 * dx_ / fastest, end - t);
      const Row h0 = h_, m0 = momentum_;
      const double keep[] = {0.0, 0.75, 1.0 / 3};  // Shu & Osher (1988)
      for (const double old : keep) {
        rates(dh, dm);
        for (std::size_t i = 0; i < n_; ++i) {
          h_[i] = old * h0[i] + (1 - old) * (h_[i] + dt * dh[i]);
          momentum_[i] = old * m0[i] + (1 - old) * (momentum_[i] + dt * dm[i]);
        }
      }
      t = t + dt;
    }
    velocities();
  }

 private:
  [[nodiscard]] double cubed_at_face(std::size_t right) const {
    const double h = 0.5 * (h_[right - 1] + h_[right]);
    return h * h * h / 3;
  }

  // h u (...) - (h^3 u_x / 3)_x = G, u = 0 at the walls (mirrored), by Thomas' algorithm
  void velocities() {
    Row upper(n_);
    const double square = 1 / (dx_ * dx_);
    for (std::size_t i = 0; i < n_; ++i) {
      const double west = square * (i == 0 ? 2 * h_[0] * h_[0] * h_[0] / 3 : cubed_at_face(i));
      const double east = square * (i + 1 == n_ ? 2 * h_[i] * h_[i] * h_[i] / 3 : cubed_at_face(i + 1));
      const auto k = static_cast<std::ptrdiff_t>(i);
      const double bed = hill_.slope(place(i)), h_x = (at(h_, k + 1, 1) - at(h_, k - 1, 1)) / (2 * dx_);
      const double inertia = h_[i] * (1 + h_x * bed + 0.5 * h_[i] * hill_.bend(place(i)) + bed * bed);
      const double pivot = inertia + west + east - (i == 0 ? 0 : west * upper[i - 1]);
      upper[i] = east / pivot;
      u_[i] = (momentum_[i] + (i == 0 ? 0 : west * u_[i - 1])) / pivot;
    }
    for (std::size_t i = n_ - 1; i-- > 0;) u_[i] += upper[i] * u_[i + 1];
  }

  [[nodiscard]] double at(const Row& q, std::ptrdiff_t i, double sign) const {  // mirrored beyond the walls
    const auto n = static_cast<std::ptrdiff_t>(n_);
    if (i < 0) return sign * q[static_cast<std::size_t>(-1 - i)];
    return i < n ? q[static_cast<std::size_t>(i)] : sign * q[static_cast<std::size_t>(2 * n - 1 - i)];
  }
  // q at the face between `near` and `beyond`, seen from the side of `near`; `far` lies behind it
  static double reach(double far, double near, double beyond) {
    const double back = near - far, ahead = beyond - near;
    if (back * ahead <= 0) return near;
    const double r = ahead / back;
    return near + 0.5 * back * std::min({2 * r, (1 + 2 * r) / 3, 2.0});
  }
  struct Face {
    double left, right;
  };
  [[nodiscard]] Face face(const Row& q, std::ptrdiff_t i, double sign) const {  // between cells i - 1 and i
    const double a = at(q, i - 2, sign), b = at(q, i - 1, sign), c = at(q, i, sign), d = at(q, i + 1, sign);
    return {reach(a, b, c), reach(d, c, b)};
  }

  void rates(Row& dh, Row& dm) {
    velocities();
    dh.assign(n_, 0.0);
    dm.assign(n_, 0.0);
    for (std::size_t f = 0; f <= n_; ++f) {
      const auto i = static_cast<std::ptrdiff_t>(f);
      const Face h = face(h_, i, 1), m = face(momentum_, i, -1);
      const double a = at(u_, i - 2, -1), b = at(u_, i - 1, -1), c = at(u_, i, -1), d = at(u_, i + 1, -1);
      const double u = (9 * (b + c) - a - d) / 16, slope = (27 * (c - b) - d + a) / (24 * dx_);  // smooth: fourth order
      const double bed = hill_.slope(-100 + static_cast<double>(f) * dx_);
      const auto flux = [&](double depth, double momentum) {
        return momentum * u + 0.5 * g * depth * depth - 2 * depth * depth * depth * slope * slope / 3 +
               depth * depth * u * slope * bed;
      };
      const double c_left = std::sqrt(g * h.left), c_right = std::sqrt(g * h.right);
      const double fast = std::max({u + c_left, u + c_right, 0.0}), slow = std::min({u - c_left, u - c_right, 0.0});
      const double spread = fast - slow, both = fast * slow;
      const double water = (fast * h.left * u - slow * h.right * u + both * (h.right - h.left)) / spread;
      const double thrust =
          (fast * flux(h.left, m.left) - slow * flux(h.right, m.right) + both * (m.right - m.left)) / spread;
      if (f > 0) {
        dh[f - 1] -= water / dx_;
        dm[f - 1] -= thrust / dx_;
      }
      if (f < n_) {
        dh[f] += water / dx_;
        dm[f] += thrust / dx_;
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      const auto k = static_cast<std::ptrdiff_t>(i);
      const double bed = hill_.slope(place(i)), bend = hill_.bend(place(i)), h = h_[i], u = u_[i];
      const double stretch = (at(u_, k + 1, -1) - at(u_, k - 1, -1)) / (2 * dx_);
      dm[i] += -0.5 * h * h * u * stretch * bend + h * u * u * bed * bend - g * h * bed;
    }
  }

  Hill hill_;
  std::size_t n_;
  double dx_;
  Row h_, momentum_, u_;
};

}  // namespace finite_volume_serre

int main(int count, char** words) {
  if (count != 6 && count != 9) {
    std::fputs("usage: finite_volume_serre LEFT RIGHT WIDTH CELLS TIME [HEIGHT PLACE LENGTH]\n", stderr);
    return 2;
  }
  const auto number = [&](int k) { return std::strtod(words[k], nullptr); };
  finite_volume_serre::Hill hill;
  if (count == 9) hill = {number(6), number(7), number(8)};
  finite_volume_serre::Solver solver(number(1), number(2), number(3), static_cast<std::size_t>(number(4)), hill);
  solver.run(number(5));
  std::puts("x,depth,velocity");
  for (std::size_t i = 0; i < solver.depth().size(); ++i)
    std::printf("%.17g,%.17g,%.17g\n", solver.place(i), solver.depth()[i], solver.velocity()[i]);
  return 0;
}
