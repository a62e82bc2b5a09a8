#include "host/schedule/plan.hpp"

#include <algorithm>
#include <set>

#include "host/schedule/graph_tables.hpp"

namespace riffle {

namespace {

bool meet(const std::vector<int>& list, const std::set<int>& set) {
  return std::any_of(list.begin(), list.end(), [&](int x) { return set.count(x) != 0; });
}

class Builder {
 public:
  explicit Builder(const Graph& graph) : graph_(graph) {}

  Plan build(const std::vector<int>& wanted) {
    std::vector<int> left;
    for (const int n : wanted) {
      const bool kept =
          std::any_of(node(n).writes.begin(), node(n).writes.end(), [](const NodeWrite& w) { return w.keep; });
      if (!node(n).makes_pair_field || kept) left.push_back(n);
    }
    const std::set<int> all(left.begin(), left.end());
    std::set<int> done;
    while (!left.empty()) {
      const auto ready = [&](int n) {
        const bool inside = current_iteration_ < 0 || node(n).iteration == current_iteration_;
        return inside &&
               std::all_of(node(n).depends.begin(), node(n).depends.end(),
                           [&](int d) { return all.count(d) == 0 || done.count(d) != 0; }) &&
               std::none_of(left.begin(), left.end(), [&](int other) { return adds_before(other, n); });
      };
      auto next = std::find_if(left.begin(), left.end(), [&](int n) { return ready(n) && joins(n); });
      if (next == left.end()) {
        close();
        next = std::find_if(left.begin(), left.end(), [&](int n) { return ready(n) && node(n).iteration < 0; });
        if (current_iteration_ >= 0 || next == left.end()) next = std::find_if(left.begin(), left.end(), ready);
        if (next == left.end()) {  // the iteration is finished
          current_iteration_ = -1;
          continue;
        }
      }
      add(*next);
      done.insert(*next);
      left.erase(next);
    }
    close();
    return std::move(plan_);
  }

 private:
  [[nodiscard]] const PassNode& node(int n) const { return graph_.nodes()[static_cast<std::size_t>(n)]; }

  [[nodiscard]] bool joins(int n) const {
    if (sweep_.nodes.empty()) return false;
    if (node(n).global || sweep_.global >= 0) return false;
    if (node(n).iteration != sweep_.iteration) return false;
    if (node(n).pair && written_.count(graph_.field("smoothing_length")) != 0) return false;  // the list is another now
    return !meet(graph_.particle_reads(n, true), written_);
  }

  // Contributions to one sum are added in one order, whatever else is stale: else the last bits would depend on it.
  [[nodiscard]] bool adds_before(int first, int second) const { return first < second && share_a_sum(first, second); }
  [[nodiscard]] bool share_a_sum(int a, int b) const {
    if ((node(a).targets & node(b).targets) == 0) return false;
    return std::any_of(node(a).writes.begin(), node(a).writes.end(), [&](const NodeWrite& w) {
      return std::any_of(node(b).writes.begin(), node(b).writes.end(),
                         [&](const NodeWrite& other) { return other.field == w.field; });
    });
  }

  void add(int n) {
    const PassNode& added = node(n);
    if (sweep_.nodes.empty()) {
      sweep_.iteration = added.iteration;
      current_iteration_ = added.iteration;
    }
    sweep_.nodes.push_back(n);
    plan_.nodes.push_back(n);
    for (const int p : added.pair_producers) add_once(plan_.nodes, p);
    if (added.global) {
      sweep_.global = n;
    } else if (!added.pair) {
      sweep_.stages.push_back({-1, n});
    } else {
      add_pair(n, added);
    }
    for (const auto& w : added.writes) written_.insert(w.field);
  }

  void add_pair(int n, const PassNode& added) {
    const NeighbourRequest request{added.reach, added.targets, added.sources};
    int host = -1;
    const std::vector<int> own = graph_.particle_reads(n, false);
    std::set<int> later;  // fields written at or after the candidate stage
    for (auto s = sweep_.stages.rbegin(); s != sweep_.stages.rend(); ++s) {
      const std::vector<int> members =
          s->group >= 0 ? sweep_.groups[static_cast<std::size_t>(s->group)].nodes : std::vector<int>{s->node};
      for (const int m : members) {
        for (const auto& w : node(m).writes) later.insert(w.field);
      }
      if (meet(own, later)) break;
      if (s->group < 0 && share_a_sum(s->node, n)) break;
      if (s->group >= 0) {
        const auto& group = sweep_.groups[static_cast<std::size_t>(s->group)];
        if (group.request.reach == request.reach && group.request.targets == request.targets &&
            group.request.sources == request.sources) {
          host = s->group;
          break;
        }
      }
    }
    if (host < 0) {
      host = static_cast<int>(sweep_.groups.size());
      sweep_.groups.push_back({{}, {}, request});
      sweep_.stages.push_back({host, -1});
    }
    auto& group = sweep_.groups[static_cast<std::size_t>(host)];
    for (const int p : added.pair_producers) add_once(group.producers, p);
    // one that is kept for a global pass is evaluated as the closures are
    if (added.makes_pair_field)
      add_once(group.producers, n);
    else
      group.nodes.push_back(n);
  }

  void close() {
    if (!sweep_.nodes.empty()) plan_.sweeps.push_back(std::move(sweep_));
    sweep_ = Sweep{};
    written_.clear();
  }

  const Graph& graph_;
  Plan plan_;
  Sweep sweep_;
  std::set<int> written_;
  int current_iteration_ = -1;
};

}  // namespace

Plan make_plan(const Graph& graph, const std::vector<int>& wanted) {
  return Builder(graph).build(wanted);
}

}  // namespace riffle
