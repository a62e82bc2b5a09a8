#include "host/verdicts/pores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riffle {

namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<double> neighbours_in_pores(const Simulation& simulation) {
  const ParticleStore& store = simulation.store();
  const Field* porosity = store.find("porosity");
  if (store.dim() != 2 || porosity == nullptr || store.find("smoothing_length") == nullptr) return {};
  const double *phi = porosity->component[0].data(), *l = store.data("smoothing_length");
  const double *x = store.data("position", 0), *z = store.data("position", 1);
  const double kappa = simulation.neighbourhood().kappa();
  for (const auto& node : simulation.graph().nodes()) {
    if (!node.pair || node.makes_pair_field || (node.targets & RIFFLE_FLUID) == 0) continue;
    const NeighbourList& list = simulation.neighbourhood().list({node.reach, node.targets, node.sources});
    const auto water = std::min(static_cast<std::size_t>(store.role_begin(1)), list.count.size());
    const double least = water > 0 ? *std::min_element(phi, phi + water) : 1;
    if (!(least < 0.999)) return {};
    double sum = 0, particles = 0;
    for (std::size_t i = 0; i < water; ++i) {
      if (phi[i] > least + 0.1 * (1 - least)) continue;
      const double reach = kappa * l[i];
      ++particles;
      for (std::int64_t k = 0; k < list.count[i]; ++k) {
        const auto j = static_cast<std::size_t>(list.neighbour[static_cast<std::size_t>(list.begin[i] + k)]);
        if (j != i && std::hypot(x[j] - x[i], z[j] - z[i]) < reach) ++sum;
      }
    }
    return sum / particles;
  }
  return {};
}

std::optional<Verdict> locked_bed(const Simulation& simulation, const std::vector<double>& exact) {
  const ParticleStore& store = simulation.store();
  const Field *porosity = store.find("porosity"), *velocity = store.find("velocity");
  const auto water = static_cast<std::size_t>(store.role_begin(1));
  if (store.dim() < 2 || porosity == nullptr || velocity == nullptr || exact.size() < water || water == 0) return {};
  const double *phi = porosity->component[0].data(), *u = velocity->component[0].data();
  const double least = *std::min_element(phi, phi + water);
  std::vector<double> moving, wanting;
  for (std::size_t i = 0; i < water; ++i) {
    if (phi[i] > least + 0.01 * (1 - least) || !std::isfinite(exact[i])) continue;
    moving.push_back(u[i]);
    wanting.push_back(exact[i]);
  }
  if (least >= 0.999 || moving.empty()) return {};
  const double found = median(moving), wanted = median(wanting);
  if (!(std::abs(wanted) > 0)) return {};
  Verdict verdict;
  verdict.name = "locked-bed";
  verdict.value = found / wanted;
  verdict.bound = locked_share;
  const bool locked = !(found / wanted >= locked_share);
  verdict.severity = locked ? Severity::suspect : Severity::note;
  verdict.text =
      fmt::format("water where the porosity is smallest moves at {:.3g} m/s at the end, {:.3g} m/s in the reference{}",
                  found, wanted,
                  locked ? ": the lattice of particles holds it; pressure = \"dynamic\" takes out what it "
                           "holds with"
                         : "");
  if (locked) verdict.first_seen = simulation.time();
  return verdict;
}

}  // namespace riffle
