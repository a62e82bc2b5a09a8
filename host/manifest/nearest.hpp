// The nearest right spelling, for messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riffle {

// Insertions, deletions, replacements and swaps of neighbouring letters that turn a into b; case and "-" against "_"
// do not count.
int edit_distance(std::string_view a, std::string_view b);

// The candidate that `wrong` was most likely meant to be, "" when none is near enough to be worth a word.
std::string nearest(const std::string& wrong, const std::vector<std::string>& candidates);

// `; did you mean "alpha"?`, or "" when nothing is near.
std::string did_you_mean(const std::string& wrong, const std::vector<std::string>& candidates);

// `"a"`, `"a" or "b"`, `"a", "b" or "c"`.
std::string any_of(const std::vector<std::string>& words);
// `"a"`, `"a" and "b"`, `"a", "b" and "c"`.
std::string all_of(const std::vector<std::string>& words);

}  // namespace riffle
