// Copies a plugin's constant tables onto structs of this program's version of the boundary. A library built against an
// older minor version has shorter structs: what they lack is zero in the copy, so that the rest of the host knows one
// version only.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "riffle/abi.h"

namespace riffle {

// Mistakes of one plugin, as sentences that begin with where they are.
class Problems {
 public:
  explicit Problems(std::string where) : where_(std::move(where)) {}
  void add(const std::string& what) { lines_.push_back(where_ + ": " + what); }
  void set_where(std::string where) { where_ = std::move(where); }
  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  [[nodiscard]] bool empty() const { return lines_.empty(); }

 private:
  std::string where_;
  std::vector<std::string> lines_;
};

struct CopiedPlugin {
  const riffle_plugin* table = nullptr;  // nullptr when the plugin's own struct has an impossible size
  std::shared_ptr<const void> owner;     // of the table and all tables below it; texts stay in the library
};

// `abi_minor` of the library: structs of our own minor version must have our sizes, older ones may be shorter. Structs of
// impossible size and endless tables are reported and left out.
CopiedPlugin copy_descriptor(const riffle_plugin& plugin, std::uint32_t abi_minor, Problems& problems);

}  // namespace riffle
