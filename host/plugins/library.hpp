// One shared library of plugins: looked at from outside first, then loaded, then believed only after every table of it
// has been checked.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/plugins/description.hpp"
#include "riffle/abi.h"

namespace riffle {

struct Plugin {
  PluginDescription description;
  const riffle_plugin* table = nullptr;  // structs of this program's version; all names, units and functions checked
  std::shared_ptr<const void> owner;     // of the tables
};

// Why a library cannot be used: sentences that name the library and, where it got so far, the plugin.
class LibraryError : public std::runtime_error {
 public:
  using KindAndId = std::pair<std::string, std::string>;
  LibraryError(std::vector<std::string> lines, std::vector<KindAndId> would_give = {});
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<KindAndId>& would_give() const { return would_give_; }  // had it been good

 private:
  std::vector<std::string> lines_;
  std::vector<KindAndId> would_give_;
};

// Reads and checks the tables of a library; `name` is used in messages and in the descriptions. Also serves closures that
// are linked into a test instead of loaded. Throws LibraryError with every mistake.
std::vector<Plugin> read_plugins(const riffle_library& entry, const std::string& name);

class Library {
 public:
  // Loads the file. It stays loaded until the program ends, because plugins may have left pointers to it anywhere. A file
  // that does not export riffle_plugin_entry is never loaded. Throws LibraryError.
  explicit Library(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::vector<Plugin>& plugins() const { return plugins_; }
  // What it did on loading that it should not; the host has put it right. Sentences.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::filesystem::path path_;
  std::vector<Plugin> plugins_;
  std::vector<std::string> warnings_;
};

}  // namespace riffle
