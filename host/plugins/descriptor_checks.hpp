// What must hold of a plugin's tables before any of its functions is called: legal names, units, ranges, shapes and
// flags, functions where its kind wants them. Mistakes across plugins (two writers, no writer) are the schedule's.
#pragma once

#include <string>
#include <string_view>

#include "host/plugins/descriptor_copy.hpp"
#include "riffle/abi.h"

namespace riffle {

// Adds one sentence per mistake to `problems`, whose `where` becomes `library: kind "id"`. The tables are those of
// copy_descriptor.
void check_descriptor(const riffle_plugin& plugin, const std::string& library, Problems& problems);

// Parts of it. `subject` begins the sentence ("pass \"momentum\"").
void check_parameters(const riffle_plugin& plugin, Problems& problems);
void check_passes(const riffle_plugin& plugin, Problems& problems);
// False when the field cannot be used further (absent or nameless).
bool check_field(const riffle_field* field, const std::string& subject, Problems& problems);
// "parameter=value|value": the parameter exists and can have these values.
void check_condition(const riffle_plugin& plugin, const char* when, const std::string& subject, Problems& problems);
const riffle_parameter* find_parameter(const riffle_plugin& plugin, std::string_view name);

// [a-z][a-z0-9]* with the given character allowed after the first place.
bool is_name(const char* text, char also);
// "first|second" into its words.
std::vector<std::string> split_words(std::string_view text);
// A text that a plugin may leave out.
inline std::string text_or_empty(const char* text) {
  return text == nullptr ? "" : text;
}

// The elements of a null-terminated table, for range-based loops.
template <class T>
class Table {
 public:
  explicit Table(const T* const* items) : begin_(items), end_(items) {
    while (end_ != nullptr && *end_ != nullptr) ++end_;
  }
  [[nodiscard]] const T* const* begin() const { return begin_; }
  [[nodiscard]] const T* const* end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

 private:
  const T* const* begin_;
  const T* const* end_;
};

}  // namespace riffle
