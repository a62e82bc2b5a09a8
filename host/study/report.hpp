// report.html: the study's results in one file that needs no network, drawn by Chart.js, which is put into it. Pictures
// of runs stay where they are, beside the report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "host/study/results.hpp"

namespace riffle {

// What the page draws; its script (report/page.js) is the only reader.
nlohmann::json report_data(const StudyResults& results);

// The library's minified file: the one that was installed with the program, or that of Debian's libjs-chart.js. Empty
// when there is none.
std::filesystem::path find_chart_library(const std::filesystem::path& program_directory);

// Throws std::runtime_error with one sentence.
void write_report(const std::filesystem::path& file, const nlohmann::json& data, const std::filesystem::path& library);

// "48 combinations, 46 finished, 2 blew up; 4 skipped as meaningless."
std::string counts_of(const StudyResults& results);
// "blew up at t = 3.1 s"
std::string state_of(const PointResult& point);

// The parts of the page, put into the program by the build.
extern const char* const report_page;
extern const char* const report_style;
extern const char* const report_script;

}  // namespace riffle
