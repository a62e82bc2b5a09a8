#include "host/manifest/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/manifest/nearest.hpp"

namespace riffle {
namespace {

constexpr SiDimension powers(int kg, int m, int s) {
  return {{12 * kg, 12 * m, 12 * s, 0, 0, 0, 0}};
}

struct Symbol {
  std::string_view name;
  bool takes_prefix;
  ScaledUnit unit;
};

const std::vector<Symbol>& symbols() {
  static const std::vector<Symbol> table{
      {"1", false, {}},
      {"m", true, {1, 1, 0, powers(0, 1, 0)}},
      {"g", true, {1, 1, -3, powers(1, 0, 0)}},
      {"s", true, {1, 1, 0, powers(0, 0, 1)}},
      {"min", false, {60, 1, 0, powers(0, 0, 1)}},
      {"h", false, {3600, 1, 0, powers(0, 0, 1)}},
      {"Hz", true, {1, 1, 0, powers(0, 0, -1)}},
      {"N", true, {1, 1, 0, powers(1, 1, -2)}},
      {"Pa", true, {1, 1, 0, powers(1, -1, -2)}},
      {"J", true, {1, 1, 0, powers(1, 2, -2)}},
      {"W", true, {1, 1, 0, powers(1, 2, -3)}},
      {"l", true, {1, 1, -3, powers(0, 3, 0)}},
      {"L", true, {1, 1, -3, powers(0, 3, 0)}},
      {"deg", false, {std::numbers::pi, 180, 0, {}}},
      {"°", false, {std::numbers::pi, 180, 0, {}}},
      {"rad", false, {}},
      {"%", false, {1, 1, -2, {}}},
      {"K", true, {1, 1, 0, {{0, 0, 0, 12, 0, 0, 0}}}},
      {"A", true, {1, 1, 0, {{0, 0, 0, 0, 12, 0, 0}}}},
      {"mol", true, {1, 1, 0, {{0, 0, 0, 0, 0, 12, 0}}}},
      {"cd", true, {1, 1, 0, {{0, 0, 0, 0, 0, 0, 12}}}},
  };
  return table;
}

struct Prefix {
  std::string_view name;
  int decimal;
};
constexpr std::array<Prefix, 9> prefixes{
    {{"k", 3}, {"M", 6}, {"G", 9}, {"h", 2}, {"d", -1}, {"c", -2}, {"m", -3}, {"u", -6}, {"n", -9}}};

std::optional<ScaledUnit> find_symbol(std::string_view name) {
  for (const Symbol& symbol : symbols()) {
    if (symbol.name == name) return symbol.unit;
  }
  for (const Prefix& prefix : prefixes) {
    if (!name.starts_with(prefix.name)) continue;
    for (const Symbol& symbol : symbols()) {
      if (!symbol.takes_prefix || symbol.name != name.substr(prefix.name.size())) continue;
      ScaledUnit unit = symbol.unit;
      unit.decimal += prefix.decimal;
      return unit;
    }
  }
  return std::nullopt;
}

[[noreturn]] void unknown(std::string_view name) {
  static const std::vector<std::string> usual{"m",  "mm",  "cm", "km", "kg", "g",  "s",  "ms",  "min", "h",
                                              "Pa", "kPa", "N",  "kN", "l",  "ml", "Hz", "deg", "rad", "%"};
  throw UnitError(fmt::format("unknown unit \"{}\"{}", name, did_you_mean(std::string(name), usual)));
}

// What typographers write, in the letters that the grammar knows.
std::string plain(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> replacements{
      {{"²", "2"}, {"³", "3"}, {"¹", "1"}, {"⁻", "-"}, {"·", "."}, {"µ", "u"}, {"μ", "u"}, {"−", "-"}}};
  std::string out(text);
  for (const auto& [from, to] : replacements) {
    for (std::size_t at = out.find(from); at != std::string::npos; at = out.find(from, at)) {
      out.replace(at, from.size(), to);
    }
  }
  return out;
}

bool is_symbol_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || (static_cast<unsigned char>(c) >= 0x80);
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

class UnitParser {
 public:
  UnitParser(std::string_view text, std::optional<int> dim) : text_(text), dim_(dim) {}

  ScaledUnit parse() {
    skip_spaces();
    if (done()) fail();
    multiply(1);
    bool divided = false;
    for (skip_spaces(); !done(); skip_spaces()) {
      if (next() == '/') {
        ++at_;
        skip_spaces();
        multiply(-1);
        divided = true;
        continue;
      }
      if (next() == '.' || next() == '*') ++at_;
      skip_spaces();
      if (divided) {
        throw UnitError(
            fmt::format("\"{}\" is ambiguous after its \"/\"; write kg/m/s or kg.m-1.s-1 for example", text_));
      }
      multiply(1);
    }
    return result_;
  }

 private:
  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  [[nodiscard]] char next() const { return text_[at_]; }
  [[nodiscard]] bool next_is_digit(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() && is_digit(text_[at_ + ahead]);
  }
  void skip_spaces() {
    while (!done() && next() == ' ') ++at_;
  }
  [[noreturn]] void fail() const { throw UnitError(fmt::format("\"{}\" is no unit", text_)); }

  std::string_view take_symbol() {
    const std::size_t begin = at_;
    if (!done() && next() == '1') {
      ++at_;
    } else {
      while (!done() && is_symbol_character(next())) ++at_;
    }
    if (at_ == begin) fail();
    return text_.substr(begin, at_ - begin);
  }

  int take_number() {
    int number = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error != std::errc{} || number > 24) fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    return number;
  }

  // Exponent in twelfths; 12 when there is none.
  int take_exponent() {
    const bool caret = !done() && next() == '^';
    if (caret) ++at_;
    const bool bracket = caret && !done() && next() == '(';
    if (bracket) ++at_;
    int sign = 1;
    if (!done() && (next() == '-' || next() == '+')) sign = text_[at_++] == '-' ? -1 : 1;
    int twelfths = 12;
    if (next_is_digit()) {
      twelfths *= take_number();
      if (!done() && next() == '/' && next_is_digit(1)) {
        ++at_;
        const int denominator = take_number();
        if (denominator == 0 || twelfths % denominator != 0) fail();
        twelfths /= denominator;
      }
    } else if (dim_ && !done() && next() == 'd') {
      ++at_;
      twelfths *= *dim_;
    } else if (caret || sign < 0) {
      fail();
    }
    if (bracket) {
      if (done() || next() != ')') fail();
      ++at_;
    }
    return sign * twelfths;
  }

  void multiply(int sign) {
    const std::string_view name = take_symbol();
    std::optional<ScaledUnit> unit = find_symbol(name);
    int exponent = 12;
    if (!unit && dim_ && name == "md") {
      unit = find_symbol("m");
      exponent = 12 * *dim_;
    } else {
      exponent = take_exponent();
    }
    if (!unit) unknown(name);
    exponent *= sign;
    for (std::size_t k = 0; k < result_.dimension.twelfths.size(); ++k) {
      result_.dimension.twelfths[k] += unit->dimension.twelfths[k] * exponent / 12;
    }
    if (exponent % 12 != 0) {
      const double scale = unit->numerator / unit->denominator * std::pow(10.0, unit->decimal);
      result_.numerator *= std::pow(scale, exponent / 12.0);
      return;
    }
    result_.decimal += unit->decimal * (exponent / 12);
    for (int k = 0; k < std::abs(exponent / 12); ++k) {
      result_.numerator *= exponent > 0 ? unit->numerator : unit->denominator;
      result_.denominator *= exponent > 0 ? unit->denominator : unit->numerator;
    }
  }

  std::string_view text_;
  std::optional<int> dim_;
  std::size_t at_ = 0;
  ScaledUnit result_;
};

}  // namespace

ScaledUnit read_unit(std::string_view text, std::optional<int> dim) {
  const std::string letters = plain(text);
  return UnitParser(letters, dim).parse();
}

std::optional<QuantityText> split_quantity(std::string_view text) {
  const auto trim = [](std::string_view s) {
    while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
    while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
    return s;
  };
  text = trim(text);
  std::string_view unsigned_text = text;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) unsigned_text.remove_prefix(1);
  if (unsigned_text.empty() || !(is_digit(unsigned_text.front()) || unsigned_text.front() == '.')) return std::nullopt;
  double ignored = 0;
  const auto [end, error] = std::from_chars(unsigned_text.data(), unsigned_text.data() + unsigned_text.size(), ignored);
  if (error == std::errc::invalid_argument) return std::nullopt;
  const std::string_view number(unsigned_text.data(), static_cast<std::size_t>(end - unsigned_text.data()));
  const std::string_view rest = unsigned_text.substr(number.size());
  const std::string_view unit = trim(rest);
  const bool reads_as_unit =
      unit.empty() || is_symbol_character(unit.front()) || (is_digit(unit.front()) && rest.size() > unit.size());
  if (!reads_as_unit) return std::nullopt;
  return QuantityText{fmt::format("{}{}", text.front() == '-' ? "-" : "", number), std::string(unit)};
}

std::optional<double> in_si(const QuantityText& quantity, const ScaledUnit& unit) {
  const std::size_t e = quantity.number.find_first_of("eE");
  int exponent = unit.decimal;
  if (e != std::string::npos) exponent += std::atoi(quantity.number.c_str() + e + 1);
  const std::string shifted = fmt::format("{}e{}", quantity.number.substr(0, e), exponent);
  double value = 0;
  const auto [end, error] = std::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return value * unit.numerator / unit.denominator;
}

std::string_view name_of(const SiDimension& dimension) {
  struct Name {
    SiDimension dimension;
    std::string_view name;
  };
  static constexpr std::array<Name, 13> names{{{powers(0, 0, 0), "a number"},
                                               {powers(0, 1, 0), "a length"},
                                               {powers(0, 2, 0), "an area"},
                                               {powers(0, 3, 0), "a volume"},
                                               {powers(1, 0, 0), "a mass"},
                                               {powers(0, 0, 1), "a time"},
                                               {powers(0, 0, -1), "a rate"},
                                               {powers(0, 1, -1), "a velocity"},
                                               {powers(0, 1, -2), "an acceleration"},
                                               {powers(0, 3, -1), "a discharge"},
                                               {powers(1, -3, 0), "a density"},
                                               {powers(1, -1, -2), "a pressure"},
                                               {powers(1, 1, -2), "a force"}}};
  for (const Name& entry : names) {
    if (entry.dimension == dimension) return entry.name;
  }
  return "a quantity";
}

}  // namespace riffle
