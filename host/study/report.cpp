#include "host/study/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "host/output/atomic_file.hpp"
#include "host/study/relative.hpp"

namespace riffle {
namespace {

using nlohmann::json;

json finite(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json finite(const std::optional<double>& value) {
  return value ? finite(*value) : json(nullptr);
}

json point_data(const PointResult& point) {
  json settings = json::array(), errors = json::array();
  for (const auto& [name, value] : point.point.settings()) settings.push_back({name, value});
  for (const double error : point.errors) errors.push_back(finite(point.counts() ? error : NAN));
  return {{"settings", settings},
          {"resolution", point.point.resolution},
          {"errors", errors},
          {"cost", finite(point.cost)},
          {"cost_low", finite(point.cost_low)},
          {"cost_high", finite(point.cost_high)},
          {"repeats", point.repeats_done},
          {"particles", point.particles},
          {"steps", point.steps},
          {"state", state_of(point)},
          {"message", point.message},
          {"picture", point.picture},
          {"command", point.command}};
}

// Which point of which line a result is.
class Places {
 public:
  explicit Places(const std::vector<ResultLine>& lines) {
    for (std::size_t l = 0; l < lines.size(); ++l) {
      for (std::size_t p = 0; p < lines[l].points.size(); ++p) place_[lines[l].points[p]] = {l, p};
    }
  }
  [[nodiscard]] json of(const PointResult* point) const {
    const auto [line, turn] = place_.at(point);
    return {line, turn};
  }

 private:
  std::map<const PointResult*, std::pair<std::size_t, std::size_t>> place_;
};

void replace(std::string& text, const std::string& mark, const std::string& by) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw std::logic_error("the page of the report has no " + mark);
  text.replace(at, mark.size(), by);
}

}  // namespace

std::string counts_of(const StudyResults& results) {
  std::map<Ending, int> times;
  for (const PointResult& point : results.points) ++times[point.ending];
  std::string words = fmt::format("{} combinations", results.points.size());
  for (const auto& [ending, count] : times) words += fmt::format(", {} {}", count, in_words(ending));
  if (!results.skipped.empty()) words += fmt::format("; {} skipped as meaningless", results.skipped.size());
  return words + '.';
}

std::string state_of(const PointResult& point) {
  std::string words = in_words(point.ending);
  if (point.ending == Ending::blew_up && std::isfinite(point.time))
    words += fmt::format(" at t = {:.3g} s", point.time);
  if (!point.same_bits) words += ", repeats differ";
  return words;
}

json report_data(const StudyResults& results) {
  const std::vector<ResultLine> lines = lines_of(results);
  const Places places(lines);
  json data{{"title", results.title},
            {"counts", counts_of(results)},
            {"cost", {{"key", results.cost}, {"name", shown_name(results.cost)}}},
            {"baseline", results.baseline}};
  data["errors"] = data["cases"] = data["lines"] = data["relative"] = data["skipped"] = json::array();
  data["fronts"] = json::object();
  for (const std::string& error : results.errors)
    data["errors"].push_back({{"key", error}, {"name", shown_name(error)}});
  for (const ResultLine& line : lines) {
    json points = json::array(), orders = json::array();
    for (const PointResult* point : line.points) points.push_back(point_data(*point));
    for (std::size_t e = 0; e < results.errors.size(); ++e) {
      orders.push_back(finite(order_of(line, e)));
      const ResultLine* const base = baseline_of(line, lines, results.baseline);
      if (base == nullptr || base == &line) continue;
      for (const Relative& relative : relative_to(*base, line, e)) {
        data["relative"].push_back({{"case", line.case_name},
                                    {"error", e},
                                    {"line", line.label},
                                    {"resolution", relative.baseline->point.resolution},
                                    {"cost", finite(relative.cost)},
                                    {"equal_cost_error", finite(relative.error)}});
      }
    }
    data["lines"].push_back({{"case", line.case_name},
                             {"label", line.label},
                             {"colour", line.colour},
                             {"mark", line.mark},
                             {"points", points},
                             {"orders", orders}});
  }
  for (const std::string& name : cases_of(results)) {
    json fronts = json::array();
    for (std::size_t e = 0; e < results.errors.size(); ++e) {
      json front = json::array();
      for (const PointResult* point : front_of(results, name, e)) front.push_back(places.of(point));
      fronts.push_back(front);
    }
    data["fronts"][name] = fronts;
    for (const ResultLine& line : lines) {
      if (line.case_name != name) continue;
      data["cases"].push_back({{"name", name}, {"title", line.case_title}});
      break;
    }
  }
  for (const Skipped& skipped : results.skipped) {
    data["skipped"].push_back({{"combination", skipped.combination}, {"reason", skipped.reason}});
  }
  return data;
}

std::filesystem::path find_chart_library(const std::filesystem::path& program_directory) {
  for (const std::filesystem::path& candidate :
       {program_directory / ".." / "share" / "riffle" / "chart.min.js",
        std::filesystem::path("/usr/share/javascript/chart.js/chart.min.js"),
        std::filesystem::path("/usr/share/nodejs/chart.js/dist/chart.min.js")}) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(candidate, ignored)) return candidate;
  }
  return {};
}

void write_report(const std::filesystem::path& file, const json& data, const std::filesystem::path& library) {
  std::string text;
  // "<" could end the element that the data stand in.
  for (const char c : data.dump(-1, ' ', false, json::error_handler_t::replace)) {
    text += c == '<' ? "\\u003c" : std::string(1, c);
  }
  std::string page = report_page;
  replace(page, "<!--style-->", report_style);
  replace(page, "<!--script-->", report_script);
  replace(page, "<!--data-->", text);
  replace(page, "<!--library-->", read_file(library));
  write_atomically(file, page);
}

}  // namespace riffle
