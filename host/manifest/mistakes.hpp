// Mistakes in a manifest: collected while reading, thrown all together.
#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace riffle {

// Where something stands: a place in a file, or an override given with --set.
struct SourcePlace {
  std::string source;        // file as the user named it, or "--set key=value"
  int line = 0, column = 0;  // from 1, in characters; of an override: 0 and its turn
  [[nodiscard]] bool from_override() const { return line == 0; }
  [[nodiscard]] std::string text() const;
};

// Every mistake of a manifest, one line each: `file:line:column: what is wrong, the rule, the value; did you mean ...?`
class ManifestError : public std::exception {
 public:
  explicit ManifestError(std::vector<std::string> lines);
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }  // all lines

 private:
  std::vector<std::string> lines_;
  std::string text_;
};

class Mistakes {
 public:
  void add(const SourcePlace& place, std::string sentence) { found_.emplace_back(place, std::move(sentence)); }
  [[nodiscard]] std::size_t count() const { return found_.size(); }
  // Throws a ManifestError when there is any: in the order of the file, then those of --set.
  void throw_if_any() const;

 private:
  std::vector<std::pair<SourcePlace, std::string>> found_;
};

}  // namespace riffle
