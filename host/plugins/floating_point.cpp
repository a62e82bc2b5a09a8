#include "host/plugins/floating_point.hpp"

#include <limits>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace riffle {

std::uint64_t floating_point_control() {
#if defined(__x86_64__)
  constexpr unsigned int flags = 0x3f;  // the six sticky exception flags of MXCSR
  std::uint16_t x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  return (static_cast<std::uint64_t>(x87) << 32U) | (_mm_getcsr() & ~flags);
#else
  // Elsewhere the word has no portable name: what can be observed is the rounding mode and lost subnormal numbers.
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double half = smallest / 2;
  return (static_cast<std::uint64_t>(std::fegetround()) << 1U) | (half == 0 ? 1U : 0U);
#endif
}

FloatingPointGuard::FloatingPointGuard() : control_(floating_point_control()) {
  std::fegetenv(&environment_);
}

bool FloatingPointGuard::restore() {
  if (floating_point_control() == control_) return false;
  std::fesetenv(&environment_);
  return true;
}

}  // namespace riffle
