#include "host/schedule/runner.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/schedule/gather.hpp"
#include "host/schedule/line.hpp"

namespace riffle {

namespace {

constexpr std::int64_t cache_budget = 22000;  // bytes of the first-level cache that the arrays of a block may fill

// Pointer tables of one call, as the boundary wants them.
struct Tables {
  std::vector<std::vector<const double*>> in_arrays;
  std::vector<std::vector<double*>> out_arrays;
  std::vector<const double* const*> in;
  std::vector<double* const*> out;
  std::size_t n_in = 0, n_out = 0;

  void open() { n_in = n_out = 0; }
  std::vector<const double*>& next_in() {
    if (n_in == in_arrays.size()) in_arrays.emplace_back();
    in_arrays[n_in].clear();
    return in_arrays[n_in++];
  }
  std::vector<double*>& next_out() {
    if (n_out == out_arrays.size()) out_arrays.emplace_back();
    out_arrays[n_out].clear();
    return out_arrays[n_out++];
  }
  void close() {
    in.clear();
    out.clear();
    for (std::size_t k = 0; k < n_in; ++k) in.push_back(in_arrays[k].empty() ? nullptr : in_arrays[k].data());
    for (std::size_t k = 0; k < n_out; ++k) out.push_back(out_arrays[k].data());
  }
};

riffle_block block_of(int dim, std::int64_t n, std::int64_t first, double time, double dt, const Tables& tables) {
  return {sizeof(riffle_block), dim, n, first, time, dt, tables.in.data(), tables.out.data()};
}

std::int64_t round_up(std::int64_t n, std::int64_t to) {
  return (n + to - 1) / to * to;
}

}  // namespace

// One pair group of a plan, compiled: layout, packed records, and an arena with pointer tables per thread.
struct Runner::Group {
  GroupLayout layout;
  NeighbourRequest request;
  const NeighbourList* list = nullptr;  // nullptr: run along the line
  std::unique_ptr<LineGroup> line;
  int stride = 0;
  std::int64_t block_pairs = 0;
  AlignedArray records;
  struct Thread {
    AlignedArray arena;
    std::vector<Tables> calls;
  };
  std::vector<std::unique_ptr<Thread>> threads;

  void prepare_threads(int count) {
    int wanted = strides[0];
    const std::int64_t longest = list->longest;
    for (const int s : strides) {
      wanted = s;
      if (longest + 48 <= s) break;
    }
    if (wanted == stride && static_cast<int>(threads.size()) >= count) {
      choose_block();
      return;
    }
    stride = wanted;
    threads.clear();
    for (int t = 0; t < count; ++t) {
      auto made = std::make_unique<Thread>();
      made->arena.resize(static_cast<std::size_t>(layout.arrays) * static_cast<std::size_t>(stride) + 8);
      double* arena = made->arena.data();
      for (const auto& [array, value] : layout.constants)
        std::fill(arena + array * stride, arena + (array + 1) * stride, value);
      for (const auto& call : layout.calls) {
        Tables tables;
        for (const auto& arrays : call.in) {
          auto& row = tables.next_in();
          for (const int a : arrays) row.push_back(arena + a * stride);
        }
        for (const auto& arrays : call.out) {
          auto& row = tables.next_out();
          for (const int a : arrays) row.push_back(arena + a * stride);
        }
        tables.close();
        made->calls.push_back(std::move(tables));
      }
      threads.push_back(std::move(made));
    }
    choose_block();
  }
  std::int64_t wanted_block = 0;
  void choose_block() {
    const std::int64_t fits = wanted_block > 0 ? wanted_block : cache_budget / 8 / std::max(1, layout.arrays);
    block_pairs = std::clamp<std::int64_t>(fits, 16, stride - 8);
  }
};

struct Runner::Compiled {
  std::vector<Group> groups;
  std::vector<char> zero;        // per stage: the particle pass is the first to add to its sums
  std::vector<int> zero_fields;  // before the sweep
};

Runner::Runner(const Graph& graph, ParticleStore& store, RunnerOptions options)
    : graph_(graph),
      store_(store),
      options_(options),
      uniform_(graph.fields().size(), 0),
      field_(graph.fields().size(), nullptr) {
  for (std::size_t f = 0; f < graph.fields().size(); ++f) {
    if (graph.fields()[f].pair_source == PairSource::none) field_[f] = store.find(graph.fields()[f].description.name);
  }
}

Runner::~Runner() = default;

void Runner::forget_plans() {
  compiled_.clear();
}

void Runner::find_uniform_fields() {
  for (std::size_t f = 0; f < uniform_.size(); ++f) {
    uniform_[f] = 0;
    const GraphField& field = graph_.fields()[f];
    if (!field.attribute || field.description.shape != Shape::scalar || field_[f] == nullptr || store_.owned() == 0)
      continue;
    const double* values = field_[f]->component[0].data();
    uniform_[f] = std::all_of(values, values + store_.owned(), [&](double v) { return v == values[0]; }) ? 1 : 0;
  }
  forget_plans();
}

const double* Runner::source(const Source& s) const {
  if (s.inverse_length) return inverse_l_.data();
  return field_[static_cast<std::size_t>(s.field)]->component[static_cast<std::size_t>(s.component)].data();
}

// The pass that writes a field first overwrites it, later contributors add. Where passes for different roles overlap
// only in part, nobody overwrites and the field is zeroed before the sweep that writes it first.
std::set<std::pair<int, int>> Runner::who_overwrites(const Plan& plan, std::size_t index,
                                                     std::vector<int>& zero_fields) const {
  struct Writer {
    int node;
    std::size_t sweep;
  };
  std::map<int, std::vector<Writer>> writers;
  for (std::size_t s = 0; s < plan.sweeps.size(); ++s) {
    for (const int n : plan.sweeps[s].nodes) {
      for (const auto& w : node(n).writes) {
        if (field_[static_cast<std::size_t>(w.field)] != nullptr) writers[w.field].push_back({n, s});
      }
    }
  }
  std::set<std::pair<int, int>> overwrites;
  for (const auto& [field, list] : writers) {
    bool partial = false;
    for (const Writer& a : list) {
      for (const Writer& b : list) {
        const auto common = node(a.node).targets & node(b.node).targets;
        if (common != 0 && node(a.node).targets != node(b.node).targets) partial = true;
      }
    }
    if (partial) {
      if (list.front().sweep == index) zero_fields.push_back(field);
      continue;
    }
    for (auto a = list.begin(); a != list.end(); ++a) {
      const bool first =
          std::none_of(list.begin(), a, [&](const Writer& b) { return node(b.node).targets == node(a->node).targets; });
      if (first) overwrites.insert({a->node, field});
    }
  }
  return overwrites;
}

Runner::Compiled& Runner::compile(const Plan& plan, std::size_t index) {
  auto& slot = compiled_[{&plan, index}];
  if (slot != nullptr) return *slot;
  slot = std::make_unique<Compiled>();
  const std::set<std::pair<int, int>> overwrites = who_overwrites(plan, index, slot->zero_fields);
  const Sweep& sweep = plan.sweeps[index];
  for (const auto& group : sweep.groups) {
    Group made;
    made.layout = make_layout(graph_, group, store_, uniform_, overwrites);
    made.request = group.request;
    made.wanted_block = options_.block;
    slot->groups.push_back(std::move(made));
  }
  for (const auto& stage : sweep.stages) {
    const bool zero =
        stage.node >= 0 &&
        std::any_of(node(stage.node).writes.begin(), node(stage.node).writes.end(), [&](const NodeWrite& w) {
          return w.how == RIFFLE_SUM && overwrites.count({stage.node, w.field}) != 0;
        });
    slot->zero.push_back(zero ? 1 : 0);
  }
  return *slot;
}

void Runner::fail(const PassNode& failed, const std::string& message) {
#pragma omp critical(riffle_runner_failure)
  {
    const auto& plugin = graph_.plugins()[static_cast<std::size_t>(failed.plugin)];
    std::string line = plugin.kind + " " + failed.label + ": " + message;
    if (failure_.empty() || line < failure_) failure_ = std::move(line);
  }
}

void Runner::pack(Group& group) {
  const GroupLayout& layout = group.layout;
  const std::int64_t n = store_.all();
  const int record = 4 * layout.quads;
  double* out = group.records.data();
  std::vector<const double*> columns;
  for (int c = 0; c < layout.dim; ++c) columns.push_back(store_.data("position", c));
  if (layout.approach) {
    for (int c = 0; c < layout.dim; ++c) columns.push_back(store_.data("velocity", c));
  }
  for (const Source& s : layout.slots) columns.push_back(source(s));
  const int used = static_cast<int>(columns.size());
  constexpr std::int64_t part = 1024;
#pragma omp for schedule(static)
  for (std::int64_t c = 0; c < (n + part - 1) / part; ++c) {
    pack_records(columns.data(), used, layout.quads, c * part, std::min(n, (c + 1) * part), out);
  }
#pragma omp single
  {  // the dummy: like the first particle, but far from everything
    double* p = out + n * record;
    std::copy(out, out + record, p);
    for (int c = 0; c < layout.dim; ++c) p[c] = 1e15;
  }
}

void Runner::run_group(Group& group, std::int64_t first, std::int64_t last, int thread, double time, double dt) {
  const GroupLayout& layout = group.layout;
  const NeighbourList& list = *group.list;
  Group::Thread& local = *group.threads[static_cast<std::size_t>(thread)];
  double* arena = local.arena.data();
  const int stride = group.stride;
  const int record = 4 * layout.quads;
  const int head = layout.dim * (layout.approach ? 2 : 1);
  const auto array = [&](int a) { return arena + static_cast<std::ptrdiff_t>(a) * stride; };
  const std::int64_t* begin = list.begin.data();
  riffle_error error;
  error.size = sizeof error;

  for (std::int64_t i0 = first; i0 < last;) {
    std::int64_t i1 = i0;
    std::int64_t pairs = 0;
    while (i1 < last) {
      const std::int64_t next = pairs + begin[i1 + 1] - begin[i1];
      const std::int64_t total = next + (layout.any_self ? round_up(i1 + 1 - i0, 4) : 0);
      if (i1 > i0 && total > group.block_pairs) break;
      pairs = next;
      ++i1;
    }
    gather({layout.dim, layout.approach, layout.quads, group.records.data(), list.neighbour.data(), list.begin.data(),
            i0, i1, arena},
           stride);
    const std::int64_t self = pairs;  // pairs of particles with themselves start here
    std::int64_t n = pairs;
    if (layout.any_self) {
      const std::int64_t count = i1 - i0;
      for (int a = 0; a < layout.dim + 3; ++a) std::fill_n(array(a) + self, round_up(count, 8), 0.0);
      for (std::size_t s = 0; s < layout.slots.size(); ++s) {
        double* to = array(layout.first_slot + static_cast<int>(s)) + self;
        const double* from = group.records.data() + i0 * record + head + static_cast<std::ptrdiff_t>(s);
        for (std::int64_t k = 0; k < count; ++k) to[k] = from[k * record];
      }
      n += count;
    }
    for (const GatherOp& op : layout.ops) {
      double* to = array(op.to);
      const double* own = source(op.source);
      const double* theirs = op.from >= 0 ? array(op.from) : nullptr;
      std::int64_t w = 0;
      const auto each = [&](auto f, auto at_self) {
        for (std::int64_t i = i0; i < i1; ++i) {
          const v4 v = all4(own[i]);
          const std::int64_t end = w + begin[i + 1] - begin[i];
          for (; w < end; w += 4) store4(to + w, f(v, w));
        }
        for (std::int64_t i = i0; layout.any_self && i < i1; ++i, ++w) to[w] = at_self(own[i]);
      };
      const auto same = [](double v) { return v; };
      switch (op.kind) {
        case GatherOp::Kind::own: each([](v4 v, std::int64_t) { return v; }, same); break;
        case GatherOp::Kind::difference:
          each([=](v4 v, std::int64_t k) { return v - load4(theirs + k); }, [](double) { return 0.0; });
          break;
        case GatherOp::Kind::mean:
          each([=](v4 v, std::int64_t k) { return 0.5 * (v + load4(theirs + k)); }, same);
          break;
        case GatherOp::Kind::inverse_mean:
          each(
              [=](v4 v, std::int64_t k) {
                const v4 u = load4(theirs + k);
                return 2 * v * u / (v + u);
              },
              same);
          break;
      }
    }
    const std::int64_t padded = round_up(n, 8);
    const riffle_plugin* kernel =
        layout.kernels.empty() ? nullptr : graph_.plugins()[static_cast<std::size_t>(graph_.kernel())].table;
    for (const KernelCall& call : layout.kernels) {
      double* out[RIFFLE_KERNEL_OUTPUTS];
      for (int b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) out[b] = call.out[b] >= 0 ? array(call.out[b]) : nullptr;
      kernel->evaluate_kernel(graph_.plugins()[static_cast<std::size_t>(graph_.kernel())].self, padded,
                              array(layout.r()), array(call.inverse_l), call.want, out);
    }
    for (std::size_t c = 0; c < layout.calls.size(); ++c) {
      const PassNode& called = node(layout.calls[c].node);
      const riffle_block block = block_of(layout.dim, padded, i0, time, dt, local.calls[c]);
      if (called.pass->run(graph_.plugins()[static_cast<std::size_t>(called.plugin)].self, &block, &error) !=
          RIFFLE_OK) {
        fail(called, error.message);
        return;
      }
    }
    for (const Keep& keep : layout.keeps) {
      double* to = kept_.at(keep.field)[static_cast<std::size_t>(keep.component)].data();
      std::copy_n(array(keep.array), pairs, to + list.begin[static_cast<std::size_t>(i0)]);
    }
    for (const Reduction& reduction : layout.reductions) {
      double* to = field_[static_cast<std::size_t>(reduction.field)]
                       ->component[static_cast<std::size_t>(reduction.component)]
                       .data();
      const double* values = array(reduction.array);
      const double* own = values + self;
      std::int64_t w = 0;
      if (reduction.how == RIFFLE_SUM) {
        for (std::int64_t i = i0; i < i1; w += begin[i + 1] - begin[i], ++i) {
          double sum = sum_segment(values + w, list.count[static_cast<std::size_t>(i)]);
          if (reduction.with_self) sum += own[i - i0];
          to[i] = reduction.first ? sum : to[i] + sum;
        }
        continue;
      }
      for (std::int64_t i = i0; i < i1; w += begin[i + 1] - begin[i], ++i) {
        const std::int64_t count = list.count[static_cast<std::size_t>(i)];
        const bool least = reduction.how == RIFFLE_MIN;
        double best = least ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
        for (std::int64_t k = 0; k < count; ++k)
          best = least ? std::min(best, values[w + k]) : std::max(best, values[w + k]);
        if (reduction.with_self) best = least ? std::min(best, own[i - i0]) : std::max(best, own[i - i0]);
        to[i] = best;
      }
    }
    i0 = i1;
  }
}

void Runner::run_line(Group& group, std::int64_t first, std::int64_t last, int thread, double time, double dt) {
  const LineGroup::Failure failure = group.line->run(first, last, thread, time, dt, [this](const Reduction& r) {
    return field_[static_cast<std::size_t>(r.field)]->component[static_cast<std::size_t>(r.component)].data();
  });
  if (failure.message.empty()) return;
  fail(node(failure.node >= 0 ? failure.node : group.layout.calls.front().node), failure.message);
}

void Runner::run_particles(const PassNode& called, bool zero, std::int64_t first, std::int64_t last, double time,
                           double dt) {
  thread_local Tables tables;  // its memory is kept from call to call
  tables.open();
  for (const auto& read : called.reads) {
    auto& row = tables.next_in();
    if (read.field < 0) continue;
    for (auto& array : field_[static_cast<std::size_t>(read.field)]->component) row.push_back(array.data() + first);
  }
  for (const auto& w : called.writes) {
    auto& row = tables.next_out();
    for (auto& array : field_[static_cast<std::size_t>(w.field)]->component) {
      row.push_back(array.data() + first);
      if (zero && w.how == RIFFLE_SUM) std::fill_n(array.data() + first, last - first, 0.0);
    }
  }
  tables.close();
  riffle_error error;
  error.size = sizeof error;
  const riffle_block block = block_of(store_.dim(), last - first, first, time, dt, tables);
  if (called.pass->run(graph_.plugins()[static_cast<std::size_t>(called.plugin)].self, &block, &error) != RIFFLE_OK) {
    fail(called, error.message);
    return;
  }
  for (const auto& w : called.writes) {
    const FieldDescription& field = graph_.fields()[static_cast<std::size_t>(w.field)].description;
    if (!field.not_negative) continue;
    const double* values = field_[static_cast<std::size_t>(w.field)]->component[0].data();
    for (std::int64_t i = first; i < last; ++i) {
      if (values[i] >= 0) continue;
      fail(called, field.name + " = " + std::to_string(values[i]) + " at particle " +
                       std::to_string(store_.ids()[static_cast<std::size_t>(i)]) + "; it must never be negative");
      return;
    }
  }
}

void Runner::run_global(const PassNode& called, const ListProvider& lists, const std::vector<Image>& images,
                        double time, double dt) {
  Tables tables;
  bool pairs_wanted = false;
  for (const auto& read : called.reads) {
    auto& row = tables.next_in();
    if (read.field < 0) continue;
    if (field_[static_cast<std::size_t>(read.field)] != nullptr) {
      for (auto& array : field_[static_cast<std::size_t>(read.field)]->component) row.push_back(array.data());
    } else {
      pairs_wanted = true;
      for (auto& array : kept_.at(read.field)) row.push_back(array.data());
    }
  }
  for (const auto& w : called.writes) {
    auto& row = tables.next_out();
    for (auto& array : field_[static_cast<std::size_t>(w.field)]->component) row.push_back(array.data());
  }
  tables.close();
  std::vector<std::int32_t> origins(images.size());
  for (std::size_t k = 0; k < images.size(); ++k) {
    std::int64_t origin = images[k].origin;
    while (origin >= store_.owned()) origin = images[static_cast<std::size_t>(origin - store_.owned())].origin;
    origins[k] = static_cast<std::int32_t>(origin);
  }
  std::vector<std::int64_t> counts;
  riffle_pairs pairs{sizeof(riffle_pairs), 0, store_.owned(), store_.all(), nullptr, nullptr, nullptr, origins.data()};
  if (pairs_wanted) {
    const NeighbourList& list = lists.list({called.reach, called.targets, called.sources});
    counts.assign(list.count.begin(), list.count.end());
    pairs.begin = list.begin.data();
    pairs.count = counts.data();
    pairs.neighbour = list.neighbour.data();
  }
  riffle_error error{sizeof(riffle_error), {}};
  const riffle_block block = block_of(store_.dim(), store_.owned(), 0, time, dt, tables);
  if (called.pass->run_global(graph_.plugins()[static_cast<std::size_t>(called.plugin)].self, &block, &pairs, &error) !=
      RIFFLE_OK) {
    fail(called, error.message);
  }
}

void Runner::run(const Plan& plan, std::size_t index, const ListProvider& lists, const std::vector<Image>& images,
                 double time, double dt) {
  const Sweep& sweep = plan.sweeps[index];
  failure_.clear();
  if (sweep.global >= 0) {
    run_global(node(sweep.global), lists, images, time, dt);
    if (!failure_.empty()) throw RunError(failure_);
    return;
  }
  Compiled& compiled = compile(plan, index);
  const int threads = omp_get_max_threads();
  const auto n_all = static_cast<std::size_t>(store_.all() + 1);
  bool lengths = false;
  for (auto& group : compiled.groups) {
    lengths = true;
    if (lists.on_a_line() && LineGroup::possible(group.layout, group.request)) {
      group.list = nullptr;
      continue;
    }
    group.list = &lists.list(group.request);
    group.prepare_threads(threads);
    const std::size_t wanted = n_all * 4 * static_cast<std::size_t>(group.layout.quads);
    if (group.records.size() < wanted) group.records.resize(wanted + wanted / 8);
    for (const Keep& keep : group.layout.keeps) {
      auto& arrays = kept_[keep.field];
      if (arrays.size() <= static_cast<std::size_t>(keep.component))
        arrays.resize(static_cast<std::size_t>(keep.component) + 1);
      arrays[static_cast<std::size_t>(keep.component)].resize(static_cast<std::size_t>(group.list->begin.back()));
    }
  }
  if (lengths && inverse_l_.size() < n_all) inverse_l_.resize(n_all + n_all / 8);
  const double* l = lengths ? store_.data("smoothing_length") : nullptr;
  struct Range {
    std::int64_t first, last;
    std::uint32_t role;
  };
  std::vector<Range> chunks;
  for (int role = 0; role < role_count; ++role) {
    for (std::int64_t i = store_.role_begin(role); i < store_.role_begin(role + 1); i += options_.chunk) {
      chunks.push_back({i, std::min(i + options_.chunk, store_.role_begin(role + 1)), 1u << role});
    }
  }
  for (const int f : compiled.zero_fields) {
    for (auto& array : field_[static_cast<std::size_t>(f)]->component) std::fill_n(array.data(), store_.owned(), 0.0);
  }
#pragma omp parallel num_threads(threads)
  {
    if (lengths) {
#pragma omp for schedule(static)
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(n_all) - 1; ++i) inverse_l_.data()[i] = 1.0 / l[i];
    }
    for (auto& group : compiled.groups) {
      if (group.list != nullptr) pack(group);
    }
#pragma omp single
    for (auto& group : compiled.groups) {
      if (group.list != nullptr) continue;
      if (group.line == nullptr) group.line = std::make_unique<LineGroup>(graph_, group.layout, group.request);
      group.line->prepare(store_, images, lists.kappa(), threads, [this](const Source& s) { return source(s); });
    }
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      for (std::size_t s = 0; s < sweep.stages.size(); ++s) {
        const Stage& stage = sweep.stages[s];
        if (stage.group >= 0) {
          Group& group = compiled.groups[static_cast<std::size_t>(stage.group)];
          if ((group.request.targets & chunks[c].role) == 0) continue;
          if (group.list == nullptr)
            run_line(group, chunks[c].first, chunks[c].last, omp_get_thread_num(), time, dt);
          else
            run_group(group, chunks[c].first, chunks[c].last, omp_get_thread_num(), time, dt);
        } else if ((node(stage.node).targets & chunks[c].role) != 0) {
          run_particles(node(stage.node), compiled.zero[s] != 0, chunks[c].first, chunks[c].last, time, dt);
        }
      }
    }
  }
  if (!failure_.empty()) throw RunError(failure_);
}

double Runner::vote(const GraphVote& vote, double time, double dt) {
  const auto& plugin = graph_.plugins()[static_cast<std::size_t>(vote.plugin)];
  double least = std::numeric_limits<double>::infinity();
  for (int role = 0; role < role_count; ++role) {
    if ((vote.targets & (1u << role)) == 0) continue;
    const std::int64_t begin = store_.role_begin(role), end = store_.role_begin(role + 1);
    const std::int64_t chunks = (end - begin + options_.chunk - 1) / options_.chunk;
#pragma omp parallel for schedule(static) reduction(min : least)
    for (std::int64_t c = 0; c < chunks; ++c) {
      const std::int64_t first = begin + c * options_.chunk, last = std::min(first + options_.chunk, end);
      thread_local Tables tables;
      tables.open();
      for (const int f : vote.fields) {
        auto& row = tables.next_in();
        for (auto& array : field_[static_cast<std::size_t>(f)]->component) row.push_back(array.data() + first);
      }
      tables.close();
      const riffle_block block = block_of(store_.dim(), last - first, first, time, dt, tables);
      const double limit = vote.vote->limit(plugin.self, &block);
      least = std::min(least, std::isnan(limit) ? 0.0 : limit);
    }
  }
  return least;
}

}  // namespace riffle
