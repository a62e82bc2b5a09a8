// Pair groups in one dimension: no list and no gather. On a sorted line the m-th neighbours of a stretch of particles are
// again a stretch, so a closure is called once per stretch and m, and reads neighbours' fields where they lie.
//
// Sums run over m = 1, 2, ... to the left, then to the right, and only pairs within reach count: the result does not
// depend on the stretch. Particles of other roles and images count too, as long as they lie beyond the ends of the
// water, as those of inflow, outflow and walls do. Two to three times faster than lists, which padding makes expensive for 6 to 8 neighbours.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "host/schedule/group_failure.hpp"
#include "host/schedule/images.hpp"
#include "host/schedule/layout.hpp"

namespace riffle {

class LineGroup {
 public:
  // `written_before`: fields that earlier stages of the same sweep write; own values of them are fetched chunk by chunk.
  LineGroup(const Graph& graph, const GroupLayout& layout, const NeighbourRequest& request,
            const std::set<int>& written_before);
  ~LineGroup();

  // What a group must not have to be run on a line: pair fields that are kept for the whole list.
  [[nodiscard]] static bool possible(const GroupLayout& layout);

  // Copies the columns that the group reads into the order of the line. `source`: the particle array of a Source.
  void prepare(const ParticleStore& store, const std::vector<Image>& images, double kappa, int threads,
               const std::function<const double*(const Source&)>& source);

  // All passes of the group for the water particles [first, last). `field`: where a reduction goes. Returns the first
  // failure, if any.
  GroupFailure run(std::int64_t first, std::int64_t last, int thread, double time, double dt,
                   const std::function<double*(const Reduction&)>& field);

 private:
  struct Thread;
  struct Place {  // of an array: in the arena, or a column read at i or at j
    int column = -1;
    bool at_j = false;
  };
  int column_of(const Source& source);
  std::unique_ptr<Thread> make_thread() const;
  void point(Thread& local, std::int64_t i, std::int64_t j) const;
  bool evaluate(Thread& local, std::int64_t i, std::int64_t j, std::int64_t n, std::int64_t first, double time,
                double dt, GroupFailure& failure) const;

  const Graph& graph_;
  const GroupLayout& layout_;
  Reach reach_;
  std::uint32_t source_roles_;
  std::vector<Source> sources_;  // of columns behind position, velocity and reach
  std::vector<Place> places_;    // per array
  std::vector<AlignedArray> columns_;
  std::int64_t start_ = 0;  // column index of the first water particle
  struct Late {
    int column = 0;
    const double* from = nullptr;
  };
  std::vector<Late> late_;  // columns of fields that the sweep itself has just written
  double largest_reach_ = 0;
  std::vector<std::unique_ptr<Thread>> threads_;
};

}  // namespace riffle
