#include "host/plugins/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

namespace riffle {
namespace fs = std::filesystem;
namespace {

std::string name_of(const LibraryError::KindAndId& key) {
  return fmt::format("{} \"{}\"", key.first, key.second);
}

// The library would probably give this plugin, going by its file name: "viscosity-monaghan.so", "my_drag.so".
bool sounds_like(const fs::path& library, const std::string& id) {
  std::string stem = library.stem().string();
  std::replace(stem.begin(), stem.end(), '_', '-');
  return stem == id || stem.ends_with("-" + id);
}

std::vector<fs::path> libraries_in(const fs::path& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    if (entry.path().extension() == ".so" && entry.is_regular_file(error)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> plugin_search_path(const std::vector<fs::path>& arguments, const fs::path& manifest_directory,
                                         const fs::path& program_directory) {
  std::vector<fs::path> directories = arguments;
  directories.push_back(manifest_directory);
  if (const char* variable = std::getenv("RIFFLE_PLUGIN_PATH")) {
    std::istringstream text(variable);
    for (std::string directory; std::getline(text, directory, ':');) directories.emplace_back(directory);
  }
  directories.push_back(program_directory);
  std::erase_if(directories, [](const fs::path& directory) { return directory.empty(); });
  return directories;
}

Registry::Registry(const std::vector<fs::path>& directories) {
  std::set<fs::path> seen;
  for (const fs::path& directory : directories) {
    std::error_code error;
    const fs::path canonical = fs::canonical(directory, error);
    if (error || !seen.insert(canonical).second) continue;
    add_directory(canonical);
  }
}

void Registry::add_directory(const fs::path& directory) {
  std::map<Key, const Plugin*> here;
  for (const fs::path& file : libraries_in(directory)) add_library(file, here);
  for (const auto& [key, plugin] : here) {
    if (ambiguous_.contains(key)) continue;
    const auto [entry, added] = plugins_.try_emplace(key, plugin);
    if (!added) {
      notes_.push_back(fmt::format("{} of {} is hidden by the one of {}", name_of(key),
                                   plugin->description.library_path, entry->second->description.library_path));
    }
  }
}

void Registry::add_library(const fs::path& file, std::map<Key, const Plugin*>& here) {
  try {
    const Library& library = libraries_.emplace_back(file);
    notes_.insert(notes_.end(), library.warnings().begin(), library.warnings().end());
    for (const Plugin& plugin : library.plugins()) {
      const Key key{plugin.description.kind, plugin.description.id};
      const auto [other, added] = here.try_emplace(key, &plugin);
      if (added || plugins_.contains(key)) continue;
      const std::string reason =
          fmt::format("{}: {} is also in {}; one directory may hold it once only, so neither is used",
                      plugin.description.library_path, name_of(key), other->second->description.library_path);
      ambiguous_.try_emplace(key, reason);
      bad_.push_back({file, {reason}, {key}});
    }
  } catch (const LibraryError& error) {
    bad_.push_back({file, error.lines(), error.would_give()});
  }
}

const Plugin* Registry::plugin(const std::string& kind, const std::string& id) const {
  const auto found = plugins_.find({kind, id});
  return found == plugins_.end() ? nullptr : found->second;
}

const PluginDescription* Registry::find(const std::string& kind, const std::string& id) const {
  const Plugin* found = plugin(kind, id);
  return found == nullptr ? nullptr : &found->description;
}

std::vector<const PluginDescription*> Registry::all() const {
  std::vector<const PluginDescription*> descriptions;
  for (const std::string& kind : plugin_kinds()) {
    for (const auto& [key, plugin] : plugins_) {
      if (key.first == kind) descriptions.push_back(&plugin->description);
    }
  }
  return descriptions;
}

std::string Registry::why_missing(const std::string& kind, const std::string& id) const {
  const Key key{kind, id};
  if (plugins_.contains(key)) return "";
  if (const auto found = ambiguous_.find(key); found != ambiguous_.end()) return found->second;
  for (const BadLibrary& bad : bad_) {
    if (std::find(bad.would_give.begin(), bad.would_give.end(), key) != bad.would_give.end())
      return bad.reasons.front();
  }
  for (const BadLibrary& bad : bad_) {
    if (bad.would_give.empty() && sounds_like(bad.path, id)) return bad.reasons.front();
  }
  return "";
}

}  // namespace riffle
