// Integrators on an oscillator, through the real evaluator: order of convergence, damping that may be as stiff as it likes,
// and what a step costs in evaluations.
#include <omp.h>

#include <atomic>

#include "host/time/integrator.hpp"
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

namespace f = riffle::fields;

constexpr int particles = 4;
std::atomic<int> evaluated{0};  // by particles

struct Spring {  // x'' = -x
  static constexpr auto pass_name = "spring";
  static constexpr riffle_read reads[] = {at_i(f::position)};
  static constexpr riffle_write writes[] = {sum(f::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    evaluated += static_cast<int>(std::min<std::int64_t>(b.size(), particles));
    for (int c = 0; c < b.dim(); ++c) {
      RIFFLE_EACH(k, b) b.out(0, c)[k] = -b.in(0, c)[k];
    }
  }
};
struct Oscillator : ToyOf<'o', Spring> {
  using ToyOf::ToyOf;
  static constexpr riffle_evolved evolved[] = {evolved_field(f::position, f::velocity),
                                               evolved_field(f::velocity, f::acceleration)};
};

struct Fall {  // u' = 1, damped
  static constexpr auto pass_name = "fall";
  static constexpr riffle_read reads[] = {at_i(f::velocity)};
  static constexpr riffle_write writes[] = {sum(f::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (int c = 0; c < b.dim(); ++c) {
      RIFFLE_EACH(k, b) b.out(0, c)[k] = 1;
    }
  }
};
struct Friction {
  static constexpr auto pass_name = "friction";
  static constexpr riffle_read reads[] = {at_i(f::velocity)};
  static constexpr riffle_write writes[] = {sum(f::drag_rate)};
  template <class P>
  static void run(const P& plugin, const Block& b) {
    const double lambda = plugin.lambda;
    RIFFLE_EACH(k, b) b.out(0)[k] = lambda;
  }
};
struct Damped : ToyOf<'d', Fall, Friction> {
  static constexpr riffle_parameter parameters[] = {real("lambda", "s-1", 1, 0, 1e12, "damping")};
  explicit Damped(const Values& v) : ToyOf(v), lambda(v.number("lambda")) {}
  static constexpr riffle_evolved evolved[] = {evolved_field(f::position, f::velocity),
                                               evolved_field(f::velocity, f::acceleration, &f::drag_rate)};
  double lambda;
};

class Motion {
 public:
  Motion(Toys toys, const std::string& integrator, bool implicit = true)
      : world_(std::move(toys), {.dim = 2, .per_role = {particles, 0, 0, 0, 0, 0}, .given = {"velocity"}}),
        integrator_(make_integrator(integrator, world_.graph, world_.store, implicit)) {
    omp_set_num_threads(1);  // for four particles, waiting for each other would be all the work
  }
  void start(double x, double u) {
    for (int c = 0; c < 2; ++c) {
      std::fill_n(world_.store.data("position", c), particles, x);
      std::fill_n(world_.store.data("velocity", c), particles, u);
    }
    world_.evaluator->everything_changed();
  }
  void steps(int n, double dt) {
    for (int k = 0; k < n; ++k) integrator_->step(*world_.evaluator, k * dt, dt, (k + 1) * dt);
  }
  [[nodiscard]] double x() const { return world_.value("position", 0, 1); }
  [[nodiscard]] double u() const { return world_.value("velocity", 0, 1); }

 private:
  World world_;
  std::unique_ptr<Integrator> integrator_;
};

double error_at_one(const std::string& integrator, int n) {
  Motion run(Toys(2).add<Oscillator>(), integrator);
  run.start(1, 0);
  run.steps(n, 1.0 / n);
  return std::max(std::abs(run.x() - std::cos(1.0)), std::abs(run.u() + std::sin(1.0)));
}

// The measured order tends to the true one with an error of the order of dt = 1/80 itself: 0.05 leaves room for a few dt.
TEST(Integrators, ConvergeWithTheOrderThatTheyClaim) {
  const std::map<std::string, double> orders{
      {"leap-frog", 2}, {"semi-implicit-euler", 1}, {"predictor-corrector", 2}, {"predictor-verlet", 2}, {"ssp-rk2", 2},
      {"ssp-rk3", 3}};
  ASSERT_EQ(orders.size(), integrator_names().size()) << "an integrator without a claim";
  for (const auto& [name, order] : orders)
    EXPECT_NEAR(std::log2(error_at_one(name, 80) / error_at_one(name, 160)), order, 0.05) << name;
}

TEST(Integrators, CostAsManyEvaluationsPerStepAsTheySay) {
  const std::map<std::string, int> first{{"leap-frog", 2}, {"semi-implicit-euler", 1}, {"predictor-corrector", 2}};
  const std::map<std::string, int> later{{"leap-frog", 1}, {"semi-implicit-euler", 1}, {"predictor-corrector", 2}};
  for (const auto& [name, count] : first) {
    Motion run(Toys(2).add<Oscillator>(), name);
    run.start(1, 0);
    evaluated = 0;
    run.steps(1, 0.01);
    EXPECT_EQ(evaluated, count * particles) << name << ", first step";
    evaluated = 0;
    run.steps(10, 0.01);
    EXPECT_EQ(evaluated, 10 * later.at(name) * particles) << name;
  }
}

// With lambda dt = 1e6 the velocity must arrive at force / lambda, to 1/(lambda dt) after the first step and to round-off
// after a few, and never change its sign on the way.
TEST(Integrators, BearAnyDampingWhenItIsImplicit) {
  const double lambda = 1e8, dt = 0.01;
  for (const auto& integrator : integrator_names()) {
    Motion run(Toys(2).add<Damped>({{"lambda", lambda}}), integrator.name);
    run.start(0.5, 1);
    for (int k = 0; k < 5; ++k) {
      run.steps(1, dt);
      EXPECT_GT(run.u(), 0) << integrator.name;
    }
    EXPECT_NEAR(run.u() * lambda, 1, 1e-12) << integrator.name;
    EXPECT_NEAR(run.x(), 0.5, 2 * dt) << integrator.name << ": no farther than the first velocity went";
  }
}

// The first velocity is multiplied as each formula says; a few roundings.
TEST(Integrators, DampAsTheirFormulasSay) {
  const double l = 0.2, dt = 0.5, q = l * dt;
  const std::map<std::string, double> implicit{
      {"leap-frog", (1 + 0.5 * dt) / (1 + 0.5 * q)},  // one half step, then another from there
      {"semi-implicit-euler", (1 + dt) / (1 + q)},
      {"predictor-corrector", (1 + dt) / (1 + q)}};
  for (const auto& [name, expected] : implicit) {
    Motion run(Toys(2).add<Damped>({{"lambda", l}}), name);
    run.start(0.5, 1);
    run.steps(1, dt);
    const double found = name == "leap-frog" ? (run.u() * (1 + 0.5 * q) - 0.5 * dt) : run.u();
    EXPECT_NEAR(found, expected, 1e-15) << name;
  }
  const double half = 1 + 0.5 * dt - 0.5 * q;
  const std::map<std::string, double> plain{{"leap-frog", half + 0.5 * dt - 0.5 * q * half},
                                            {"semi-implicit-euler", 1 + dt - q},
                                            {"predictor-corrector", 1 + dt - q}};
  for (const auto& [name, expected] : plain) {
    Motion run(Toys(2).add<Damped>({{"lambda", l}}), name, false);
    run.start(0.5, 1);
    run.steps(1, dt);
    EXPECT_NEAR(run.u(), expected, 1e-15) << name;
  }
}

TEST(Integrators, SayWhenAnExplicitDampingBlowsUp) {
  Motion run(Toys(2).add<Damped>({{"lambda", 1e8}}), "semi-implicit-euler", false);
  run.start(0.5, 1);
  EXPECT_THROW(run.steps(100, 0.01), RunError);
}

}  // namespace
}  // namespace riffle::test
