#include "host/schedule/runner.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/plugins/call.hpp"
#include "host/schedule/line.hpp"
#include "host/schedule/list_group.hpp"

namespace riffle {

namespace {

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

std::vector<int> members(const Sweep& sweep, const Stage& stage) {
  return stage.group >= 0 ? sweep.groups[static_cast<std::size_t>(stage.group)].nodes : std::vector<int>{stage.node};
}

// The passes of a sweep as they are run.
std::vector<int> in_order(const Sweep& sweep) {
  if (sweep.global >= 0) return {sweep.global};
  std::vector<int> nodes;
  for (const Stage& stage : sweep.stages) {
    for (const int n : members(sweep, stage)) nodes.push_back(n);
  }
  return nodes;
}

}  // namespace

// One pair group of a plan, compiled; run along the line where that is possible, else over a list.
struct Runner::Group {
  GroupLayout layout;
  NeighbourRequest request;
  std::set<int> written_before;  // by earlier stages of the sweep
  bool on_a_line = false;
  std::unique_ptr<LineGroup> line;
  std::unique_ptr<ListGroup> list;
};

struct Runner::Compiled {
  std::vector<Group> groups;
  std::vector<std::set<int>> zero;  // per stage: fields that its particle pass is the first to add to
  std::vector<int> zero_fields;     // before the sweep
};

Runner::Runner(const Graph& graph, ParticleStore& store, RunnerOptions options)
    : graph_(graph),
      store_(store),
      options_(options),
      uniform_(graph.fields().size(), 0),
      uniform_value_(graph.fields().size(), 0.0),
      field_(graph.fields().size(), nullptr) {
  for (std::size_t f = 0; f < graph.fields().size(); ++f) {
    if (graph.fields()[f].pair_source == PairSource::none) field_[f] = store.find(graph.fields()[f].description.name);
  }
}

Runner::~Runner() = default;

void Runner::find_uniform_fields() {
  bool changed = false;
  for (std::size_t f = 0; f < uniform_.size(); ++f) {
    const GraphField& field = graph_.fields()[f];
    if (!field.attribute || field.description.shape != Shape::scalar || field_[f] == nullptr) continue;
    const double* values = field_[f]->component[0].data();
    const bool uniform =
        store_.owned() > 0 && std::all_of(values, values + store_.owned(), [&](double v) { return v == values[0]; });
    changed = changed || (uniform_[f] != 0) != uniform || (uniform && uniform_value_[f] != values[0]);
    uniform_[f] = uniform ? 1 : 0;
    uniform_value_[f] = values[0];
  }
  if (!changed) return;
  compiled_.clear();
  kept_on_line_.clear();
}

// The pass that writes a field first overwrites it, later contributors add. Where passes for different roles overlap
// only in part, nobody overwrites and the field is zeroed before the sweep that writes it first.
std::set<std::pair<int, int>> Runner::who_overwrites(const Plan& plan, std::size_t index,
                                                     std::vector<int>& zero_fields) const {
  using Writer = std::pair<int, std::size_t>;  // node and sweep
  std::map<int, std::vector<Writer>> writers;
  for (std::size_t s = 0; s < plan.sweeps.size(); ++s) {
    for (const int n : in_order(plan.sweeps[s])) {
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
        const auto common = node(a.first).targets & node(b.first).targets;
        if (common != 0 && node(a.first).targets != node(b.first).targets) partial = true;
      }
    }
    if (partial) {
      if (list.front().second == index) zero_fields.push_back(field);
      continue;
    }
    for (auto a = list.begin(); a != list.end(); ++a) {
      const bool first = std::none_of(list.begin(), a,
                                      [&](const Writer& b) { return node(b.first).targets == node(a->first).targets; });
      if (first) overwrites.insert({a->first, field});
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
    slot->groups.push_back(std::move(made));
  }
  std::set<int> written;
  for (std::size_t s = 0; s < sweep.stages.size(); ++s) {
    const Stage& stage = sweep.stages[s];
    slot->zero.emplace_back();
    if (stage.group >= 0) slot->groups[static_cast<std::size_t>(stage.group)].written_before = written;
    for (const int n : members(sweep, stage)) {
      for (const auto& w : node(n).writes) {
        written.insert(w.field);
        if (stage.node >= 0 && w.how == RIFFLE_SUM && overwrites.count({n, w.field}) != 0)
          slot->zero.back().insert(w.field);
      }
    }
  }
  if (sweep.global >= 0) {
    for (const auto& w : node(sweep.global).writes) {
      if (w.how == RIFFLE_SUM && overwrites.count({sweep.global, w.field}) != 0) slot->zero_fields.push_back(w.field);
    }
  }
  return *slot;
}

void Runner::run_group(Group& group, std::int64_t first, std::int64_t last, int thread, double time, double dt) {
  const GroupFailure failure =
      group.on_a_line ? group.line->run(first, last, thread, time, dt,
                                        [this](const Reduction& r) { return component(r.field, r.component); })
                      : group.list->run(first, last, thread, time, dt);
  if (failure.message.empty()) return;
  fail(node(failure.node >= 0 ? failure.node : group.layout.calls.front().node), failure.message);
}

void Runner::run_particles(const PassNode& called, const std::set<int>& zero, std::int64_t first, std::int64_t last,
                           double time, double dt) {
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
      if (zero.count(w.field) != 0) std::fill_n(array.data() + first, last - first, 0.0);
    }
  }
  tables.close();
  riffle_error error;
  error.size = sizeof error;
  error.message[0] = '\0';
  const riffle_block block = block_of(store_.dim(), last - first, first, time, dt, tables);
  if (run_pass(*called.pass, graph_.plugins()[static_cast<std::size_t>(called.plugin)].self, block, error) !=
      RIFFLE_OK) {
    fail(called, message_of(error));
    return;
  }
  check_signs(called, first, last);
}

void Runner::run_global(const PassNode& called, const ListProvider& lists, const std::vector<Image>& images,
                        double time, double dt) {
  Tables tables;
  const PassNode* keeper = nullptr;  // the list is that of the pass whose pair fields are read
  const LineGroup* line = nullptr;   // or that of the line
  for (const auto& read : called.reads) {
    auto& row = tables.next_in();
    if (read.field < 0) continue;
    if (field_[static_cast<std::size_t>(read.field)] != nullptr) {
      for (auto& array : field_[static_cast<std::size_t>(read.field)]->component) row.push_back(array.data());
    } else {
      keeper = &node(graph_.fields()[static_cast<std::size_t>(read.field)].writers.front());
      line = kept_on_line_.at(read.field);
      if (line == nullptr) {
        for (auto& array : kept_.at(read.field)) row.push_back(array.data());
      } else {
        for (const auto* array : line->kept_of(read.field)) row.push_back(array->data());
      }
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
  if (line != nullptr) {
    pairs.begin = line->kept().begin().data();
    pairs.count = line->kept().count().data();
    pairs.neighbour = line->kept().neighbour().data();
  } else if (keeper != nullptr) {
    const NeighbourList& list = lists.list({keeper->reach, keeper->targets, keeper->sources});
    counts.assign(list.count.begin(), list.count.end());
    pairs.begin = list.begin.data();
    pairs.count = counts.data();
    pairs.neighbour = list.neighbour.data();
  }
  riffle_error error{sizeof(riffle_error), {}};
  const riffle_block block = block_of(store_.dim(), store_.owned(), 0, time, dt, tables);
  const void* self = graph_.plugins()[static_cast<std::size_t>(called.plugin)].self;
  const auto run_it = [&] { return may_throw(called.pass->run_global)(self, &block, &pairs, &error); };
  if (call_plugin(error, run_it) != RIFFLE_OK) {
    fail(called, message_of(error));
  }
}

void Runner::prepare(Group& group, const ListProvider& lists, const std::vector<Image>& images, int threads) {
  const auto from = [this](const Source& s) { return source(s); };
  group.on_a_line = lists.on_a_line(group.request) && LineGroup::possible(group.layout);
  if (group.on_a_line) {
    if (group.line == nullptr)
      group.line = std::make_unique<LineGroup>(graph_, group.layout, group.request, group.written_before);
    group.line->prepare(store_, images, lists.kappa(), threads, from, fresh_, evaluation_);
    for (const Keep& keep : group.layout.keeps) kept_on_line_[keep.field] = group.line.get();
    return;
  }
  const NeighbourList& list = lists.list(group.request);
  for (const Keep& keep : group.layout.keeps) {
    kept_on_line_[keep.field] = nullptr;
    auto& arrays = kept_[keep.field];
    if (arrays.size() <= static_cast<std::size_t>(keep.component))
      arrays.resize(static_cast<std::size_t>(keep.component) + 1);
    arrays[static_cast<std::size_t>(keep.component)].resize(static_cast<std::size_t>(list.begin.back()));
  }
  if (group.list == nullptr) group.list = std::make_unique<ListGroup>(graph_, group.layout, options_.block);
  group.list->prepare(
      store_, list, threads, from, [this](int f, int c) { return component(f, c); },
      [this](const Keep& keep) { return kept_.at(keep.field)[static_cast<std::size_t>(keep.component)].data(); });
}

void Runner::run(const Plan& plan, std::size_t index, const ListProvider& lists, const std::vector<Image>& images,
                 double time, double dt, const std::vector<Span>* only) {
  const Sweep& sweep = plan.sweeps[index];
  failure_.clear();
  if (sweep.global >= 0) {
    for (const int f : compile(plan, index).zero_fields) clear(f, node(sweep.global).targets);
    run_global(node(sweep.global), lists, images, time, dt);
    if (failure_.empty()) check_signs_of_all(node(sweep.global));
    if (!failure_.empty()) throw RunError(failure_);
    return;
  }
  Compiled& compiled = compile(plan, index);
  const int threads = omp_get_max_threads();
  if (!compiled.groups.empty()) invert_lengths();
  for (auto& group : compiled.groups) prepare(group, lists, images, threads);
  std::vector<Span> chunks;
  if (only != nullptr && compiled.zero_fields.empty()) {
    chunks = *only;
  } else {
    for (int role = 0; role < role_count; ++role) {
      for (std::int64_t i = store_.role_begin(role); i < store_.role_begin(role + 1); i += options_.chunk) {
        chunks.push_back({i, std::min(i + options_.chunk, store_.role_begin(role + 1)), 1u << role});
      }
    }
  }
  for (const int f : compiled.zero_fields) clear(f, RIFFLE_ALL_ROLES);
#pragma omp parallel num_threads(threads)
  {
    for (auto& group : compiled.groups) {
      if (!group.on_a_line) group.list->pack();
    }
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      for (std::size_t s = 0; s < sweep.stages.size(); ++s) {
        const Stage& stage = sweep.stages[s];
        if (stage.group >= 0) {
          Group& group = compiled.groups[static_cast<std::size_t>(stage.group)];
          if ((group.request.targets & chunks[c].role) != 0) {
            run_group(group, chunks[c].first, chunks[c].last, omp_get_thread_num(), time, dt);
          }
        } else if ((node(stage.node).targets & chunks[c].role) != 0) {
          run_particles(node(stage.node), compiled.zero[s], chunks[c].first, chunks[c].last, time, dt);
        }
      }
    }
  }
  for (auto& group : compiled.groups) {
    if (group.on_a_line && !group.layout.keeps.empty()) group.line->finish_kept();
  }
  for (const auto& group : sweep.groups) {
    for (const int n : group.nodes) {
      if (failure_.empty()) check_signs_of_all(node(n));
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
