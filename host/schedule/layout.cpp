#include "host/schedule/layout.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include "host/schedule/gather.hpp"

namespace riffle {

namespace {

class Maker {
 public:
  Maker(const Graph& graph, const ParticleStore& store, const std::vector<char>& uniform,
        const std::set<std::pair<int, int>>& overwrites)
      : graph_(graph), store_(store), uniform_(uniform), overwrites_(overwrites) {}

  GroupLayout make(const PairGroup& group) {
    layout_.dim = graph_.dim();
    std::vector<int> members = group.producers;
    members.insert(members.end(), group.nodes.begin(), group.nodes.end());
    for (const int n : members) {
      for (const auto& read : node(n).reads) note(read);
    }
    layout_.first_slot = layout_.dim + 3;
    const int head = layout_.dim * (layout_.approach ? 2 : 1);
    layout_.quads = (head + static_cast<int>(layout_.slots.size()) + 3) / 4;
    layout_.arrays = layout_.first_slot + layout_.quads * 4 - head;
    layout_.first_own = layout_.arrays;
    layout_.arrays += gathered_own;
    for (const int n : group.producers) outputs_of_producer(n);
    request_ = group.request;
    for (const int n : members)
      call(n, std::find(group.producers.begin(), group.producers.end(), n) == group.producers.end());
    return std::move(layout_);
  }

 private:
  [[nodiscard]] const PassNode& node(int n) const { return graph_.nodes()[static_cast<std::size_t>(n)]; }
  [[nodiscard]] const GraphField& field(int f) const { return graph_.fields()[static_cast<std::size_t>(f)]; }
  [[nodiscard]] bool is_uniform(const Source& s) const {
    const int f = s.inverse_length ? graph_.field("smoothing_length") : s.field;
    return uniform_[static_cast<std::size_t>(f)] != 0;
  }
  [[nodiscard]] double uniform_value(const Source& s) const {
    const int f = s.inverse_length ? graph_.field("smoothing_length") : s.field;
    const double v = store_.data(graph_.name(f), s.component)[0];
    return s.inverse_length ? 1.0 / v : v;
  }
  [[nodiscard]] int shape(int f) const { return components(field(f).description.shape, layout_.dim); }

  // First round: which slots the record needs.
  void note(const NodeRead& read) {
    if (read.field < 0) return;
    const auto& f = field(read.field);
    if (f.geometry == 3) layout_.approach = true;
    if (f.kernel_bit >= 0) {
      if (read.where != RIFFLE_AT_I) slot({graph_.field("smoothing_length"), 0, true});
    } else if (f.pair_source == PairSource::none && read.where != RIFFLE_AT_I) {
      for (int c = 0; c < shape(read.field); ++c) slot({read.field, c, false});
    }
  }
  void slot(const Source& s) {
    if (is_uniform(s)) return;
    if (std::find(layout_.slots.begin(), layout_.slots.end(), s) == layout_.slots.end()) layout_.slots.push_back(s);
  }
  [[nodiscard]] int slot_array(const Source& s) const {
    const auto found = std::find(layout_.slots.begin(), layout_.slots.end(), s);
    return layout_.first_slot + static_cast<int>(found - layout_.slots.begin());
  }

  int constant(double value) {
    for (const auto& [array, have] : layout_.constants) {
      if (have == value) return array;
    }
    layout_.constants.emplace_back(layout_.arrays, value);
    return layout_.arrays++;
  }
  int op(GatherOp::Kind kind, const Source& s) {
    const auto key = std::make_tuple(static_cast<int>(kind), s.field, s.component, s.inverse_length);
    const auto found = made_.find(key);
    if (found != made_.end()) return found->second;
    const bool gathered = kind == GatherOp::Kind::own && layout_.own_count < gathered_own;
    const int to = gathered ? layout_.first_own + layout_.own_count++ : layout_.arrays++;
    layout_.ops.push_back({kind, to, kind == GatherOp::Kind::own ? -1 : slot_array(s), s});
    made_[key] = to;
    return to;
  }
  int value(std::uint32_t where, const Source& s) {
    if (is_uniform(s)) return constant(where == RIFFLE_DIFFERENCE ? 0.0 : uniform_value(s));
    switch (where) {
      case RIFFLE_AT_J: return slot_array(s);
      case RIFFLE_DIFFERENCE: return op(GatherOp::Kind::difference, s);
      case RIFFLE_MEAN: return op(s.inverse_length ? GatherOp::Kind::inverse_mean : GatherOp::Kind::mean, s);
      default: return op(GatherOp::Kind::own, s);
    }
  }
  int kernel(std::uint32_t where, int bit) {
    const int inverse_l = value(where, {graph_.field("smoothing_length"), 0, true});
    auto found = std::find_if(layout_.kernels.begin(), layout_.kernels.end(),
                              [&](const KernelCall& k) { return k.inverse_l == inverse_l; });
    if (found == layout_.kernels.end()) {
      layout_.kernels.push_back({});
      found = layout_.kernels.end() - 1;
      found->inverse_l = inverse_l;
    }
    if (found->out[bit] < 0) {
      found->out[bit] = layout_.arrays++;
      found->want |= 1u << bit;
    }
    return found->out[bit];
  }

  void outputs_of_producer(int n) {
    for (const auto& w : node(n).writes) {
      for (int c = 0; c < shape(w.field); ++c) pair_array_[{w.field, c}] = layout_.arrays++;
    }
  }

  void call(int n, bool is_pass) {
    PassCall made;
    made.node = n;
    for (const auto& read : node(n).reads) {
      std::vector<int> arrays;
      if (read.field >= 0) {
        const auto& f = field(read.field);
        for (int c = 0; c < shape(read.field); ++c) {
          if (f.geometry == 0)
            arrays.push_back(c);
          else if (f.geometry > 0)
            arrays.push_back(layout_.dim + f.geometry - 1);
          else if (f.kernel_bit >= 0)
            arrays.push_back(kernel(read.where, f.kernel_bit));
          else if (f.pair_source == PairSource::pass)
            arrays.push_back(pair_array_.at({read.field, c}));
          else
            arrays.push_back(value(read.where, {read.field, c, false}));
        }
      }
      made.in.push_back(arrays);
    }
    for (const auto& w : node(n).writes) {
      std::vector<int> arrays;
      for (int c = 0; c < shape(w.field); ++c) {
        const bool per_pair = field(w.field).pair_source == PairSource::pass;
        const auto known = pair_array_.find({w.field, c});
        const int array = per_pair && known != pair_array_.end() ? known->second : layout_.arrays++;
        arrays.push_back(array);
        if (per_pair) {
          const bool own_list = node(n).reach == request_.reach && node(n).targets == request_.targets &&
                                node(n).sources == request_.sources;
          if (w.keep && own_list) layout_.keeps.push_back({array, w.field, c});
        } else if (is_pass) {
          layout_.reductions.push_back({array, w.field, c, w.how,
                                        overwrites_.count({n, w.field}) != 0 || w.how != RIFFLE_SUM,
                                        node(n).with_self});
          if (node(n).with_self) layout_.any_self = true;
        }
      }
      made.out.push_back(arrays);
    }
    layout_.calls.push_back(std::move(made));
  }

  const Graph& graph_;
  const ParticleStore& store_;
  const std::vector<char>& uniform_;
  const std::set<std::pair<int, int>>& overwrites_;
  NeighbourRequest request_;
  GroupLayout layout_;
  std::map<std::tuple<int, int, int, bool>, int> made_;
  std::map<std::pair<int, int>, int> pair_array_;
};

}  // namespace

GroupLayout make_layout(const Graph& graph, const PairGroup& group, const ParticleStore& store,
                        const std::vector<char>& uniform, const std::set<std::pair<int, int>>& overwrites) {
  return Maker(graph, store, uniform, overwrites).make(group);
}

}  // namespace riffle
