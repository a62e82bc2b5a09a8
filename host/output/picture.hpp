// The picture of a run, as SVG and PNG, drawn by gnuplot. picture.gp and picture.dat stay beside it: `gnuplot
// picture.gp` in that folder draws it again, and is where to start when a paper wants it otherwise.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riffle {

// How a series looks: computed as small dots over the exact line; the initial state dashed and grey; measured as open
// circles; ground filled from its line down to the axis. Drawn in the order given, so the ground comes first.
enum class SeriesStyle { computed, exact, initial, measured, ground };

struct Series {
  std::string name;  // in the legend
  SeriesStyle style = SeriesStyle::computed;
  std::vector<double> x, y;  // in any order; NaN where not defined
};

struct Panel {
  std::string y_label;  // "depth [m]"
  std::vector<Series> series;
};

// Panels over one another on a common x axis, for scenes in one dimension.
struct LinePicture {
  std::string title, x_label;
  std::vector<Panel> panels;
};

// Particles in the vertical plane as discs coloured by a value.
struct FieldPicture {
  std::string title, x_label, z_label, value_label;
  std::vector<double> x, z, value;
  double spacing = 0;  // m: diameter of a disc; 0: from the number of particles and the area they cover
};

struct PictureResult {
  bool drawn = false;
  std::string message;  // why not: one sentence for the log
};

// Writes <folder>/picture.{svg,png,gp,dat}. A picture is never worth a run: nothing is thrown for want of gnuplot or
// for what it complains of. Dots closer than about 5 pixels to the one before are not drawn, so that the line under
// them stays visible and the files small; profile.csv has every particle.
PictureResult draw(const std::filesystem::path& folder, const LinePicture& picture);
PictureResult draw(const std::filesystem::path& folder, const FieldPicture& picture);

}  // namespace riffle
