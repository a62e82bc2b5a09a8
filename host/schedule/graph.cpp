#include "host/schedule/graph.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include "riffle/fields.hpp"

namespace riffle {

namespace {

template <class T>
std::vector<const T*> entries(const T* const* table) {
  std::vector<const T*> out;
  for (; table != nullptr && *table != nullptr; ++table) out.push_back(*table);
  return out;
}

constexpr std::uint32_t default_targets = RIFFLE_FLUID;
constexpr std::uint32_t default_sources = RIFFLE_ALL_ROLES & ~RIFFLE_PROBE;

int geometry_of(const std::string& name) {
  static const std::vector<std::string> names{"separation", "distance", "distance_squared", "approach"};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

int kernel_bit_of(const std::string& name) {
  static const std::vector<std::string> names{"kernel",     "kernel_gradient", "kernel_dl",
                                              "kernel_drr", "kernel_drdl",     "kernel_dldl"};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

const ParameterValue* parameter(const ActivePlugin& plugin, const char* name) {
  for (const auto& value : plugin.values) {
    if (value.name == name) return &value;
  }
  return nullptr;
}

FieldDescription describe(const riffle_field& f) {
  FieldDescription d;
  d.name = f.name;
  d.unit = f.unit != nullptr ? f.unit : "1";
  d.meaning = f.meaning != nullptr ? f.meaning : "";
  d.shape = static_cast<Shape>(f.shape);
  d.accumulates = (f.flags & RIFFLE_ACCUMULATES) != 0;
  d.not_negative = (f.flags & RIFFLE_NOT_NEGATIVE) != 0;
  d.per_pair = (f.flags & RIFFLE_PER_PAIR) != 0;
  return d;
}

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace

ScheduleError::ScheduleError(std::vector<std::string> lines)
    : std::runtime_error(lines.empty() ? "" : lines.front()), lines_(std::move(lines)) {}

bool condition_holds(const char* when, const std::vector<ParameterValue>& values) {
  if (when == nullptr) return true;
  const std::string text = when;
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  for (const auto& value : values) {
    if (value.name != name) continue;
    std::string shown = value.text;
    if (shown.empty()) shown = value.number != 0 ? "true" : "false";
    std::istringstream words(text.substr(equals + 1));
    for (std::string word; std::getline(words, word, '|');) {
      if (word == shown) return true;
    }
    return false;
  }
  return false;
}

Graph::Graph(int dim, std::vector<ActivePlugin> plugins, const std::vector<std::string>& given,
             const std::vector<std::string>& wanted_outputs)
    : dim_(dim), plugins_(std::move(plugins)) {
  intern(fields::position, "the host");
  intern(fields::cell_measure, "the host");
  collect(given);
  drop_unprovided();
  resolve();
  if (!errors_.empty()) throw ScheduleError(errors_);
  drop_unused(wanted_outputs);
  link();
  order();
  if (!errors_.empty()) throw ScheduleError(errors_);
}

int Graph::field(const std::string& name) const {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    if (fields_[k].description.name == name) return static_cast<int>(k);
  }
  return -1;
}

int Graph::intern(const riffle_field& f, const std::string& user) {
  const int known = field(f.name);
  const FieldDescription d = describe(f);
  if (known >= 0) {
    const auto& have = fields_[static_cast<std::size_t>(known)];
    if (have.description.shape != d.shape || have.description.unit != d.unit) {
      errors_.push_back(user + ": its field \"" + d.name + "\" [" + d.unit +
                        "] differs in shape or unit from that of " + have.first_user + " [" + have.description.unit +
                        "]; two plugins that share a field name must agree");
    }
    return known;
  }
  GraphField made;
  made.description = d;
  made.first_user = user;
  made.geometry = geometry_of(d.name);
  made.kernel_bit = kernel_bit_of(d.name);
  if (made.geometry >= 0)
    made.pair_source = PairSource::geometry;
  else if (made.kernel_bit >= 0)
    made.pair_source = PairSource::kernel;
  else if (d.per_pair)
    made.pair_source = PairSource::pass;
  fields_.push_back(made);
  return static_cast<int>(fields_.size()) - 1;
}

void Graph::collect(const std::vector<std::string>& given) {
  for (std::size_t p = 0; p < plugins_.size(); ++p) {
    const ActivePlugin& plugin = plugins_[p];
    const int index = static_cast<int>(p);
    if (plugin.kind == "kernel") kernel_ = index;
    if (plugin.table->conserved != nullptr) conserved_ = intern(*plugin.table->conserved, plugin.id);
    for (const auto* f : entries(plugin.table->initial)) intern(*f, plugin.id);
    std::map<std::string, int> iteration_of;
    for (const auto* declared : entries(plugin.table->iterations)) {
      Iteration it;
      it.name = plugin.id + ": " + declared->name;
      it.residual = intern(*declared->residual, plugin.id);
      if (const auto* v = parameter(plugin, declared->tolerance)) it.tolerance = v->number;
      if (const auto* v = parameter(plugin, declared->maximum_iterations))
        it.maximum = static_cast<std::int64_t>(v->number);
      iteration_of[declared->name] = static_cast<int>(iterations_.size());
      iterations_.push_back(it);
    }
    for (const auto* pass : entries(plugin.table->passes)) {
      if (!condition_holds(pass->when, plugin.values)) continue;
      PassNode node;
      node.plugin = index;
      node.pass = pass;
      node.label = plugin.id == pass->name ? plugin.id : plugin.id + ": " + pass->name;
      node.pair = pass->type == RIFFLE_PASS_PAIR;
      node.global = pass->type == RIFFLE_PASS_GLOBAL;
      node.targets = pass->targets != 0 ? pass->targets : default_targets;
      node.sources = pass->sources != 0 ? pass->sources : default_sources;
      node.reach = static_cast<Reach>(pass->neighbours);
      node.with_self = (pass->flags & RIFFLE_WITH_SELF) != 0;
      node.initial = (pass->flags & RIFFLE_INITIAL) != 0;
      node.occasional = (pass->flags & RIFFLE_OCCASIONAL) != 0;
      if (node.initial && pass->targets == 0) node.targets = RIFFLE_ALL_ROLES;
      if (pass->iteration != nullptr)
        node.iteration = iteration_of.count(pass->iteration) ? iteration_of[pass->iteration] : -1;
      if (pass->every != nullptr) {
        if (const auto* v = parameter(plugin, pass->every)) node.every = static_cast<std::int64_t>(v->number);
      }
      if (pass->interval != nullptr) {
        if (const auto* v = parameter(plugin, pass->interval)) node.interval = v->number;
      }
      for (const auto* read : entries(pass->reads)) {
        NodeRead r;
        r.field = intern(*read->field, plugin.id);
        r.where = read->where;
        r.previous = (read->flags & RIFFLE_PREVIOUS) != 0;
        if (fields_[static_cast<std::size_t>(r.field)].geometry == 3) intern(fields::velocity, plugin.id);
        if (fields_[static_cast<std::size_t>(r.field)].kernel_bit >= 0) intern(fields::smoothing_length, plugin.id);
        node.reads.push_back(r);
      }
      for (const auto* write : entries(pass->writes)) {
        NodeWrite w;
        w.field = intern(*write->field, plugin.id);
        w.how = write->how;
        w.keep = (write->flags & RIFFLE_KEEP) != 0;
        if (fields_[static_cast<std::size_t>(w.field)].pair_source == PairSource::pass) node.makes_pair_field = true;
        node.writes.push_back(w);
      }
      const bool reduces = std::any_of(node.writes.begin(), node.writes.end(), [&](const NodeWrite& w) {
        return fields_[static_cast<std::size_t>(w.field)].pair_source == PairSource::none;
      });
      if (node.makes_pair_field && (reduces || !node.pair)) {
        errors_.push_back(node.label +
                          " writes a per-pair field, which only pair passes can, and no particle field besides; split "
                          "it in two passes");
      }
      nodes_.push_back(std::move(node));
    }
    for (const auto* evolved : entries(plugin.table->evolved)) {
      GraphEvolved e;
      e.field = intern(*evolved->field, plugin.id);
      e.rate = intern(*evolved->rate, plugin.id);
      if (evolved->damping != nullptr) e.damping = intern(*evolved->damping, plugin.id);
      fields_[static_cast<std::size_t>(e.field)].evolved = true;
      evolved_.push_back(e);
    }
    for (const auto* vote : entries(plugin.table->votes)) {
      if (!condition_holds(vote->when, plugin.values)) continue;
      GraphVote v;
      v.plugin = index;
      v.vote = vote;
      v.label = plugin.id + ": " + vote->name;
      v.targets = vote->targets != 0 ? vote->targets : default_targets;
      for (const auto* read : entries(vote->reads)) v.fields.push_back(intern(*read->field, plugin.id));
      votes_.push_back(std::move(v));
    }
  }
  for (const auto& name : given) {
    const int f = field(name);
    if (f >= 0) fields_[static_cast<std::size_t>(f)].given = true;
  }
  for (const char* name : {"position", "cell_measure"}) fields_[static_cast<std::size_t>(field(name))].given = true;
}

// Removes passes that ask to be left out when something they read is missing, the host's own where somebody else
// writes, and turns absent optional reads into -1; repeats, since one removal may cause another.
void Graph::drop_unprovided() {
  const auto provided = [&](int f, const PassNode* except) {
    const GraphField& graph_field = fields_[static_cast<std::size_t>(f)];
    if (graph_field.pair_source == PairSource::geometry || graph_field.pair_source == PairSource::kernel) return true;
    if (graph_field.given || graph_field.evolved) return true;
    return std::any_of(nodes_.begin(), nodes_.end(), [&](const PassNode& n) {
      return &n != except &&
             std::any_of(n.writes.begin(), n.writes.end(), [&](const NodeWrite& w) { return w.field == f; });
    });
  };
  std::erase_if(nodes_, [&](const PassNode& node) {
    if (!plugins_[static_cast<std::size_t>(node.plugin)].fallback) return false;
    return std::any_of(node.writes.begin(), node.writes.end(), [&](const NodeWrite& w) {
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
        if ((reads[r]->flags & RIFFLE_OPTIONAL) == 0 && !provided(node.reads[r].field, nullptr)) {
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
      if ((reads[r]->flags & RIFFLE_OPTIONAL) != 0 && !provided(node.reads[r].field, nullptr)) node.reads[r].field = -1;
    }
  }
  std::erase_if(votes_, [&](const GraphVote& vote) {
    for (const int f : vote.fields) {
      if (provided(f, nullptr)) continue;
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
    const auto& graph_field = fields_[static_cast<std::size_t>(f)];
    return graph_field.given || graph_field.evolved || graph_field.pair_source == PairSource::geometry ||
           graph_field.pair_source == PairSource::kernel || !graph_field.initial_writers.empty() ||
           (!initial && !graph_field.writers.empty());
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
        if (f.pair_source == PairSource::kernel && kernel_ < 0) {
          errors_.push_back(node.label + " uses the kernel, but the case names no plugin of kind kernel");
        }
      }
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

void Graph::implied(const NodeRead& read, bool neighbours, std::vector<int>& out) const {
  if (read.field < 0) return;
  const auto& f = fields_[static_cast<std::size_t>(read.field)];
  const bool at_j = read.where != RIFFLE_AT_I;
  if (f.geometry >= 0) {
    add_once(out, field("position"));
    if (f.geometry == 3) add_once(out, field("velocity"));
  } else if (f.kernel_bit >= 0) {
    add_once(out, field("position"));
    if (!neighbours || at_j) add_once(out, field("smoothing_length"));
  } else if (f.pair_source == PairSource::none && (neighbours ? at_j : read.where != RIFFLE_AT_J)) {
    add_once(out, read.field);
  }
}

std::vector<int> Graph::particle_reads(int n, bool neighbours) const {
  std::vector<int> out;
  const PassNode& node = nodes_[static_cast<std::size_t>(n)];
  if (neighbours && !node.pair && !node.global) return out;
  const auto add = [&](const PassNode& of) {
    for (const auto& read : of.reads) {
      if (node.global && read.field >= 0) {  // a global pass may look anywhere
        if (fields_[static_cast<std::size_t>(read.field)].pair_source == PairSource::none) add_once(out, read.field);
      } else {
        implied(read, neighbours, out);
      }
    }
  };
  add(node);
  for (const int p : node.pair_producers) add(nodes_[static_cast<std::size_t>(p)]);
  if (node.pair && neighbours) {
    add_once(out, field("position"));
    if (node.reach != Reach::gather) add_once(out, field("smoothing_length"));
  }
  if (node.pair && !neighbours) add_once(out, field("smoothing_length"));
  return out;
}

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
    const auto depend_on_writers = [&](int f, bool previous) {
      if (f < 0 || previous) return;
      const auto& graph_field = fields_[static_cast<std::size_t>(f)];
      for (const int w : node.initial ? graph_field.initial_writers : graph_field.writers) {
        if (w != static_cast<int>(n)) add_once(node.depends, w);
      }
    };
    const auto depend = [&](const PassNode& of) {
      for (const auto& read : of.reads) {
        if (read.field < 0) continue;
        const auto& f = fields_[static_cast<std::size_t>(read.field)];
        if (f.pair_source == PairSource::pass && !node.global) continue;  // evaluated within
        if (f.geometry == 3)
          depend_on_writers(field("velocity"), read.previous);
        else if (f.kernel_bit >= 0)
          depend_on_writers(field("smoothing_length"), read.previous);
        else
          depend_on_writers(read.field, read.previous);
      }
    };
    depend(node);
    for (const int p : node.pair_producers) depend(nodes_[static_cast<std::size_t>(p)]);
    if (node.pair && !node.makes_pair_field) {
      const bool any_previous =
          std::any_of(node.reads.begin(), node.reads.end(), [&](const NodeRead& r) { return r.previous; });
      depend_on_writers(field("smoothing_length"), any_previous);  // the list itself
    }
  }
  for (auto& e : evolved_) {
    const auto& rate = fields_[static_cast<std::size_t>(e.rate)];
    e.rate_is_evolved = rate.evolved;
    e.is_rate_of_evolved =
        std::any_of(evolved_.begin(), evolved_.end(), [&](const GraphEvolved& o) { return o.rate == e.field; });
    if (rate.evolved) {
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
