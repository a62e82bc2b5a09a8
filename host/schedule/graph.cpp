#include "host/schedule/graph.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "host/schedule/graph_tables.hpp"
#include "riffle/fields.hpp"

namespace riffle {

namespace {

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
      if (node.pair) intern(fields::smoothing_length, plugin.id);
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
      if (!condition_holds(evolved->when, plugin.values)) continue;
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

}  // namespace riffle
