// Turns "the neighbours of particle i" into compressed rows, on all threads.
//
// The owned particles are processed in waves. In a wave each thread fills a buffer of its own for one contiguous part;
// when all have finished, the buffers' places in the list are known and they are copied there, out of the cache. So no
// segment is computed twice (as counting first would), no second copy of the whole list exists, and the list is the
// same for any number of threads.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <vector>

#include "host/neighbours/view_checks.hpp"

namespace riffle {

// A search may write this many values past the start of a segment, so that room is asked for once per target and not
// per neighbour.
inline constexpr std::int64_t segment_room = 2 * longest_segment + IndexArray::slack;

struct CollectWorkspace {
  std::vector<IndexArray> buffer;                         // per thread
  std::vector<std::exception_ptr> failure;                // per thread
  std::vector<std::int64_t> used, place, longest, pairs;  // per thread
};

// Fills out.{begin, count, neighbour, longest, pairs}. For each target i, in ascending order within a thread's part,
// search(i, out) writes its neighbours from `out` on and returns their number; it must not write more than segment_room
// values. Each thread has a copy of `search`. `part`: particles per thread and wave.
template <class Search>
void collect(const ParticleView& particles, std::uint32_t targets, std::int64_t part, const Search& search,
             CollectWorkspace& work, NeighbourList& out) {
  const std::int64_t n = particles.owned;
  const auto dummy = static_cast<std::int32_t>(particles.all);
  out.begin.resize(static_cast<std::size_t>(n) + 1);
  out.count.resize(static_cast<std::size_t>(n));
  out.neighbour.resize(0);
  std::int64_t* begin = out.begin.data();
  std::int32_t* count = out.count.data();
  const auto threads = static_cast<std::size_t>(
      std::clamp<std::int64_t>((n + part - 1) / part, 1, static_cast<std::int64_t>(omp_get_max_threads())));
  if (work.buffer.size() < threads) work.buffer.resize(threads);
  work.failure.assign(threads, nullptr);
  work.used.assign(threads, 0);
  work.place.assign(threads, 0);
  work.longest.assign(threads, 0);
  work.pairs.assign(threads, 0);
  std::int64_t total = 0;
  bool failed = false;

#pragma omp parallel num_threads(static_cast <int>(threads))
  {
    const auto t = static_cast<std::size_t>(omp_get_thread_num());
    const auto team = static_cast<std::int64_t>(omp_get_num_threads());
    IndexArray& buffer = work.buffer[t];
    Search own_search(search);
    std::int64_t longest = 0, pairs = 0;
    for (std::int64_t wave = 0; wave < n; wave += team * part) {
      const std::int64_t first = std::min(n, wave + static_cast<std::int64_t>(t) * part);
      const std::int64_t last = std::min(n, first + part);
      try {
        std::int64_t used = 0;
        for (std::int64_t i = first; i < last; ++i) {
          begin[i] = used;
          count[i] = 0;
          if (!has_role(particles, targets, i)) continue;
          if (used + segment_room > buffer.size()) {
            buffer.resize(used);  // what is to be kept if it moves
            buffer.resize(used + 4 * segment_room);
          }
          std::int32_t* segment = buffer.data() + used;
          const std::int64_t found = own_search(i, segment);
          for (int k = 0; k < 4; ++k) segment[found + k] = dummy;
          const std::int64_t padded = (found + 3) & ~std::int64_t{3};
          count[i] = static_cast<std::int32_t>(found);
          used += padded;
          longest = std::max(longest, padded);
          pairs += found;
        }
        work.used[t] = used;
      } catch (...) {
        work.failure[t] = std::current_exception();
      }
#pragma omp barrier
#pragma omp single
      {
        try {
          for (std::size_t k = 0; k < static_cast<std::size_t>(team); ++k) {
            failed = failed || work.failure[k] != nullptr;
            work.place[k] = total;
            total += work.used[k];
          }
          // the rest of the particles will need about as much as those before
          const std::int64_t done = std::min(n, wave + team * part);
          const double expected = static_cast<double>(total) * static_cast<double>(n) / static_cast<double>(done);
          if (total > out.neighbour.capacity()) {
            out.neighbour.reserve(std::max(total, static_cast<std::int64_t>(1.05 * expected)));
          }
          out.neighbour.resize(total);
        } catch (...) {
          work.failure[0] = std::current_exception();
          failed = true;
        }
      }
      if (failed) break;
      const std::int64_t place = work.place[t];
      if (work.used[t] > 0) {
        std::memcpy(out.neighbour.data() + place, buffer.data(), static_cast<std::size_t>(work.used[t]) * 4);
      }
      for (std::int64_t i = first; i < last; ++i) begin[i] += place;
    }
    work.longest[t] = longest;
    work.pairs[t] = pairs;
  }
  // parts are in the order of the particles, so the first failure is that of the first particle
  for (const auto& failure : work.failure) {
    if (failure != nullptr) std::rethrow_exception(failure);
  }
  begin[n] = total;
  std::fill_n(out.neighbour.data() + total, IndexArray::slack, dummy);
  out.longest = *std::max_element(work.longest.begin(), work.longest.end());
  out.pairs = 0;
  for (const std::int64_t pairs : work.pairs) out.pairs += pairs;
}

}  // namespace riffle
