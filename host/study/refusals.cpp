#include "host/study/refusals.hpp"

#include <set>

namespace riffle {
namespace {

// "--set key=value: what is wrong" without its beginning, or "" when the line is about something else.
std::string about(const StudyOverride& change, const std::string& line) {
  const std::string beginning = "--set " + change.text + ": ";
  return line.rfind(beginning, 0) == 0 ? line.substr(beginning.size()) : "";
}

}  // namespace

std::string Refusals::note(const SourcePlace& case_place, const std::vector<StudyOverride>& overrides,
                           const std::vector<std::string>& lines) {
  std::string reason;
  std::set<std::string> explained;
  for (const StudyOverride& change : overrides) {
    Count& count = of_override_[change.place.text() + change.key];
    count.place = change.place;
    ++count.tried;
    for (const std::string& line : lines) {
      const std::string sentence = about(change, line);
      if (sentence.empty()) continue;
      explained.insert(line);
      if (reason.empty()) reason = sentence;
      // Of several, the one that knows a better spelling says most.
      const bool knows_better = sentence.find("did you mean") != std::string::npos;
      if (count.sentence.empty() || (knows_better && count.sentence.find("did you mean") == std::string::npos)) {
        count.sentence = sentence;
      }
      ++count.refused;
      break;
    }
  }
  Count& count = of_case_[case_place.text()];
  count.place = case_place;
  ++count.tried;
  for (const std::string& line : lines) {
    if (explained.count(line) > 0) continue;
    if (reason.empty()) reason = line;
    if (count.sentence.empty()) count.sentence = line;
    ++count.refused;
    break;
  }
  return reason;
}

void Refusals::report(Mistakes& mistakes) const {
  for (const auto* counts : {&of_override_, &of_case_}) {
    for (const auto& [key, count] : *counts) {
      if (count.refused == count.tried) mistakes.add(count.place, count.sentence);
    }
  }
}

}  // namespace riffle
