#include "host/schedule/resting.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>

namespace riffle {

namespace {
constexpr std::int64_t together = 32, piece = 256;  // particles of a group, and of a span
constexpr std::int64_t longest_gap = 4;             // looks since a node last ran; water may not move far meanwhile
constexpr int longest_pause = 64;
constexpr double worthwhile = 0.8;  // share of the water that is awake: beyond it all of it is run
}  // namespace

Resting::Resting(const Graph& graph, const ParticleStore& store, double kappa)
    : graph_(graph), store_(store), kappa_(kappa), hops_(graph.nodes().size(), -1), ran_(graph.nodes().size(), -1) {
  const auto& fields = graph.fields();
  std::set<int> inputs;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].evolved) inputs.insert(static_cast<int>(f));
  }
  for (const PassNode& node : graph.nodes()) {
    for (const NodeRead& read : node.reads) {
      if (!read.previous || node.global || node.initial) continue;
      const bool kernel = fields[static_cast<std::size_t>(read.field)].pair_source == PairSource::kernel;
      inputs.insert(kernel ? graph.field("smoothing_length") : read.field);
    }
  }
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    if (!steady(static_cast<int>(n))) continue;
    const PassNode& node = graph.nodes()[n];
    int hops = 0;
    bool known = true;
    for (const bool neighbours : {false, true}) {
      for (const int f : graph.particle_reads(static_cast<int>(n), neighbours)) {
        const GraphField& field = fields[static_cast<std::size_t>(f)];
        int away = 0;
        known = known && !field.occasional;
        for (const int w : field.writers) {
          const bool previous =
              inputs.count(f) != 0 && hops_[static_cast<std::size_t>(w)] < 0 && w >= static_cast<int>(n);
          if (previous) continue;  // of the passes of an iteration, and of those whose last value is read
          known = known && hops_[static_cast<std::size_t>(w)] >= 0;
          away = std::max(away, hops_[static_cast<std::size_t>(w)]);
        }
        hops = std::max(hops, away + (neighbours ? 1 : 0));
      }
    }
    if (node.pair) hops = std::max(hops, 1);
    if (known) hops_[n] = hops;
  }
  for (const int f : inputs) {
    const Field* field = f >= 0 ? store.find(graph.name(f)) : nullptr;
    if (field == nullptr) continue;
    if (field->description.name == "position") position_ = inputs_.size();
    for (const AlignedArray& array : field->component) inputs_.push_back({&array, {}});
  }
}

bool Resting::steady(int n) const {
  const PassNode& node = graph_.nodes()[static_cast<std::size_t>(n)];
  const auto flagged = [&](const PassNode& p) { return (p.pass->flags & RIFFLE_STEADY) != 0; };
  return flagged(node) && !node.global && !node.initial && !node.occasional &&
         std::all_of(node.pair_producers.begin(), node.pair_producers.end(),
                     [&](int p) { return flagged(graph_.nodes()[static_cast<std::size_t>(p)]); });
}

bool Resting::possible(const std::vector<int>& nodes) const {
  if (store_.dim() != 1 || store_.role_begin(1) != store_.owned() || store_.owned() == 0) return false;
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) {
    return graph_.nodes()[static_cast<std::size_t>(n)].global || hops_[static_cast<std::size_t>(n)] >= 0;
  });
}

void Resting::forget() {
  std::fill(ran_.begin(), ran_.end(), -1);
  groups_.clear();
}

void Resting::ran(const std::vector<int>& nodes) {
  for (const int n : nodes) ran_[static_cast<std::size_t>(n)] = paused_ ? -1 : serial_;
}

void Resting::look() {
  const std::int64_t n = store_.owned();
  const auto count = static_cast<std::size_t>((n + together - 1) / together);
  const double* x = store_.data("position");
  ++serial_;
  const bool fresh = groups_.size() != count;
  if (fresh) groups_.assign(count, {});
  for (Input& input : inputs_) input.before.resize(static_cast<std::size_t>(n));
  for (std::size_t g = 0; g < count; ++g) {
    const std::int64_t first = static_cast<std::int64_t>(g) * together, last = std::min(n, first + together);
    const auto bytes = static_cast<std::size_t>(last - first) * sizeof(double);
    const bool changed = fresh || std::any_of(inputs_.begin(), inputs_.end(), [&](const Input& input) {
                           return std::memcmp(input.before.data() + first, input.now->data() + first, bytes) != 0;
                         });
    if (!changed) continue;
    const double* old = fresh ? x : inputs_[position_].before.data();
    groups_[g] = {serial_, std::min(x[first], old[first]), std::max(x[last - 1], old[last - 1])};
    for (Input& input : inputs_) std::memcpy(input.before.data() + first, input.now->data() + first, bytes);
  }
}

std::optional<std::vector<Span>> Resting::awake(const std::vector<int>& nodes, const std::vector<Image>& images) {
  paused_ = pause_ > 0;
  if (paused_) {
    --pause_;
    return std::nullopt;
  }
  look();
  std::int64_t since = serial_, hops = 1;
  for (const int n : nodes) {
    if (graph_.nodes()[static_cast<std::size_t>(n)].global) continue;
    since = std::min(since, ran_[static_cast<std::size_t>(n)]);
    hops = std::max<std::int64_t>(hops, hops_[static_cast<std::size_t>(n)]);
  }
  if (since < 0 || serial_ - since > longest_gap) return std::nullopt;
  const std::int64_t owned = store_.owned();
  const double *x = store_.data("position"), *l = store_.data("smoothing_length");
  double longest = 0;
#ifndef __clang__  // which cannot vectorise a largest value, and warns
#pragma omp simd reduction(max : longest)
#endif
  for (std::int64_t i = 0; i < owned; ++i) longest = l[i] > longest ? l[i] : longest;
  // one more reach for each look: what is awake has moved meanwhile, and has other supports
  const double reach = static_cast<double>(hops + serial_ - since + 1) * kappa_ * longest;
  std::vector<std::pair<double, double>> stretches;
  for (const Group& group : groups_) {
    if (group.changed > since) stretches.emplace_back(group.low - reach, group.high + reach);
  }
  for (std::size_t k = 0; k < images.size(); ++k) {
    std::int64_t origin = images[k].origin;
    while (origin >= owned) origin = images[static_cast<std::size_t>(origin - owned)].origin;
    if (groups_[static_cast<std::size_t>(origin / together)].changed <= since) continue;
    const double at = x[owned + static_cast<std::int64_t>(k)];
    stretches.emplace_back(at - reach, at + reach);
  }
  std::sort(stretches.begin(), stretches.end());
  std::vector<Span> spans;
  std::int64_t done = 0, total = 0;
  for (const auto& [low, high] : stretches) {
    const std::int64_t first = std::max(done, static_cast<std::int64_t>(std::lower_bound(x, x + owned, low) - x));
    const std::int64_t last = std::upper_bound(x, x + owned, high) - x;
    for (std::int64_t i = first; i < last; i += piece) spans.push_back({i, std::min(i + piece, last), RIFFLE_FLUID});
    total += std::max<std::int64_t>(0, last - first);
    done = std::max(done, last);
  }
  if (static_cast<double>(total) <= worthwhile * static_cast<double>(owned)) {
    next_pause_ = 1;
    return spans;
  }
  pause_ = next_pause_;
  next_pause_ = std::min(2 * next_pause_, longest_pause);
  return std::nullopt;
}

}  // namespace riffle
