#include <CLI/CLI.hpp>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/cli/run_driver.hpp"

namespace riffle {

void add_run(CLI::App& app, int& code) {
  auto request = std::make_shared<RunRequest>();
  auto* run = app.add_subcommand("run", "Run a case: riffle run cases/dam-break/wet-0.5.toml");
  run->add_option("case", request->manifest, "The manifest (TOML)");
  run->add_option("--out", request->out, "Folder for the results; default runs/<case>-<n>");
  run->add_flag("--overwrite", request->overwrite, "Replace the run that is in --out");
  run->add_option("--resume", request->resume, "Go on from the last checkpoint of this run folder");
  run->add_option("--threads", request->threads,
                  "Number of threads; default all cores, fewer for small cases. Results do not depend on it")
      ->check(CLI::Range(1, 1024));
  run->add_option("--set", request->overrides, "Override a key: --set plugins.viscosity.alpha=1.0 (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  run->add_option("--plugin-path", request->plugin_path, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  run->add_option("--block", request->block, "Pairs per block, for experiments. Results do not depend on it")
      ->check(CLI::Range(4, 1000));
  run->add_option("--chunk", request->chunk, "Particles per chunk, for experiments. Results do not depend on it")
      ->check(CLI::Range(1, 1000000));
  run->add_flag("--quiet", request->quiet, "Only warnings, errors and the result");
  run->add_flag("--strict", request->strict, "Exit code 3 when the result is suspect");
  run->callback([request, run, &code] {
    if (request->manifest.empty() == request->resume.empty()) {
      throw CLI::ValidationError("run",
                                 run->get_help_ptr() != nullptr ? "give a manifest or --resume DIR, and not both" : "");
    }
    code = run_case(*request);
  });
}

}  // namespace riffle
