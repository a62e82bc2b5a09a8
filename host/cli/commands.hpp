// The subcommands. Each adds itself to the program and, when chosen, leaves its exit code in `code`.
#pragma once

namespace CLI {
class App;
}

namespace riffle {

void add_run(CLI::App& app, int& code);
void add_list(CLI::App& app, int& code);
void add_describe(CLI::App& app, int& code);
void add_explain(CLI::App& app, int& code);
void add_schema(CLI::App& app, int& code);
void add_bench(CLI::App& app, int& code);
void add_check(CLI::App& app, int& code);
void add_new(CLI::App& app, int& code);
void add_compare(CLI::App& app, int& code);
void add_stability(CLI::App& app, int& code);
void add_advise(CLI::App& app, int& code);

}  // namespace riffle
