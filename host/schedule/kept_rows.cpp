#include "host/schedule/kept_rows.hpp"

#include <algorithm>

namespace riffle {

void KeptRows::prepare(std::int64_t rows, std::size_t fields, std::size_t threads) {
  if (spilled_.size() < threads) spilled_.resize(threads);
  if (count_.size() == static_cast<std::size_t>(rows) && values_.size() == fields) return;
  count_.assign(static_cast<std::size_t>(rows), 0);
  values_.clear();
  values_.resize(fields);
  begin_.clear();
  lengthen(row_);
}

void KeptRows::begin_rows(std::int64_t first, std::int64_t count) {
  std::fill_n(count_.begin() + first, count, 0);
}

void KeptRows::add(std::size_t thread, std::int64_t first, std::int64_t count, const double* marks,
                   const std::int32_t* neighbour, const std::vector<const double*>& values) {
  const std::int64_t row = row_;
  std::int64_t* taken = count_.data() + first;
  for (std::size_t q = 0; q < values.size(); ++q) {
    const double* from = values[q];
    double* to = values_[q].data() + first * row;
    for (std::int64_t k = 0; k < count; ++k) {
      if ((marks == nullptr || marks[k] != 0) && taken[k] < row) to[k * row + taken[k]] = from[k];
    }
  }
  std::int32_t* to = neighbour_.data() + first * row;
  for (std::int64_t k = 0; k < count; ++k) {
    if (marks != nullptr && marks[k] == 0) continue;
    if (taken[k] < row) {
      to[k * row + taken[k]] = neighbour[k];
    } else {
      Spilled pair{first + k, neighbour[k], {}};
      for (const double* from : values) pair.values.push_back(from[k]);
      spilled_[thread].push_back(std::move(pair));
    }
    ++taken[k];
  }
}

void KeptRows::finish() {
  std::int64_t longest = 0;
  for (const auto& pairs : spilled_) {
    for (const Spilled& pair : pairs) longest = std::max(longest, count_[static_cast<std::size_t>(pair.row)]);
  }
  if (longest == 0) return;
  std::vector<std::int64_t> taken(count_.size(), row_);  // of the rows that had not enough places
  lengthen(longest + longest / 4);
  for (auto& pairs : spilled_) {
    for (const Spilled& pair : pairs) {  // a row belongs to one thread, which met its pairs in their order
      const std::int64_t place = pair.row * row_ + taken[static_cast<std::size_t>(pair.row)]++;
      neighbour_[static_cast<std::size_t>(place)] = pair.neighbour;
      for (std::size_t q = 0; q < values_.size(); ++q) values_[q].data()[place] = pair.values[q];
    }
    pairs.clear();
  }
}

// Rows of `row` places, with what they hold.
void KeptRows::lengthen(std::int64_t row) {
  const auto n = static_cast<std::int64_t>(count_.size());
  const bool filled = !begin_.empty();
  std::vector<std::int32_t> neighbour(static_cast<std::size_t>(n * row));
  std::vector<AlignedArray> values(values_.size());
  for (AlignedArray& array : values) array.resize(static_cast<std::size_t>(n * row));
  for (std::int64_t i = 0; filled && i < n; ++i) {
    const std::int64_t count = std::min(count_[static_cast<std::size_t>(i)], row_);
    std::copy_n(neighbour_.begin() + i * row_, count, neighbour.begin() + i * row);
    for (std::size_t q = 0; q < values.size(); ++q)
      std::copy_n(values_[q].data() + i * row_, count, values[q].data() + i * row);
  }
  row_ = row;
  neighbour_ = std::move(neighbour);
  values_ = std::move(values);
  begin_.resize(static_cast<std::size_t>(n) + 1);
  for (std::int64_t i = 0; i <= n; ++i) begin_[static_cast<std::size_t>(i)] = i * row;
}

}  // namespace riffle
