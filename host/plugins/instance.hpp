// A plugin that has been created with the parameters of a case.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/plugins/library.hpp"
#include "riffle/abi.h"

namespace riffle {

// A plugin did what it may not, or said that it cannot; one sentence that begins with its kind and id.
class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A scene of one metre in each direction, without bed and width: for plugins that are tried on their own.
const riffle_services& flat_scene(int dim);

// Calls a plugin's `destroy`.
struct DestroyPlugin {
  void (*destroy)(void*) = nullptr;
  void operator()(void* self) const;
};

// Owns what the plugin's `create` returned; destroyed with it. The parameters, functions included, stay where they are as
// long as the instance lives, also when it is moved.
class PluginInstance {
 public:
  // `values`: one per described parameter, in that order, in SI (PluginChoice.values). They are not checked again: the
  // checker also creates plugins out of their range. Throws PluginError when the plugin does not support `dim`, fails to
  // create, throws, or (then the arithmetic is put right first) changes the floating-point environment.
  // `scene`: what it is connected to at once, flat_scene if not said; nullptr when there is none yet: then connect() follows.
  PluginInstance(const Plugin& plugin, int dim, const std::vector<ParameterValue>& values);
  PluginInstance(const Plugin& plugin, int dim, const std::vector<ParameterValue>& values,
                 const riffle_services* scene);

  // Shows the plugin the scene that it is part of. Throws PluginError when the plugin refuses it.
  void connect(const riffle_services& scene);

  [[nodiscard]] const riffle_plugin& table() const { return *table_; }
  [[nodiscard]] const void* self() const { return self_.get(); }
  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] std::string name() const { return kind_ + " \"" + id_ + "\""; }  // how messages call it
  [[nodiscard]] const std::vector<ParameterValue>& values() const { return values_->given; }

 private:
  struct Values {
    std::vector<ParameterValue> given;
    std::deque<riffle_function> functions;
    std::vector<riffle_value> values;
    std::vector<const riffle_value*> pointers;
  };
  // In this order: the instance goes first, then what it points to, then the tables.
  std::shared_ptr<const void> owner_;
  const riffle_plugin* table_;
  int dim_;
  std::string kind_, id_;
  std::unique_ptr<Values> values_;
  std::unique_ptr<void, DestroyPlugin> self_;
};

// Every parameter at its default. Those that inherit take the quantity of that name from `inherited` ("fluid.gravity"),
// or that of water on earth. Those that a manifest must give, and so have no default, get a number of everyday size.
std::vector<ParameterValue> default_values(const PluginDescription& description,
                                           const std::map<std::string, double>& inherited = {});

// A function that is the same number everywhere.
std::shared_ptr<const Function> shared_constant(double value);

}  // namespace riffle
