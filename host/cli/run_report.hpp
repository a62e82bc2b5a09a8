// What a finished run leaves: record, profile, picture and the lines on the terminal.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/cli/comparison.hpp"
#include "host/output/run_record.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

struct InitialState {  // of the particles at t = 0, for the picture
  std::vector<double> x;
  std::map<std::string, std::vector<double>> fields;  // "velocity_x" for components
};
InitialState capture(const Simulation& simulation);

struct RunReport {
  std::string failure;  // empty: it reached its end
  std::map<std::string, StepLimit> limits;
  std::vector<double> momentum_initial;
  double volume_initial = 0;  // of the water; 0: its particles have no density
  std::vector<SurfaceError> surface;
  double wall_seconds = 0, cpu_seconds = 0, output_seconds = 0, verdict_seconds = 0;
  std::string resumed_from;
  std::vector<Verdict> verdicts;  // of the watch
  std::filesystem::path picture;
  std::optional<FlowAverages> averages;
};

// Sum of m / rho over the water, in m3 or per m of width in m2; 0 where particles have no mass or no density.
double volume_of_water(const Simulation& simulation);

RunRecord make_record(Simulation& simulation, const Registry& registry, const Comparison* comparison,
                      const RunReport& report);

void write_run_profile(const std::filesystem::path& path, Simulation& simulation, const Comparison* comparison);

// The path of the PNG, or why there is none.
std::filesystem::path draw_run(const std::filesystem::path& folder, Simulation& simulation,
                               const Comparison* comparison, const InitialState& initial);

std::string summary(const RunRecord& record, const Case& scene, const RunReport& report,
                    const std::filesystem::path& folder);

nlohmann::json limits_json(const std::map<std::string, StepLimit>& limits);
std::map<std::string, StepLimit> limits_from(const nlohmann::json& json);

}  // namespace riffle
