// Which passes of a case take part, and every contradiction between them.
#include <algorithm>
#include <set>

#include "host/schedule/graph.hpp"
#include "host/schedule/graph_tables.hpp"

namespace riffle {

// Removes passes that ask to be left out when something they read is missing, the host's own where somebody else
// writes, and turns absent optional reads into -1; repeats, since one removal may cause another.
void Graph::drop_unprovided() {
  const auto provided = [&](int f, bool at_start) {  // at_start: before any but the initial passes have run
    const GraphField& graph_field = fields_[static_cast<std::size_t>(f)];
    if (graph_field.pair_source == PairSource::geometry || graph_field.pair_source == PairSource::kernel) return true;
    if (graph_field.given || (graph_field.evolved && !at_start)) return true;
    return std::any_of(nodes_.begin(), nodes_.end(), [&](const PassNode& n) {
      return (n.initial || !at_start) &&
             std::any_of(n.writes.begin(), n.writes.end(), [&](const NodeWrite& w) { return w.field == f; });
    });
  };
  std::erase_if(nodes_, [&](const PassNode& node) {
    if (!plugins_[static_cast<std::size_t>(node.plugin)].fallback) return false;
    return std::any_of(node.writes.begin(), node.writes.end(), [&](const NodeWrite& w) {
      if (fields_[static_cast<std::size_t>(w.field)].given) return true;
      return std::any_of(nodes_.begin(), nodes_.end(), [&](const PassNode& other) {
        return !plugins_[static_cast<std::size_t>(other.plugin)].fallback &&
               std::any_of(other.writes.begin(), other.writes.end(),
                           [&](const NodeWrite& o) { return o.field == w.field; });
      });
    });
  });
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < nodes_.size() && !changed; ++k) {
      const PassNode& node = nodes_[k];
      const bool fallback = plugins_[static_cast<std::size_t>(node.plugin)].fallback;
      if (!fallback && (node.pass->flags & RIFFLE_IF_PROVIDED) == 0) continue;
      const auto reads = entries(node.pass->reads);
      for (std::size_t r = 0; r < node.reads.size(); ++r) {
        if ((reads[r]->flags & RIFFLE_OPTIONAL) == 0 && !provided(node.reads[r].field, node.initial)) {
          if (!fallback) {
            notes_.push_back(node.label + " is left out: nobody provides " + name(node.reads[r].field));
          }
          nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(k));
          changed = true;
          break;
        }
      }
    }
  }
  for (auto& node : nodes_) {
    const auto reads = entries(node.pass->reads);
    for (std::size_t r = 0; r < node.reads.size(); ++r) {
      if ((reads[r]->flags & RIFFLE_OPTIONAL) != 0 && !provided(node.reads[r].field, node.initial))
        node.reads[r].field = -1;
    }
  }
  std::erase_if(votes_, [&](const GraphVote& vote) {
    for (const int f : vote.fields) {
      if (provided(f, false)) continue;
      notes_.push_back(vote.label + " does not vote on the time step: nobody provides " + name(f));
      return true;
    }
    return false;
  });
}

// Who writes what; two writers, missing writers.
void Graph::resolve() {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const PassNode& node = nodes_[n];
    for (const auto& w : node.writes) {
      auto& f = fields_[static_cast<std::size_t>(w.field)];
      if (node.initial)
        f.initial_writers.push_back(static_cast<int>(n));
      else if (!node.occasional)
        f.writers.push_back(static_cast<int>(n));
      else
        f.occasional = true;
    }
  }
  for (auto& f : fields_) {
    for (const auto* list : {&f.initial_writers, &f.writers}) {
      for (std::size_t a = 0; a < list->size(); ++a) {
        for (std::size_t b = a + 1; b < list->size(); ++b) {
          const PassNode& first = nodes_[static_cast<std::size_t>((*list)[a])];
          const PassNode& second = nodes_[static_cast<std::size_t>((*list)[b])];
          if ((first.targets & second.targets) == 0) continue;
          const auto sums = [&](const PassNode& node) {
            return std::any_of(node.writes.begin(), node.writes.end(), [&](const NodeWrite& w) {
              return name(w.field) == f.description.name && w.how == RIFFLE_SUM;
            });
          };
          if (f.description.accumulates && sums(first) && sums(second)) continue;
          errors_.push_back("two writers of the field \"" + f.description.name + "\": " + first.label + " and " +
                            second.label + "; only fields that accumulate, such as acceleration, may have several");
        }
      }
    }
    if (f.evolved && !f.writers.empty()) {
      errors_.push_back("the field \"" + f.description.name +
                        "\" is advanced in time and must not also be written by " +
                        nodes_[static_cast<std::size_t>(f.writers.front())].label);
    }
    f.attribute = f.writers.empty() && !f.evolved && (f.given || !f.initial_writers.empty());
  }
  const auto available = [&](int f, bool initial) {
    if (f < 0) return false;
    const auto& graph_field = fields_[static_cast<std::size_t>(f)];
    return graph_field.given || graph_field.evolved || graph_field.pair_source == PairSource::geometry ||
           graph_field.pair_source == PairSource::kernel || !graph_field.initial_writers.empty() ||
           graph_field.occasional || (!initial && !graph_field.writers.empty());
  };
  riffle_kernel kernel{};
  if (kernel_ >= 0) {
    const ActivePlugin& plugin = plugins_[static_cast<std::size_t>(kernel_)];
    plugin.table->kernel(plugin.self, &kernel);
  }
  const auto kept = [&](int f) {
    return std::any_of(nodes_.begin(), nodes_.end(), [&](const PassNode& n) {
      return std::any_of(n.writes.begin(), n.writes.end(), [&](const NodeWrite& w) { return w.field == f && w.keep; });
    });
  };
  for (auto& node : nodes_) {
    for (const auto& read : node.reads) {
      if (read.field < 0) continue;
      const auto& f = fields_[static_cast<std::size_t>(read.field)];
      if (read.previous) {
        const int actual = f.pair_source == PairSource::kernel ? field("smoothing_length") : read.field;
        fields_[static_cast<std::size_t>(actual)].carried = true;
      }
      if (!available(read.field, node.initial)) {
        errors_.push_back(node.label + " reads the field \"" + f.description.name + "\" [" + f.description.unit +
                          "], which no plugin writes and [initial] does not give");
      }
      if (f.pair_source == PairSource::kernel || f.geometry == 3) {
        const int needed = field(f.geometry == 3 ? "velocity" : "smoothing_length");
        if (!available(needed, node.initial)) {
          errors_.push_back(node.label + " uses \"" + f.description.name + "\", which needs the field \"" +
                            name(needed) + "\"; no plugin writes it and [initial] does not give it");
        }
        if (f.pair_source == PairSource::kernel && kernel_ >= 0 && (kernel.provides >> f.kernel_bit & 1u) == 0) {
          errors_.push_back(node.label + " uses \"" + f.description.name + "\", which the kernel \"" +
                            plugins_[static_cast<std::size_t>(kernel_)].id + "\" does not give");
        }
      }
      if (node.global && f.pair_source != PairSource::none && !kept(read.field)) {
        errors_.push_back(node.label + " reads \"" + f.description.name +
                          "\" of all pairs, but no pass keeps it (RIFFLE_KEEP)");
      }
    }
    if (!node.pair) continue;
    if (kernel_ < 0) {
      errors_.push_back(node.label +
                        " looks at neighbours, but the case names no plugin of kind kernel, whose support says which");
    } else if (!available(field("smoothing_length"), node.initial) &&
               std::none_of(node.reads.begin(), node.reads.end(), [&](const NodeRead& r) {
                 return r.field >= 0 && fields_[static_cast<std::size_t>(r.field)].kernel_bit >= 0;
               })) {
      errors_.push_back(node.label +
                        " looks at neighbours as far as the field \"smoothing_length\" says; no plugin "
                        "writes it and [initial] does not give it");
    }
  }
  for (const auto& e : evolved_) {
    const auto& f = fields_[static_cast<std::size_t>(e.field)];
    const auto& rate = fields_[static_cast<std::size_t>(e.rate)];
    if (rate.writers.empty() && !rate.evolved) {
      errors_.push_back("the field \"" + f.description.name +
                        "\" is advanced in time, but no plugin writes its rate \"" + rate.description.name + "\"");
    }
    if (!f.given && f.initial_writers.empty()) {
      errors_.push_back("the field \"" + f.description.name +
                        "\" is advanced in time, but neither [initial] nor a pass gives its initial value");
    }
  }
}

// Removes passes whose output nobody uses: what a scene does not need is not computed.
void Graph::drop_unused(const std::vector<std::string>& wanted_outputs) {
  std::set<int> used;
  const auto use = [&](int f) {
    if (f >= 0) used.insert(f);
  };
  for (const auto& e : evolved_) {
    use(e.rate);
    use(e.damping);
    use(e.field);
  }
  for (const auto& v : votes_) {
    for (const int f : v.fields) use(f);
  }
  for (const auto& i : iterations_) use(i.residual);
  for (const auto& out : wanted_outputs) use(field(out));
  use(conserved_);
  use(field("smoothing_length"));
  std::vector<char> alive(nodes_.size(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (alive[n] != 0) continue;
      const PassNode& node = nodes_[n];
      const bool needed = node.occasional || std::any_of(node.writes.begin(), node.writes.end(),
                                                         [&](const NodeWrite& w) { return used.count(w.field) != 0; });
      if (!needed) continue;
      alive[n] = 1;
      changed = true;
      for (const auto& read : node.reads) {
        use(read.field);
        if (read.field < 0) continue;
        const auto& f = fields_[static_cast<std::size_t>(read.field)];
        if (f.pair_source == PairSource::kernel) use(field("smoothing_length"));
        if (f.geometry == 3) use(field("velocity"));
      }
    }
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (alive[n] == 0 && !plugins_[static_cast<std::size_t>(nodes_[n].plugin)].fallback) {
      notes_.push_back(nodes_[n].label + " is left out: nobody uses what it writes");
    }
  }
  std::vector<PassNode> kept;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (alive[n] != 0) kept.push_back(std::move(nodes_[n]));
  }
  nodes_ = std::move(kept);
  for (auto& f : fields_) {
    f.writers.clear();
    f.initial_writers.clear();
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    for (const auto& w : nodes_[n].writes) {
      auto& f = fields_[static_cast<std::size_t>(w.field)];
      if (nodes_[n].initial)
        f.initial_writers.push_back(static_cast<int>(n));
      else if (!nodes_[n].occasional)
        f.writers.push_back(static_cast<int>(n));
    }
  }
}

}  // namespace riffle
