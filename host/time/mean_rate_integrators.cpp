#include "host/time/mean_rate_integrators.hpp"

#include "host/time/integrator_base.hpp"

namespace riffle {

namespace {

class MeanRateIntegrator : public IntegratorBase {
 public:
  MeanRateIntegrator(const Graph& graph, ParticleStore& store, bool implicit)
      : IntegratorBase(graph, store, implicit, "_start") {
    for (const auto* list : {&first_order_, &positions_}) {
      for (const auto& n : *list) {
        add_scratch(graph, store, n.e.field, n.field + mean_);
        if (damped(n)) add_scratch(graph, store, n.e.damping, n.damping + mean_ + "_of_" + n.field);
      }
    }
  }

 protected:
  [[nodiscard]] bool damped(const Named& n) const { return implicit_ && !n.damping.empty(); }
  [[nodiscard]] std::string mean_damping(const Named& n) const {
    return damped(n) ? n.damping + mean_ + "_of_" + n.field : "";
  }

  void remember_start(Evaluator& evaluator) const {
    for (const auto* list : {&first_order_, &positions_}) {
      for (const auto& n : *list) copy_field(evaluator.store(), n.field + "_start", n.field);
    }
  }
  // mean = keep mean + take rate, with the rates as they are now.
  void weigh(Evaluator& evaluator, const Named& n, double keep, double take) const {
    ParticleStore& store = evaluator.store();
    mix(store, n.field + mean_, n.rate, keep, take, n.e.roles);
    if (damped(n))
      mix(store, mean_damping(n), n.damping, keep, take, n.e.roles);
    else if (!n.damping.empty())
      mix_damping(store, n.field + mean_, n.damping, n.field, take, n.e.roles);
  }
  // From the start over `dt` with the means.
  bool advance_from_start(Evaluator& evaluator, const Named& n, double dt) const {
    return advance_damped(evaluator.store(), n.field, n.field + "_start", n.field + mean_, mean_damping(n), dt,
                          n.e.roles);
  }

 private:
  static constexpr const char* mean_ = "_mean_rate";
};

// In the Butcher form of Shu & Osher (1988): stage k starts from t with a mean of the rates so far.
//   order 2: u + dt L0;  u + dt (L0 + L1) / 2
//   order 3: u + dt L0;  u + dt/2 (L0 + L1) / 2;  u + dt (L0 + L1 + 4 L2) / 6
class SspRungeKutta : public MeanRateIntegrator {
 public:
  SspRungeKutta(int order, const Graph& graph, ParticleStore& store, bool implicit)
      : MeanRateIntegrator(graph, store, implicit), stages_(order == 2 ? second() : third()) {}

  void step(Evaluator& evaluator, double time, double dt, double end) override {
    remember_start(evaluator);
    for (const Stage& stage : stages_) {
      const double at = stage.at == 0 ? time : stage.at == 1 ? end : 0.5 * (time + end);
      evaluator.compute(rates_, at, dt);
      bool finite = true;
      for (const auto* list : {&first_order_, &positions_}) {
        for (const auto& n : *list) weigh(evaluator, n, stage.keep, 1 - stage.keep);
      }
      for (const auto* list : {&first_order_, &positions_}) {
        for (const auto& n : *list) finite = advance_from_start(evaluator, n, stage.part * dt) && finite;
      }
      all_changed(evaluator);
      check(evaluator, finite);
    }
  }

 private:
  struct Stage {
    double at, keep, part;  // where the rates are taken, weight of the mean so far, part of the step
  };
  static std::vector<Stage> second() { return {{0, 0, 1}, {1, 0.5, 1}}; }
  static std::vector<Stage> third() { return {{0, 0, 1}, {1, 0.5, 0.5}, {0.5, 1.0 / 3, 1}}; }
  std::vector<Stage> stages_;
};

// x += dt (u + u*) / 2, u* = u + dt a; then u += dt (a + a*) / 2 with a* = F(x, u*), which the next step starts from.
class PredictorVerlet : public MeanRateIntegrator {
 public:
  using MeanRateIntegrator::MeanRateIntegrator;

  void step(Evaluator& evaluator, double time, double dt, double end) override {
    if (!started_) {
      evaluator.compute(rates_, time, dt);
      started_ = true;
    }
    remember_start(evaluator);
    bool finite = true;
    for (const auto& n : positions_) weigh(evaluator, n, 0, 1);
    for (const auto& n : first_order_) {
      weigh(evaluator, n, 0, 1);
      finite = advance_from_start(evaluator, n, dt) && finite;
    }
    for (const auto& n : positions_) {
      weigh(evaluator, n, 0.5, 0.5);
      finite = advance_from_start(evaluator, n, dt) && finite;
    }
    all_changed(evaluator);
    check(evaluator, finite);
    evaluator.compute(rates_, end, dt);
    for (const auto& n : first_order_) {
      weigh(evaluator, n, 0.5, 0.5);
      finite = advance_from_start(evaluator, n, dt) && finite;
      evaluator.changed(n.e.field);
    }
    check(evaluator, finite);
  }
  [[nodiscard]] std::vector<int> carried() const override { return rates_; }
  [[nodiscard]] bool carrying() const override { return started_; }
  void resumed() override { started_ = true; }
  void restarted() override { started_ = false; }

 private:
  bool started_ = false;
};

}  // namespace

std::unique_ptr<Integrator> make_ssp_runge_kutta(int order, const Graph& graph, ParticleStore& store,
                                                 bool drag_implicit) {
  return std::make_unique<SspRungeKutta>(order, graph, store, drag_implicit);
}

std::unique_ptr<Integrator> make_predictor_verlet(const Graph& graph, ParticleStore& store, bool drag_implicit) {
  return std::make_unique<PredictorVerlet>(graph, store, drag_implicit);
}

}  // namespace riffle
