// What the parts of the manifest reader share while one manifest is read.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "host/manifest/case.hpp"
#include "host/manifest/document.hpp"

namespace riffle {

struct Reading {
  Reading(const TomlNode& root, const PluginCatalogue& catalogue) : root(root), catalogue(catalogue) {}

  const TomlNode& root;
  const PluginCatalogue& catalogue;
  std::filesystem::path folder;  // relative paths start here
  Mistakes mistakes;
  Case result;
  nlohmann::ordered_json effective = nlohmann::ordered_json::object();
  int dim = 0;                               // 0 as long as the manifest has not said it rightly
  std::map<std::string, double> quantities;  // those that parameters may inherit: "fluid.gravity", "domain.x_min", ...
  std::set<std::string> mistaken;            // those that would be there but for a mistake already noted
};

}  // namespace riffle
