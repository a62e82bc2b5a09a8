// Stable counting sort on all threads, and the loop over equal parts that it and its callers share.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace riffle {

// Calls f(part, first, last) for `parts` contiguous parts of [0, n), on all threads. The parts are the same whatever
// number of threads the run-time grants.
template <class F>
void for_parts(std::int64_t n, int parts, F&& f) {
#pragma omp parallel for schedule(static, 1) num_threads(parts)
  for (int part = 0; part < parts; ++part) f(part, n * part / parts, n * (part + 1) / parts);
}

// As many parts as there are threads, but none so small that waking a thread costs more than it does.
inline int parts_for(std::int64_t n) {
  return static_cast<int>(std::clamp<std::int64_t>(n / 4096, 1, omp_get_max_threads()));
}

// Replaces each key (its cell, in [0, cells), or -1 to leave it out) by its place in the sorted order, -1 again if left
// out. begin[c] is the first place of cell c, begin[cells] their number.
inline void places_by_counting(std::int64_t cells, std::vector<std::int32_t>& key_then_place,
                               std::vector<std::int32_t>& begin, std::vector<std::int32_t>& histogram) {
  const auto n = static_cast<std::int64_t>(key_then_place.size());
  // one histogram per part: with many more cells than particles fewer parts, so that memory stays bounded
  const int parts =
      static_cast<int>(std::clamp<std::int64_t>(8 * n / std::max<std::int64_t>(cells, 1), 1, parts_for(n)));
  histogram.assign(static_cast<std::size_t>(cells * parts), 0);
  begin.resize(static_cast<std::size_t>(cells) + 1);
  std::int32_t* keys = key_then_place.data();
  for_parts(n, parts, [&](int part, std::int64_t first, std::int64_t last) {
    std::int32_t* number = histogram.data() + part * cells;
    for (std::int64_t i = first; i < last; ++i) {
      if (keys[i] >= 0) ++number[keys[i]];
    }
  });
  std::int32_t sum = 0;
  for (std::int64_t c = 0; c < cells; ++c) {
    begin[static_cast<std::size_t>(c)] = sum;
    for (int part = 0; part < parts; ++part) {
      std::int32_t& number = histogram[static_cast<std::size_t>(part * cells + c)];
      const std::int32_t next = sum + number;
      number = sum;
      sum = next;
    }
  }
  begin[static_cast<std::size_t>(cells)] = sum;
  for_parts(n, parts, [&](int part, std::int64_t first, std::int64_t last) {
    std::int32_t* next = histogram.data() + part * cells;
    for (std::int64_t i = first; i < last; ++i) {
      if (keys[i] >= 0) keys[i] = next[keys[i]]++;
    }
  });
}

}  // namespace riffle
