// Where everything of a pair group lies: the packed record of a particle, and the arrays of one block.
//
// A record holds what is read of neighbours: position, velocity when `approach` is asked for, then the other fields;
// it is a multiple of 4 doubles, so that 4 records are gathered by 4x4 transposes. The arena of a thread holds one
// short array per thing: geometry, neighbours' values, own values, kernel outputs, closures' outputs, contributions.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "host/particles/store.hpp"
#include "host/schedule/plan.hpp"

namespace riffle {

// One number per particle: a component of a field, or the inverse smoothing length.
struct Source {
  int field = -1;
  int component = 0;
  bool inverse_length = false;
  friend bool operator==(const Source&, const Source&) = default;
};

struct GatherOp {  // on whole blocks, after the gather
  enum class Kind { own, difference, mean, inverse_mean } kind;
  int to = 0, from = -1;  // arrays; `from`: the neighbours' values
  Source source;          // of the particle itself
};

struct KernelCall {
  int inverse_l = -1;  // array
  std::uint32_t want = 0;
  int out[RIFFLE_KERNEL_OUTPUTS] = {-1, -1, -1, -1, -1, -1};
};

struct PassCall {
  int node = -1;
  std::vector<std::vector<int>> in, out;  // arrays per component; empty `in`: absent optional read
};

struct Reduction {
  int array = 0;
  int field = -1, component = 0;
  std::uint32_t how = RIFFLE_SUM;
  bool first = true;  // overwrites; later contributors add
  bool with_self = false;
};

struct Keep {
  int array = 0, field = -1, component = 0;
};

struct GroupLayout {
  int dim = 1;
  bool approach = false, any_self = false;
  int quads = 1;                                  // 4-double pieces of a record
  std::vector<Source> slots;                      // after position (and velocity): slot k is array first_slot + k
  int first_slot = 0;                             // array of the first slot
  int first_own = 0, own_count = 0;               // arrays of own values that the gather itself repeats, and how many
  int arrays = 0;                                 // all arrays
  std::vector<std::pair<int, double>> constants;  // arrays that never change: uniform fields
  std::vector<GatherOp> ops;
  std::vector<KernelCall> kernels;
  std::vector<PassCall> calls;  // closures first, then passes
  std::vector<Reduction> reductions;
  std::vector<Keep> keeps;
  [[nodiscard]] int r() const { return dim; }
  [[nodiscard]] int r2() const { return dim + 1; }
  [[nodiscard]] int vr() const { return dim + 2; }
};

// `uniform[f]`: the field has one value, which the dummy holds too. `overwrites`: (node, field) where the node is the
// first to write the field in this plan; others add.
GroupLayout make_layout(const Graph& graph, const PairGroup& group, const ParticleStore& store,
                        const std::vector<char>& uniform, const std::set<std::pair<int, int>>& overwrites);

}  // namespace riffle
