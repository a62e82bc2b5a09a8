#include "host/output/canvas.hpp"

#include <fmt/format.h>

#include <exception>

#include "host/output/atomic_file.hpp"
#include "host/output/build_info.hpp"
#include "host/output/gnuplot.hpp"

namespace riffle::canvas {
namespace {

// `letters`: size of the title's, in pixels. Terminals measure letters and point sizes differently, so they are set for
// each (dot() by measuring what was drawn).
std::string settings(double height, double letters) {
  return fmt::format(
      "# Drawn by riffle {}. In this folder, `gnuplot picture.gp` draws picture.svg and picture.png again.\n"
      "if (!exists('aside')) aside = ''\n"
      "set encoding utf8\n"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{\n"
      "  set terminal svg noenhanced size {:.0f},{:.0f} font 'sans-serif,13' background rgb 'white'\n"
      "  dot(d) = d / 10.7\n"
      "  title_font = 'sans-serif,{:.1f}'\n"
      "}} else {{\n"
      "  set terminal pngcairo noenhanced size {:.0f},{:.0f} font 'DejaVu Sans,9.75' fontscale 2 linewidth 2 "
      "pointscale 2 background rgb 'white'\n"
      "  dot(d) = d > 2 ? (d - 1.55) / 6.03 : 0.075\n"
      "  title_font = 'DejaVu Sans,{:.1f}'\n"
      "}}\n"
      "set output 'picture.' . kind . aside\n"
      "set border 3 lw 1 lc rgb '#555555'\n"
      "set tics nomirror out scale 0.6 textcolor rgb '#333333'\n"
      "set grid lw 0.7 lt 1 dt 1 lc rgb '#e2e2e2'\n",
      riffle_version(), width, height, letters, 2 * width, 2 * height, 0.75 * letters);
}

}  // namespace

Range padded(Range r) {
  if (!(r.low <= r.high)) return {0, 1};
  const double size = std::max(std::abs(r.low), std::abs(r.high));
  if (r.length() <= 1e-9 * size || size == 0)
    return size == 0 ? Range{-1, 1} : Range{r.low - 0.1 * size, r.high + 0.1 * size};
  const double room = 0.07 * r.length();
  const bool from_zero = r.low >= 0 && r.low < 0.35 * r.high;
  const bool to_zero = r.high <= 0 && -r.high < 0.35 * -r.low;
  return {from_zero ? 0 : r.low - room, to_zero ? 0 : r.high + room};
}

Range snapped(Range r) {
  if (!(r.length() > 0)) return padded(r);
  const double step = std::pow(10, std::floor(std::log10(r.length())));
  const double low = std::floor(r.low / step) * step, high = std::ceil(r.high / step) * step;
  const double near = 0.01 * r.length();
  return {r.low - low < near ? low : r.low, high - r.high < near ? high : r.high};
}

double tic_step(const Range& r, double most) {
  const double least = r.length() / std::max(most, 1.0);
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= least) return step * power;
  }
  return 10 * power;
}

std::string screen(double x, double y, double height) {
  return fmt::format("screen {:.5f}, screen {:.5f}", x / width, 1 - y / height);
}

std::string start_of_script(double height, const std::string& title) {
  const double letters = std::clamp(16.0 * 88 / static_cast<double>(title.size() + 1), 9.0, 16.0);
  return settings(height, letters) + fmt::format("set label 1 {} at {} left font title_font textcolor rgb '#1a1a1a'\n",
                                                 gnuplot_text(title), screen(left, 22, height));
}

std::string margins(double from_left, double from_top, double to_right, double to_bottom, double height) {
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
      "set bmargin at screen {:.5f}\n",
      from_left / width, to_right / width, 1 - from_top / height, 1 - to_bottom / height);
}

std::string turned_label(int number, const std::string& text, double x, double y, double height) {
  return fmt::format("set label {} {} at {} center rotate by 90 textcolor rgb '#1a1a1a'\n", number, gnuplot_text(text),
                     screen(x, y, height));
}

PictureResult run(const std::filesystem::path& folder, const std::string& script, const std::string& data) try {
  write_atomically(folder / "picture.dat", data);
  write_atomically(folder / "picture.gp", script);
  const auto program = find_gnuplot();
  if (!program) {
    return {false,
            "no picture is drawn, for gnuplot is not installed (package gnuplot-nox); later, `gnuplot picture.gp` in "
            "the run's folder draws it"};
  }
  PartFile svg(folder / "picture.svg"), png(folder / "picture.png");
  const std::string complaint = run_gnuplot(*program, folder, "picture.gp", "aside = '.part'");
  if (!complaint.empty()) return {false, "no picture is drawn, gnuplot failed: " + complaint};
  svg.publish();
  png.publish();
  return {true, {}};
} catch (const std::exception& error) {
  return {false, std::string("no picture is drawn: ") + error.what()};
}

}  // namespace riffle::canvas
