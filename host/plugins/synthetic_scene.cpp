#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include "host/plugins/dictionary.hpp"
#include "host/plugins/synthetic_block.hpp"

namespace riffle {
namespace {

struct Range {
  std::string_view field;
  double low, high;
};
// Where 0.5 to 2 in SI (with either sign for vectors) would be odd.
constexpr std::array<Range, 18> ranges{{{"position", -2, 2},
                                        {"inverse_smoothing_length", 10, 16},
                                        {"velocity", -1, 1},
                                        {"drag_rate", 0, 2},
                                        {"smoothing_length", 0.06, 0.1},
                                        {"cell_measure", 0.01, 0.02},
                                        {"depth", 0.1, 1},
                                        {"volume", 0.01, 0.02},
                                        {"mass", 1, 3},
                                        {"density", 990, 1010},
                                        {"density_rate", -100, 100},
                                        {"pressure", -1000, 5000},
                                        {"wave_speed", 1, 20},
                                        {"bed_level", -1, 1},
                                        {"bed_slope", -0.1, 0.1},
                                        {"porosity", 0.3, 0.9},
                                        {"eddy_viscosity", 0, 1e-2},
                                        {"local_depth", 0.1, 1}}};

// The finaliser of splitmix64 (Steele, Lea, Flood 2014): neighbouring arguments give unrelated results.
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

// Uniform in [0, 1), a function of its arguments alone.
double uniform(std::uint64_t seed, std::string_view name, int side, int component, std::int64_t item) {
  std::uint64_t hash = scrambled(seed);
  for (const char c : name) hash = scrambled(hash ^ static_cast<unsigned char>(c));
  hash = scrambled(hash ^ static_cast<std::uint64_t>(2 * component + side));
  hash = scrambled(hash ^ static_cast<std::uint64_t>(item));
  return static_cast<double>(hash >> 11U) * 0x1p-53;
}

// A power of two to a power given in twelfths, exact when the result is a power of two.
double power(double base, int twelfths) {
  return std::exp2(std::log2(base) * twelfths / 12.0);
}

bool is_far(std::int64_t item) {
  return item % 32 == 7;
}

}  // namespace

double UnitScale::of(const Unit& unit, int dim) const {
  return power(kilogram, unit.twelfths[Unit::kilogram]) * power(second, unit.twelfths[Unit::second]) *
         power(metre, unit.twelfths[Unit::metre] + unit.metre_twelfths_per_dimension * dim);
}

std::vector<std::int64_t> first_items(std::int64_t n) {
  std::vector<std::int64_t> items(static_cast<std::size_t>(n));
  std::iota(items.begin(), items.end(), 0);
  return items;
}

double SyntheticScene::separation(int component, std::int64_t item) const {
  if (with_self && item % 16 == 0) return 0;
  // Most within a support of 2 l, some beyond; one in 32 as far as a list's padding.
  const double reach = is_far(item) ? 2e3 : 0.25 / std::sqrt(dim);
  const double x = reach * (uniform(seed, "separation", 0, component, item) - 0.5) * scale.metre;
  return swapped ? -x : x;
}

double SyntheticScene::at(const riffle_field& field, bool neighbour, int component, std::int64_t item) const {
  const std::string_view name = field.name;
  if (name == "position" && neighbour) return at(field, false, component, item) - separation(component, item);
  if (name == "velocity" && at_rest) return 0;
  // A particle that is its own neighbour has one value; in a swapped pair the sides change, not the particles.
  const bool second = with_self && item % 16 == 0 ? false : neighbour != swapped;
  const auto* known = std::find_if(ranges.begin(), ranges.end(), [&](const Range& r) { return r.field == name; });
  const bool is_signed = field.shape != RIFFLE_SCALAR && (field.flags & RIFFLE_NOT_NEGATIVE) == 0;
  const double u = uniform(seed, name, second ? 1 : 0, component, item);
  double value = 0;
  if (known != ranges.end()) {
    value = known->low + (known->high - known->low) * u;
  } else if (is_signed) {
    value = 4 * u - 2;
  } else {
    value = 0.5 + 1.5 * u;
  }
  return value * scale.of(parse_unit(field.unit).value(), dim);
}

// Wendland's C2 function of two dimensions, whatever the scene has: its outputs fit each other, which is all that a
// closure may rely on.
double SyntheticScene::kernel(const std::string& name, double r, double l) const {
  const double q = r / l, t = std::max(0.0, 1 - 0.5 * q);
  double scaled = 7 / (4 * 3.141592653589793);
  for (int d = 0; d < dim; ++d) scaled /= l;
  const double w = t * t * t * t * (1 + 2 * q), slope = -5 * t * t * t, curvature = 5 * t * t * (2 * q - 1);
  if (name == "kernel") return scaled * w;
  if (name == "kernel_gradient") return scaled * slope / (l * l);
  if (name == "kernel_dl") return -scaled * (dim * w + q * q * slope) / l;
  if (name == "kernel_drr") return scaled * curvature / (l * l);
  if (name == "kernel_drdl") return -scaled * q * ((dim + 1) * slope + curvature) / (l * l);
  return scaled * (dim * (dim + 1) * w + q * q * (2 * (dim + 1) * slope + curvature)) / (l * l);
}

double SyntheticScene::of_pair(const riffle_field& field, std::uint32_t where, int component, std::int64_t item) const {
  const std::string name = field.name;
  if (name == "separation") return separation(component, item);
  double r2 = 0, approach = 0;
  static const riffle_field velocity{sizeof(riffle_field), RIFFLE_VECTOR, 0, 0, "velocity", "m.s-1", ""};
  static const riffle_field length{sizeof(riffle_field), RIFFLE_SCALAR, 0, 0, "smoothing_length", "m", ""};
  for (int c = 0; c < dim; ++c) {
    const double x = separation(c, item);
    r2 += x * x;
    approach += (at(velocity, false, c, item) - at(velocity, true, c, item)) * x;
  }
  if (name == "distance_squared") return r2;
  if (name == "distance") return std::sqrt(r2);
  if (name == "approach") return approach;
  if (is_kernel_field(name)) return kernel(name, std::sqrt(r2), value(length, where, 0, item));
  if (name == "viscous_pressure" && approach >= 0) return 0;
  const double sign = field.shape == RIFFLE_VECTOR && swapped ? -1 : 1;
  return sign * (0.5 + 1.5 * uniform(seed, name, 0, component, item)) * scale.of(parse_unit(field.unit).value(), dim);
}

double SyntheticScene::value(const riffle_field& field, std::uint32_t where, int component, std::int64_t item) const {
  if ((field.flags & RIFFLE_PER_PAIR) != 0) return of_pair(field, where, component, item);
  if (where == RIFFLE_AT_I) return at(field, false, component, item);
  const double j = at(field, true, component, item);
  if (where == RIFFLE_AT_J) return j;
  const double i = at(field, false, component, item);
  return where == RIFFLE_DIFFERENCE ? i - j : 0.5 * (i + j);
}

}  // namespace riffle
