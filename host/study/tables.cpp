#include "host/study/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "host/study/relative.hpp"
#include "host/study/report.hpp"

namespace riffle {
namespace {

std::string exact(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "-";
}

std::string short_number(const std::optional<double>& value) {
  return value ? short_number(*value) : "-";
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

// For a cell of a Markdown table.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return out;
}

std::string with_spread(const PointResult& point) {
  if (!std::isfinite(point.cost)) return "-";
  if (point.repeats_done < 2) return short_number(point.cost);
  return fmt::format("{} ({} to {})", short_number(point.cost), short_number(point.cost_low),
                     short_number(point.cost_high));
}

class Markdown {
 public:
  explicit Markdown(const StudyResults& results) : results_(results), lines_(lines_of(results)) {}

  std::string write() {
    out_ = fmt::format("# {}\n\n{}\n", results_.title, counts_of(results_));
    for (const std::string& name : cases_of(results_)) {
      const auto first =
          std::find_if(lines_.begin(), lines_.end(), [&](const ResultLine& l) { return l.case_name == name; });
      out_ += fmt::format("\n## {}\n", first->case_title);
      if (results_.errors.empty()) costs(name);
      for (std::size_t e = 0; e < results_.errors.size(); ++e) {
        all_points(name, e);
        orders(name, e);
        front(name, e);
        baseline(name, e);
      }
    }
    others();
    return out_;
  }

 private:
  [[nodiscard]] std::vector<const ResultLine*> of(const std::string& name) const {
    std::vector<const ResultLine*> lines;
    for (const ResultLine& line : lines_) {
      if (line.case_name == name) lines.push_back(&line);
    }
    return lines;
  }

  void costs(const std::string& name) {
    out_ += fmt::format("\n| closure | resolution | {} | state |\n|---|---|---|---|\n", shown_name(results_.cost));
    for (const ResultLine* line : of(name)) {
      for (const PointResult* point : line->points) {
        out_ += fmt::format("| {} | {} | {} | {} |\n", plain(line->label), point->point.resolution, with_spread(*point),
                            state_of(*point));
      }
    }
  }

  void all_points(const std::string& name, std::size_t e) {
    const auto best = front_of(results_, name, e);
    out_ += fmt::format(
        "\n### {} against {}\n\nA star marks the points that no other beats in one without being worse in the "
        "other; the order is the one from the row above.\n\n| closure | resolution | {} | order | {} | "
        "particles | steps | state |\n|---|---|---|---|---|---|---|---|\n",
        shown_name(results_.errors[e]), shown_name(results_.cost), shown_name(results_.errors[e]),
        shown_name(results_.cost));
    for (const ResultLine* line : of(name)) {
      const PointResult* before = nullptr;
      for (const PointResult* point : line->points) {
        const bool star = std::find(best.begin(), best.end(), point) != best.end();
        double order = NAN;
        if (before != nullptr) {
          const std::array<double, 2> spacing{before->spacing, point->spacing},
              error{before->errors[e], point->errors[e]};
          order = convergence_order(spacing, error);
        }
        out_ += fmt::format("| {} | {} | {}{} | {} | {} | {} | {} | {} |\n", plain(line->label),
                            point->point.resolution, short_number(point->errors[e]), star ? " *" : "",
                            short_number(order), with_spread(*point), point->particles, point->steps, state_of(*point));
        before = point;
      }
    }
  }

  void orders(const std::string& name, std::size_t e) {
    std::string rows;
    for (const ResultLine* line : of(name)) {
      const double order = order_of(*line, e);
      if (std::isfinite(order)) rows += fmt::format("| {} | {:.2f} |\n", plain(line->label), order);
    }
    if (rows.empty()) return;
    out_ += fmt::format(
        "\nOrder of convergence over all resolutions, by least squares:\n\n| closure | order of {} |\n|---|---|\n{}",
        shown_name(results_.errors[e]), rows);
  }

  void front(const std::string& name, std::size_t e) {
    const auto best = front_of(results_, name, e);
    if (best.empty()) return;
    out_ += "\nThe Pareto front, from the cheapest on:\n\n";
    for (const PointResult* point : best) {
      const std::string resolution =
          point->point.resolution.empty()
              ? ""
              : fmt::format(", {} = {}", point->point.resolution_name, point->point.resolution);
      out_ += fmt::format("- {}{}: {} = {}, {} = {}\n", point->point.line, resolution, shown_name(results_.errors[e]),
                          short_number(point->errors[e]), shown_name(results_.cost), short_number(point->cost));
    }
  }

  void baseline(const std::string& name, std::size_t e) {
    std::string rows;
    for (const ResultLine* line : of(name)) {
      const ResultLine* const base = baseline_of(*line, lines_, results_.baseline);
      if (base == nullptr || base == line) continue;
      for (const Relative& relative : relative_to(*base, *line, e)) {
        rows +=
            fmt::format("| {} | {} | {} | {} | {} | {} |\n", plain(line->label), relative.baseline->point.resolution,
                        short_number(relative.baseline->errors[e]), short_number(relative.cost),
                        short_number(relative.baseline->cost), short_number(relative.error));
      }
    }
    if (rows.empty()) return;
    out_ += fmt::format(
        "\nAgainst the baseline \"{}\": what the same error costs, and which error the same cost gives, each "
        "as a multiple of the baseline's at that resolution (interpolated on logarithms; - where a line does "
        "not reach that far).\n\n| closure | baseline's resolution | its error | cost at equal error | its cost | "
        "error at equal cost |\n|---|---|---|---|---|---|\n{}",
        results_.baseline, rows);
  }

  void others() {
    std::string rows;
    for (const PointResult& point : results_.points) {
      if (point.ending == Ending::good) continue;
      rows += fmt::format("| {} | {} | {} | {} | {} |\n", point.point.case_name, plain(point.point.line),
                          point.point.resolution, state_of(point), plain(point.message));
    }
    if (!rows.empty()) {
      out_ += "\n## Not good\n\n| case | closure | resolution | state | why |\n|---|---|---|---|---|\n" + rows;
    }
    if (results_.skipped.empty()) return;
    out_ += "\n## Skipped as meaningless\n\n| combination | why |\n|---|---|\n";
    for (const Skipped& skipped : results_.skipped) {
      out_ += fmt::format("| {} | {} |\n", plain(skipped.combination), plain(skipped.reason));
    }
  }

  const StudyResults& results_;
  const std::vector<ResultLine> lines_;
  std::string out_;
};

}  // namespace

std::string results_in_csv(const StudyResults& results) {
  std::vector<std::string> names;  // of settings, as they first appear
  for (const PointResult& point : results.points) {
    for (const auto& [name, value] : point.point.settings()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::string out;
  for (const std::string& name : names) out += cell(name) + ',';
  out += "state,message,time_s";
  for (const std::string& error : results.errors) out += ',' + cell(error);
  out += fmt::format(",{0},{0}.min,{0}.max,repeats,same_bits,particles,steps,command\n", results.cost);
  for (const PointResult& point : results.points) {
    const Settings settings = point.point.settings();
    for (const std::string& name : names) {
      const auto found = std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.first == name; });
      out += (found == settings.end() ? "" : cell(found->second)) + ',';
    }
    out += fmt::format("{},{},{}", in_words(point.ending), cell(point.message), exact(point.time));
    for (const double error : point.errors) out += ',' + exact(error);
    out += fmt::format(",{},{},{},{},{},{},{},{}\n", exact(point.cost), exact(point.cost_low), exact(point.cost_high),
                       point.repeats_done, point.same_bits ? "yes" : "no", point.particles, point.steps,
                       cell(point.command));
  }
  return out;
}

std::string results_in_markdown(const StudyResults& results) {
  return Markdown(results).write();
}

}  // namespace riffle
