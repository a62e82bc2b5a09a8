#include "host/study/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

#include "host/output/atomic_file.hpp"
#include "host/output/build_info.hpp"
#include "host/output/gnuplot.hpp"
#include "host/study/relative.hpp"

namespace riffle {
namespace {

// Okabe and Ito's, then four more; the report's page has the same.
constexpr std::array<const char*, chart_colours> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                                                         "#56b4e9", "#000000", "#8c8c8c", "#7f3c8d", "#a5aa00"};

struct Pair {
  double x = 0, y = 0;
};

// A little more than the values, with marks at 1, 2 and 5 of each decade.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] std::string settings(char axis) const {
    std::string tics;
    for (double decade = std::pow(10, std::floor(std::log10(low))); decade < high; decade *= 10) {
      for (const double step : {1.0, 2.0, 5.0}) tics += fmt::format("{}{:g}", tics.empty() ? "" : ", ", step * decade);
    }
    return fmt::format("set {0}range [{1:.4g}:{2:.4g}]\nset {0}tics ({3})\n", axis, low / 1.2, high * 1.2, tics);
  }
};

class Drawing {
 public:
  std::string script, data;
  int blocks = 0;
  Span xs, ys;  // of the chart at hand

  // A block of data, as the plot command names it; empty when nothing can be drawn on logarithms.
  std::string block(const std::vector<Pair>& points) {
    std::string rows;
    for (const Pair& p : points) {
      if (!(p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y))) continue;
      rows += fmt::format("{} {}\n", p.x, p.y);
      xs.include(p.x);
      ys.include(p.y);
    }
    if (rows.empty()) return "";
    data += rows + "\n\n";
    return fmt::format("'charts.dat' index {}", blocks++);
  }
};

std::vector<Pair> pairs_of(const ResultLine& line, std::size_t error, bool against_cost) {
  std::vector<Pair> pairs;
  for (const PointResult* point : line.points) {
    if (!point->counts()) continue;
    pairs.push_back({against_cost ? point->cost : static_cast<double>(point->particles), point->errors[error]});
  }
  return pairs;
}

std::string look(const ResultLine& line) {
  static constexpr std::array<int, chart_marks> marks{7, 5, 9, 13, 11};
  return fmt::format("with linespoints lc rgb {} lw 1.5 pt {} ps 0.9 dt {}", colour_of(line.colour),
                     marks[line.mark % marks.size()], 1 + line.mark % 5);
}

void chart(Drawing& drawing, const StudyResults& results, const std::vector<ResultLine>& lines, const std::string& name,
           std::size_t error, bool against_cost) {
  std::string plots, title;
  drawing.xs = drawing.ys = {};
  const auto add = [&](const std::string& block, const std::string& rest) {
    if (!block.empty()) plots += fmt::format("{}{} {}", plots.empty() ? "" : ", \\\n  ", block, rest);
  };
  if (against_cost) {
    std::vector<Pair> front;
    for (const PointResult* point : front_of(results, name, error))
      front.push_back({point->cost, point->errors[error]});
    add(drawing.block(front), "with lines lw 7 lc rgb '#d9d9d9' title 'Pareto front'");
  }
  for (const ResultLine& line : lines) {
    if (line.case_name != name) continue;
    title = line.case_title;
    add(drawing.block(pairs_of(line, error, against_cost)),
        fmt::format("{} title {}", look(line), gnuplot_text(line.label)));
  }
  if (plots.empty() || (!against_cost && !(drawing.xs.low < drawing.xs.high))) return;
  const std::string what = shown_name(results.errors[error]);
  drawing.script += drawing.xs.settings('x') + drawing.ys.settings('y');
  // Convergence as SVG only: PNG is what takes time, and who needs it draws it again.
  drawing.script +=
      fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n{}set output '{}-{}-{}.' . kind\nplot {}\n{}",
                  gnuplot_text(title), gnuplot_text(against_cost ? shown_name(results.cost) : "particles"),
                  gnuplot_text(what), against_cost ? "" : "if (kind eq 'svg') {\n", name, what,
                  against_cost ? "cost" : "convergence", plots, against_cost ? "" : "}\n");
}

}  // namespace

std::string colour_of(std::size_t k) {
  return fmt::format("'{}'", palette[k % palette.size()]);
}

std::string begin_of_charts(int width, int height) {
  return fmt::format(
      "# Drawn by riffle {}. `gnuplot` and the name of this file, in this folder, draw the charts again.\n"
      "set encoding utf8\n"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{ set terminal svg noenhanced size {},{} font 'sans-serif,13' background rgb 'white' }} "
      "else {{\n"
      "  set terminal pngcairo noenhanced size {},{} font 'DejaVu Sans,9.75' fontscale 1.5 linewidth 1.5 pointscale "
      "1.5 "
      "background "
      "rgb 'white' }}\n"
      "set border 3 lw 1 lc rgb '#555555'\n"
      "set tics nomirror out scale 0.6 textcolor rgb '#333333'\n"
      "set grid lw 0.7 lt 1 dt 1 lc rgb '#e2e2e2'\n",
      riffle_version(), width, height, 3 * width / 2, 3 * height / 2);
}

std::string draw_with_gnuplot(const std::filesystem::path& folder, const std::string& stem, const std::string& script,
                              const std::string& data) try {
  std::filesystem::create_directories(folder);
  write_atomically(folder / (stem + ".dat"), data);
  write_atomically(folder / (stem + ".gp"), script);
  const auto program = find_gnuplot();
  if (!program) return "no charts are drawn, for gnuplot is not installed (package gnuplot-nox)";
  const std::string complaint = run_gnuplot(*program, folder, stem + ".gp", "");
  return complaint.empty() ? "" : "no charts are drawn, gnuplot failed: " + complaint;
} catch (const std::exception& error) {
  return std::string("no charts are drawn: ") + error.what();
}

std::string draw_charts(const StudyResults& results, const std::filesystem::path& folder) {
  Drawing drawing;
  const std::vector<ResultLine> lines = lines_of(results);
  for (const std::string& name : cases_of(results)) {
    for (std::size_t error = 0; error < results.errors.size(); ++error) {
      for (const bool against_cost : {true, false}) chart(drawing, results, lines, name, error, against_cost);
    }
  }
  std::size_t most = 0;  // lines in a legend, for which there must be room
  for (const std::string& name : cases_of(results)) {
    most = std::max(most, static_cast<std::size_t>(std::count_if(
                              lines.begin(), lines.end(), [&](const ResultLine& l) { return l.case_name == name; })));
  }
  const int height = std::max(500, static_cast<int>(24 * most) + 90);
  if (drawing.script.empty()) return "no charts are drawn, for no run has an error to draw";
  const std::string settings =
      "set logscale xy\nset format xy '%g'\nset key outside right top vertical Left reverse spacing 1.2 samplen 2\n";
  return draw_with_gnuplot(folder / "charts", "charts",
                           begin_of_charts(1080, height) + settings + drawing.script + end_of_charts, drawing.data);
}

}  // namespace riffle
