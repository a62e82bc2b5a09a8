// The log of a run: short on the console (stderr), complete with times in log.txt of the run's folder.
#pragma once

#include <spdlog/logger.h>

#include <filesystem>
#include <memory>

namespace riffle {

// `file`: log.txt, appended to, so that a resumed run goes on in it; empty: console only. `quiet`: the console shows
// warnings and errors only. Every line reaches the file at once: a killed run leaves its log.
// Throws std::runtime_error with one sentence when the file cannot be opened.
std::shared_ptr<spdlog::logger> open_log(const std::filesystem::path& file, bool quiet);

}  // namespace riffle
