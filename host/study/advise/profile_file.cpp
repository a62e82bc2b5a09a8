#include "host/study/advise/profile_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace riffle {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::vector<std::vector<double>> profile_columns(const std::filesystem::path& file,
                                                 const std::vector<std::string>& names) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " cannot be read");
  std::vector<std::vector<double>> columns(names.size());
  std::vector<std::size_t> places;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    if (places.empty()) {
      for (const std::string& name : names) {
        const auto found = std::find(cells.begin(), cells.end(), name);
        if (found == cells.end()) throw std::runtime_error(file.string() + " has no column " + name);
        places.push_back(static_cast<std::size_t>(found - cells.begin()));
      }
      continue;
    }
    for (std::size_t c = 0; c < places.size(); ++c) {
      columns[c].push_back(places[c] < cells.size() ? std::strtod(cells[places[c]].c_str(), nullptr) : 0);
    }
  }
  return columns;
}

}  // namespace riffle
