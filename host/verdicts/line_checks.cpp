#include "host/verdicts/line_checks.hpp"

#include <algorithm>
#include <limits>

namespace riffle {

LineLook look_along(const LineView& line) {
  constexpr double nobody = std::numeric_limits<double>::infinity();
  std::vector<double> others = line.others;
  std::sort(others.begin(), others.end());
  LineLook look;
  const std::size_t n = line.x.size();
  auto behind = others.begin();  // the first of the others that is not left of the particle
  std::int64_t paired = 0, stretched = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = line.x[i];
    while (behind != others.end() && *behind < x) ++behind;
    double left = i > 0 ? x - line.x[i - 1] : nobody, right = i + 1 < n ? line.x[i + 1] - x : nobody;
    if (behind != others.begin()) left = std::min(left, x - *std::prev(behind));
    if (behind != others.end()) right = std::min(right, *behind - x);
    const bool alone_left = left != nobody && left >= line.reach[i];
    const bool alone_right = right != nobody && right >= line.reach[i];
    if (alone_left || alone_right) {
      if (look.one_sided == 0) look.one_sided_at = x;
      ++look.one_sided;
    }
    const double limit = stretched_gap * line.reach[i];
    if ((left != nobody && left > limit) || (right != nobody && right > limit)) ++stretched;
    if (i < 2 || i + 1 >= n) continue;
    const double before = line.x[i - 1] - line.x[i - 2], here = x - line.x[i - 1], after = line.x[i + 1] - x;
    if ((after - here) * (here - before) < 0 && std::max(here, after) > paired_gaps * std::min(here, after)) ++paired;
  }
  const double share = n > 0 ? 1 / static_cast<double>(n) : 0;
  look.paired = share * static_cast<double>(paired);
  look.stretched = share * static_cast<double>(stretched);
  return look;
}

namespace {

// Particles of `now` that stand behind one that was behind them in `before`.
std::int64_t out_of_order(const std::vector<std::int64_t>& before, const std::vector<std::int64_t>& now) {
  std::int64_t largest = -1;
  for (const auto* list : {&before, &now}) {
    for (const std::int64_t id : *list) largest = std::max(largest, id);
  }
  std::vector<std::int64_t> rank(static_cast<std::size_t>(largest + 1), -1);
  for (std::size_t k = 0; k < before.size(); ++k)
    rank[static_cast<std::size_t>(before[k])] = static_cast<std::int64_t>(k);
  std::int64_t found = 0, furthest = -1;
  for (const std::int64_t id : now) {
    const std::int64_t r = rank[static_cast<std::size_t>(id)];
    if (r < 0) continue;
    if (r < furthest) ++found;
    furthest = std::max(furthest, r);
  }
  return found;
}

}  // namespace

std::int64_t overtakings(const std::vector<std::int64_t>& before, const std::vector<std::int64_t>& now) {
  if (before == now || now.empty()) return 0;
  const std::int64_t found = out_of_order(before, now);
  const auto first = std::find(before.begin(), before.end(), now.front());
  if (found == 0 || first == before.begin() || first == before.end()) return found;
  std::vector<std::int64_t> turned(first, before.end());  // where a boundary closes the channel to a ring
  turned.insert(turned.end(), before.begin(), first);
  return std::min(found, out_of_order(turned, now));
}

}  // namespace riffle
