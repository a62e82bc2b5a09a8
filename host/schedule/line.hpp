// Pair groups in one dimension: no list and no gather. On a sorted line the m-th neighbours of a stretch of particles are
// again a stretch, so a closure is called once per stretch and m, and reads neighbours' fields where they lie.
//
// Sums run over m = 1, 2, ... to the left, then to the right, and only pairs within reach count: the result does not
// depend on the stretch. Particles of other roles and images count too, as long as they lie beyond the ends of the
// water, as those of inflow, outflow and walls do. Two to three times faster than lists, which padding makes expensive
// for 6 to 8 neighbours.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "host/schedule/group_failure.hpp"
#include "host/schedule/images.hpp"
#include "host/schedule/kept_rows.hpp"
#include "host/schedule/layout.hpp"
#include "host/schedule/span.hpp"

namespace riffle {

class LineGroup {
 public:
  // `written_before`: fields that earlier stages of the same sweep write; own values of them are fetched chunk by chunk.
  LineGroup(const Graph& graph, const GroupLayout& layout, const NeighbourRequest& request,
            const std::set<int>& written_before);
  ~LineGroup();

  [[nodiscard]] static bool possible(const GroupLayout& layout) { return layout.dim == 1; }

  // Copies the columns that the group reads into the order of the line. `source`: the particle array of a Source.
  // `fresh`: the only particles whose values have changed since evaluation `number` - 1; nullptr: who knows.
  void prepare(const ParticleStore& store, const std::vector<Image>& images, double kappa, int threads,
               const std::function<const double*(const Source&)>& source, const std::vector<Span>* fresh,
               std::int64_t number);

  // All passes of the group for the water particles [first, last). `field`: where a reduction goes. Returns the first
  // failure, if any.
  GroupFailure run(std::int64_t first, std::int64_t last, int thread, double time, double dt,
                   const std::function<double*(const Reduction&)>& field);

  // Pair fields that the group keeps. After all of run(), finish_kept() makes the rows whole.
  void finish_kept() { kept_.finish(); }
  [[nodiscard]] const KeptRows& kept() const { return kept_; }
  [[nodiscard]] std::vector<const AlignedArray*> kept_of(int field) const;  // component by component

 private:
  struct Thread;
  struct Place {  // of an array: in the arena, or a column read at i or at j
    int column = -1;
    bool at_j = false;
  };
  struct Op {  // means and differences of a column, formed for each m
    GatherOp::Kind kind;
    int to, column;
  };
  int column_of(const Source& source);
  void find_edges(std::int64_t first, std::int64_t last);
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
  std::array<bool, 4> reads_{};  // whether anybody reads separation, distance, its square, approach: arrays 0 to 3
  std::vector<Op> ops_;
  std::vector<AlignedArray> columns_;
  AlignedArray edge_right_, edge_left_;  // how far those at and beyond a place reach back
  std::int64_t start_ = 0;               // column index of the first water particle
  std::int64_t begin_ = -1, end_ = -1;   // of all particles in the columns; dummies around them
  struct Late {
    int column = 0;
    const double* from = nullptr;
  };
  std::vector<Late> late_;  // columns of fields that the sweep itself has just written
  std::vector<std::unique_ptr<Thread>> threads_;
  std::int64_t prepared_ = -2;  // number of the evaluation that the columns were last copied for
  KeptRows kept_;
  std::vector<std::int32_t> who_;  // per column index: the particle or image that stands there; only with keeps
};

}  // namespace riffle
