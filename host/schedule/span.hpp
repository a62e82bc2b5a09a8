#pragma once

#include <cstdint>

namespace riffle {

// Owned particles [first, last) of one role, given as a bit.
struct Span {
  std::int64_t first, last;
  std::uint32_t role;
};

}  // namespace riffle
