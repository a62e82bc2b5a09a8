#include "host/manifest/nearest.hpp"

#include <algorithm>

namespace riffle {
namespace {

std::string folded(std::string_view word) {
  std::string out;
  for (const char c : word) {
    if (c >= 'A' && c <= 'Z') {
      out += static_cast<char>(c - 'A' + 'a');
    } else {
      out += c == '-' ? '_' : c;
    }
  }
  return out;
}

std::string listed(const std::vector<std::string>& words, const char* before_last) {
  std::string out;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) out += k + 1 == words.size() ? before_last : ", ";
    out += '"' + words[k] + '"';
  }
  return out;
}

// Letters from the beginning that are the same; decides between equally near words.
std::size_t common_beginning(std::string_view a, std::string_view b) {
  std::size_t k = 0;
  while (k < a.size() && k < b.size() && a[k] == b[k]) ++k;
  return k;
}

}  // namespace

int edit_distance(std::string_view first, std::string_view second) {
  const std::string a = folded(first), b = folded(second);
  const std::size_t width = b.size() + 1;
  std::vector<int> cost((a.size() + 1) * width);
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      int& here = cost[i * width + j];
      if (i == 0 || j == 0) {
        here = static_cast<int>(i + j);
        continue;
      }
      here = std::min({cost[(i - 1) * width + j] + 1, cost[i * width + j - 1] + 1,
                       cost[(i - 1) * width + j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        here = std::min(here, cost[(i - 2) * width + j - 2] + 1);
      }
    }
  }
  return cost.back();
}

std::string nearest(const std::string& wrong, const std::vector<std::string>& candidates) {
  // A third of the letters may be wrong; short words get at least one slip, words from four letters two.
  const int allowed = std::max(wrong.size() < 4 ? 1 : 2, static_cast<int>(wrong.size() / 3));
  std::string best;
  int least = allowed + 1;
  std::size_t common = 0;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(wrong, candidate);
    if (distance >= static_cast<int>(std::max(wrong.size(), candidate.size()))) continue;
    const std::size_t begins_alike = common_beginning(wrong, candidate);
    if (distance < least || (distance == least && !best.empty() && begins_alike > common)) {
      common = begins_alike;
      least = distance;
      best = candidate;
    }
  }
  if (!best.empty() || wrong.size() < 3) return best;
  for (const std::string& candidate : candidates) {
    if (folded(candidate).find(folded(wrong)) != std::string::npos) return candidate;
  }
  return best;
}

std::string did_you_mean(const std::string& wrong, const std::vector<std::string>& candidates) {
  const std::string best = nearest(wrong, candidates);
  return best.empty() ? "" : "; did you mean \"" + best + "\"?";
}

std::string any_of(const std::vector<std::string>& words) {
  return listed(words, " or ");
}

std::string all_of(const std::vector<std::string>& words) {
  return listed(words, " and ");
}

}  // namespace riffle
