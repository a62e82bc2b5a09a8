#include "host/output/profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>

#include "host/output/atomic_file.hpp"
#include "host/output/build_info.hpp"

namespace riffle {
namespace {

// A line break in a name would end the comment that holds it.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

void write_profile(const std::filesystem::path& path, const ProfileHeader& header,
                   const std::vector<ProfileColumn>& columns) {
  assert(!columns.empty());
  const std::span<const double> x = columns.front().values;
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });

  std::string text = fmt::format("# case: {}\n# time: {} s\n# riffle: {}\n# units:", one_line(header.case_name),
                                 header.time, riffle_version());
  std::string names;
  for (const ProfileColumn& column : columns) {
    assert(column.values.size() == x.size());
    const char* separator = names.empty() ? "" : ",";
    text += fmt::format("{} {} [{}]", separator, column.name, column.unit);
    names += separator + column.name;
  }
  text += "\n" + names + "\n";
  for (const std::size_t i : order) {
    const char* separator = "";
    for (const ProfileColumn& column : columns) {
      fmt::format_to(std::back_inserter(text), "{}{}", separator, column.values[i]);
      separator = ",";
    }
    text += '\n';
  }
  write_atomically(path, text);
}

}  // namespace riffle
