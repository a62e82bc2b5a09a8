// All plugins that the program can find. A bad library never stops the others: it is remembered with its reason.
#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/plugins/library.hpp"

namespace riffle {

// Directories in the order in which they are searched: those of --plugin-path, the manifest's, those of the environment
// variable RIFFLE_PLUGIN_PATH (separated by colons), the program's own. Empty paths are left out.
std::vector<std::filesystem::path> plugin_search_path(const std::vector<std::filesystem::path>& arguments,
                                                      const std::filesystem::path& manifest_directory,
                                                      const std::filesystem::path& program_directory);

class Registry : public PluginCatalogue {
 public:
  struct BadLibrary {
    std::filesystem::path path;
    std::vector<std::string> reasons;  // whole sentences, which name the library
    std::vector<LibraryError::KindAndId> would_give;
  };

  // Loads every *.so of the directories (not of directories below them). Of two plugins with one kind and id the one in
  // the earlier directory is used; in one directory they are an error, and neither is.
  explicit Registry(const std::vector<std::filesystem::path>& directories);

  Registry(Registry&&) = default;  // but no copies: plugins are known by their addresses
  Registry& operator=(Registry&&) = default;

  [[nodiscard]] const PluginDescription* find(const std::string& kind, const std::string& id) const override;
  [[nodiscard]] std::vector<const PluginDescription*> all() const override;  // by kind as in plugin_kinds(), then id
  [[nodiscard]] std::string why_missing(const std::string& kind, const std::string& id) const override;

  // With the functions; nullptr when there is none. Valid as long as the registry.
  [[nodiscard]] const Plugin* plugin(const std::string& kind, const std::string& id) const;
  [[nodiscard]] const std::vector<BadLibrary>& bad_libraries() const { return bad_; }
  // Sentences about what was found but is not as it should be: hidden plugins, changed arithmetic.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  using Key = LibraryError::KindAndId;
  void add_directory(const std::filesystem::path& directory);
  void add_library(const std::filesystem::path& file, std::map<Key, const Plugin*>& here);

  std::list<Library> libraries_;  // a list: plugins keep their addresses
  std::map<Key, const Plugin*> plugins_;
  std::map<Key, std::string> ambiguous_;  // with the sentence that names both libraries
  std::vector<BadLibrary> bad_;
  std::vector<std::string> notes_;
};

}  // namespace riffle
