// The third side of the boundary benchmark: the same rates by Riffle's own pipeline, through loaded plugins.
#pragma once

#include <memory>
#include <string>

#include "host/bench/state.hpp"
#include "host/plugins/registry.hpp"

namespace riffle::bench {

class ThroughPlugins {
 public:
  // Particles of `state`, equations "wcsph", kernel "wendland-c2", viscosity "monaghan" and filter "delta-sph" of the
  // registry, one thread. Throws std::runtime_error when one of them is missing.
  ThroughPlugins(const BenchState& state, const Registry& registry, double skin, std::int64_t block = 0);
  ~ThroughPlugins();

  // One evaluation of acceleration and density rate: state equation, packing and the sweep; the list stays.
  void operator()();
  void copy_to(BenchRates& rates) const;  // in the order of the state

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace riffle::bench
