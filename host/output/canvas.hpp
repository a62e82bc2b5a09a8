// What the pictures of a run have in common: sizes, ranges of axes, the parts of a gnuplot script, and drawing it. Not
// part of the public face of host/output; see picture.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "host/output/picture.hpp"

namespace riffle::canvas {

// All sizes are in pixels of the SVG, from the upper left corner; the PNG has twice as many. Heights differ.
inline constexpr double width = 900, left = 84, right = 28, title_height = 42, bottom = 60;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] double length() const { return high - low; }
};

// Room around the values; 0 at the edge where it is near, and no zoom into the round-off of a constant.
Range padded(Range range);

// The ends rounded outwards to where an axis has a tic, if that is near: particles stand half a spacing off a wall.
Range snapped(Range range);

// Step of tics for at most `most` intervals: 1, 2 or 5 times a power of ten
double tic_step(const Range& range, double most);

// Everything before the first plot. Scripts go on from here, once for each kind of file, until end_of_script. In them
// dot(d) is the point size of a disc d pixels across.
std::string start_of_script(double height, const std::string& title);
inline constexpr const char* end_of_script = "unset label\nset output\n}\n";

// Place on the canvas in gnuplot's terms
std::string screen(double x, double y, double height);

// The rectangle within the axes
std::string margins(double from_x, double from_y, double to_x, double to_y, double height);

// A turned label beside an axis, where no tic labels can push it about; number 1 is the title's.
std::string turned_label(int number, const std::string& text, double x, double y, double height);

// Writes picture.gp and picture.dat, and draws.
PictureResult run(const std::filesystem::path& folder, const std::string& script, const std::string& data);

}  // namespace riffle::canvas
