// The floating-point environment of the calling thread, kept safe from plugins. A library linked with -ffast-math sets
// "flush to zero" for whoever loads it (GCC bug 55522), which changes the host's own arithmetic without a word.
#pragma once

#include <cfenv>
#include <cstdint>

namespace riffle {

// Takes the environment when made, puts it back when restored or destroyed. Rounding mode, exception masks and (x86)
// flush-to-zero are covered; exception flags are not compared, since any arithmetic may raise them.
class FloatingPointGuard {
 public:
  FloatingPointGuard();
  ~FloatingPointGuard() { restore(); }
  FloatingPointGuard(const FloatingPointGuard&) = delete;
  FloatingPointGuard& operator=(const FloatingPointGuard&) = delete;

  // True when somebody changed the environment since this guard was made; it is as before afterwards.
  bool restore();

 private:
  std::fenv_t environment_{};
  std::uint64_t control_ = 0;
};

// The control bits alone, to compare: rounding, masks, treatment of subnormal numbers.
std::uint64_t floating_point_control();

}  // namespace riffle
