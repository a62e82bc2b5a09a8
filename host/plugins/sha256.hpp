// SHA-256 (FIPS 180-4) of a file, for the provenance of a run: which library was it?
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace riffle {

// 64 hexadecimal digits in lower case.
std::string sha256(std::span<const std::byte> bytes);

}  // namespace riffle
