// Pair groups over a neighbour list: packs records, gathers small blocks that fit the first-level cache, calls kernel,
// closures and passes on them, and sums per particle in list order.
//
// All that does not change during a sweep is prepared before it: the loop over blocks only follows pointers.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/schedule/gather.hpp"
#include "host/schedule/group_failure.hpp"
#include "host/schedule/layout.hpp"

namespace riffle {

class ListGroup {
 public:
  // `wanted_block`: pairs per block, 0: what fits the cache.
  ListGroup(const Graph& graph, const GroupLayout& layout, std::int64_t wanted_block);
  ~ListGroup();

  // Before a sweep, on one thread. `source`: the particle array of a Source; `target`: where a component of a field
  // goes; `kept`: the array over the whole list of a kept pair field.
  void prepare(const ParticleStore& store, const NeighbourList& list, int threads,
               const std::function<const double*(const Source&)>& source,
               const std::function<double*(int field, int component)>& target,
               const std::function<double*(const Keep&)>& kept);
  // Fills the records; called by all threads of a parallel region, ends with a barrier.
  void pack();
  // All passes of the group for the targets [first, last). Returns the first failure, if any.
  GroupFailure run(std::int64_t first, std::int64_t last, int thread, double time, double dt);

 private:
  struct Thread;
  std::unique_ptr<Thread> make_thread() const;
  void fill_own_pairs(double* arena, std::int64_t self, std::int64_t i0, std::int64_t count) const;
  void fill_ops(double* arena, std::int64_t i0, std::int64_t i1) const;
  void reduce(const double* arena, std::int64_t i0, std::int64_t i1, std::int64_t self) const;

  struct Sums {  // up to four contributions, summed side by side
    int count = 0;
    int array[4] = {};
    double* to[4] = {};
    bool first[4] = {}, with_self[4] = {};
  };
  template <int Count>
  void sum_some(const Sums& sums, const double* arena, std::int64_t i0, std::int64_t i1, std::int64_t self) const;

  const Graph& graph_;
  const GroupLayout& layout_;
  std::int64_t wanted_block_;
  const NeighbourList* list_ = nullptr;
  GatherFunction gather_ = nullptr;
  int stride_ = 0;
  std::int64_t block_pairs_ = 0, particles_ = 0;
  AlignedArray records_;
  std::vector<const double*> columns_;  // of the record
  std::vector<const double*> own_;      // per op
  std::vector<Sums> sums_;
  std::vector<double*> extreme_to_;  // of minima and maxima, per reduction
  std::vector<double*> keep_to_;
  std::vector<std::unique_ptr<Thread>> threads_;
};

}  // namespace riffle
