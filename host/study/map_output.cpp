#include "host/study/map_output.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "host/output/atomic_file.hpp"
#include "host/output/gnuplot.hpp"
#include "host/study/charts.hpp"

namespace riffle {
namespace {

// Of the classes, from good to refused: dark enough for dots on them, and told apart by colour-blind readers.
constexpr std::array<const char*, stability_classes> colours{"#a6dba0", "#f6e8a0", "#f4a582",
                                                             "#c2a5cf", "#d6604d", "#f2f2f2"};

std::string stem_of(const StabilityResult& result) {
  std::string name = result.case_name;
  for (const char c : result.closure.empty() ? std::string() : '-' + result.closure) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (kept || name.back() != '-') name += kept ? c : '-';
  }
  while (name.back() == '-') name.pop_back();
  return name;
}

std::string title_of(const StabilityResult& result) {
  return result.case_title + (result.closure.empty() ? "" : ": " + result.closure);
}

std::set<StabilityClass> classes_of(const StabilityResult& result) {
  std::set<StabilityClass> classes;
  for (const int of : result.map.of) classes.insert(static_cast<StabilityClass>(of));
  return classes;
}

// Some six values of an axis, at the places of its points.
std::string tics_of(const MapAxis& axis) {
  std::string tics;
  const int step = std::max(1, (axis.points + 4) / 6);
  for (int k = 0; k < axis.points; k += step) {
    tics += fmt::format("{}'{:.3g}' {}", tics.empty() ? "" : ", ", axis.value(k), k);
  }
  return tics;
}

class MapDrawing {
 public:
  explicit MapDrawing(const Study& study) : study_(study) {}

  void add(const StabilityResult& result) {
    const int nx = result.map.nx, ny = result.map.ny;
    std::string plots;
    for (const StabilityClass of : classes_of(result)) {
      std::string cells;
      for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
          if (result.at(x, y) == of)
            cells += fmt::format("{} {} {} {} {} {}\n", x, y, x - 0.5, x + 0.5, y - 0.5, y + 0.5);
        }
      }
      plots += fmt::format("{}{} with boxxyerror fs solid 1 noborder lc rgb '{}' title '{}'",
                           plots.empty() ? "" : ", \\\n  ", block(cells), colours[static_cast<std::size_t>(of)],
                           in_words(of));
    }
    const std::string steps = boundary(result);
    if (!steps.empty())
      plots += fmt::format(", \\\n  {} with vectors nohead lw 2 lc rgb '#333333' notitle", block(steps));
    std::string dots;
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        if (result.map.tried[result.map.index(x, y)] != 0) dots += fmt::format("{} {}\n", x, y);
      }
    }
    plots += fmt::format(", \\\n  {} with points pt 7 ps 0.35 lc rgb '#333333' title 'run'", block(dots));
    const auto& axes = study_.map->axes;
    script_ += fmt::format(
        "set output '{}.' . kind\nset title {}\nset xlabel {}\nset ylabel {}\nset xrange [-0.5:{}]\nset yrange "
        "[-0.5:{}]\n"
        "set xtics ({})\nset ytics ({})\nplot {}\n",
        stem_of(result), gnuplot_text(title_of(result)), gnuplot_text(axes[0].name), gnuplot_text(axes[1].name),
        nx - 0.5, ny - 0.5, tics_of(axes[0]), tics_of(axes[1]), plots);
  }

  [[nodiscard]] std::string draw(const std::filesystem::path& folder) const {
    const std::string settings = "unset grid\nset key outside right top vertical Left reverse spacing 1.3 samplen 2\n";
    return draw_with_gnuplot(folder, "maps", begin_of_charts(760, 520) + settings + script_ + end_of_charts, data_);
  }

 private:
  std::string block(const std::string& rows) {
    data_ += rows + "\n\n";
    return fmt::format("'maps.dat' index {}", blocks_++);
  }

  // The sides between cells of different classes.
  static std::string boundary(const StabilityResult& result) {
    std::string sides;
    for (int y = 0; y < result.map.ny; ++y) {
      for (int x = 0; x < result.map.nx; ++x) {
        if (x + 1 < result.map.nx && result.at(x, y) != result.at(x + 1, y))
          sides += fmt::format("{} {} 0 1\n", x + 0.5, y - 0.5);
        if (y + 1 < result.map.ny && result.at(x, y) != result.at(x, y + 1))
          sides += fmt::format("{} {} 1 0\n", x - 0.5, y + 0.5);
      }
    }
    return sides;
  }

  const Study& study_;
  std::string script_, data_;
  int blocks_ = 0;
};

}  // namespace

std::string map_in_csv(const Study& study, const StabilityResult& result) {
  const auto& axes = study.map->axes;
  std::string out = fmt::format("{},{},class,run,error,message,folder\n", axes[0].key, axes[1].key);
  for (int y = 0; y < result.map.ny; ++y) {
    for (int x = 0; x < result.map.nx; ++x) {
      const std::size_t k = result.map.index(x, y);
      const bool tried = result.map.tried[k] != 0;
      const TriedPoint& point = result.points[k];
      std::string message;
      for (const char c : point.message) message += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
      out +=
          fmt::format("{},{},{},{},{},\"{}\",{}\n", axes[0].value(x), axes[1].value(y), in_words(result.at(x, y)),
                      tried ? "yes" : "no", tried && std::isfinite(point.error) ? fmt::format("{}", point.error) : "",
                      tried ? message : "", tried && !point.folder.empty() ? "runs/" + point.folder : "");
    }
  }
  return out;
}

std::string maps_in_markdown(const Study& study, const std::vector<StabilityResult>& results,
                             const std::string& error) {
  const auto& axes = study.map->axes;
  std::string out = fmt::format("# {}\n", study.title);
  if (!error.empty())
    out += fmt::format("\nA run is inaccurate when {} is above {:g}.\n", error, study.map->error_bound);
  for (const StabilityResult& result : results) {
    out += fmt::format(
        "\n## {}\n\n![{}]({}.svg)\n\n{} of {} points were run; each of the others has the class of its nearest. "
        "From the lowest {} to the highest:\n\n| {} | {} |\n|---|---|\n",
        title_of(result), title_of(result), stem_of(result), result.map.runs(), result.map.of.size(), axes[1].name,
        axes[0].name, axes[1].name);
    for (int x = 0; x < result.map.nx; ++x) {
      std::string words;
      for (int y = 0; y < result.map.ny; ++y) {
        const bool last = y + 1 == result.map.ny || result.at(x, y) != result.at(x, y + 1);
        if (!last) continue;
        words += fmt::format("{}{}", words.empty() ? "" : ", ", in_words(result.at(x, y)));
        if (y + 1 < result.map.ny) words += fmt::format(" up to {:.3g}", axes[1].value(y));
      }
      out += fmt::format("| {:.3g} | {} |\n", axes[0].value(x), words);
    }
  }
  return out;
}

std::string write_maps(const Study& study, const std::vector<StabilityResult>& results, const std::string& error,
                       const std::filesystem::path& folder) {
  MapDrawing drawing(study);
  for (const StabilityResult& result : results) {
    write_atomically(folder / (stem_of(result) + ".csv"), map_in_csv(study, result));
    drawing.add(result);
  }
  write_atomically(folder / "stability.md", maps_in_markdown(study, results, error));
  return drawing.draw(folder);
}

}  // namespace riffle
