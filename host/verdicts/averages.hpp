// Averages over time, by height, of flow that is statistically steady: profiles, stresses, and what they say about it.
//
// Heights are the last axis, cut into bins one particle spacing high. Each sample adds every water particle to its bin.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/output/run_record.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

class Averages {
 public:
  Averages(const Simulation& simulation, double from);

  void sample(Simulation& simulation);

  [[nodiscard]] FlowAverages result() const;
  [[nodiscard]] std::vector<Verdict> verdicts() const;

  // For checkpoints.
  [[nodiscard]] nlohmann::json state() const;
  void restore(const nlohmann::json& state);

 private:
  struct Whole {  // of all the water, at one sample
    double time, velocity, depth, momentum, driving, drag, mass;
  };
  [[nodiscard]] double sum(const std::string& name, std::size_t bin) const;
  [[nodiscard]] double mean(const std::string& name, std::size_t bin) const;
  [[nodiscard]] double stress_scale() const;

  double from_, low_ = 0, spacing_ = 0, length_ = 0, density_, gravity_;
  bool open_ = false;  // with buffers beyond its ends, whose pressures drive the water, too
  std::int64_t samples_ = 0;
  std::vector<double> count_;
  std::map<std::string, std::vector<double>> sums_;
  std::vector<Whole> whole_;
};

}  // namespace riffle
