#include "host/manifest/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace riffle {
namespace {

std::string trimmed(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  const auto first = std::find_if_not(text.begin(), text.end(), blank);
  text.erase(text.begin(), first);
  return text;
}

// Cells may be quoted; a quote inside quotes is written twice.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') {
      if (quoted && k + 1 < line.size() && line[k + 1] == '"') {
        cell += line[k++];
      } else {
        quoted = !quoted;
      }
    } else if (line[k] == ',' && !quoted) {
      cells.push_back(trimmed(cell));
      cell.clear();
    } else {
      cell += line[k];
    }
  }
  cells.push_back(trimmed(cell));
  return cells;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file, std::string shown) : shown_(std::move(shown)) {
  std::error_code ignored;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open() || std::filesystem::is_directory(file, ignored)) {
    throw TableError("no such file \"" + file.string() + "\"");
  }
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string byte_order_mark = "\xEF\xBB\xBF";
    if (number == 1 && line.rfind(byte_order_mark, 0) == 0) line.erase(0, byte_order_mark.size());
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    if (columns_.empty()) {
      columns_ = split(line);
    } else {
      rows_.push_back({number, split(line)});
    }
  }
  if (rows_.size() < 2) {
    throw TableError(fmt::format("{}: a table must have a header and at least two rows, this one has {}", shown_,
                                 columns_.empty() ? "neither"
                                 : rows_.empty()  ? "no row"
                                                  : "one row"));
  }
}

bool CsvTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::vector<double> CsvTable::numbers(const std::string& column) const {
  const auto index = static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), column) - columns_.begin());
  std::vector<double> values;
  for (const Row& row : rows_) {
    if (index >= row.cells.size()) {
      throw TableError(fmt::format("{}{} of {} columns are given, \"{}\" is missing", at(row), row.cells.size(),
                                   columns_.size(), column));
    }
    const std::string& cell = row.cells[index];
    const char* const begin = cell.data() + (cell.rfind('+', 0) == 0 ? 1 : 0);
    const char* const end = cell.data() + cell.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) {
      throw TableError(fmt::format("{}column \"{}\" must hold numbers, got \"{}\"", at(row), column, cell));
    }
    values.push_back(value);
  }
  return values;
}

std::vector<double> CsvTable::increasing_numbers(const std::string& column) const {
  std::vector<double> values = numbers(column);
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (values[k] > values[k - 1]) continue;
    throw TableError(fmt::format("{}column \"{}\" must increase from row to row, got {} after {}", at(rows_[k]), column,
                                 values[k], values[k - 1]));
  }
  return values;
}

}  // namespace riffle
