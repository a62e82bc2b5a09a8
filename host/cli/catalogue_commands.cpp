// list, describe, schema: what plugins there are and what they say of themselves.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/cli/describe.hpp"
#include "host/manifest/schema.hpp"

namespace riffle {

namespace {
using Paths = std::vector<std::filesystem::path>;

std::shared_ptr<Paths> plugin_path_option(CLI::App* command) {
  auto paths = std::make_shared<Paths>();
  command->add_option("--plugin-path", *paths, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  return paths;
}
}  // namespace

void add_list(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("list", "List all plugins, by kind");
  auto paths = plugin_path_option(command);
  auto kind = std::make_shared<std::string>();
  command->add_option("kind", *kind, "Only this kind")->check(CLI::IsMember(plugin_kinds()));
  command->callback([paths, kind, &code] {
    const Registry registry = open_registry(*paths, "");
    std::string last;
    for (const auto* plugin : registry.all()) {
      if (!kind->empty() && plugin->kind != *kind) continue;
      if (plugin->kind != last) std::cout << (last.empty() ? "" : "\n") << plugin->kind << "\n";
      last = plugin->kind;
      std::cout << fmt::format("  {:<20} {}\n", plugin->id, plugin->summary);
    }
    for (const auto& note : registry.notes()) std::cout << "\nnote: " << note << "\n";
    for (const auto& bad : registry.bad_libraries()) {
      for (const auto& reason : bad.reasons) std::cerr << "\nleft out: " << reason << "\n";
    }
    code = exit_good;
  });
}

void add_describe(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("describe", "Show a plugin: parameters with units and ranges, passes, source");
  auto paths = plugin_path_option(command);
  auto id = std::make_shared<std::string>();
  command->add_option("id", *id, "Id of the plugin, or kind/id where several kinds share it")->required();
  command->callback([paths, id, &code] {
    const Registry registry = open_registry(*paths, "");
    code = describe_plugin(registry, *id);
  });
}

void add_schema(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("schema", "Print the JSON Schema of manifests, plugins included, for editors");
  auto paths = plugin_path_option(command);
  command->callback([paths, &code] {
    const Registry registry = open_registry(*paths, "");
    std::cout << manifest_schema(registry).dump(2) << "\n";
    code = exit_good;
  });
}

}  // namespace riffle
