#include "host/schedule/line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "host/neighbours/neighbours.hpp"
#include "host/plugins/call.hpp"
#include "host/schedule/line_pairs.hpp"

namespace riffle {

namespace {

constexpr std::int64_t stretch = 256;                            // particles whose m-th neighbours are taken together
constexpr std::int64_t margin = longest_segment + stretch + 16;  // far dummies at both ends of every column
constexpr int x_column = 0, u_column = 1, reach_column = 2, first_column = 3;
constexpr double far = 1e15;

std::int64_t round_up(std::int64_t n, std::int64_t to) {
  return (n + to - 1) / to * to;
}

}  // namespace

struct LineGroup::Thread {
  struct Call {
    std::vector<std::vector<const double*>> in_arrays;
    std::vector<std::vector<double*>> out_arrays;
    std::vector<const double* const*> in;
    std::vector<double* const*> out;
  };
  struct Moving {  // an entry of a pointer table that follows the stretch
    std::size_t call;
    std::size_t read, component;
    Place place;
  };
  AlignedArray arena;
  std::vector<AlignedArray> sums;  // per reduction
  AlignedArray counts;             // 1 where a pair is within reach, else 0
  std::vector<Call> calls;
  std::vector<Moving> moving;
  std::vector<const double*> kept;  // arrays of layout.keeps
};

LineGroup::LineGroup(const Graph& graph, const GroupLayout& layout, const NeighbourRequest& request,
                     const std::set<int>& written_before)
    : graph_(graph), layout_(layout), reach_(request.reach), source_roles_(request.sources) {
  places_.resize(static_cast<std::size_t>(layout.arrays));
  for (std::size_t k = 0; k < layout.slots.size(); ++k) {
    places_[static_cast<std::size_t>(layout.first_slot) + k] = {column_of(layout.slots[k]), true};
  }
  for (const GatherOp& op : layout.ops) {
    const int column = column_of(op.source);
    if (op.kind == GatherOp::Kind::own)
      places_[static_cast<std::size_t>(op.to)] = {column, false};
    else
      ops_.push_back({op.kind, op.to, column});
  }
  for (const PassCall& call : layout.calls) {
    for (const auto& arrays : call.in) {
      for (const int a : arrays) {
        if (a < 4) reads_[static_cast<std::size_t>(a)] = true;
      }
    }
  }
  columns_.resize(first_column + sources_.size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    if (!sources_[k].inverse_length && written_before.count(sources_[k].field) != 0)
      late_.push_back({first_column + static_cast<int>(k), nullptr});
  }
}

LineGroup::~LineGroup() = default;

std::vector<const AlignedArray*> LineGroup::kept_of(int field) const {
  std::vector<const AlignedArray*> components;
  for (std::size_t q = 0; q < layout_.keeps.size(); ++q) {
    if (layout_.keeps[q].field == field) components.push_back(&kept_.values()[q]);
  }
  return components;
}

int LineGroup::column_of(const Source& source) {
  const auto found = std::find(sources_.begin(), sources_.end(), source);
  const auto index = static_cast<int>(found - sources_.begin());
  if (found == sources_.end()) sources_.push_back(source);
  return first_column + index;
}

std::unique_ptr<LineGroup::Thread> LineGroup::make_thread() const {
  auto local = std::make_unique<Thread>();
  const auto arrays = static_cast<std::size_t>(layout_.arrays);
  constexpr auto length = static_cast<std::size_t>(stretch + 8);
  local->arena.resize(arrays * length);
  local->counts.resize(length);
  for (const auto& [array, value] : layout_.constants) {
    std::fill_n(local->arena.data() + static_cast<std::size_t>(array) * length, length, value);
  }
  local->kept.resize(layout_.keeps.size());
  for (std::size_t r = 0; r < layout_.reductions.size(); ++r) local->sums.emplace_back(length);
  for (std::size_t c = 0; c < layout_.calls.size(); ++c) {
    auto& call = local->calls.emplace_back();
    const PassCall& pass = layout_.calls[c];
    for (std::size_t k = 0; k < pass.in.size(); ++k) {
      auto& row = call.in_arrays.emplace_back();
      for (std::size_t q = 0; q < pass.in[k].size(); ++q) {
        const auto array = static_cast<std::size_t>(pass.in[k][q]);
        row.push_back(local->arena.data() + array * length);
        if (places_[array].column >= 0) local->moving.push_back({c, k, q, places_[array]});
      }
    }
    for (const auto& arrays_of : pass.out) {
      auto& row = call.out_arrays.emplace_back();
      for (const int a : arrays_of) row.push_back(local->arena.data() + static_cast<std::size_t>(a) * length);
    }
    for (auto& row : call.in_arrays) call.in.push_back(row.empty() ? nullptr : row.data());
    for (auto& row : call.out_arrays) call.out.push_back(row.data());
  }
  return local;
}

void LineGroup::prepare(const ParticleStore& store, const std::vector<Image>& images, double kappa, int threads,
                        const std::function<const double*(const Source&)>& source, const std::vector<Span>* fresh,
                        std::int64_t number) {
  const std::int64_t n = store.role_begin(1), owned = store.owned();
  const double* x = store.data("position");
  std::vector<std::int64_t> left, right;  // sources beyond the ends of the water, in ascending x
  for (std::int64_t i = n; i < store.all(); ++i) {
    std::int64_t origin = i;
    while (origin >= owned) origin = images[static_cast<std::size_t>(origin - owned)].origin;
    if ((source_roles_ & 1u << store.role_of(origin)) != 0) (x[i] < x[0] ? left : right).push_back(i);
  }
  for (auto* side : {&left, &right}) {
    std::sort(side->begin(), side->end(),
              [x](std::int64_t a, std::int64_t b) { return x[a] < x[b] || (x[a] == x[b] && a < b); });
  }
  const auto on_left = static_cast<std::int64_t>(left.size()), on_right = static_cast<std::int64_t>(right.size());
  start_ = round_up(margin + on_left, 8);
  const std::int64_t begin = start_ - on_left, end = start_ + n + on_right;
  const bool same_ends = begin == begin_ && end == end_;  // then the dummies of the last sweep serve again
  begin_ = begin;
  end_ = end;
  const bool some = fresh != nullptr && same_ends && prepared_ >= number - 1;
  prepared_ = number;
  const auto fill = [&](int column, const double* values, bool position) {
    AlignedArray& array = columns_[static_cast<std::size_t>(column)];
    array.resize(static_cast<std::size_t>(end + margin));
    double* to = array.data();
    for (std::int64_t k = 0; k < on_left; ++k) to[begin + k] = values[left[static_cast<std::size_t>(k)]];
    if (some) {
      for (const Span& span : *fresh) std::copy(values + span.first, values + span.last, to + start_ + span.first);
    } else {
      std::copy(values, values + n, to + start_);
    }
    for (std::int64_t k = 0; k < on_right; ++k) to[start_ + n + k] = values[right[static_cast<std::size_t>(k)]];
    if (same_ends) return;
    std::fill(to, to + begin, position ? -far : values[0]);
    std::fill(to + end, to + end + margin, position ? far : values[0]);
    for (std::int64_t k = 0; position && k < margin; ++k) to[end + k] *= static_cast<double>(k + 1);  // far apart, too
  };
  fill(x_column, x, true);
  if (layout_.approach) fill(u_column, store.data("velocity"), false);
  fill(reach_column, store.data("smoothing_length"), false);
  double* reach = columns_[reach_column].data();
  const auto scale = [&](std::int64_t from, std::int64_t to) {
#pragma omp simd
    for (std::int64_t k = from; k < to; ++k) reach[k] *= kappa;
  };
  if (some) {
    scale(begin, start_);
    for (const Span& span : *fresh) scale(start_ + span.first, start_ + span.last);
    scale(start_ + n, end);
  } else {
    scale(begin, end);
  }
  if (!same_ends) {  // dummies see nobody, not even each other
    std::fill(reach, reach + begin, -1.0);
    std::fill(reach + end, reach + end + margin, -1.0);
  }
  if (reach_ != Reach::gather) {
    if (!some) {
      find_edges(begin_, end_);
    } else {
      if (on_left > 0) find_edges(begin_, start_);
      if (!fresh->empty()) find_edges(start_ + fresh->front().first, start_ + fresh->back().last);
      if (on_right > 0) find_edges(start_ + n, end_);
    }
  }
  for (std::size_t k = 0; k < sources_.size(); ++k)
    fill(first_column + static_cast<int>(k), source(sources_[k]), false);
  for (Late& late : late_) late.from = source(sources_[static_cast<std::size_t>(late.column - first_column)]);
  while (static_cast<int>(threads_.size()) < threads) threads_.push_back(make_thread());
  if (layout_.keeps.empty()) return;
  who_.resize(static_cast<std::size_t>(end + margin));
  for (std::int64_t k = 0; k < on_left; ++k)
    who_[static_cast<std::size_t>(begin + k)] = static_cast<std::int32_t>(left[static_cast<std::size_t>(k)]);
  if (!same_ends) std::iota(who_.begin() + start_, who_.begin() + start_ + n, 0);
  for (std::int64_t k = 0; k < on_right; ++k)
    who_[static_cast<std::size_t>(start_ + n + k)] = static_cast<std::int32_t>(right[static_cast<std::size_t>(k)]);
  kept_.prepare(owned, layout_.keeps.size(), static_cast<std::size_t>(threads));
}

// How far those at k and beyond reach back, a little more than exactly: where a walk ends must not decide whether a pair
// counts that rounding puts on one side of the reach or on the other. Of [first, last) in the columns, and as far beyond as
// that makes a difference.
void LineGroup::find_edges(std::int64_t first, std::int64_t last) {
  const double *x = columns_[x_column].data(), *reach = columns_[reach_column].data();
  const auto edge = [&](std::int64_t k, double side) {
    return side * x[k] - reach[k] - 1e-9 * reach[k] - 1e-15 * std::abs(x[k]);
  };
  constexpr double nobody = std::numeric_limits<double>::infinity();
  const bool all = first == begin_ && last == end_;
  if (all) {
    for (AlignedArray* edges : {&edge_right_, &edge_left_}) edges->resize(columns_[x_column].size());
    std::fill(edge_right_.data() + end_, edge_right_.data() + end_ + margin, nobody);
    std::fill(edge_left_.data(), edge_left_.data() + begin_, nobody);
  }
  double *right = edge_right_.data(), *left = edge_left_.data();
  double least = right[last];
  for (std::int64_t k = last; k-- > first;) right[k] = least = std::min(least, edge(k, 1));
  for (std::int64_t k = first; k-- > 0;) {
    const double now = k < begin_ ? least : std::min(least, edge(k, 1));
    if (!all && right[k] == now) break;
    right[k] = least = now;
  }
  least = first > 0 ? left[first - 1] : nobody;
  for (std::int64_t k = first; k < last; ++k) left[k] = least = std::min(least, edge(k, -1));
  for (std::int64_t k = last; k < end_ + margin; ++k) {
    const double now = k >= end_ ? least : std::min(least, edge(k, -1));
    if (!all && left[k] == now) break;
    left[k] = least = now;
  }
}

void LineGroup::point(Thread& local, std::int64_t i, std::int64_t j) const {
  for (const auto& m : local.moving) {
    local.calls[m.call].in_arrays[m.read][m.component] =
        columns_[static_cast<std::size_t>(m.place.column)].data() + (m.place.at_j ? j : i);
  }
}

// Closures and passes for the pairs (i + k, j + k), k < n, whose geometry is in the arena.
bool LineGroup::evaluate(Thread& local, std::int64_t i, std::int64_t j, std::int64_t n, std::int64_t first, double time,
                         double dt, GroupFailure& failure) const {
  const auto array = [&](int a) { return local.arena.data() + static_cast<std::ptrdiff_t>(a) * (stretch + 8); };
  for (const Op& op : ops_) {
    const double* at = columns_[static_cast<std::size_t>(op.column)].data();
    const double *own = at + i, *theirs = at + j;
    double* to = array(op.to);
    if (op.kind == GatherOp::Kind::difference) {
#pragma omp simd
      for (std::int64_t k = 0; k < n; ++k) to[k] = own[k] - theirs[k];
    } else if (op.kind == GatherOp::Kind::mean) {
#pragma omp simd
      for (std::int64_t k = 0; k < n; ++k) to[k] = 0.5 * (own[k] + theirs[k]);
    } else {
#pragma omp simd
      for (std::int64_t k = 0; k < n; ++k) {  // 2 v u / (v + u), and exactly v where both are
        const double sum = own[k] + theirs[k], difference = own[k] - theirs[k];
        to[k] = 0.5 * (sum - difference * difference / sum);
      }
    }
  }
  riffle_error error;
  error.size = sizeof error;
  error.message[0] = '\0';
  if (!layout_.kernels.empty()) {
    const ActivePlugin& kernel = graph_.plugins()[static_cast<std::size_t>(graph_.kernel())];
    for (const KernelCall& call : layout_.kernels) {
      double* out[RIFFLE_KERNEL_OUTPUTS];
      for (int b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) out[b] = call.out[b] >= 0 ? array(call.out[b]) : nullptr;
      const Place& place = places_[static_cast<std::size_t>(call.inverse_l)];
      const double* inverse_l = place.column < 0
                                    ? array(call.inverse_l)
                                    : columns_[static_cast<std::size_t>(place.column)].data() + (place.at_j ? j : i);
      const auto evaluate = [&] {
        return may_throw(kernel.table->evaluate_kernel)(kernel.self, n, array(layout_.r()), inverse_l, call.want, out);
      };
      if (call_plugin(error, evaluate) != RIFFLE_OK) {
        failure = {layout_.calls.front().node, "kernel " + kernel.id + ": " + message_of(error)};
        return false;
      }
    }
  }
  point(local, i, j);
  for (std::size_t c = 0; c < layout_.calls.size(); ++c) {
    const PassNode& called = graph_.nodes()[static_cast<std::size_t>(layout_.calls[c].node)];
    const riffle_block block{sizeof(riffle_block),     1, n, first, time, dt, local.calls[c].in.data(),
                             local.calls[c].out.data()};
    if (run_pass(*called.pass, graph_.plugins()[static_cast<std::size_t>(called.plugin)].self, block, error) !=
        RIFFLE_OK) {
      failure = {layout_.calls[c].node, message_of(error)};
      return false;
    }
  }
  return true;
}

GroupFailure LineGroup::run(std::int64_t first, std::int64_t last, int thread, double time, double dt,
                            const std::function<double*(const Reduction&)>& field) {
  Thread& local = *threads_[static_cast<std::size_t>(thread)];
  const auto array = [&](int a) { return local.arena.data() + static_cast<std::ptrdiff_t>(a) * (stretch + 8); };
  double *dx = array(0), *r = array(layout_.r()), *r2 = array(layout_.r2()), *vr = array(layout_.vr());
  GroupFailure failure;
  for (const Late& late : late_) {
    std::copy(late.from + first, late.from + last,
              columns_[static_cast<std::size_t>(late.column)].data() + start_ + first);
  }
  for (std::int64_t b = first; b < last; b += stretch) {
    const std::int64_t count = std::min(stretch, last - b), n = round_up(count, 8), i = start_ + b;
    for (std::size_t q = 0; q < layout_.reductions.size(); ++q) {
      const std::uint32_t how = layout_.reductions[q].how;
      constexpr double infinity = std::numeric_limits<double>::infinity();
      std::fill_n(local.sums[q].data(), n, how == RIFFLE_MIN ? infinity : how == RIFFLE_MAX ? -infinity : 0.0);
    }
    if (layout_.any_self) {
      for (double* geometry : {dx, r, r2, vr}) std::fill_n(geometry, n, 0.0);
      if (!evaluate(local, i, i, n, b, time, dt, failure)) return failure;
      for (std::size_t q = 0; q < layout_.reductions.size(); ++q) {
        const Reduction& reduction = layout_.reductions[q];
        if (reduction.with_self) std::copy_n(array(reduction.array), n, local.sums[q].data());
      }
    }
    if (!layout_.keeps.empty()) kept_.begin_rows(b, count);
    const double *x = columns_[x_column].data(), *u = layout_.approach ? columns_[u_column].data() : nullptr;
    const double* reach = columns_[reach_column].data();
    double* counts = local.counts.data();
    LinePairs pairs;
    pairs.n = n;
    pairs.xi = x + i;
    pairs.li = reach + i;
    pairs.distance = r;
    pairs.separation = reads_[0] ? dx : nullptr;
    pairs.squared = reads_[2] ? r2 : nullptr;
    pairs.approach = reads_[3] ? vr : nullptr;
    pairs.counts = counts;
    for (const std::int64_t side : {-1, 1}) {
      const double* edge = (side < 0 ? edge_left_ : edge_right_).data();
      pairs.side = static_cast<double>(side);
      for (std::int64_t m = 1;; ++m) {
        const std::int64_t j = i + side * m;
        pairs.xj = x + j;
        pairs.lj = reach + j;
        if (u != nullptr) {
          pairs.ui = u + i;
          pairs.uj = u + j;
        }
        if (reach_ != Reach::gather) pairs.edge = edge + j;
        const LineCount count_of =
            reach_ == Reach::gather ? pairs_by_own_reach(pairs) : pairs_by_their_reach(pairs, reach_ == Reach::either);
        if (!count_of.more) break;
        if (m >= longest_segment) {
          failure.message = "a particle near x = " + std::to_string(x[i]) + " m has more than " +
                            std::to_string(longest_segment) + " neighbours on one side: the support is too large";
          return failure;
        }
        if (count_of.within == 0) continue;
        const bool all = count_of.within == static_cast<double>(n);
        if (!evaluate(local, i, j, n, b, time, dt, failure)) return failure;
        if (!layout_.keeps.empty()) {
          for (std::size_t q = 0; q < layout_.keeps.size(); ++q) local.kept[q] = array(layout_.keeps[q].array);
          kept_.add(static_cast<std::size_t>(thread), b, count, all ? nullptr : counts, who_.data() + j, local.kept);
        }
        for (std::size_t q = 0; q < layout_.reductions.size(); ++q) {
          const Reduction& reduction = layout_.reductions[q];
          const double* f = array(reduction.array);
          double* sum = local.sums[q].data();
          if (reduction.how == RIFFLE_SUM) {
            add_pairs(n, all, counts, f, sum);
          } else {
            const bool least = reduction.how == RIFFLE_MIN;
            for (std::int64_t k = 0; k < n; ++k) {
              if (all || counts[k] != 0) sum[k] = least ? std::min(sum[k], f[k]) : std::max(sum[k], f[k]);
            }
          }
        }
      }
    }
    for (std::size_t q = 0; q < layout_.reductions.size(); ++q) {
      const Reduction& reduction = layout_.reductions[q];
      double* to = field(reduction) + b;
      const double* sum = local.sums[q].data();
      for (std::int64_t k = 0; k < count; ++k) to[k] = reduction.first ? sum[k] : to[k] + sum[k];
    }
  }
  return failure;
}

}  // namespace riffle
