#include "host/neighbours/line.hpp"

#include <algorithm>
#include <cstring>

namespace riffle {

namespace {

// Merges the neighbouring runs [a, b) and [b, c). From the back: whole blocks of the left run move at once, because
// typically the right run is a handful of images.
void merge_runs(Line& line, std::int64_t a, std::int64_t b, std::int64_t c) {
  double* x = line.x.data();
  std::int32_t* particle = line.particle.data();
  line.merge_x.assign(x + b, x + c);
  line.merge_particle.assign(particle + b, particle + c);
  std::int64_t left_end = b, to = c;
  for (auto k = static_cast<std::size_t>(c - b); k-- > 0;) {
    const double value = line.merge_x[k];
    // the block of the left run that is greater: double the step until it is found, then bisect
    std::int64_t step = 1;
    while (left_end - step > a && x[left_end - step] > value) step *= 2;
    const std::int64_t from = std::upper_bound(x + std::max(a, left_end - step), x + left_end, value) - x;
    const auto block = static_cast<std::size_t>(left_end - from);
    to -= left_end - from;
    std::memmove(x + to, x + from, block * sizeof(double));
    std::memmove(particle + to, particle + from, block * sizeof(std::int32_t));
    left_end = from;
    --to;
    x[to] = value;
    particle[to] = line.merge_particle[k];
  }
}

}  // namespace

void sort_along_line(Line& line) {
  const auto n = static_cast<std::int64_t>(line.x.size());
  const double* x = line.x.data();
  std::vector<std::int64_t>& run = line.run;  // starts of the pending runs, each at least twice as long as the next
  run.clear();
  const auto merge_last_two = [&](std::int64_t last) {
    merge_runs(line, run[run.size() - 2], run.back(), last);
    run.pop_back();
  };
  std::int64_t first = 0;
  while (first < n) {
    std::int64_t last = first + 1;
    while (last < n && x[last - 1] <= x[last]) ++last;
    run.push_back(first);
    while (run.size() > 1 && run.back() - run[run.size() - 2] < 2 * (last - run.back())) merge_last_two(last);
    first = last;
  }
  while (run.size() > 1) merge_last_two(n);
}

}  // namespace riffle
