// Tables that tests compare with: CSV whose lines may begin with '#' and whose first other line names the columns.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace riffle::contract {

inline std::vector<std::vector<std::string>> csv_rows(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("no file " + path);
  std::vector<std::vector<std::string>> table;
  bool names = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (!std::exchange(names, false)) {
      table.emplace_back();
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
    }
  }
  return table;
}

// From tests/contract/data.
inline std::vector<std::vector<std::string>> rows(const std::string& file) {
  return csv_rows(std::string(RIFFLE_TEST_DATA) + "/" + file);
}

}  // namespace riffle::contract
