#include "host/manifest/document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <tuple>
#include <utility>

namespace riffle {
namespace {

SourcePlace place_of(const toml::source_region& region, const std::string& source) {
  return {source, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

// In characters, as editors and the TOML library count columns, not in bytes.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

TomlNode convert(const toml::node& from, const std::string& source, const std::vector<std::string>& lines) {
  TomlNode node;
  node.place = place_of(from.source(), source);
  if (const auto* table = from.as_table()) {
    node.in_braces = table->is_inline();
    for (const auto& [key, value] : *table) {
      node.entries.push_back({std::string(key.str()), place_of(key.source(), source), convert(value, source, lines)});
    }
    std::stable_sort(node.entries.begin(), node.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
      return std::tuple(a.place.line, a.place.column) < std::tuple(b.place.line, b.place.column);
    });
  } else if (const auto* array = from.as_array()) {
    node.type = TomlNode::Type::array;
    for (const auto& item : *array) node.items.push_back(convert(item, source, lines));
  } else if (const auto* text = from.as_string()) {
    node.type = TomlNode::Type::text;
    node.text = text->get();
    const std::string& line = lines.at(static_cast<std::size_t>(node.place.line) - 1);
    node.plain_text = line.find('"' + node.text + '"') != std::string::npos ||
                      line.find('\'' + node.text + '\'') != std::string::npos;
  } else if (const auto* integer = from.as_integer()) {
    node.type = TomlNode::Type::integer;
    node.integer = integer->get();
    node.number = static_cast<double>(node.integer);
  } else if (const auto* real = from.as_floating_point()) {
    node.type = TomlNode::Type::real;
    node.number = real->get();
  } else if (const auto* boolean = from.as_boolean()) {
    node.type = TomlNode::Type::boolean;
    node.boolean = boolean->get();
  } else {
    node.type = TomlNode::Type::date;
  }
  return node;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    const auto code = static_cast<unsigned char>(c);
    out += code < 0x20 ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return out + '"';
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

}  // namespace

const TomlEntry* TomlNode::find(const std::string& key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const TomlEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

TomlEntry* TomlNode::find(const std::string& key) {
  return const_cast<TomlEntry*>(std::as_const(*this).find(key));
}

std::vector<std::string> TomlNode::keys() const {
  std::vector<std::string> names;
  for (const TomlEntry& entry : entries) names.push_back(entry.key);
  return names;
}

std::string TomlNode::shown() const {
  switch (type) {
    case Type::table: return "a table";
    case Type::array: return items.empty() ? "an empty array" : "an array";
    case Type::date: return "a date";
    case Type::boolean: return boolean ? "true" : "false";
    case Type::integer: return fmt::format("{}", integer);
    case Type::real: return fmt::format("{}", number);
    case Type::text: break;
  }
  constexpr std::size_t enough = 60;
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (line.size() > enough) line = line.substr(0, enough) + "...";
  return '"' + line + '"';
}

std::string TomlNode::as_toml() const {
  std::vector<std::string> parts;
  switch (type) {
    case Type::boolean: return boolean ? "true" : "false";
    case Type::integer: return fmt::format("{}", integer);
    case Type::real: {
      const std::string shortest = fmt::format("{}", number);
      const bool whole = shortest.find_first_not_of("-0123456789") == std::string::npos;
      return whole ? shortest + ".0" : shortest;
    }
    case Type::text: return quoted(text);
    case Type::date: return text;
    case Type::array:
      for (const TomlNode& item : items) parts.push_back(item.as_toml());
      return fmt::format("[{}]", fmt::join(parts, ", "));
    case Type::table: break;
  }
  for (const TomlEntry& entry : entries) {
    const bool bare = std::all_of(entry.key.begin(), entry.key.end(),
                                  [](char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
    parts.push_back(fmt::format("{} = {}", bare ? entry.key : quoted(entry.key), entry.value.as_toml()));
  }
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

SourcePlace TomlNode::character(std::size_t k) const {
  SourcePlace at = place;
  if (plain_text) at.column += 1 + static_cast<int>(characters(std::string_view(text).substr(0, k)));
  return at;
}

TomlNode read_toml(const std::string& text, const std::string& source) {
  try {
    const toml::table parsed = toml::parse(std::string_view(text), std::string_view(source));
    return convert(parsed, source, split_lines(text));
  } catch (const toml::parse_error& error) {
    std::string what(error.description());
    const std::string preamble = "Error while ";
    if (what.rfind(preamble, 0) == 0) what = what.substr(preamble.size());
    throw ManifestError({place_of(error.source(), source).text() + ": not valid TOML: " + what});
  }
}

TomlNode read_document(const std::filesystem::path& file) {
  const std::string source = file.string();
  std::error_code ignored;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open() || std::filesystem::is_directory(file, ignored)) {
    const bool exists = std::filesystem::exists(file, ignored);
    throw ManifestError({source + ": " + (exists ? "this manifest cannot be read" : "no such manifest")});
  }
  return read_toml({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}, source);
}

}  // namespace riffle
