#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "host/output/canvas.hpp"
#include "host/output/gnuplot.hpp"
#include "host/output/picture.hpp"

namespace riffle {
namespace {

using canvas::Range;

constexpr double panel_height = 250, panel_gap = 26, legend_height = 30,
                 within = canvas::width - canvas::left - canvas::right;

// Closer than this a dot adds ink and hides the line under it; closer than the other a line's points cannot be told
// apart.
constexpr double dot_gap = 5.5, line_gap = 0.3;

std::vector<std::size_t> order_of(const std::vector<double>& x) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  return order;
}

// What is drawn of a series, along x
struct Points {
  std::string text;
  int count = 0;
};

Points points_of(const Series& series, const Range& xs, const Range& ys, double gap) {
  const double px = within / xs.length(), py = panel_height / ys.length();
  Points points;
  double last_x = -1e9, last_y = -1e9;
  const auto order = order_of(series.x);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double x = series.x[order[k]], y = series.y[order[k]];
    const bool end = k == 0 || k + 1 == order.size();
    if (!end && std::hypot((x - last_x) * px, (y - last_y) * py) < gap) continue;
    fmt::format_to(std::back_inserter(points.text), "{} {}\n", x, y);
    ++points.count;
    last_x = x;
    last_y = y;
  }
  return points;
}

// Okabe and Ito's palette, which colour-blind readers tell apart; dots and dashes tell the rest. `scale` enlarges dots.
std::string look_of(SeriesStyle style, double scale) {
  switch (style) {
    case SeriesStyle::computed: return fmt::format("with points pt 7 ps dot({:.2f}) lc rgb '#d55e00'", 3.6 * scale);
    case SeriesStyle::exact: return "with lines lw 1.8 lc rgb '#0072b2'";
    case SeriesStyle::initial: return "with lines lw 1.5 dt (7,5) lc rgb '#8c8c8c'";
    case SeriesStyle::measured: return "with points pt 6 ps dot(7) lw 1.5 lc rgb '#1a1a1a'";
    case SeriesStyle::ground: return "with filledcurves x1 fs solid 1.0 border lc rgb '#a89a86' fc rgb '#d9d0c3'";
  }
  return "with lines";
}

bool in_legend(const Series& series) {
  return series.style != SeriesStyle::ground;  // nobody takes it for anything else
}

bool same_legend(const Panel& a, const Panel& b) {
  const auto names = [](const Panel& panel) {
    std::vector<std::pair<std::string, SeriesStyle>> list;
    for (const Series& s : panel.series) {
      if (in_legend(s)) list.emplace_back(s.name, s.style);
    }
    return list;
  };
  return names(a) == names(b);
}

// Data and plot command of one panel
struct Drawing {
  std::string data, plot;
};

Drawing drawing_of(const Panel& panel, const Range& xs, const Range& ys, bool legend, int& block) {
  Drawing drawing;
  std::string keys;
  for (const Series& s : panel.series) {
    const Points points = points_of(s, xs, ys, s.style == SeriesStyle::computed ? dot_gap : line_gap);
    drawing.data += fmt::format("# {}: {}\n{}\n\n", panel.y_label, s.name, points.text);
    const char* separator = drawing.plot.empty() ? "plot" : ",";
    drawing.plot += fmt::format("{} \\\n  'picture.dat' index {} using 1:2 {} notitle", separator, block++,
                                look_of(s.style, points.count < 150 ? 1.5 : 1));
    if (legend && in_legend(s))
      keys += fmt::format(", \\\n  keyentry {} title {}", look_of(s.style, 2), gnuplot_text(s.name));
  }
  drawing.plot += keys + "\n";
  return drawing;
}

}  // namespace

PictureResult draw(const std::filesystem::path& folder, const LinePicture& picture) {
  Range xs;
  for (const Panel& panel : picture.panels) {
    for (const Series& s : panel.series) std::for_each(s.x.begin(), s.x.end(), [&](double x) { xs.include(x); });
  }
  xs = canvas::snapped(xs);

  // Upper edges of the panels, from the top; one legend for all panels that agree with the one above
  std::vector<double> upper;
  std::vector<bool> legend;
  double height = canvas::title_height;
  for (std::size_t k = 0; k < picture.panels.size(); ++k) {
    legend.push_back(k == 0 || !same_legend(picture.panels[k - 1], picture.panels[k]));
    if (k > 0) height += panel_gap;
    if (legend.back()) height += legend_height;
    upper.push_back(height);
    height += panel_height;
  }
  height += canvas::bottom;

  std::string data, script = canvas::start_of_script(height, picture.title);
  script += fmt::format("set xrange [{}:{}]\nset multiplot\n", xs.low, xs.high);
  int block = 0;
  for (std::size_t k = 0; k < picture.panels.size(); ++k) {
    const Panel& panel = picture.panels[k];
    Range ys;
    for (const Series& s : panel.series) std::for_each(s.y.begin(), s.y.end(), [&](double y) { ys.include(y); });
    ys = canvas::padded(ys);
    const bool last = k + 1 == picture.panels.size();
    script += canvas::margins(canvas::left, upper[k], canvas::width - canvas::right, upper[k] + panel_height, height);
    script += fmt::format("set yrange [{}:{}]\n", ys.low, ys.high);
    script += canvas::turned_label(2, panel.y_label, 24, upper[k] + panel_height / 2, height);
    script += fmt::format("set format x '{}'\nset xlabel {} textcolor rgb '#1a1a1a'\n", last ? "%g" : "",
                          last ? gnuplot_text(picture.x_label) : "''");
    script += fmt::format("set key at {} left top Left reverse horizontal samplen 2.5 textcolor rgb '#333333'\n",
                          canvas::screen(canvas::left - 8, upper[k] - 30, height));
    const Drawing drawing = drawing_of(panel, xs, ys, legend[k], block);
    script += drawing.plot + "unset label 1\n";
    data += drawing.data;
  }
  return canvas::run(folder, script + "unset multiplot\n" + canvas::end_of_script, data);
}

}  // namespace riffle
