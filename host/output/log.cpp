#include "host/output/log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <unistd.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace riffle {

std::shared_ptr<spdlog::logger> open_log(const std::filesystem::path& file, bool quiet) {
  auto console = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  console->set_level(quiet ? spdlog::level::warn : spdlog::level::info);
  // On a terminal a progress bar may stand in the line: it is cleared first, and drawn again by its next update.
  console->set_pattern(::isatty(STDERR_FILENO) != 0 ? "\r\x1b[K%^%l%$: %v" : "%l: %v");
  std::vector<spdlog::sink_ptr> sinks{console};
  if (!file.empty()) {
    try {
      auto lines = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file.string(), false);
      lines->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
      sinks.push_back(std::move(lines));
    } catch (const spdlog::spdlog_ex& error) {
      throw std::runtime_error("cannot write " + file.string() + ": " + error.what());
    }
  }
  auto log = std::make_shared<spdlog::logger>("riffle", sinks.begin(), sinks.end());
  log->set_level(spdlog::level::debug);
  log->flush_on(spdlog::level::debug);
  return log;
}

}  // namespace riffle
