// The checks of `riffle check`, each of one plugin. Each runs in a process of its own (see child.hpp), so it may crash.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host/plugins/library.hpp"

namespace riffle::check {

struct Findings {
  std::vector<std::string> failures;  // sentences; none: the check is passed
  std::vector<std::string> warnings;  // worth a line, but nothing is wrong
  std::string summary;                // what was tried, shown when all is well

  void fail(std::string line) { failures.push_back(std::move(line)); }
  void warn(std::string line) { warnings.push_back(std::move(line)); }
};

// The summary of a check that finds nothing to look at.
inline constexpr const char* nothing = "does not apply";

// One exported symbol, loads at once, leaves arithmetic and threads alone, all descriptors good. `plugins` receives the
// (kind, id) of what it gives.
Findings check_loading(const std::filesystem::path& file, std::vector<std::pair<std::string, std::string>>& plugins);

// Created and destroyed at its defaults, at every bound, and with 50 random sets of parameters.
Findings check_creation(const Plugin& plugin);
// The contract of its kind (contracts.hpp) at the defaults.
Findings check_contract(const Plugin& plugin);
// The same with each parameter at each of its bounds.
Findings check_bounds(const Plugin& plugin);
// Writes only what it declares and only as far as it may.
Findings check_writes(const Plugin& plugin);
// Runs with inputs that cannot be written; a crash is the finding.
Findings check_inputs(const Plugin& plugin);
// A value depends on its own pair or particle alone: the same bits whatever the block holds besides.
Findings check_blocks(const Plugin& plugin);
// The same bits when called again, and from several threads at once.
Findings check_threads(const Plugin& plugin);
// With other units of mass, length and time the same physics comes out: no constant with a hidden unit.
Findings check_dimensions(const Plugin& plugin);
// Votes on the time step are positive, and that of a block is the least of its parts.
Findings check_votes(const Plugin& plugin);
// Nanoseconds per pair in a block that fits the first-level cache.
Findings check_speed(const Plugin& plugin);

}  // namespace riffle::check
