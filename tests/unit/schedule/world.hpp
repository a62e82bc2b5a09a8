// A small world for the schedule: toy plugins made by hand, a cloud of particles, and the evaluator over them. It does
// what a run does, without manifest, libraries and time.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <riffle/radial_kernel.hpp>
#include <riffle/sdk.hpp>
#include <set>
#include <string>
#include <vector>

#include "host/schedule/evaluator.hpp"

namespace riffle::test {

// W = sigma l^-d (1 - q/2)^4 (1 + 2 q), all six outputs.
struct ToyKernel : RadialKernel<ToyKernel> {
  using RadialKernel::RadialKernel;
  static constexpr auto id = "toy-kernel", kind = "kernel", version = "1.0.0", summary = "a kernel", source = "";
  static constexpr double support = 2;
  static double normalisation(int dim) { return dim == 1 ? 0.75 : 7 / (4 * pi); }
  template <int dim>
  static double w(double q) {
    const double t = std::max(0.0, 1 - 0.5 * q);
    return t * t * t * t * (1 + 2 * q);
  }
  template <int dim>
  static double w1(double q) {
    const double t = std::max(0.0, 1 - 0.5 * q);
    return -5 * t * t * t;
  }
  template <int dim>
  static double w2(double q) {
    const double t = std::max(0.0, 1 - 0.5 * q);
    return 5 * t * t * (2 * q - 1);
  }
};

// What most toys look at.
inline constexpr riffle_field weight = scalar_field("weight", "1", "something to sum");

// Sum, least or largest over the neighbours of one thing that is read of each pair.
template <const riffle_field& Out, std::uint32_t Where, const riffle_field& In, std::uint32_t How = RIFFLE_SUM,
          std::uint32_t Neighbours = RIFFLE_GATHER, std::uint32_t Flags = 0, std::uint32_t Targets = 0,
          std::uint32_t Sources = 0>
struct Reduce {
  static constexpr auto pass_name = Out.name;
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t neighbours = Neighbours, pass_flags = Flags, targets = Targets, sources = Sources;
  static constexpr riffle_read reads[] = {{sizeof(riffle_read), Where, 0, 0, &In}};
  static constexpr riffle_write writes[] = {{sizeof(riffle_write), How, 0, 0, &Out}};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k];
  }
};

// out = factor * in, particle by particle.
template <const riffle_field& Out, const riffle_field& In, int Factor = 1, std::uint32_t ReadFlags = 0>
struct Scale {
  static constexpr auto pass_name = Out.name;
  static constexpr auto pass_type = RIFFLE_PASS_PARTICLE;
  static constexpr riffle_read reads[] = {at_i(In, ReadFlags)};
  static constexpr riffle_write writes[] = {set(Out)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = Factor * b.in(0)[k];
  }
};

// Names of the passes that have run since it was last cleared.
class Ran {
 public:
  void note(const char* name);
  std::set<std::string> take();  // and forgets them

 private:
  std::mutex mutex_;
  std::set<std::string> names_;
};
Ran& ran();

// A pass that leaves its name behind.
template <class Pass>
struct Noted : Pass {
  template <class P>
  static void run(const P& plugin, const Block& block) {
    ran().note(Pass::pass_name);
    Pass::run(plugin, block);
  }
};

// What every toy has to say about itself; `Id` makes messages tell them apart.
template <char Id, class... Pass>
struct ToyOf {
  static constexpr char id[] = {'t', 'o', 'y', '-', Id, 0};
  static constexpr auto kind = "filter", version = "1.0.0", summary = "a toy", source = "";
  using passes = Passes<Pass...>;
  explicit ToyOf(const Values&) {}
};

// Created plugins, kept alive.
class Toys {
 public:
  explicit Toys(int dim) : dim_(dim) {}
  template <class P>
  Toys& add(const std::map<std::string, double>& numbers = {}, const std::map<std::string, std::string>& words = {}) {
    return add(detail::Plugin<P>::value, numbers, words);
  }
  Toys& add(const riffle_plugin& table, const std::map<std::string, double>& numbers = {},
            const std::map<std::string, std::string>& words = {});
  std::vector<ActivePlugin> active;

 private:
  int dim_;
  std::vector<std::shared_ptr<void>> keep_;
};

struct WorldOptions {
  int dim = 2;
  std::array<std::int64_t, role_count> per_role{300, 0, 0, 0, 0, 0};
  std::vector<std::string> given{};  // besides smoothing_length: scattered in (0.5, 1.5)
  std::vector<std::string> wanted{};
  double length = 1.6;  // smoothing lengths in spacings; they vary by +-25 % unless `uniform`
  bool uniform_length = false;
  bool written_length = false;  // a pass writes smoothing lengths; those placed are only where it begins
  double skin = 0.1;
  RunnerOptions runner{};
  std::function<void(ParticleStore&, std::vector<Image>&)> images{};
};

// Particles scattered in the unit cube, roles mixed in space.
class World {
 public:
  World(Toys toys, WorldOptions options);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void compute(const std::vector<std::string>& fields, double time = 0, double dt = 0);
  [[nodiscard]] std::vector<double> values(const std::string& field, int component = 0) const;
  [[nodiscard]] double value(const std::string& field, std::int64_t i, int component = 0) const {
    return store.data(field, component)[i];
  }
  // Adds to each position a random step of at most `largest`, and says so.
  void move(double largest, unsigned seed);
  void changed(const std::string& field) { evaluator->changed(graph.field(field)); }
  [[nodiscard]] const riffle_kernel& kernel() const { return kernel_; }
  // One output of the kernel at one distance, by itself.
  [[nodiscard]] double kernel_value(int bit, double r, double l) const;
  [[nodiscard]] std::uint32_t role(std::int64_t index) const;  // of images too

  Toys toys;
  WorldOptions options;
  Graph graph;
  ParticleStore store;

 private:
  riffle_kernel kernel_{};

 public:
  Neighbourhood neighbourhood;
  std::unique_ptr<Evaluator> evaluator;

 private:
  void place();
  std::mt19937 random_{7};
};

// One pair (i, j) as a double loop finds it.
struct FoundPair {
  std::int64_t i = 0, j = 0;
  double r = 0, dx[3] = {};
};

// Calls `visit` for every pair within reach, images included, each particle with itself excluded.
void each_pair(const World& world, const NeighbourRequest& request, const std::function<void(const FoundPair&)>& visit);

// Sum over the neighbours of each owned particle, formed by a double loop.
std::vector<double> brute_force_sum(const World& world, const NeighbourRequest& request,
                                    const std::function<double(const FoundPair&)>& term);

// Relative to the largest expected size: the two differ only by the order of summation, of some 30 terms.
inline void expect_same_sums(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  double scale = 0;
  for (const double e : expected) scale = std::max(scale, std::abs(e));
  ASSERT_GT(scale, 0) << "nothing to compare";
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-13 * scale) << "particle " << i;
}

inline constexpr NeighbourRequest gathered{Reach::gather, RIFFLE_FLUID, RIFFLE_ALL_ROLES & ~RIFFLE_PROBE};

}  // namespace riffle::test
