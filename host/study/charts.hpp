// Still charts for papers and documentation, drawn by gnuplot as the pictures of runs are: charts/<case>-<error>-cost as
// .svg and .png, and -convergence as .svg. charts/charts.gp and charts.dat stay beside them and draw them again.
#pragma once

#include <filesystem>
#include <string>

#include "host/study/results.hpp"

namespace riffle {

// Returns why there are none, in one sentence, or "". Charts are never worth a study: nothing is thrown.
std::string draw_charts(const StudyResults& results, const std::filesystem::path& folder);

// Runs a script with its data in <folder>, both written there first as <stem>.gp and <stem>.dat. The script draws
// <name>.svg and <name>.png for each of `names`. Returns why it did not, or "".
std::string draw_with_gnuplot(const std::filesystem::path& folder, const std::string& stem, const std::string& script,
                              const std::string& data);

// What stands before a plot for each of two kinds of file; the script must end what it begins with end_of_chart.
std::string begin_of_charts(int width, int height);
inline constexpr const char* end_of_charts = "unset output\n}\n";

// Colour number k of the palette that colour-blind readers tell apart, "'#0072b2'".
std::string colour_of(std::size_t k);

}  // namespace riffle
