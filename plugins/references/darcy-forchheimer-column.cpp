// Steady flow along a column of any porosity phi(s), driven by a constant force per mass of water, or what is the same, by a
// hydraulic gradient i over the whole length: the filter velocity U = phi u is the same everywhere, and the drags add up,
//
//   int_0^L [ k1 u + k2 u^2 ] ds = g i L,   u = U / phi(s)          Kazemi (2017) eqs 2.21, 4.29; Whitaker (1996)
//
// so that a U + b U^2 = g i with the means of k1 / phi and k2 / phi^2. Drag by Ergun, or by a permeability and a form
// coefficient. Free water, phi = 1, has none. Errors are relative to the mean velocity of the water.
// Not in it: walls and their shear, free surfaces, what the flow did before it was steady.
#include <algorithm>
#include <cmath>
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>
#include <stdexcept>

namespace f = riffle::fields;

struct DarcyForchheimerColumn {
  static constexpr auto id = "darcy-forchheimer-column", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Steady seepage along a column of given porosity under a hydraulic gradient";
  static constexpr auto source = "Darcy (1856); Forchheimer (1901); Ergun (1952); Kazemi (2017) eqs 2.21, 4.29";
  static constexpr auto leaves_out = "walls, free surfaces, the way to the steady state";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("gradient", "1", 0, 1e3, "i: driving force over gravity, along the axis", RIFFLE_ABOVE_MIN),
      riffle::choice("axis", "x|z", "x", "along which it flows"),
      riffle::function("porosity", "1", 0.4, "phi of place; it may vary along the axis only"),
      riffle::choice("law", "ergun|darcy-forchheimer", "ergun", "of the drag"),
      riffle::real("grain_diameter", "m", 0.01, 0, 1e3, "ergun: d_s", RIFFLE_ABOVE_MIN),
      riffle::real("c1", "1", 150, 0, 1e5, "ergun: viscous coefficient"),
      riffle::real("c2", "1", 1.75, 0, 1e3, "ergun: form coefficient"),
      riffle::real("permeability", "m2", 1e-8, 0, 1, "darcy-forchheimer: K at reference_porosity", RIFFLE_ABOVE_MIN),
      riffle::real("form_coefficient", "1", 0.5, 0, 1e3, "darcy-forchheimer: C_F"),
      riffle::real("reference_porosity", "1", 0.4, 0, 1, "darcy-forchheimer: where K was measured",
                   RIFFLE_ABOVE_MIN | RIFFLE_BELOW_MAX),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity"),
      riffle::real("viscosity", "m2.s-1", 1e-6, 0, 1e3, "nu of the water", 0, "fluid.viscosity")};
  static constexpr const riffle_field* gives[] = {&f::velocity};

  explicit DarcyForchheimerColumn(const riffle::Values& v)
      : gradient(v.number("gradient")),
        axis(v.word("axis") == "x" ? 0 : v.dim() - 1),
        porosity(v.function("porosity")),
        ergun(v.word("law") == "ergun"),
        diameter(v.number("grain_diameter")),
        c1(v.number("c1")),
        c2(v.number("c2")),
        permeability(v.number("permeability")),
        form(v.number("form_coefficient")),
        at(v.number("reference_porosity")),
        g(v.number("gravity")),
        nu(v.number("viscosity")) {}

  [[nodiscard]] double phi(double s) const {
    const double zero = 0;
    double value = 1;
    porosity->evaluate(porosity->context, 1, axis == 0 ? &s : &zero, nullptr, axis == 0 ? &zero : &s, 0, &value);
    return value;
  }
  [[nodiscard]] riffle::porous_drag::Coefficients drag(double here) const {
    return ergun ? riffle::porous_drag::ergun(here, diameter, nu, c1, c2)
                 : riffle::porous_drag::darcy_forchheimer(here, permeability, form, at, nu);
  }

  void connect(const riffle_services& s) {
    constexpr int n = 20000;  // midpoints: a jump is met within L / n
    const double low = s.low[axis], length = s.high[axis] - low;
    double a = 0, b = 0;
    for (int k = 0; k < n; ++k) {
      const double here = phi(low + length * (k + 0.5) / n);
      if (!(here > 0 && here <= 1))
        throw std::invalid_argument("porosity must be above 0 and at most 1 along the axis");
      const auto k12 = drag(here);
      a += k12.linear / here / n;
      b += k12.quadratic / (here * here) / n;
      mean += 1 / here / n;
    }
    if (!(a > 0 || b > 0)) throw std::invalid_argument("no steady flow: there is no drag anywhere along the axis");
    filter_velocity = 2 * g * gradient / (a + std::sqrt(a * a + 4 * b * g * gradient));
    mean *= filter_velocity;
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double here = points.x[axis] != nullptr ? phi(points.x[axis][k]) : 1;
      for (int c = 0; c < points.dim; ++c) {
        values[c][k] = c == axis ? filter_velocity / here : 0;
        scales[c][k] = mean;
      }
      defined[k] = here > 0 ? 1 : 0;
    }
  }
  double gradient;
  int axis;
  const riffle_function* porosity;
  bool ergun;
  double diameter, c1, c2, permeability, form, at, g, nu, filter_velocity = 0, mean = 0;
};

RIFFLE_PLUGIN(DarcyForchheimerColumn)
