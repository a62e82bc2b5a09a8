// Which refusals are mistakes of the study, and which only make a combination meaningless.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/manifest/mistakes.hpp"
#include "host/study/study.hpp"

namespace riffle {

// An override, all values of one key at one place taken together, that is refused in every combination that has it is a mistake at its place in the study. One that other
// combinations take, such as alpha where the viscosity is "none", makes this one meaningless.
class Refusals {
 public:
  // A combination of this case with these overrides was tried; `lines` as the manifest says them, empty when it is good.
  // Returns why it is meaningless, in one sentence, or "".
  std::string note(const SourcePlace& case_place, const std::vector<StudyOverride>& overrides,
                   const std::vector<std::string>& lines);
  void report(Mistakes& mistakes) const;

 private:
  struct Count {
    int tried = 0, refused = 0;
    std::string sentence;
    SourcePlace place;
  };
  std::map<std::string, Count> of_override_, of_case_;
};

}  // namespace riffle
