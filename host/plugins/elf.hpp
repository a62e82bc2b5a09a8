// What a shared library exports, read from the file without running any of it.
//
// boost::dll::library_info would be the natural tool, but in Boost 1.74 it reads .symtab only, so that a stripped
// plugin has no symbols at all, and it looks names up in the last string table of the file, so that a partly stripped
// one has wrong names (boostorg/dll issue 41). It also trusts every size that it reads. This reader goes by .dynsym, the
// table that the dynamic linker uses, and believes no offset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace riffle {

struct ExportedSymbol {
  std::string name;
  std::uint64_t size = 0;  // bytes, of a data object
};

// Defined, visible symbols of an ELF shared library for this machine. Throws std::runtime_error with the reason, as the
// end of a sentence ("is not a shared library ..."), when the bytes are anything else or end too early.
std::vector<ExportedSymbol> exported_symbols(std::span<const std::byte> file);

}  // namespace riffle
