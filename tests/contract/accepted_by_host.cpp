// The host's own judgement of every shipped plugin: loaded, created with its defaults, and its contract checked as at
// the start of a run.
#include <gtest/gtest.h>

#include <sstream>

#include "host/plugins/contracts.hpp"
#include "host/plugins/library.hpp"

namespace riffle::contract {
namespace {

struct Shipped {
  const Plugin* plugin;
  int dim;
};
void PrintTo(const Shipped& shipped, std::ostream* out) {
  *out << shipped.plugin->description.library_path << " in " << shipped.dim << "d";
}

std::vector<Shipped> all_shipped() {
  static std::vector<Library> libraries;
  std::istringstream paths(RIFFLE_PLUGINS);
  for (std::string path; std::getline(paths, path, '|');) libraries.emplace_back(path);
  std::vector<Shipped> shipped;
  for (const Library& library : libraries) {
    for (const Plugin& plugin : library.plugins()) {
      for (const int dim : plugin.description.dimensions) shipped.push_back({&plugin, dim});
    }
  }
  return shipped;
}

class ShippedPlugin : public testing::TestWithParam<Shipped> {};

TEST_P(ShippedPlugin, IsAcceptedByTheHostWithItsDefaults) {
  const auto [plugin, dim] = GetParam();
  const PluginInstance instance(*plugin, dim, default_values(plugin->description));
  EXPECT_EQ(contract_problems(instance), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Host, ShippedPlugin, testing::ValuesIn(all_shipped()), [](const auto& info) {
  std::string name = info.param.plugin->description.kind + "_" + info.param.plugin->description.id;
  for (char& letter : name) letter = letter == '-' ? '_' : letter;
  return name + "_in_" + std::to_string(info.param.dim) + "d";
});

}  // namespace
}  // namespace riffle::contract
