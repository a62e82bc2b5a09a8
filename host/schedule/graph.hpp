// The passes of a case as a graph: what each reads and writes, and from that alone who must come before whom, which
// fields exist, and every contradiction in it. Nothing else decides the order of a step.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/neighbours/neighbours.hpp"
#include "host/particles/store.hpp"
#include "riffle/abi.h"

namespace riffle {

// A created plugin as the schedule sees it; whoever made it keeps it alive.
struct ActivePlugin {
  std::string slot, id, kind;
  const riffle_plugin* table = nullptr;
  const void* self = nullptr;
  std::vector<ParameterValue> values;
  bool fallback = false;  // the host's own passes: used only for fields that nobody else writes
};

// Contradictions between plugins, each in one sentence that names them.
class ScheduleError : public std::runtime_error {
 public:
  explicit ScheduleError(std::vector<std::string> lines);
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

enum class PairSource { none, geometry, kernel, pass };  // where a per-pair field comes from

struct GraphField {
  FieldDescription description;
  PairSource pair_source = PairSource::none;
  int geometry = -1;    // 0 separation, 1 distance, 2 distance_squared, 3 approach
  int kernel_bit = -1;  // position in riffle_plugin.evaluate_kernel's out[]
  bool given = false;   // by the host or [initial]: position, cell_measure, initial fields
  bool evolved = false;
  bool attribute = false;            // constant after t = 0
  bool carried = false;              // somebody reads its previous value
  bool occasional = false;           // written between steps; keeps its value until the next time
  std::vector<int> writers;          // nodes of the rate phase
  std::vector<int> initial_writers;  // nodes that run at t = 0
  std::string first_user;            // for messages

  [[nodiscard]] bool is_given() const {  // somebody gives it a value
    return given || evolved || occasional || !writers.empty() || !initial_writers.empty();
  }
};

struct NodeRead {
  int field = -1;  // -1: optional and absent
  std::uint32_t where = RIFFLE_AT_I;
  bool previous = false;
};

struct NodeWrite {
  int field = -1;
  std::uint32_t how = RIFFLE_SET;
  bool keep = false;
};

struct Iteration {
  std::string name;
  int residual = -1;  // field; -1: nobody writes it, the passes run once
  double tolerance = 0;
  std::int64_t maximum = 1;
};

struct PassNode {
  int plugin = -1;
  const riffle_pass* pass = nullptr;
  std::string label;  // "swe-standard: momentum"
  std::vector<NodeRead> reads;
  std::vector<NodeWrite> writes;
  std::uint32_t targets = 0, sources = 0;
  Reach reach = Reach::gather;
  bool pair = false, global = false, with_self = false, initial = false, occasional = false;
  int iteration = -1;
  std::int64_t every = 0;           // steps, of occasional passes
  double interval = 0;              // s
  bool makes_pair_field = false;    // a closure evaluated inside the groups that read its output
  std::vector<int> pair_producers;  // nodes whose per-pair output this node reads, in order
  std::vector<int> depends;         // nodes of the same phase that must run before
};

struct GraphVote {
  int plugin = -1;
  const riffle_vote* vote = nullptr;
  std::vector<int> fields;
  std::string label;
  std::uint32_t targets = 0;
};

struct GraphEvolved {
  int field = -1, rate = -1, damping = -1;  // damping -1: none
  bool rate_is_evolved = false;             // position, whose rate is the evolved velocity
  bool is_rate_of_evolved = false;          // velocity
  std::uint32_t roles = 0;                  // that it is advanced for
};

class Graph {
 public:
  // `given`: fields that [initial] or the host provides at t = 0. Throws ScheduleError with every contradiction.
  Graph(int dim, std::vector<ActivePlugin> plugins, const std::vector<std::string>& given,
        const std::vector<std::string>& wanted_outputs);

  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] const std::vector<ActivePlugin>& plugins() const { return plugins_; }
  [[nodiscard]] const std::vector<GraphField>& fields() const { return fields_; }
  [[nodiscard]] const std::vector<PassNode>& nodes() const { return nodes_; }  // in an order that respects `depends`
  [[nodiscard]] const std::vector<Iteration>& iterations() const { return iterations_; }
  [[nodiscard]] const std::vector<GraphVote>& votes() const { return votes_; }
  [[nodiscard]] const std::vector<GraphEvolved>& evolved() const { return evolved_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }  // what was left out, and why
  [[nodiscard]] int kernel() const { return kernel_; }                            // plugin index
  [[nodiscard]] int field(const std::string& name) const;                         // -1 when there is none
  [[nodiscard]] int conserved() const { return conserved_; }                      // field, -1 if none
  // Particle fields that a node uses of its neighbours (`neighbours`) or of the particle itself, those of the closures
  // evaluated within it and those that geometry and kernel imply included.
  [[nodiscard]] std::vector<int> particle_reads(int node, bool neighbours) const;
  [[nodiscard]] std::string name(int field) const { return fields_[static_cast<std::size_t>(field)].description.name; }

 private:
  int intern(const riffle_field& field, const std::string& user);
  void collect(const std::vector<std::string>& given);
  void resolve();
  void drop_unprovided();
  void drop_unused(const std::vector<std::string>& wanted_outputs);
  void link();
  void order();
  void implied(const NodeRead& read, bool neighbours, std::vector<int>& out) const;

  int dim_;
  std::vector<ActivePlugin> plugins_;
  std::vector<GraphField> fields_;
  std::vector<PassNode> nodes_;
  std::vector<Iteration> iterations_;
  std::vector<GraphVote> votes_;
  std::vector<GraphEvolved> evolved_;
  std::vector<std::string> notes_, errors_;
  int kernel_ = -1, conserved_ = -1;
};

// "parameter=value|value" over the values of a plugin.
bool condition_holds(const char* when, const std::vector<ParameterValue>& values);

}  // namespace riffle
