// The depth along x that a run has left in its profile.csv (host/output/profiles.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riffle {

// Columns of the file in the order asked for. Throws std::runtime_error with one sentence.
std::vector<std::vector<double>> profile_columns(const std::filesystem::path& file,
                                                 const std::vector<std::string>& names);

}  // namespace riffle
