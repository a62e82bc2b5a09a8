// Tables in CSV: lines that start with # are comments, the first other line names the columns.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace riffle {

// The message is a sentence that names the table and, where there is one, its line: "bed.csv:7: column ...".
class TableError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class CsvTable {
 public:
  // `shown` stands for the file in messages. Throws TableError: no such file, no header, no column.
  CsvTable(const std::filesystem::path& file, std::string shown);

  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] bool has(const std::string& column) const;

  // All values of a column that exists. Throws TableError when a row has no number there.
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const;
  // The same, and each value must be larger than the one before.
  [[nodiscard]] std::vector<double> increasing_numbers(const std::string& column) const;

 private:
  struct Row {
    int line;
    std::vector<std::string> cells;
  };
  [[nodiscard]] std::string at(const Row& row) const { return shown_ + ':' + std::to_string(row.line) + ": "; }

  std::string shown_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace riffle
