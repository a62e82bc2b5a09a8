// The program: one subcommand per file; all of them thin.
#include <CLI/CLI.hpp>

#include "host/cli/commands.hpp"
#include "host/output/build_info.hpp"

int main(int argc, char** argv) {
  CLI::App app{
      "Riffle: particle (SPH) solver for open-channel and porous-bed flow; physics are plugins named in a TOML "
      "manifest"};
  app.require_subcommand(1);
  app.set_version_flag("--version", riffle::riffle_version());
  int code = 0;
  riffle::add_run(app, code);
  riffle::add_compare(app, code);
  riffle::add_stability(app, code);
  riffle::add_advise(app, code);
  riffle::add_list(app, code);
  riffle::add_describe(app, code);
  riffle::add_explain(app, code);
  riffle::add_schema(app, code);
  riffle::add_bench(app, code);
  riffle::add_check(app, code);
  riffle::add_new(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return code;
}
