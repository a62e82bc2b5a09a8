// `riffle new`: a plugin project of one's own, from the templates of sdk/template, which are part of the program.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace riffle {

// "viscosity.cpp", "viscosity.toml", ..., "CMakeLists.txt": the templates, by file name.
const std::map<std::string, std::string>& plugin_templates();

// The name of a C++ class for a plugin id: "my-drag" gives "MyDrag".
std::string class_name(const std::string& id);

// Makes `folder` with <id>.cpp, CMakeLists.txt and case.toml. `sdk` is where RiffleSDKConfig.cmake is, for builds where
// CMake would not look by itself. Either all of it appears or nothing. Throws std::runtime_error with one sentence when
// there is no such kind, the id is not [a-z][a-z0-9-]*, the folder exists, or it cannot be written.
void write_plugin_project(const std::string& kind, const std::string& id, const std::filesystem::path& folder,
                          const std::filesystem::path& sdk);

}  // namespace riffle
