// riffle/limiters.hpp: slope limiters for reconstructions between particles.
//
// A limiter phi(a, b) takes the differences of a quantity on the two sides of a particle (or of a face), over the same
// distance, and gives one that makes no new extremum: 0 where a and b differ in sign, and phi(a, a) = a, so that linear
// fields are kept. All are symmetric in a and b, and made for vectorised loops: no branch, no call.
//
//   riffle::with_limiter(v.choice, [&](auto limiter) { RIFFLE_EACH(k, b) slope[k] = limiter(a[k], b[k]); });
//
// Sources: van Leer (1974); Roe (1986) for minmod and superbee; van Leer (1977) for the monotonised central one.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace riffle {

struct VanLeer {  // smooth; the usual choice
  double operator()(double a, double b) const {
    const double ab = a * b;
    return ab > 0 ? 2 * ab / (a + b) : 0.0;
  }
};

struct Minmod {  // the most dissipative of second order
  double operator()(double a, double b) const {
    const double least = std::abs(a) < std::abs(b) ? a : b;
    return a * b > 0 ? least : 0.0;
  }
};

struct MonotonisedCentral {  // the mean of a and b, but at most twice the smaller
  double operator()(double a, double b) const {
    const double twice = 2 * (std::abs(a) < std::abs(b) ? a : b), mean = 0.5 * (a + b);
    const double least = std::abs(twice) < std::abs(mean) ? twice : mean;
    return a * b > 0 ? least : 0.0;
  }
};

struct Superbee {  // the least dissipative: sharpens contacts, and makes steps of smooth waves
  double operator()(double a, double b) const {
    const bool first = std::abs(a) < std::abs(b);
    const double small = first ? a : b, large = first ? b : a, twice = 2 * small;
    const double most = std::abs(twice) < std::abs(large) ? twice : large;
    return a * b > 0 ? most : 0.0;
  }
};

struct FirstOrder {  // no reconstruction
  double operator()(double, double) const { return 0; }
};

// The choices of a plugin's parameter, and the call of `work` with the limiter of that name.
inline constexpr auto limiter_choices = "van-leer|minmod|monotonised-central|superbee|first-order";

enum class Limiter { van_leer, minmod, monotonised_central, superbee, first_order };

inline Limiter limiter_of(std::string_view name) {
  if (name == "van-leer") return Limiter::van_leer;
  if (name == "minmod") return Limiter::minmod;
  if (name == "monotonised-central") return Limiter::monotonised_central;
  if (name == "superbee") return Limiter::superbee;
  if (name == "first-order") return Limiter::first_order;
  throw std::invalid_argument("there is no limiter \"" + std::string(name) + "\"");
}

template <class Work>
void with_limiter(Limiter limiter, Work work) {
  switch (limiter) {
    case Limiter::van_leer: return work(VanLeer{});
    case Limiter::minmod: return work(Minmod{});
    case Limiter::monotonised_central: return work(MonotonisedCentral{});
    case Limiter::superbee: return work(Superbee{});
    case Limiter::first_order: return work(FirstOrder{});
  }
}

}  // namespace riffle
