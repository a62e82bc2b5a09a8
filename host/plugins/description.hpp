// What a plugin says about itself, as host code sees it: a copy of the constant tables of riffle/abi.h in C++ types.
// Built by the loader (library.hpp), read by the manifest, `describe`, `schema` and the schedule.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace riffle {

enum class ParameterType { real, integer, boolean, choice, text, function };

struct ParameterDescription {
  std::string name, unit, doc;
  ParameterType type = ParameterType::real;
  bool required = false, above_min = false, below_max = false, path = false;
  std::vector<std::string> choices;  // of a choice
  std::string inherit;               // manifest quantity whose value is the default ("fluid.gravity"), or empty
  double fallback = 0, min = 0, max = 0;
  std::string fallback_text;
};

enum class Shape { scalar, vector, symmetric, tensor };

struct FieldDescription {
  std::string name, unit, meaning;
  Shape shape = Shape::scalar;
  bool accumulates = false, not_negative = false, per_pair = false;
  bool needed = false;  // of an initial field: [initial] must give it (depth always)
};

// Number of double components that a field of this shape has in `dim` dimensions.
constexpr int components(Shape shape, int dim) {
  switch (shape) {
    case Shape::scalar: return 1;
    case Shape::vector: return dim;
    case Shape::symmetric: return dim * (dim + 1) / 2;
    case Shape::tensor: return dim * dim;
  }
  return 1;
}

// What an equation set cannot be run with: every plugin of that kind but "none" when `id` is empty.
struct Refusal {
  std::string kind, id, reason;
};

struct PluginDescription {
  std::string id, kind, version, summary, source, leaves_out;
  std::vector<int> dimensions;
  std::vector<ParameterDescription> parameters;
  std::vector<FieldDescription> initial;  // equations: fields that [initial] may give
  std::vector<FieldDescription> gives;    // references
  std::string library_path, library_hash, build;
  std::vector<std::string> integrators;  // that it can be run with; empty: any
  std::vector<Refusal> refuses;          // equations
};

// The kinds that exist, in the order in which they are listed.
inline const std::vector<std::string>& plugin_kinds() {
  static const std::vector<std::string> kinds{"equations", "kernel", "viscosity", "drag",     "turbulence", "boundary",
                                              "filter",    "bed",    "width",     "porosity", "reference"};
  return kinds;
}

// Where descriptions come from; the registry implements it, tests fake it.
class PluginCatalogue {
 public:
  virtual ~PluginCatalogue() = default;
  // nullptr when there is no such plugin
  [[nodiscard]] virtual const PluginDescription* find(const std::string& kind, const std::string& id) const = 0;
  [[nodiscard]] virtual std::vector<const PluginDescription*> all() const = 0;
  // Why find() gives nullptr, as a sentence, when a library was there that cannot be used; else empty.
  [[nodiscard]] virtual std::string why_missing(const std::string& /*kind*/, const std::string& /*id*/) const {
    return {};
  }
};

}  // namespace riffle
