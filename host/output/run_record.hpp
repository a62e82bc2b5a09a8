// run.json: what a run was, what it found, and what it cost. Every key is documented in docs/run-record.md, which a
// test compares with what is written. The names are relied on by scripts: add, never rename.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/output/build_info.hpp"
#include "host/output/errors.hpp"
#include "host/output/fronts.hpp"

namespace riffle {

enum class RunStatus { finished, suspect, failed };

enum class Severity { note, suspect, failed };

// A judgement on the run: "mass", "energy", ...; `text` is one sentence with the figures.
struct Verdict {
  std::string name, text;
  Severity severity = Severity::note;
  std::optional<double> value{}, bound{};  // the worst value seen, and what it must not cross
  std::optional<double> first_seen{};      // s: when it first did
};

struct MassLedger {  // kg
  double initial = 0, in = 0, out = 0, final = 0;
  // (final + out - initial - in) over (initial + in): round-off when every kilogram is accounted for
  [[nodiscard]] double imbalance() const;
};

struct MomentumLedger {  // kg m/s, one value per axis; kg m/s per m of width in 1D and in the vertical plane
  std::vector<double> initial, final;
  double scale = 0;  // sum of m |u| at the end, to judge the change by
};

struct StepLimit {
  std::int64_t steps = 0;  // that it decided
  double smallest = 0;     // s
};

struct PluginRecord {
  std::string slot, kind, id, version, library, hash, build;
  nlohmann::ordered_json parameters = nlohmann::ordered_json::object();  // all in force, SI
  std::vector<double> state = {};  // numbers that a boundary remembers, at the end
};

struct NeighbourStatistics {
  double mean = 0;
  std::int64_t smallest = 0, largest = 0;
};

struct PhaseSeconds {  // wall
  double sort = 0, list = 0, sweeps = 0, integrate = 0, output = 0, verdicts = 0;
};

// Averages over time and along the bed of flow that is statistically steady; one value per row of `z`.
struct FlowAverages {
  std::int64_t samples = 0;
  double from = 0, to = 0;                         // s
  std::vector<double> z, velocity, rms_x, rms_z;   // m, m/s: along the bed; deviations from the mean
  std::vector<double> modelled, resolved, virial;  // Pa: shear stresses
  std::vector<double> pressure;                    // Pa
  double mean_velocity = 0, depth = 0;             // over the depth, m/s; m
  std::optional<double> balance{}, drag_share{};   // of what drives the water: held back in all; by drag
};

struct SurfaceError {                   // of the free surface against measured levels
  double time = 0, rmse = 0, bias = 0;  // s, m, m (computed less measured)
  std::int64_t points = 0;
};

struct VolumeLedger {  // of the water, m / rho; per m of width in the vertical plane
  double initial = 0, final = 0,
         expected = 0;  // expected: initial and what boundaries brought and took, at rest density
  [[nodiscard]] double change() const { return (final - expected) / initial; }
};

struct RunRecord {
  RunStatus status = RunStatus::finished;
  std::string message;  // why it failed or is suspect: one sentence; empty otherwise
  std::string case_name, title;
  double time = 0;  // s, simulated, reached
  std::int64_t steps = 0, particles = 0;
  double wall_seconds = 0, cpu_seconds = 0;
  double particle_steps_per_second = 0, evaluations_per_second = 0;
  std::map<std::string, FieldErrors> errors;
  std::map<std::string, Extrema> extrema;
  MassLedger mass;
  MomentumLedger momentum;
  std::optional<VolumeLedger> volume;
  std::vector<SurfaceError> surface;
  std::map<std::string, StepLimit> limits;
  std::vector<PluginRecord> plugins;
  std::vector<Verdict> verdicts;
  std::vector<std::string> overrides;  // "key=value" as given with --set
  std::string manifest;                // the effective manifest, JSON text
  std::string resumed_from;            // name of the checkpoint file, or empty
  int threads = 1;
  Machine machine = this_machine();
  std::optional<NeighbourStatistics> neighbours;
  std::optional<double> active_fraction;  // of the water, where the equations have terms that act in places only
  std::optional<DepthStep> dam;           // where the initial state is a step
  Fronts fronts;
  std::optional<FlowAverages> averages;  // where [output] averages asks for them
  double bytes_per_particle = 0;
  PhaseSeconds seconds;
};

// The worst severity decides: failed, suspect, or finished.
RunStatus status_from(const std::vector<Verdict>& verdicts);

// What the program returns: 0 good, 1 failed, 3 suspect when `strict`. (2, bad input, never has a record.)
int exit_code(RunStatus status, bool strict);

// Values that are not finite become null.
nlohmann::ordered_json to_json(const RunRecord& record);

// Throws std::runtime_error with one sentence.
void write_run_record(const std::filesystem::path& path, const RunRecord& record);

}  // namespace riffle
