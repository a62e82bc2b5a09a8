// Maps of stability as files: <case>[-<closure>].csv, .svg and .png, and stability.md, which reads each column in words.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/study/stability.hpp"

namespace riffle {

std::string map_in_csv(const Study& study, const StabilityResult& result);

// "good up to 1.2, then blew up" along y for each x.
std::string maps_in_markdown(const Study& study, const std::vector<StabilityResult>& results, const std::string& error);

// Writes all of it into the folder. Returns why nothing is drawn, in one sentence, or "".
std::string write_maps(const Study& study, const std::vector<StabilityResult>& results, const std::string& error,
                       const std::filesystem::path& folder);

}  // namespace riffle
