#include "host/plugins/elf.hpp"

#include <elf.h>

#include <cstring>
#include <stdexcept>

namespace riffle {
namespace {

#if defined(__x86_64__)
constexpr Elf64_Half this_machine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half this_machine = EM_AARCH64;
#elif defined(__riscv)
constexpr Elf64_Half this_machine = EM_RISCV;
#elif defined(__powerpc64__)
constexpr Elf64_Half this_machine = EM_PPC64;
#else
#error "name this machine's ELF code here"
#endif

[[noreturn]] void truncated() {
  throw std::runtime_error("is cut off: the file ends before its own tables say");
}

// A copy of the T at `offset`, so that no alignment is assumed.
template <class T>
T read(std::span<const std::byte> file, std::uint64_t offset) {
  if (offset > file.size() || file.size() - offset < sizeof(T)) truncated();
  T value;
  std::memcpy(&value, file.data() + offset, sizeof(T));
  return value;
}

std::span<const std::byte> section_bytes(std::span<const std::byte> file, const Elf64_Shdr& section) {
  if (section.sh_offset > file.size() || file.size() - section.sh_offset < section.sh_size) truncated();
  return file.subspan(section.sh_offset, section.sh_size);
}

Elf64_Ehdr checked_header(std::span<const std::byte> file) {
  if (file.size() < sizeof(Elf64_Ehdr) || std::memcmp(file.data(), ELFMAG, SELFMAG) != 0) {
    throw std::runtime_error("is not a shared library (no ELF file)");
  }
  const auto header = read<Elf64_Ehdr>(file, 0);
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_machine != this_machine) {
    throw std::runtime_error("is built for another processor than this one");
  }
  if (header.e_type != ET_DYN) throw std::runtime_error("is not a shared library (an ELF file of another type)");
  // The dynamic linker maps what the segments promise and dies of SIGBUS where the file has ended before.
  for (std::uint64_t k = 0; k < header.e_phnum; ++k) {
    const auto segment = read<Elf64_Phdr>(file, header.e_phoff + k * sizeof(Elf64_Phdr));
    if (segment.p_type != PT_LOAD) continue;
    if (segment.p_offset > file.size() || file.size() - segment.p_offset < segment.p_filesz) truncated();
  }
  return header;
}

}  // namespace

std::vector<ExportedSymbol> exported_symbols(std::span<const std::byte> file) {
  const Elf64_Ehdr header = checked_header(file);
  std::vector<ExportedSymbol> symbols;
  for (std::uint64_t k = 0; k < header.e_shnum; ++k) {
    const auto section = read<Elf64_Shdr>(file, header.e_shoff + k * sizeof(Elf64_Shdr));
    if (section.sh_type != SHT_DYNSYM) continue;
    const auto table = section_bytes(file, section);
    const auto text =
        section_bytes(file, read<Elf64_Shdr>(file, header.e_shoff + section.sh_link * sizeof(Elf64_Shdr)));
    for (std::uint64_t at = 0; at + sizeof(Elf64_Sym) <= table.size(); at += sizeof(Elf64_Sym)) {
      const auto symbol = read<Elf64_Sym>(table, at);
      const auto visibility = ELF64_ST_VISIBILITY(symbol.st_other);
      const bool visible = visibility == STV_DEFAULT || visibility == STV_PROTECTED;
      if (symbol.st_shndx == SHN_UNDEF || ELF64_ST_BIND(symbol.st_info) == STB_LOCAL || !visible) continue;
      if (symbol.st_name >= text.size()) truncated();
      const auto* name = reinterpret_cast<const char*>(text.data()) + symbol.st_name;
      symbols.push_back({std::string(name, strnlen(name, text.size() - symbol.st_name)), symbol.st_size});
    }
  }
  return symbols;
}

}  // namespace riffle
