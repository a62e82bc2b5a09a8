#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <thread>

#include "host/plugins/call.hpp"
#include "host/plugins/check/checks.hpp"
#include "host/plugins/check/closure.hpp"
#include "host/plugins/descriptor_checks.hpp"

namespace riffle::check {
namespace {

constexpr std::int64_t count = 64;

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Compares the part with the items of the whole that it holds; empty when they have the same bits.
std::string difference(const Closure& closure, const SyntheticBlock& whole, const SyntheticBlock& part,
                       const std::vector<std::int64_t>& items) {
  for (int k = 0; k < whole.outputs(); ++k) {
    for (int c = 0; c < whole.components(k); ++c) {
      for (std::size_t p = 0; p < items.size(); ++p) {
        const double expected = whole.out(k, c)[items[p]], found = part.out(k, c)[p];
        if (same_bits(expected, found)) continue;
        return fmt::format("{}: \"{}\" of one {} is {:.17g} in one block and {:.17g} in another", closure.name,
                           closure.output(k).name, closure.pairs() ? "pair" : "particle", expected, found);
      }
    }
  }
  return "";
}

// Pieces of the items 0 .. count-1, as the block runner might cut them.
std::vector<std::vector<std::int64_t>> pieces(const Closure& closure) {
  const std::vector<std::int64_t> lengths =
      closure.pairs() ? std::vector<std::int64_t>{4, 8, 20, 4, 28} : std::vector<std::int64_t>{1, 3, 7, 8, 16, 29};
  std::vector<std::vector<std::int64_t>> all;
  std::int64_t first = 0;
  for (const std::int64_t length : lengths) {
    std::vector<std::int64_t> items(static_cast<std::size_t>(length));
    std::iota(items.begin(), items.end(), first);
    all.push_back(std::move(items));
    first += length;
  }
  return all;
}

}  // namespace

Findings check_blocks(const Plugin& plugin) {
  Findings findings;
  std::mt19937_64 random(1);
  const bool any = for_each_closure(plugin, [&](const PluginInstance& instance, const Closure& closure) {
    if (!findings.failures.empty()) return;
    const SyntheticScene scene = scene_for(closure, instance.dim());
    const SyntheticBlock whole(scene, closure.pass, first_items(count));
    run(closure, whole);
    auto parts = pieces(closure);
    parts.push_back(first_items(count));
    std::shuffle(parts.back().begin(), parts.back().end(), random);
    for (const auto& items : parts) {
      const SyntheticBlock part(scene, closure.pass, items);
      run(closure, part);
      const std::string text = difference(closure, whole, part, items);
      if (text.empty()) continue;
      findings.fail(text + "; it must depend on nothing else in the block");
      return;
    }
  });
  findings.summary = any ? "bitwise the same whatever block a pair or particle is in" : nothing;
  return findings;
}

Findings check_threads(const Plugin& plugin) {
  Findings findings;
  const bool any = for_each_closure(plugin, [&](const PluginInstance& instance, const Closure& closure) {
    if (!findings.failures.empty()) return;
    const SyntheticScene scene = scene_for(closure, instance.dim());
    const auto items = first_items(count);
    const SyntheticBlock first(scene, closure.pass, items);
    run(closure, first);
    std::atomic<int> different{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&] {
        riffle_error error = no_error();
        for (int repeat = 0; repeat < 25; ++repeat) {
          const SyntheticBlock again(scene, closure.pass, items);
          const bool ran = run_pass(closure.pass, closure.self, again.block(), error) == RIFFLE_OK;
          if (!ran || !difference(closure, first, again, items).empty()) ++different;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    if (different == 0) return;
    findings.fail(
        fmt::format("{}: {} of 100 calls on the same block, from four threads at once, differ; self must not "
                    "change in run",
                    closure.name, different.load()));
  });
  findings.summary = any ? "bitwise the same on every call, from four threads at once" : nothing;
  return findings;
}

Findings check_votes(const Plugin& plugin) {
  Findings findings;
  std::size_t votes = 0;
  for (const int dim : plugin.description.dimensions) {
    const PluginInstance instance(plugin, dim, default_values(plugin.description));
    for (const riffle_vote* vote : Table(instance.table().votes)) {
      ++votes;
      SyntheticScene scene;
      scene.dim = instance.dim();
      const auto limit = [&](const std::vector<std::int64_t>& items) {
        const SyntheticBlock block(scene, *vote, items);
        return may_throw(vote->limit)(instance.self(), &block.block());
      };
      for (const bool at_rest : {false, true}) {
        scene.at_rest = at_rest;
        const double whole = limit(first_items(count));
        double least = std::numeric_limits<double>::infinity();
        for (std::int64_t k = 0; k < count; k += 8) {
          std::vector<std::int64_t> items(8);
          std::iota(items.begin(), items.end(), k);
          least = std::min(least, limit(items));
        }
        if (!(whole > 0)) {
          findings.fail(fmt::format("vote \"{}\" on the time step is {} s{}", vote->name, whole,
                                    at_rest ? " for water at rest" : ""));
          return findings;
        }
        if (!same_bits(whole, least)) {
          findings.fail(fmt::format("vote \"{}\" is {} s for a block, but {} s for the least of its parts", vote->name,
                                    whole, least));
          return findings;
        }
      }
    }
  }
  findings.summary = votes == 0 ? nothing : "positive, and that of a block is the least of its parts";
  return findings;
}

}  // namespace riffle::check
