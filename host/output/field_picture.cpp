#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host/output/canvas.hpp"
#include "host/output/gnuplot.hpp"
#include "host/output/picture.hpp"

namespace riffle {
namespace {

using canvas::Range;

// A field of more particles is drawn as a mean over small squares: the SVG takes some 90 bytes for each.
constexpr std::size_t most_discs = 40000;

// Where a field is drawn: ranges in m, and pixels per m, which differ in a very long or very high scene
struct Frame {
  Range x, z;
  double px = 1, pz = 1;
};

// What is drawn of a field: x, z, value by rows, as discs of a diameter in pixels
struct Discs {
  std::string text;
  double diameter = 0;
};

// Particles as they are; where there are more than a picture can show, the mean over small squares instead.
Discs discs_of(const FieldPicture& picture, const Frame& frame, double spacing) {
  const std::size_t n = picture.x.size();
  Discs discs;
  if (n <= most_discs) {
    const double apart = spacing * std::max(frame.px, frame.pz);
    // Discs too small to be told apart overlap, or the gaps between them would be a pattern of their own.
    discs.diameter = (apart < 4 ? 1.5 : 0.95) * apart;
    for (std::size_t i = 0; i < n; ++i) {
      fmt::format_to(std::back_inserter(discs.text), "{:.7g} {:.7g} {:.7g}\n", picture.x[i], picture.z[i],
                     picture.value[i]);
    }
    return discs;
  }
  const double cell =
      std::sqrt(frame.x.length() * frame.px * frame.z.length() * frame.pz / static_cast<double>(most_discs));
  const auto columns = static_cast<std::size_t>(frame.x.length() * frame.px / cell) + 1;
  const auto rows = static_cast<std::size_t>(frame.z.length() * frame.pz / cell) + 1;
  std::vector<double> sum(columns * rows, 0.0), count(columns * rows, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(picture.x[i]) || !std::isfinite(picture.z[i])) continue;
    const auto column = static_cast<std::size_t>((picture.x[i] - frame.x.low) * frame.px / cell);
    const auto row = static_cast<std::size_t>((picture.z[i] - frame.z.low) * frame.pz / cell);
    sum[row * columns + column] += picture.value[i];
    count[row * columns + column] += 1;
  }
  discs.diameter = 1.6 * cell;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    if (count[k] == 0) continue;
    const double x = frame.x.low + (static_cast<double>(k % columns) + 0.5) * cell / frame.px;
    const double z = frame.z.low + (static_cast<double>(k / columns) + 0.5) * cell / frame.pz;
    fmt::format_to(std::back_inserter(discs.text), "{:.7g} {:.7g} {:.7g}\n", x, z, sum[k] / count[k]);
  }
  return discs;
}

}  // namespace

PictureResult draw(const std::filesystem::path& folder, const FieldPicture& picture) {
  Range xs, zs, values;
  for (const double x : picture.x) xs.include(x);
  for (const double z : picture.z) zs.include(z);
  for (const double v : picture.value) values.include(v);
  if (!(xs.low <= xs.high)) xs = zs = {0, 1};
  const double area = std::max(xs.length(), 1e-12) * std::max(zs.length(), 1e-12);
  const double spacing =
      picture.spacing > 0 ? picture.spacing : std::sqrt(area / static_cast<double>(picture.x.size() + 1));
  xs = {xs.low - spacing, xs.high + spacing};
  zs = {zs.low - spacing, zs.high + spacing};
  if (!(values.length() > 0)) values = canvas::padded(values);

  // Equal scales: a long flume makes a low picture, a tall tank a narrow one.
  constexpr double bar_room = 84, most = 640, least = 90;
  double across = canvas::width - canvas::left - canvas::right - bar_room;
  double down = across * zs.length() / xs.length();
  if (down > most) across *= most / down;
  down = std::clamp(down, least, most);
  const double upper = canvas::title_height + 14, height = upper + down + canvas::bottom;

  const Discs discs = discs_of(picture, {xs, zs, across / xs.length(), down / zs.length()}, spacing);
  std::string script = canvas::start_of_script(height, picture.title);
  script += canvas::margins(canvas::left, upper, canvas::left + across, upper + down, height);
  script += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset cbrange [{}:{}]\n", xs.low, xs.high, zs.low,
                        zs.high, values.low, values.high);
  script += fmt::format("set xtics {}\nset ytics {}\nset cbtics {} format '%g'\n", canvas::tic_step(xs, across / 80),
                        canvas::tic_step(zs, down / 30), canvas::tic_step(values, down / 30));
  // Viridis: even steps to the eye, in grey and for colour-blind readers too
  script +=
      "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', "
      "6 '#5ec962', 7 '#addc30', 8 '#fde725')\n";
  script +=
      fmt::format("set colorbox user origin {} size screen {:.5f}, screen {:.5f} noborder\n",
                  canvas::screen(canvas::left + across + 16, upper + down, height), 13 / canvas::width, down / height);
  script += canvas::turned_label(2, picture.z_label, 24, upper + down / 2, height);
  script +=
      canvas::turned_label(3, picture.value_label, canvas::left + across + bar_room + 14, upper + down / 2, height);
  script += fmt::format("set xlabel {} textcolor rgb '#1a1a1a'\nunset key\n", gnuplot_text(picture.x_label));
  script += fmt::format("plot 'picture.dat' using 1:2:3 with points pt 7 ps dot({:.3f}) lc palette\n", discs.diameter);
  return canvas::run(
      folder, script + canvas::end_of_script,
      fmt::format("# {}, {}, {}\n{}", picture.x_label, picture.z_label, picture.value_label, discs.text));
}

}  // namespace riffle
