// A checked case: everything a manifest says, in SI units, with every default filled in. Nothing in here can be wrong
// any more: the reader (read_case) refuses a manifest with any mistake and lists all of them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/manifest/function.hpp"
#include "host/plugins/description.hpp"

namespace riffle {

struct ParameterValue {
  std::string name;
  bool given = false;  // by the manifest or --set, not by default
  double number = 0;   // real, integer, boolean as 0 or 1, choice as index
  std::string text;    // choice and text; paths absolute
  std::shared_ptr<const Function> function;
};

// One plugin of the case. `slot` is the name of its table: [plugins.<slot>], or "reference".
struct PluginChoice {
  std::string slot, kind, id;
  const PluginDescription* description = nullptr;  // owned by the catalogue
  std::vector<ParameterValue> values;              // one per described parameter, in that order
};

struct Placement {
  enum class Mode { spacing, count, equal_volume, equal_volume_in_plane };
  Mode mode = Mode::spacing;
  double spacing = 0;       // m; spacing mode, and in the vertical plane
  std::int64_t count = 0;   // count and equal_volume
  double perturbation = 0;  // largest random displacement over the local spacing, [0, 0.5)
  std::uint64_t seed = 1;
  Function inside;  // particles only where it is above 0; not valid(): everywhere
};

struct TimeControl {
  double end = 0;                        // s
  double cfl = 0.5;                      // multiplies the votes that scale
  std::optional<double> fixed_step;      // s; replaces the votes
  double max_step = 0;                   // s; 0: none
  std::int64_t max_steps = 0;            // 0: none
  std::string integrator = "leap-frog";  // "leap-frog" | "semi-implicit-euler" | "predictor-corrector"
  bool drag_implicit = true;
};

struct OutputControl {
  double snapshot_interval = 0;         // s of simulated time; 0: only first and last
  double profile_interval = 0;          // s; 0: only last
  double checkpoint_interval = 0;       // s of simulated time; 0: none
  double checkpoint_wall_interval = 0;  // s of wall time; 0: none
  double averages_interval = 0;         // s; 0: none
  double averages_from = 0;             // s
  bool picture = true;
  std::vector<std::string> fields;  // to write; empty: initial and evolved fields
};

struct ReferenceControl {
  PluginChoice plugin;
  std::map<std::string, double> ignore_below;   // field name -> exact value under which a particle is left out
  std::optional<std::array<double, 2>> region;  // of x: particles outside are left out
};

struct SurfaceControl {  // measured free surfaces: by time [s], points x and level [m]
  std::map<double, std::vector<std::array<double, 2>>> points;
};

struct Case {
  std::string name, title;
  std::filesystem::path file;
  int dimension = 1;
  std::array<double, 3> lower{}, upper{};  // of the domain, m; axes x | x z | x y z: the last one is up
  double smoothing_ratio = 0;              // smoothing length over particle spacing at t = 0
  double gravity = 9.81, density = 1000, viscosity = 1e-6;  // m/s2, kg/m3, m2/s
  Placement placement;
  // Field -> one function per component. Holds what the manifest gives; other fields of the equation set start from 0
  // unless a plugin writes them.
  std::map<std::string, std::vector<Function>> initial;
  Function level;  // of the water at t = 0, instead of initial["depth"], which then follows from the bed
  std::vector<std::string> initial_from_reference;  // fields that begin as the reference has them at t = 0
  std::vector<PluginChoice> plugins;                // in the order of the manifest, reference excluded
  std::optional<ReferenceControl> reference;
  std::optional<SurfaceControl> surface;
  TimeControl time;
  OutputControl output;
  std::vector<std::string> overrides;  // "key=value" as given with --set
  std::string effective;               // JSON text: every key in force, defaults included, SI
};

}  // namespace riffle
