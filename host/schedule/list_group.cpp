#include "host/schedule/list_group.hpp"

#include <algorithm>
#include <limits>

#include "host/neighbours/neighbours.hpp"
#include "host/plugins/call.hpp"

namespace riffle {

namespace {

constexpr std::int64_t cache_budget = 22000;  // bytes of the first-level cache that the arrays of a block may fill

std::int64_t round_up(std::int64_t n, std::int64_t to) {
  return (n + to - 1) / to * to;
}

}  // namespace

struct ListGroup::Thread {
  struct Kernel {
    const double* inverse_l;
    std::uint32_t want;
    double* out[RIFFLE_KERNEL_OUTPUTS];
  };
  struct Call {
    int node;
    riffle_run_fn run;
    const void* self;
    std::vector<std::vector<const double*>> in_arrays;
    std::vector<std::vector<double*>> out_arrays;
    std::vector<const double* const*> in;
    std::vector<double* const*> out;
  };
  AlignedArray arena;
  std::vector<Kernel> kernels;
  std::vector<Call> calls;
};

ListGroup::ListGroup(const Graph& graph, const GroupLayout& layout, std::int64_t wanted_block)
    : graph_(graph), layout_(layout), wanted_block_(wanted_block) {}

ListGroup::~ListGroup() = default;

std::unique_ptr<ListGroup::Thread> ListGroup::make_thread() const {
  auto local = std::make_unique<Thread>();
  local->arena.resize(static_cast<std::size_t>(layout_.arrays) * static_cast<std::size_t>(stride_) + 8);
  double* arena = local->arena.data();
  const auto array = [&](int a) { return arena + static_cast<std::ptrdiff_t>(a) * stride_; };
  for (const auto& [constant, value] : layout_.constants) std::fill_n(array(constant), stride_, value);
  for (const KernelCall& call : layout_.kernels) {
    Thread::Kernel kernel{array(call.inverse_l), call.want, {}};
    for (int b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) kernel.out[b] = call.out[b] >= 0 ? array(call.out[b]) : nullptr;
    local->kernels.push_back(kernel);
  }
  for (const PassCall& pass : layout_.calls) {
    const PassNode& node = graph_.nodes()[static_cast<std::size_t>(pass.node)];
    Thread::Call call{
        pass.node, node.pass->run, graph_.plugins()[static_cast<std::size_t>(node.plugin)].self, {}, {}, {}, {}};
    for (const auto& arrays : pass.in) {
      auto& row = call.in_arrays.emplace_back();
      for (const int a : arrays) row.push_back(array(a));
    }
    for (const auto& arrays : pass.out) {
      auto& row = call.out_arrays.emplace_back();
      for (const int a : arrays) row.push_back(array(a));
    }
    for (const auto& row : call.in_arrays) call.in.push_back(row.empty() ? nullptr : row.data());
    for (const auto& row : call.out_arrays) call.out.push_back(row.data());
    local->calls.push_back(std::move(call));
  }
  return local;
}

void ListGroup::prepare(const ParticleStore& store, const NeighbourList& list, int threads,
                        const std::function<const double*(const Source&)>& source,
                        const std::function<double*(int, int)>& target,
                        const std::function<double*(const Keep&)>& kept) {
  list_ = &list;
  particles_ = store.all();
  int stride = 0;
  for (const int s : strides) {
    stride = s;
    if (list.longest + 48 <= s) break;
  }
  if (stride != stride_) threads_.clear();
  stride_ = stride;
  gather_ = choose_gather(layout_.dim, layout_.approach, layout_.quads, layout_.own_count, stride);
  const std::int64_t fits = cache_budget / 8 / std::max(1, layout_.arrays) - list.longest / 2;
  block_pairs_ = std::clamp<std::int64_t>(wanted_block_ > 0 ? wanted_block_ : fits, 16, stride - 8);
  while (static_cast<int>(threads_.size()) < threads) threads_.push_back(make_thread());
  const std::size_t wanted = static_cast<std::size_t>(particles_ + 1) * 4 * static_cast<std::size_t>(layout_.quads);
  if (records_.size() < wanted) records_.resize(wanted);
  columns_.clear();
  for (int c = 0; c < layout_.dim; ++c) columns_.push_back(store.data("position", c));
  for (int c = 0; layout_.approach && c < layout_.dim; ++c) columns_.push_back(store.data("velocity", c));
  for (const Source& s : layout_.slots) columns_.push_back(source(s));
  own_.clear();
  for (const GatherOp& op : layout_.ops) own_.push_back(source(op.source));
  sums_.clear();
  extreme_to_.clear();
  for (const Reduction& reduction : layout_.reductions) {
    double* to = target(reduction.field, reduction.component);
    extreme_to_.push_back(to);
    if (reduction.how != RIFFLE_SUM) continue;
    if (sums_.empty() || sums_.back().count == 4) sums_.emplace_back();
    Sums& sums = sums_.back();
    sums.array[sums.count] = reduction.array;
    sums.to[sums.count] = to;
    sums.first[sums.count] = reduction.first;
    sums.with_self[sums.count] = reduction.with_self;
    ++sums.count;
  }
  keep_to_.clear();
  for (const Keep& keep : layout_.keeps) keep_to_.push_back(kept(keep));
}

void ListGroup::pack() {
  constexpr std::int64_t part = 1024;
  const std::int64_t n = particles_;
  double* out = records_.data();
  const int record = 4 * layout_.quads;
#pragma omp for schedule(static)
  for (std::int64_t c = 0; c < (n + part - 1) / part; ++c) {
    pack_records(columns_.data(), static_cast<int>(columns_.size()), layout_.quads, c * part,
                 std::min(n, (c + 1) * part), out);
  }
#pragma omp single
  {  // the dummy: like the first particle, but far from everything
    double* p = out + n * record;
    std::copy(out, out + record, p);
    for (int c = 0; c < layout_.dim; ++c) p[c] = 1e15;
  }
}

// Pairs of particles with themselves, behind the others.
void ListGroup::fill_own_pairs(double* arena, std::int64_t self, std::int64_t i0, std::int64_t count) const {
  const auto array = [&](int a) { return arena + static_cast<std::ptrdiff_t>(a) * stride_ + self; };
  for (int a = 0; a < layout_.dim + 3; ++a) std::fill_n(array(a), count, 0.0);
  const int head = layout_.dim * (layout_.approach ? 2 : 1);
  for (std::size_t s = 0; s < layout_.slots.size(); ++s) {
    std::copy_n(columns_[static_cast<std::size_t>(head) + s] + i0, count,
                array(layout_.first_slot + static_cast<int>(s)));
  }
  for (std::size_t o = 0; o < layout_.ops.size(); ++o) {
    const GatherOp& op = layout_.ops[o];
    if (op.kind == GatherOp::Kind::difference)
      std::fill_n(array(op.to), count, 0.0);
    else
      std::copy_n(own_[o] + i0, count, array(op.to));
  }
}

void ListGroup::fill_ops(double* arena, std::int64_t i0, std::int64_t i1) const {
  const std::int64_t* begin = list_->begin.data();
  for (std::size_t o = 0; o < layout_.ops.size(); ++o) {
    const GatherOp& op = layout_.ops[o];
    if (op.to < layout_.first_own + layout_.own_count && op.to >= layout_.first_own) continue;  // done by the gather
    double* to = arena + static_cast<std::ptrdiff_t>(op.to) * stride_;
    const double* theirs = op.from >= 0 ? arena + static_cast<std::ptrdiff_t>(op.from) * stride_ : nullptr;
    const double* own = own_[o];
    const auto each = [&](auto f) {
      std::int64_t w = 0;
      for (std::int64_t i = i0; i < i1; ++i) {
        const v4 v = all4(own[i]);
        const std::int64_t end = w + begin[i + 1] - begin[i];
        for (; w < end; w += 4) store4(to + w, f(v, w));
      }
    };
    switch (op.kind) {
      case GatherOp::Kind::own: each([](v4 v, std::int64_t) { return v; }); break;
      case GatherOp::Kind::difference: each([=](v4 v, std::int64_t k) { return v - load4(theirs + k); }); break;
      case GatherOp::Kind::mean: each([=](v4 v, std::int64_t k) { return 0.5 * (v + load4(theirs + k)); }); break;
      case GatherOp::Kind::inverse_mean:
        each([=](v4 v, std::int64_t k) {
          const v4 u = load4(theirs + k);
          const v4 sum = v + u, difference = v - u;
          return 0.5 * (sum - difference * difference / sum);  // 2 v u / (v + u), and exactly v where both are
        });
        break;
    }
  }
}

template <int Count>
void ListGroup::sum_some(const Sums& sums, const double* arena, std::int64_t i0, std::int64_t i1,
                         std::int64_t self) const {
  const std::int64_t* begin = list_->begin.data();
  const std::int32_t* counts = list_->count.data();
  const double* values[Count];
  for (int r = 0; r < Count; ++r) values[r] = arena + static_cast<std::ptrdiff_t>(sums.array[r]) * stride_;
  std::int64_t k = 0;
  for (std::int64_t i = i0; i < i1; ++i) {
    v4 sum[4] = {all4(0.0), all4(0.0), all4(0.0), all4(0.0)};
    const std::int64_t end = k + begin[i + 1] - begin[i];
    if (k < end) {
      for (; k < end - 4; k += 4) {
#pragma GCC unroll 4
        for (int r = 0; r < Count; ++r) sum[r] += load4(values[r] + k);
      }
      const std::int64_t lanes = counts[i] - (begin[i + 1] - begin[i]) + 4;  // of the last four; the rest is padding
#pragma GCC unroll 4
      for (int r = 0; r < Count; ++r) sum[r] += first_lanes(load4(values[r] + k), lanes);
      k = end;
    }
    transpose4(sum[0], sum[1], sum[2], sum[3]);  // the lanes of all sums at once
    const v4 totals = (sum[0] + sum[1]) + (sum[2] + sum[3]);
#pragma GCC unroll 4
    for (int r = 0; r < Count; ++r) {
      double total = totals[r];
      if (sums.with_self[r]) total += values[r][self + i - i0];
      sums.to[r][i] = sums.first[r] ? total : sums.to[r][i] + total;
    }
  }
}

void ListGroup::reduce(const double* arena, std::int64_t i0, std::int64_t i1, std::int64_t self) const {
  for (const Sums& sums : sums_) {
    switch (sums.count) {
      case 1: sum_some<1>(sums, arena, i0, i1, self); break;
      case 2: sum_some<2>(sums, arena, i0, i1, self); break;
      case 3: sum_some<3>(sums, arena, i0, i1, self); break;
      default: sum_some<4>(sums, arena, i0, i1, self); break;
    }
  }
  if (sums_.size() * 4 >= layout_.reductions.size() &&
      std::all_of(layout_.reductions.begin(), layout_.reductions.end(),
                  [](const Reduction& r) { return r.how == RIFFLE_SUM; }))
    return;
  const std::int64_t* begin = list_->begin.data();
  for (std::size_t q = 0; q < layout_.reductions.size(); ++q) {
    const Reduction& reduction = layout_.reductions[q];
    if (reduction.how == RIFFLE_SUM) continue;
    const bool least = reduction.how == RIFFLE_MIN;
    const double* values = arena + static_cast<std::ptrdiff_t>(reduction.array) * stride_;
    const double* own = values + self;
    std::int64_t w = 0;
    for (std::int64_t i = i0; i < i1; w += begin[i + 1] - begin[i], ++i) {
      const std::int64_t count = list_->count[static_cast<std::size_t>(i)];
      double best = least ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
      for (std::int64_t k = 0; k < count; ++k)
        best = least ? std::min(best, values[w + k]) : std::max(best, values[w + k]);
      if (reduction.with_self) best = least ? std::min(best, own[i - i0]) : std::max(best, own[i - i0]);
      extreme_to_[q][i] = best;
    }
  }
}

GroupFailure ListGroup::run(std::int64_t first, std::int64_t last, int thread, double time, double dt) {
  Thread& local = *threads_[static_cast<std::size_t>(thread)];
  double* arena = local.arena.data();
  const std::int64_t* begin = list_->begin.data();
  const double* distance = arena + static_cast<std::ptrdiff_t>(layout_.r()) * stride_;
  const ActivePlugin* kernel =
      graph_.kernel() >= 0 ? &graph_.plugins()[static_cast<std::size_t>(graph_.kernel())] : nullptr;
  const bool any_op = layout_.ops.size() > static_cast<std::size_t>(layout_.own_count);
  GatherArguments arguments{records_.data(), list_->neighbour.data(), begin, {}, layout_.own_count, 0, 0, arena};
  int gathered = 0;
  for (std::size_t o = 0; o < layout_.ops.size() && gathered < layout_.own_count; ++o) {
    if (layout_.ops[o].kind == GatherOp::Kind::own) arguments.own[gathered++] = own_[o];
  }
  riffle_error error;
  error.size = sizeof error;
  error.message[0] = '\0';

  for (std::int64_t i0 = first; i0 < last;) {
    std::int64_t i1 = i0 + 1;
    while (i1 < last && begin[i1 + 1] - begin[i0] + (layout_.any_self ? round_up(i1 + 1 - i0, 4) : 0) <= block_pairs_)
      ++i1;
    arguments.first = i0;
    arguments.last = i1;
    const std::int64_t self = gather_(arguments);  // pairs of particles with themselves start here
    if (any_op) fill_ops(arena, i0, i1);
    if (layout_.any_self) fill_own_pairs(arena, self, i0, i1 - i0);
    const std::int64_t n = round_up(self + (layout_.any_self ? i1 - i0 : 0), 8);
    for (const auto& call : local.kernels) {
      const auto evaluate = [&] {
        return may_throw(kernel->table->evaluate_kernel)(kernel->self, n, distance, call.inverse_l, call.want,
                                                         call.out);
      };
      if (call_plugin(error, evaluate) != RIFFLE_OK) {
        return {local.calls.front().node, "kernel " + kernel->id + ": " + message_of(error)};
      }
    }
    for (const auto& call : local.calls) {
      const riffle_block block{sizeof(riffle_block), layout_.dim, n, i0, time, dt, call.in.data(), call.out.data()};
      const auto run_it = [&] { return may_throw(call.run)(call.self, &block, &error); };
      if (call_plugin(error, run_it) != RIFFLE_OK) return {call.node, message_of(error)};
    }
    for (std::size_t k = 0; k < layout_.keeps.size(); ++k) {
      std::copy_n(arena + static_cast<std::ptrdiff_t>(layout_.keeps[k].array) * stride_, self, keep_to_[k] + begin[i0]);
    }
    reduce(arena, i0, i1, self);
    i0 = i1;
  }
  return {};
}

}  // namespace riffle
