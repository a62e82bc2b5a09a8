// The shipped plugins, loaded once through their C tables, and instances of them with chosen parameters.
#pragma once

#include <riffle/abi.h>

#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace riffle::contract {

struct Loaded {
  const riffle_plugin* plugin;
  std::string library;  // file name
};
inline std::ostream& operator<<(std::ostream& out, const Loaded& loaded) {
  return out << loaded.library;
}

// All plugins of all libraries that this build makes.
const std::vector<Loaded>& all_plugins();
std::vector<Loaded> plugins_of(const std::string& kind);
// Throws std::out_of_range when there is none.
const riffle_plugin& plugin(const std::string& kind, const std::string& id);
// "cubic_spline": a name for a parametrised test.
std::string test_name(const Loaded& loaded);

template <class T>
std::vector<const T*> entries(const T* const* table) {
  std::vector<const T*> list;
  for (; table != nullptr && *table != nullptr; ++table) list.push_back(*table);
  return list;
}

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A scene of one metre, without bed and a metre wide.
const riffle_services& flat_metre(int dim);

// One instance. Parameters that are not given have their default; choices are given by index, functions are constant. Throws Refused with the
// plugin's own sentence, and std::out_of_range for a parameter that the plugin does not have.
class Instance {
 public:
  // Connected to `scene` at once, to flat_metre if not said; nullptr when the test does that itself.
  Instance(const riffle_plugin& plugin, int dim, const std::map<std::string, double>& given = {})
      : Instance(plugin, dim, given, &flat_metre(dim)) {}
  Instance(const riffle_plugin& plugin, int dim, const std::map<std::string, double>& given,
           const riffle_services* scene);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  [[nodiscard]] const riffle_plugin& table() const { return plugin_; }
  [[nodiscard]] const void* self() const { return self_; }
  [[nodiscard]] void* self() { return self_; }

 private:
  const riffle_plugin& plugin_;
  std::vector<riffle_function> functions_;  // these two must outlive the instance
  std::vector<double> numbers_;
  void* self_ = nullptr;
};

}  // namespace riffle::contract
