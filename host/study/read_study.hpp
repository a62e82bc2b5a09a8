// From STUDY.toml to a study, checked as a manifest is: every mistake, with its place, in one go.
#pragma once

#include <filesystem>

#include "host/plugins/description.hpp"
#include "host/study/study.hpp"

namespace riffle {

enum class StudyPurpose { compare, stability };

// Throws ManifestError. Whether a varied key exists is seen only when combinations are tried (plan.hpp).
Study read_study(const std::filesystem::path& file, StudyPurpose purpose, const PluginCatalogue& catalogue);

}  // namespace riffle
