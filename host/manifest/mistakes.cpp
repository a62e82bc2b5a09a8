#include "host/manifest/mistakes.hpp"

#include <algorithm>
#include <tuple>

namespace riffle {

std::string SourcePlace::text() const {
  if (from_override()) return source;
  return source + ':' + std::to_string(line) + ':' + std::to_string(column);
}

ManifestError::ManifestError(std::vector<std::string> lines) : lines_(std::move(lines)) {
  for (const std::string& line : lines_) text_ += (text_.empty() ? "" : "\n") + line;
}

void Mistakes::throw_if_any() const {
  if (found_.empty()) return;
  auto sorted = found_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first.from_override(), a.first.line, a.first.column) <
           std::tuple(b.first.from_override(), b.first.line, b.first.column);
  });
  std::vector<std::string> lines;
  for (const auto& [place, sentence] : sorted) lines.push_back(place.text() + ": " + sentence);
  throw ManifestError(std::move(lines));
}

}  // namespace riffle
