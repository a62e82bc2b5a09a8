// Who must come before whom, and an order that respects it.
#include <algorithm>

#include "host/schedule/graph.hpp"
#include "host/schedule/graph_tables.hpp"

namespace riffle {

// Pair producers and dependencies.
void Graph::link() {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    PassNode& node = nodes_[n];
    for (const auto& read : node.reads) {
      if (read.field < 0) continue;
      const auto& f = fields_[static_cast<std::size_t>(read.field)];
      if (f.pair_source != PairSource::pass || node.global) continue;
      for (const int w : f.writers) add_once(node.pair_producers, w);
    }
  }
  // closures that read other closures' pair output: the producers of producers come first
  for (auto& node : nodes_) {
    for (std::size_t k = 0; k < node.pair_producers.size(); ++k) {
      const auto& deeper = nodes_[static_cast<std::size_t>(node.pair_producers[k])].pair_producers;
      for (const int d : deeper) {
        if (std::find(node.pair_producers.begin(), node.pair_producers.end(), d) == node.pair_producers.end()) {
          node.pair_producers.insert(node.pair_producers.begin() + static_cast<std::ptrdiff_t>(k), d);
          ++k;
        }
      }
      if (node.pair_producers.size() > nodes_.size()) {
        errors_.push_back(node.label + ": its per-pair inputs depend on each other in a circle");
        return;
      }
    }
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    PassNode& node = nodes_[n];
    // A pass waits for those who write what it reads for the particles that it looks at: its own, or its neighbours.
    const auto depend_on_writers = [&](int f, bool previous, std::uint32_t roles) {
      if (f < 0 || previous) return;
      const auto& graph_field = fields_[static_cast<std::size_t>(f)];
      for (const int w : node.initial ? graph_field.initial_writers : graph_field.writers) {
        if (w != static_cast<int>(n) && (nodes_[static_cast<std::size_t>(w)].targets & roles) != 0)
          add_once(node.depends, w);
      }
    };
    const auto depend = [&](const PassNode& of) {
      for (const auto& read : of.reads) {
        if (read.field < 0) continue;
        const auto& f = fields_[static_cast<std::size_t>(read.field)];
        if (f.pair_source == PairSource::pass && !node.global) continue;  // evaluated within
        const std::uint32_t own = node.targets, others = node.sources;
        const std::uint32_t seen = node.global                 ? std::uint32_t{RIFFLE_ALL_ROLES}
                                   : read.where == RIFFLE_AT_I ? own
                                   : read.where == RIFFLE_AT_J ? others
                                                               : own | others;
        if (f.geometry == 3)
          depend_on_writers(field("velocity"), read.previous, own | others);
        else if (f.kernel_bit >= 0)
          depend_on_writers(field("smoothing_length"), read.previous, own | others);
        else
          depend_on_writers(read.field, read.previous, seen);
      }
    };
    depend(node);
    for (const int p : node.pair_producers) depend(nodes_[static_cast<std::size_t>(p)]);
    if (node.pair && !node.makes_pair_field) {
      const bool any_previous =
          std::any_of(node.reads.begin(), node.reads.end(), [&](const NodeRead& r) { return r.previous; });
      depend_on_writers(field("smoothing_length"), any_previous, node.targets | node.sources);  // the list itself
    }
  }
  for (auto& e : evolved_) {
    const auto& rate = fields_[static_cast<std::size_t>(e.rate)];
    e.rate_is_evolved = rate.evolved;
    e.is_rate_of_evolved =
        std::any_of(evolved_.begin(), evolved_.end(), [&](const GraphEvolved& o) { return o.rate == e.field; });
    // Particles of all roles are carried along, whoever says how fast: by their velocity, or by what a boundary wrote.
    if (rate.evolved || e.field == field("position")) {
      e.roles = RIFFLE_ALL_ROLES & ~RIFFLE_PROBE;
    } else {
      for (const int w : rate.writers) e.roles |= nodes_[static_cast<std::size_t>(w)].targets;
    }
    if (e.damping >= 0 && fields_[static_cast<std::size_t>(e.damping)].writers.empty()) e.damping = -1;
  }
}

// Topological order, passes of one iteration together; a circle is an error that names its passes.
void Graph::order() {
  const std::size_t count = nodes_.size();
  const auto group = [&](std::size_t n) {
    return nodes_[n].iteration >= 0 ? -2 - nodes_[n].iteration : static_cast<int>(n);
  };
  std::vector<char> placed(count, 0);
  std::vector<std::size_t> sequence;
  while (sequence.size() < count) {
    bool progress = false;
    for (std::size_t n = 0; n < count; ++n) {
      if (placed[n] != 0) continue;
      std::vector<std::size_t> members;
      for (std::size_t m = 0; m < count; ++m) {
        if (group(m) == group(n) && placed[m] == 0) members.push_back(m);
      }
      const bool ready = std::all_of(members.begin(), members.end(), [&](std::size_t m) {
        return std::all_of(nodes_[m].depends.begin(), nodes_[m].depends.end(), [&](int d) {
          const auto other = static_cast<std::size_t>(d);
          return placed[other] != 0 || group(other) == group(m);
        });
      });
      if (!ready) continue;
      while (!members.empty()) {  // order within the iteration
        const auto next = std::find_if(members.begin(), members.end(), [&](std::size_t m) {
          return std::all_of(nodes_[m].depends.begin(), nodes_[m].depends.end(),
                             [&](int d) { return placed[static_cast<std::size_t>(d)] != 0; });
        });
        if (next == members.end()) break;
        placed[*next] = 1;
        sequence.push_back(*next);
        members.erase(next);
        progress = true;
      }
      if (!members.empty()) progress = false;
      if (!progress) break;
    }
    if (!progress) {
      std::string names;
      for (std::size_t n = 0; n < count; ++n) {
        if (placed[n] == 0) names += (names.empty() ? "" : ", ") + nodes_[n].label;
      }
      errors_.push_back("these passes wait for each other in a circle: " + names +
                        "; one of them must read the previous value, or they must be declared as an iteration");
      return;
    }
  }
  std::vector<int> where(count);
  for (std::size_t k = 0; k < count; ++k) where[sequence[k]] = static_cast<int>(k);
  std::vector<PassNode> sorted;
  for (const std::size_t n : sequence) sorted.push_back(std::move(nodes_[n]));
  nodes_ = std::move(sorted);
  const auto renumber = [&](std::vector<int>& list) {
    for (int& n : list) n = where[static_cast<std::size_t>(n)];
  };
  for (auto& node : nodes_) {
    renumber(node.depends);
    renumber(node.pair_producers);
    std::sort(node.depends.begin(), node.depends.end());
  }
  for (auto& f : fields_) {
    renumber(f.writers);
    renumber(f.initial_writers);
  }
}

}  // namespace riffle
