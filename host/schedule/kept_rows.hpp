// Pair fields that are kept along a line: a row of places per particle, filled by the threads as they meet its neighbours.
//
// Nobody knows beforehand how long rows become. Pairs that find no place are put aside, and finish() makes longer rows.
#pragma once

#include <cstdint>
#include <vector>

#include "host/particles/store.hpp"

namespace riffle {

class KeptRows {
 public:
  void prepare(std::int64_t rows, std::size_t fields, std::size_t threads);
  // Empties rows. Threads may do so, and add, at once as long as their rows differ.
  void begin_rows(std::int64_t first, std::int64_t count);
  // One more pair for each row first + k, k < count, where marks[k] is not 0 (nullptr: for all of them).
  void add(std::size_t thread, std::int64_t first, std::int64_t count, const double* marks,
           const std::int32_t* neighbour, const std::vector<const double*>& values);
  void finish();

  // Row i has the places begin()[i] .. begin()[i] + count()[i] - 1, in the order in which its pairs were met.
  [[nodiscard]] const std::vector<std::int64_t>& begin() const { return begin_; }
  [[nodiscard]] const std::vector<std::int64_t>& count() const { return count_; }
  [[nodiscard]] const std::vector<std::int32_t>& neighbour() const { return neighbour_; }
  [[nodiscard]] const std::vector<AlignedArray>& values() const { return values_; }  // per field

 private:
  struct Spilled {
    std::int64_t row;
    std::int32_t neighbour;
    std::vector<double> values;
  };
  void lengthen(std::int64_t row);

  std::int64_t row_ = 8;  // places
  std::vector<std::int64_t> begin_, count_;
  std::vector<std::int32_t> neighbour_;
  std::vector<AlignedArray> values_;
  std::vector<std::vector<Spilled>> spilled_;  // per thread
};

}  // namespace riffle
