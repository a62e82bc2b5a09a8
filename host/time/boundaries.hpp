// Boundaries at work: calls the plugins that create, retag, move and remove particles between steps, and those that ask
// for images, and keeps the mass ledger of what they do.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/schedule/evaluator.hpp"

namespace riffle {

struct Ledger {  // in the unit of the conserved field, water alone
  double initial = 0, in = 0, out = 0;
  double in_rest = 0, out_rest = 0;  // what rounding has cut off: millions of small amounts still close to round-off

  void enter(double amount) { add(in, in_rest, amount); }
  void leave(double amount) { add(out, out_rest, amount); }

  static void add(double& sum, double& rest, double amount) {  // Kahan (1965)
    const double y = amount + rest, t = sum + y;
    rest = y - (t - sum);
    sum = t;
  }
};

class Boundaries {
 public:
  Boundaries(const Graph& graph, ParticleStore& store);

  void connect(Evaluator& evaluator, Neighbourhood& neighbourhood);
  void begin(double time);                  // once
  bool edit(double time, double dt);        // after each step; true when particles came, went or changed role
  void images(std::vector<Image>& images);  // at each new list
  [[nodiscard]] const Ledger& ledger() const { return ledger_; }
  [[nodiscard]] Ledger& ledger() { return ledger_; }
  [[nodiscard]] double inside() const;  // conserved amount in the water
  // Where fluxes carry the conserved amount, it may pass to and from buffers within a step, and no particle with it: the
  // net amount goes into the ledger. Around the integrator's step.
  [[nodiscard]] double inside_before_exchange() const { return exchanges() ? inside() : 0; }
  void enter_exchange(double before);
  [[nodiscard]] std::vector<double>& state(std::size_t plugin) { return state_[plugin]; }
  // Graph indices of the fields that boundaries have written; part of the state.
  [[nodiscard]] std::set<int>& written() { return written_; }
  void particles_replaced() { roles_changed_ = true; }  // by those of a checkpoint
  [[nodiscard]] std::int64_t& next_id() { return next_id_; }

 private:
  struct Context;
  enum class Call { begin, edit, images };
  bool call(Call which, double time, double dt, std::vector<Image>* images);
  void apply(Context& context);
  void update_roles();
  void enter_changes(const Context& context);
  [[nodiscard]] bool exchanges() const;
  void follow_water();
  [[nodiscard]] bool has_buffers() const { return store_.role_begin(2) < store_.role_begin(4); }

  const Graph& graph_;
  ParticleStore& store_;
  Evaluator* evaluator_ = nullptr;
  Neighbourhood* neighbourhood_ = nullptr;
  std::vector<std::uint32_t> roles_;  // of owned particles, as bits
  bool roles_changed_ = true;
  std::vector<double> reach_;
  std::vector<std::vector<double>> state_;  // per plugin of the graph
  std::vector<int> followed_;               // fields of buffers that follow the water unless a boundary writes them
  std::set<int> written_;
  Ledger ledger_;
  std::int64_t next_id_ = 0;
};

}  // namespace riffle
