// A collapse of a water column in the vertical plane as a whole program runs it: plugins, neighbour search, steps and all.
#pragma once

#include <cstdint>
#include <filesystem>

#include "host/manifest/case.hpp"
#include "host/plugins/registry.hpp"

namespace riffle::bench {

struct DamBreakRequest {
  std::int64_t particles = 80000;  // of water, about
  int warm_up = 150, steps = 60, repeats = 5;
  double cfl = 1.25;  // fronts as with 0.25 within 0.1 %: docs/results-weakly-compressible.md
};

struct DamBreakFigures {
  std::int64_t particles = 0;                  // of water
  double neighbours = 0;                       // within the support, mean
  double evaluations_per_second_per_core = 0;  // particles times evaluations of all rates, per CPU second, median
  double advance_rate = 0;                     // the same times dt c0 / dx
  double step_over_spacing = 0;                // dt c0 / dx
  double speedup_2_threads = 0;                // wall time, interleaved, medians
  double bytes_per_particle = 0;               // particle arrays, lists and records
};

// The manifest of the scene, with a disordered start.
std::string dam_break_manifest(std::int64_t particles, double cfl);

// Throws what a run throws.
DamBreakFigures bench_dam_break(const Registry& registry, const DamBreakRequest& request);

}  // namespace riffle::bench
