// advise: the least model for a scene.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/cli/study_run.hpp"
#include "host/study/advise/advice.hpp"

namespace riffle {

void add_advise(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("advise", "The least model that will do for a case: riffle advise CASE.toml");
  auto request = std::make_shared<AdviceRequest>();
  auto json = std::make_shared<bool>(false);
  command->add_option("case", request->manifest, "The manifest (TOML)")->required();
  command
      ->add_option("--tolerance", request->tolerance,
                   "Change of the depth that does not matter, as a share of it; default 0.005")
      ->check(CLI::Range(1e-6, 1.0));
  command->add_flag("--verify", request->verify, "Measure what each term changes, by two short runs that differ in it");
  command->add_option("--budget", request->budget, "CPU time in seconds that one run of --verify may take; default 20")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", *json, "Print the advice as JSON");
  command->add_option("--set", request->overrides, "Override a key, as for run")->take_all()->allow_extra_args(false);
  command->add_option("--plugin-path", request->plugin_path, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  command->callback([request, json, &code] {
    code = guarded([&] {
      const Registry registry = open_registry(request->plugin_path, request->manifest);
      const Advice advice = advise(*request, registry);
      std::cout << (*json ? advice_in_json(advice) : advice_in_words(advice, request->manifest.string()));
      return exit_good;
    });
  });
}

}  // namespace riffle
