// Runs sweeps over the particle store on all cores.
//
// Work is cut into fixed chunks of particles and, for pair passes, into blocks of some tens of pairs whose arrays stay
// in the first-level cache. Each particle's sums are formed by one thread in list order, so results do not depend on
// the number of threads, the chunk or the block.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "host/schedule/images.hpp"
#include "host/schedule/layout.hpp"
#include "host/schedule/plan.hpp"
#include "host/schedule/run_error.hpp"
#include "host/schedule/span.hpp"

namespace riffle {

struct RunnerOptions {
  std::int64_t chunk = 256;  // particles
  std::int64_t block = 0;    // pairs; 0: what fits the cache
};

class LineGroup;

// Where the lists come from; the neighbourhood implements it.
class ListProvider {
 public:
  virtual ~ListProvider() = default;
  [[nodiscard]] virtual const NeighbourList& list(const NeighbourRequest& request) const = 0;
  [[nodiscard]] virtual double kappa() const = 0;  // support of the kernel in smoothing lengths
  // One dimension, water alone as targets, in ascending x, and all other sources (buffers, walls, images) beyond its ends.
  [[nodiscard]] virtual bool on_a_line(const NeighbourRequest& request) const = 0;
};

class Runner {
 public:
  Runner(const Graph& graph, ParticleStore& store, RunnerOptions options);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  // An evaluation begins: several sweeps. `fresh`: the only particles of which anything has changed or will since the
  // evaluation before; nullptr: all.
  void begin(const std::vector<Span>* fresh) {
    fresh_ = fresh;
    ++evaluation_;
  }
  // Runs one sweep, over all particles or some. Images of what it reads of neighbours must be current. Throws RunError
  // naming plugin and pass.
  void run(const Plan& plan, std::size_t sweep, const ListProvider& lists, const std::vector<Image>& images,
           double time, double dt, const std::vector<Span>* only = nullptr);
  // Smallest limit over the particles of a vote.
  double vote(const GraphVote& vote, double time, double dt);
  // Attribute fields with one value for all particles need no gather; call when attributes have changed.
  void find_uniform_fields();

 private:
  struct Group;
  struct Compiled;
  Compiled& compile(const Plan& plan, std::size_t sweep);
  std::set<std::pair<int, int>> who_overwrites(const Plan& plan, std::size_t index,
                                               std::vector<int>& zero_fields) const;
  void prepare(Group& group, const ListProvider& lists, const std::vector<Image>& images, int threads);
  void invert_lengths();
  void run_group(Group& group, std::int64_t first, std::int64_t last, int thread, double time, double dt);
  void clear(int field, std::uint32_t roles);
  void check_signs(const PassNode& writer, std::int64_t first, std::int64_t last);
  void check_signs_of_all(const PassNode& writer);
  void run_particles(const PassNode& node, const std::set<int>& zero, std::int64_t first, std::int64_t last,
                     double time, double dt);
  void run_global(const PassNode& node, const ListProvider& lists, const std::vector<Image>& images, double time,
                  double dt);
  void fail(const PassNode& node, const std::string& message);
  [[nodiscard]] const PassNode& node(int n) const { return graph_.nodes()[static_cast<std::size_t>(n)]; }
  [[nodiscard]] double* component(int field, int component) const;
  [[nodiscard]] const double* source(const Source& s) const;

  const Graph& graph_;
  ParticleStore& store_;
  RunnerOptions options_;
  std::vector<char> uniform_;
  std::vector<double> uniform_value_;
  std::vector<Field*> field_;  // of the store, by graph index; nullptr for per-pair fields
  std::map<std::pair<const Plan*, std::size_t>, std::unique_ptr<Compiled>> compiled_;
  std::map<int, std::vector<AlignedArray>> kept_;  // per field, component by component, in the order of the list
  std::map<int, const LineGroup*> kept_on_line_;   // or who holds them, where the line made them; else nullptr
  AlignedArray inverse_l_;
  const std::vector<Span>* fresh_ = nullptr;
  std::int64_t evaluation_ = 0, inverted_ = -2;  // numbers: of this evaluation, and of the last that formed inverse_l_
  std::string failure_;
};

}  // namespace riffle
