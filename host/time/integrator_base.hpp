// What integrators share: the evolved fields sorted into positions (whose rate is evolved too), the fields that drive
// them, and the rest; and scratch fields beside them.
#pragma once

#include <string>
#include <vector>

#include "host/time/advance.hpp"
#include "host/time/integrator.hpp"

namespace riffle {

class IntegratorBase : public Integrator {
 public:
  // `scratch`: suffix of one more field per evolved one; empty: none.
  IntegratorBase(const Graph& graph, ParticleStore& store, bool implicit, const std::string& scratch)
      : implicit_(implicit) {
    for (const auto& e : graph.evolved()) {
      const Named named{e, graph.name(e.field), graph.name(e.rate), e.damping >= 0 ? graph.name(e.damping) : ""};
      (e.rate_is_evolved ? positions_ : first_order_).push_back(named);
      if (!e.rate_is_evolved) {
        rates_.push_back(e.rate);
        if (e.damping >= 0) rates_.push_back(e.damping);
      }
      if (!scratch.empty()) add_scratch(graph, store, e.field, named.field + scratch);
    }
  }

 protected:
  struct Named {
    GraphEvolved e;
    std::string field, rate, damping;
  };
  static void add_scratch(const Graph& graph, ParticleStore& store, int like, const std::string& name) {
    FieldDescription d = graph.fields()[static_cast<std::size_t>(like)].description;
    d.name = name;
    store.add_field(d, FieldUse::derived);
  }
  bool move(Evaluator& evaluator, const Named& n, const std::string& to, const std::string& from, double dt,
            std::uint32_t roles = 0) const {
    return advance(evaluator.store(), to, from, n.rate, n.damping, implicit_, dt, roles != 0 ? roles : n.e.roles);
  }
  void all_changed(Evaluator& evaluator) const {
    for (const auto* list : {&first_order_, &positions_}) {
      for (const auto& n : *list) evaluator.changed(n.e.field);
    }
  }
  void check(Evaluator& evaluator, bool finite) const {
    if (finite) return;
    const std::string culprit = evaluator.find_culprit();
    throw RunError(culprit.empty() ? "an evolved field is no longer finite" : culprit);
  }

  std::vector<Named> positions_, first_order_;
  std::vector<int> rates_;
  bool implicit_;
};

}  // namespace riffle
