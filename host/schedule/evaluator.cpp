#include "host/schedule/evaluator.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "host/schedule/graph_tables.hpp"

namespace riffle {

namespace {
double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}  // namespace

Evaluator::Evaluator(const Graph& graph, ParticleStore& store, Neighbourhood& neighbourhood, RunnerOptions options)
    : graph_(graph),
      store_(store),
      neighbourhood_(neighbourhood),
      runner_(graph, store, options),
      stale_(graph.nodes().size(), 1),
      images_current_(graph.fields().size(), 0),
      dependents_(graph.fields().size()),
      resting_(graph, store, neighbourhood.kappa()),
      next_due_(graph.nodes().size(), 0),
      position_(graph.field("position")),
      smoothing_length_(graph.field("smoothing_length")) {
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    const PassNode& node = graph.nodes()[n];
    if (node.initial) continue;
    std::vector<int> readers{static_cast<int>(n)};  // and the passes that keep pair fields for it
    for (const auto& read : node.reads) {
      if (!node.global || read.field < 0) continue;
      const auto& field = graph.fields()[static_cast<std::size_t>(read.field)];
      if (field.pair_source == PairSource::pass)
        readers.insert(readers.end(), field.writers.begin(), field.writers.end());
    }
    bool constant = !node.occasional;
    for (const int reader : readers) {
      for (const bool neighbours : {false, true}) {
        for (const int f : graph.particle_reads(reader, neighbours)) {
          add_once(dependents_[static_cast<std::size_t>(f)], static_cast<int>(n));
          constant = constant && graph.fields()[static_cast<std::size_t>(f)].attribute;
        }
      }
    }
    if (constant) of_time_.push_back(static_cast<int>(n));
  }
  require_lists(false);
}

void Evaluator::require_lists(bool initial) {
  neighbourhood_.forget_requests();
  for (const PassNode& node : graph_.nodes()) {
    if (node.pair && node.initial == initial) neighbourhood_.require({node.reach, node.targets, node.sources});
  }
}

void Evaluator::changed(int field) {
  if (field < 0) return;
  images_current_[static_cast<std::size_t>(field)] = 0;
  if (field == position_ || field == smoothing_length_) lists_current_ = false;
  if (graph_.fields()[static_cast<std::size_t>(field)].attribute) attributes_changed_ = true;
  for (const int n : dependents_[static_cast<std::size_t>(field)]) make_stale(n);
}

void Evaluator::make_stale(int n) {
  if (stale_[static_cast<std::size_t>(n)] != 0) return;
  stale_[static_cast<std::size_t>(n)] = 1;
  const PassNode& node = graph_.nodes()[static_cast<std::size_t>(n)];
  if (node.occasional) return;
  for (const auto& w : node.writes) {
    const GraphField& field = graph_.fields()[static_cast<std::size_t>(w.field)];
    if (field.pair_source != PairSource::none) continue;
    for (const int other : field.writers) make_stale(other);  // sums are formed anew as a whole
    changed(w.field);
  }
}

// Nothing that such a pass reads ever changes, but what it makes of it may: a force that swings with time.
void Evaluator::pass_of_time(double time) {
  if (time == computed_at_) return;
  computed_at_ = time;
  for (const int n : of_time_) make_stale(n);
}

void Evaluator::everything_changed() {
  std::fill(stale_.begin(), stale_.end(), 1);
  std::fill(images_current_.begin(), images_current_.end(), 0);
  lists_current_ = false;
  neighbourhood_.invalidate();
  attributes_changed_ = true;
  resting_.forget();
}

void Evaluator::mark_fresh(const std::vector<int>& nodes) {
  for (const int n : nodes) stale_[static_cast<std::size_t>(n)] = 0;
}

void Evaluator::collect(int field, bool all, std::vector<char>& wanted) const {
  if (field < 0) return;
  for (const int w : graph_.fields()[static_cast<std::size_t>(field)].writers) collect_node(w, all, wanted);
}

void Evaluator::collect_node(int n, bool all, std::vector<char>& wanted) const {
  const auto index = static_cast<std::size_t>(n);
  if (wanted[index] != 0 || (!all && stale_[index] == 0)) return;
  wanted[index] = 1;
  const PassNode& node = graph_.nodes()[index];
  for (const int d : node.depends) collect_node(d, all, wanted);
  for (const int p : node.pair_producers) {
    for (const int d : graph_.nodes()[static_cast<std::size_t>(p)].depends) collect_node(d, all, wanted);
  }
  for (const auto& read : node.reads) {
    if (read.previous) {  // the other passes of an iteration
      collect(graph_.fields()[static_cast<std::size_t>(read.field)].kernel_bit >= 0 ? smoothing_length_ : read.field,
              all, wanted);
    }
  }
  for (const auto& w : node.writes) {
    if (graph_.fields()[static_cast<std::size_t>(w.field)].description.accumulates) collect(w.field, all, wanted);
  }
}

const Plan& Evaluator::plan_for(const std::vector<int>& nodes) {
  auto& plan = plans_[nodes];
  if (plan == nullptr) plan = std::make_unique<Plan>(make_plan(graph_, nodes));
  return *plan;
}

Plan Evaluator::full_plan() const {
  std::vector<char> wanted(stale_.size(), 0);
  for (const auto& e : graph_.evolved()) {
    collect(e.rate, true, wanted);
    collect(e.damping, true, wanted);
  }
  for (const auto& v : graph_.votes()) {
    for (const int f : v.fields) collect(f, true, wanted);
  }
  std::vector<int> nodes;
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    if (wanted[n] != 0) nodes.push_back(static_cast<int>(n));
  }
  return make_plan(graph_, nodes);
}

void Evaluator::run_initial_passes() {
  std::vector<int> nodes;
  for (std::size_t n = 0; n < graph_.nodes().size(); ++n) {
    if (graph_.nodes()[n].initial) nodes.push_back(static_cast<int>(n));
  }
  if (!nodes.empty()) {
    require_lists(true);
    run(plan_for(nodes), 0, 0);
    require_lists(false);
  }
  everything_changed();
}

void Evaluator::compute(const std::vector<int>& fields, double time, double dt) {
  pass_of_time(time);
  std::vector<char> wanted(stale_.size(), 0);
  for (const int f : fields) collect(f, false, wanted);
  std::vector<int> nodes;
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    if (wanted[n] != 0) nodes.push_back(static_cast<int>(n));
  }
  if (nodes.empty()) return;
  const Plan& plan = plan_for(nodes);
  const auto known = may_rest_.find(&plan);
  const bool rests = known != may_rest_.end() ? known->second : (may_rest_[&plan] = may_rest(plan));
  if (attributes_changed_) resting_.forget();
  if (rests && resting_.possible(plan.nodes)) {
    bring_lists();
    const bool on_a_line = std::all_of(plan.nodes.begin(), plan.nodes.end(), [&](int n) {
      const PassNode& node = graph_.nodes()[static_cast<std::size_t>(n)];
      return !node.pair || neighbourhood_.on_a_line({node.reach, node.targets, node.sources});
    });
    const auto awake = on_a_line ? resting_.awake(plan.nodes, neighbourhood_.images()) : std::nullopt;
    run(plan, time, dt, awake ? &*awake : nullptr);
    if (on_a_line) resting_.ran(plan.nodes);
  } else {
    run(plan, time, dt);
  }
  mark_fresh(nodes);
}

void Evaluator::run_occasional_passes(std::int64_t step, double time, double dt) {
  pass_of_time(time);
  for (std::size_t n = 0; n < graph_.nodes().size(); ++n) {
    const PassNode& node = graph_.nodes()[n];
    if (!node.occasional) continue;
    const bool by_step = node.every > 0 && step % node.every == 0;
    // due when the last step crossed a multiple of the interval
    const bool by_time = node.interval > 0 && std::floor(time / node.interval * (1 + 1e-14)) >
                                                  std::floor((time - dt) / node.interval * (1 + 1e-14));
    if (!by_step && !by_time) continue;
    std::vector<char> wanted(stale_.size(), 0);
    stale_[n] = 1;
    collect_node(static_cast<int>(n), false, wanted);
    std::vector<int> nodes;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (wanted[k] != 0) nodes.push_back(static_cast<int>(k));
    }
    run(plan_for(nodes), time, dt);
    mark_fresh(nodes);
    for (const auto& w : node.writes) changed(w.field);
  }
}

void Evaluator::run(const Plan& plan, double time, double dt, const std::vector<Span>* awake) {
  runner_.begin(awake);
  if (attributes_changed_) runner_.find_uniform_fields();
  attributes_changed_ = false;
  for (std::size_t s = 0; s < plan.sweeps.size();) {
    const int iteration = plan.sweeps[s].iteration;
    if (iteration < 0) {
      run_sweep(plan, s, time, dt, awake);
      ++s;
      continue;
    }
    std::size_t end = s;
    while (end < plan.sweeps.size() && plan.sweeps[end].iteration == iteration) ++end;
    const Iteration& it = graph_.iterations()[static_cast<std::size_t>(iteration)];
    const bool judged = it.residual >= 0 && !graph_.fields()[static_cast<std::size_t>(it.residual)].writers.empty();
    // Where no particle looks at what the iteration makes of its neighbours, those that have converged may rest.
    const bool each_alone = judged && converges_alone(plan, s, end);
    std::vector<Span> left;
    for (std::int64_t k = 0; k < std::max<std::int64_t>(1, judged ? it.maximum : 1); ++k) {
      for (std::size_t q = s; q < end; ++q) run_sweep(plan, q, time, dt, k > 0 && each_alone ? &left : awake);
      if (!judged) break;
      left = unconverged(store_.data(graph_.name(it.residual)), it.tolerance);
      if (left.empty()) break;
    }
    s = end;
  }
}

// Groups of particles, always the same ones whatever the chunks, in which some residual is above the tolerance.
std::vector<Span> Evaluator::unconverged(const double* residual, double tolerance) const {
  constexpr std::int64_t together = 128;
  std::vector<Span> left;
  for (int role = 0; role < role_count; ++role) {
    for (std::int64_t i = store_.role_begin(role); i < store_.role_begin(role + 1); i += together) {
      const std::int64_t end = std::min(i + together, store_.role_begin(role + 1));
      double largest = 0;
#pragma omp simd reduction(max : largest)
      for (std::int64_t k = i; k < end; ++k)
        largest = std::abs(residual[k]) > largest ? std::abs(residual[k]) : largest;
      if (largest > tolerance) left.push_back({i, end, 1u << role});
    }
  }
  return left;
}

void Evaluator::bring_lists() {
  if (lists_current_) return;
  if (neighbourhood_.prepare()) std::fill(images_current_.begin(), images_current_.end(), 0);
  lists_current_ = true;
}

void Evaluator::run_sweep(const Plan& plan, std::size_t index, double time, double dt, const std::vector<Span>* only) {
  const Sweep& sweep = plan.sweeps[index];
  const double start = now();
  bool pairs = !sweep.groups.empty();
  if (sweep.global >= 0) {
    for (const auto& read : graph_.nodes()[static_cast<std::size_t>(sweep.global)].reads) {
      pairs = pairs || (read.field >= 0 &&
                        graph_.fields()[static_cast<std::size_t>(read.field)].pair_source != PairSource::none);
    }
  }
  // A global pass may look at images, which are made with the lists.
  pairs = pairs || (sweep.global >= 0 && smoothing_length_ >= 0 && store_.find("smoothing_length") != nullptr);
  if (pairs) bring_lists();
  if (!sweep.groups.empty() && !same_images_as_last_time(sweep)) only = nullptr;
  if (only != nullptr && only->empty() && sweep.global < 0) return;
  auto& image_fields = image_fields_[&sweep];
  if (image_fields.empty() && (!sweep.groups.empty() || sweep.global >= 0)) {
    for (const int n : sweep.nodes) {
      for (const int f : graph_.particle_reads(n, true)) image_fields.push_back(f);
    }
    for (const int f : {position_, smoothing_length_}) {
      if (f >= 0 && store_.find(graph_.name(f)) != nullptr) image_fields.push_back(f);
    }
    std::sort(image_fields.begin(), image_fields.end());
    image_fields.erase(std::unique(image_fields.begin(), image_fields.end()), image_fields.end());
  }
  for (const int f : image_fields) {
    if (images_current_[static_cast<std::size_t>(f)] != 0) continue;
    refresh_images(neighbourhood_.images(), store_, store_.at(graph_.name(f)));
    images_current_[static_cast<std::size_t>(f)] = 1;
  }
  const double prepared = now();
  list_seconds_ += prepared - start;
  runner_.run(plan, index, neighbourhood_, neighbourhood_.images(), time, dt, only);
  for (const int n : sweep.nodes) {
    for (const auto& w : graph_.nodes()[static_cast<std::size_t>(n)].writes) {
      images_current_[static_cast<std::size_t>(w.field)] = 0;
      if (w.field == smoothing_length_) lists_current_ = false;
    }
  }
  if (!sweep.groups.empty() && only == nullptr) evaluations_ += store_.owned();
  if (!sweep.groups.empty() && only != nullptr) {
    for (const Span& span : *only) evaluations_ += span.last - span.first;
  }
  sweep_seconds_ += now() - prepared;
}

Limit Evaluator::time_step(double cfl, double time, double dt) {
  std::vector<int> fields;
  for (const auto& vote : graph_.votes()) fields.insert(fields.end(), vote.fields.begin(), vote.fields.end());
  compute(fields, time, dt);
  Limit least{std::numeric_limits<double>::infinity(), "none"};
  for (const auto& vote : graph_.votes()) {
    const double limit = runner_.vote(vote, time, dt) * (vote.vote->scaled != 0 ? cfl : 1.0);
    if (limit < least.dt) least = {limit, vote.label};
  }
  return least;
}

std::string Evaluator::find_culprit() const {
  for (const auto& node : graph_.nodes()) {
    if (node.initial || node.occasional) continue;
    for (const auto& w : node.writes) {
      const Field* field = store_.find(graph_.name(w.field));
      if (field == nullptr) continue;
      for (const auto& array : field->component) {
        for (std::int64_t i = 0; i < store_.owned(); ++i) {
          if (std::isfinite(array.data()[i]) || (node.targets & (1u << store_.role_of(i))) == 0) continue;
          if (w.how == RIFFLE_MIN || w.how == RIFFLE_MAX) continue;
          std::string where = "x = " + std::to_string(store_.data("position")[i]) + " m";
          for (int c = 1; c < store_.dim(); ++c) where += ", " + std::to_string(store_.data("position", c)[i]);
          return node.label + " gave " + (std::isnan(array.data()[i]) ? "NaN" : "an infinite value") + " for " +
                 graph_.name(w.field) + " at particle " + std::to_string(store_.ids()[static_cast<std::size_t>(i)]) +
                 ", " + where;
        }
      }
    }
  }
  return "";
}

std::vector<int> Evaluator::history_nodes() const {
  std::vector<int> out;
  for (std::size_t n = 0; n < graph_.nodes().size(); ++n) {
    const PassNode& node = graph_.nodes()[n];
    const bool previous =
        std::any_of(node.reads.begin(), node.reads.end(), [](const NodeRead& r) { return r.previous; });
    if (!node.initial && !node.occasional && (node.iteration >= 0 || previous)) out.push_back(static_cast<int>(n));
  }
  return out;
}

std::vector<std::int64_t> Evaluator::history() const {
  std::vector<std::int64_t> fresh;
  for (const int n : history_nodes()) fresh.push_back(stale_[static_cast<std::size_t>(n)] != 0 ? 0 : 1);
  return fresh;
}

void Evaluator::restore_history(const std::vector<std::int64_t>& fresh) {
  const std::vector<int> nodes = history_nodes();
  for (std::size_t k = 0; k < nodes.size() && k < fresh.size(); ++k) {
    if (fresh[k] != 0) stale_[static_cast<std::size_t>(nodes[k])] = 0;
  }
}

}  // namespace riffle
