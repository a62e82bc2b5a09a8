#include "host/time/integrator.hpp"

#include <stdexcept>

#include "host/time/integrator_base.hpp"
#include "host/time/mean_rate_integrators.hpp"

namespace riffle {

namespace {

// Kick-drift-kick: u_half = u + dt/2 a; x += dt u_half; a = F(x, u_half + dt/2 a); u = u_half + dt/2 a. Second order,
// time-reversible for forces of position alone; one evaluation per step. Diwakar & Mohapatra (2023) eqs 13-15.
class LeapFrog : public IntegratorBase {
 public:
  LeapFrog(const Graph& graph, ParticleStore& store, bool implicit) : IntegratorBase(graph, store, implicit, "_half") {}

  void step(Evaluator& evaluator, double time, double dt, double end) override {
    if (!started_) {
      evaluator.compute(rates_, time, dt);
      started_ = true;
    }
    ParticleStore& store = evaluator.store();
    bool finite = true;
    for (const auto& n : first_order_) {
      if (!all_advanced(store, n.e.roles))
        copy_field(store, n.field + "_half", n.field);  // the others keep their value
      finite = move(evaluator, n, n.field + "_half", n.field, 0.5 * dt) && finite;
      finite = move(evaluator, n, n.field, n.field + "_half", 0.5 * dt) && finite;
    }
    for (const auto& n : positions_) {
      finite = advance(store, n.field, n.field, n.rate + "_half", "", implicit_, dt, n.e.roles) && finite;
      evaluator.changed(n.e.field);
    }
    for (const auto& n : first_order_) evaluator.changed(n.e.field);
    check(evaluator, finite);
    evaluator.compute(rates_, end, dt);
    for (const auto& n : first_order_) {
      finite = move(evaluator, n, n.field, n.field + "_half", 0.5 * dt) && finite;
      evaluator.changed(n.e.field);
    }
    check(evaluator, finite);
  }
  [[nodiscard]] std::vector<int> carried() const override { return rates_; }
  [[nodiscard]] bool carrying() const override { return started_; }
  void resumed() override { started_ = true; }
  void restarted() override { started_ = false; }

 private:
  static bool all_advanced(const ParticleStore& store, std::uint32_t roles) {
    for (int role = 0; role < role_count; ++role) {
      if ((roles & (1u << role)) == 0 && store.role_begin(role) != store.role_begin(role + 1)) return false;
    }
    return true;
  }
  bool started_ = false;
};

// Fields that drive no position first (density), with their rates; then, with the new values, those that do (velocity);
// then positions with the new velocities. First order, symplectic; one evaluation per step.
class SemiImplicitEuler : public IntegratorBase {
 public:
  SemiImplicitEuler(const Graph& graph, ParticleStore& store, bool implicit)
      : IntegratorBase(graph, store, implicit, "") {}

  void step(Evaluator& evaluator, double time, double dt, double /*end*/) override {
    bool finite = true;
    for (const bool drives : {false, true}) {
      std::vector<int> rates;
      for (const auto& n : first_order_) {
        if (n.e.is_rate_of_evolved != drives) continue;
        rates.push_back(n.e.rate);
        if (n.e.damping >= 0) rates.push_back(n.e.damping);
      }
      if (rates.empty()) continue;
      evaluator.compute(rates, time, dt);
      for (const auto& n : first_order_) {
        if (n.e.is_rate_of_evolved != drives) continue;
        finite = move(evaluator, n, n.field, n.field, dt) && finite;
        evaluator.changed(n.e.field);
      }
      check(evaluator, finite);
    }
    for (const auto& n : positions_) {
      finite = move(evaluator, n, n.field, n.field, dt) && finite;
      evaluator.changed(n.e.field);
    }
    check(evaluator, finite);
  }
};

// Monaghan (1989) as in Kazemi (2017) eqs 3.12-3.14: half a step with the rates at t, half a step again from t with the
// rates at t + dt/2, then extrapolated to t + dt. Two evaluations per step. Damping is applied over the whole step with
// its value at the middle, because extrapolating a point-implicit half step would overshoot for stiff drag.
class PredictorCorrector : public IntegratorBase {
 public:
  PredictorCorrector(const Graph& graph, ParticleStore& store, bool implicit)
      : IntegratorBase(graph, store, implicit, "_start") {}

  void step(Evaluator& evaluator, double time, double dt, double end) override {
    ParticleStore& store = evaluator.store();
    bool finite = true;
    evaluator.compute(rates_, time, dt);
    for (const auto* list : {&first_order_, &positions_}) {
      for (const auto& n : *list) copy_field(store, n.field + "_start", n.field);
    }
    for (const auto& n : positions_)
      finite = advance(store, n.field, n.field + "_start", n.rate, "", implicit_, 0.5 * dt, n.e.roles) && finite;
    for (const auto& n : first_order_) finite = move(evaluator, n, n.field, n.field + "_start", 0.5 * dt) && finite;
    all_changed(evaluator);
    check(evaluator, finite);
    evaluator.compute(rates_, 0.5 * (time + end), dt);
    for (const auto& n : first_order_) finite = move(evaluator, n, n.field, n.field + "_start", 0.5 * dt) && finite;
    for (const auto& n : positions_)
      finite = advance(store, n.field, n.field + "_start", n.rate, "", implicit_, dt, n.e.roles) && finite;
    for (const auto& n : first_order_) finite = move(evaluator, n, n.field, n.field + "_start", dt) && finite;
    all_changed(evaluator);
    check(evaluator, finite);
  }
};

}  // namespace

const std::vector<IntegratorName>& integrator_names() {
  static const std::vector<IntegratorName> names{
      {"leap-frog", "kick-drift-kick, second order, one evaluation per step"},
      {"semi-implicit-euler",
       "scalars, then velocity, then position; first order, one evaluation per step, large steps"},
      {"predictor-corrector", "Monaghan (1989), Kazemi (2017) eqs 3.12-3.14; second order, two evaluations per step"},
      {"predictor-verlet", "velocity Verlet with a predicted velocity; second order, one evaluation per step"},
      {"ssp-rk2", "Heun in the form of Shu and Osher (1988); second order, two evaluations per step"},
      {"ssp-rk3", "Shu and Osher (1988); third order, second for drag, three evaluations per step"}};
  return names;
}

std::unique_ptr<Integrator> make_integrator(const std::string& name, const Graph& graph, ParticleStore& store,
                                            bool drag_implicit) {
  if (name == "leap-frog") return std::make_unique<LeapFrog>(graph, store, drag_implicit);
  if (name == "semi-implicit-euler") return std::make_unique<SemiImplicitEuler>(graph, store, drag_implicit);
  if (name == "predictor-corrector") return std::make_unique<PredictorCorrector>(graph, store, drag_implicit);
  if (name == "predictor-verlet") return make_predictor_verlet(graph, store, drag_implicit);
  if (name == "ssp-rk2") return make_ssp_runge_kutta(2, graph, store, drag_implicit);
  if (name == "ssp-rk3") return make_ssp_runge_kutta(3, graph, store, drag_implicit);
  throw std::logic_error("there is no integrator \"" + name + "\"");
}

}  // namespace riffle
