// Running gnuplot, which draws the pictures of a run: an established tool, found on PATH and never required.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace riffle {

// The program "gnuplot" on PATH, or nothing.
std::optional<std::filesystem::path> find_gnuplot();

// Runs a script of `folder` there, with nobody's start-up file. `variables`: gnuplot statements before the script.
// Returns what gnuplot complained of when it failed, or an empty text.
std::string run_gnuplot(const std::filesystem::path& program, const std::filesystem::path& folder,
                        const std::string& script, const std::string& variables);

// A literal of gnuplot for any text. Within single quotes gnuplot substitutes nothing: no commands in backquotes, no
// escapes. Control characters become spaces.
std::string gnuplot_text(const std::string& text);

}  // namespace riffle
