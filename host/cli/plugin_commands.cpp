// check and new: for those who write plugins.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/cli/new_plugin.hpp"
#include "host/plugins/check/check.hpp"

namespace riffle {
namespace {

// Where RiffleSDKConfig.cmake is: under the prefix of an installed program, else in the sources it was built from.
std::filesystem::path sdk_directory() {
  const auto installed = program_directory() / ".." / "lib" / "cmake" / "RiffleSDK";
  std::error_code error;
  if (std::filesystem::exists(installed, error)) return std::filesystem::canonical(installed);
  return std::filesystem::path(RIFFLE_SOURCE_DIRECTORY) / "sdk" / "cmake";
}

int make_project(const std::string& kind, const std::string& id, std::filesystem::path folder) {
  try {
    const Registry registry = open_registry({}, "");
    if (const auto* existing = registry.find(kind, id); existing != nullptr) {
      throw std::runtime_error(
          fmt::format("there is a {} \"{}\" already ({}); choose another name", kind, id, existing->library_path));
    }
    if (folder.empty()) folder = id;
    write_plugin_project(kind, id, folder, sdk_directory());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return exit_bad_input;
  }
  const std::string at = folder.string();
  std::cout << fmt::format(
      "{0}/{1}.cpp works as it is (kind: {2}); put your formula into it. From here:\n\n"
      "  cmake -S {0} -B {0}/build && cmake --build {0}/build\n"
      "  riffle check {0}/{1}.so\n"
      "  riffle run {0}/case.toml\n",
      at, id, kind);
  return exit_good;
}

}  // namespace

void add_check(CLI::App& app, int& code) {
  auto* command = app.add_subcommand(
      "check",
      "Try a plugin library: does it keep the rules of the boundary, and what its kind owes? Crashes included");
  auto files = std::make_shared<std::vector<std::filesystem::path>>();
  auto seconds = std::make_shared<double>(20);
  command->add_option("library", *files, "The shared library, or several")->required()->check(CLI::ExistingFile);
  command->add_option("--limit", *seconds, "Longest time that one check may take, in seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->callback([files, seconds, &code] {
    const auto limit = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * *seconds));
    code = exit_good;
    for (const auto& file : *files) {
      if (check_library(file, std::cout, limit) != 0) code = exit_failed;
    }
  });
}

void add_new(CLI::App& app, int& code) {
  auto* command =
      app.add_subcommand("new", "Start a plugin of your own: a project that builds, passes `check` and runs in a case");
  auto kind = std::make_shared<std::string>();
  auto id = std::make_shared<std::string>();
  auto folder = std::make_shared<std::filesystem::path>();
  command->add_option("kind", *kind, fmt::format("What it is: {}", fmt::join(plugin_kinds(), ", ")))->required();
  command->add_option("name", *id, "Its id: small letters, digits and hyphens, such as my-drag")->required();
  command->add_option("--folder", *folder, "Where the project is made; the name itself unless given");
  command->callback([kind, id, folder, &code] { code = make_project(*kind, *id, *folder); });
}

}  // namespace riffle
