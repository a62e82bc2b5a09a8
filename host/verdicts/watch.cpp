#include "host/verdicts/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "host/verdicts/line_checks.hpp"
#include "host/verdicts/pores.hpp"

namespace riffle {

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// One sentence per sign: what was seen, whether good or bad.
std::string sentence(const std::string& name, double value, const std::string& where) {
  if (name == "mass") return fmt::format("mass imbalance {:.2e} of what there was", value);
  if (name == "depth") return fmt::format("the smallest depth was {:.3g} of the largest one at t = 0{}", value, where);
  if (name == "neighbours") {
    if (value == 0) return "every particle saw its neighbours";
    return fmt::format(
        "{:.0f} water particles see nobody on one side, though somebody is there{}: they stand too far "
        "apart for their support",
        value, where);
  }
  if (name == "pores")
    return fmt::format("water where the porosity is smallest had {:.1f} neighbours in the mean at t = 0{}", value,
                       value < fewest_neighbours_in_pores
                           ? ", too few for a pressure: take placement = \"equal-spacing\" or a larger smoothing_ratio"
                           : "");
  if (name == "order") {
    if (value == 0) return "no particle overtook another";
    return fmt::format("particles overtook each other, {:.2g} times per particle, which water in a channel cannot do",
                       value);
  }
  if (name == "support")
    return fmt::format(
        "at most {:.2g} % of the particles had a neighbour beyond {:.0f} % of their reach, too far to be "
        "felt",
        100 * value, 100 * stretched_gap);
  if (name == "spacing")
    return fmt::format(
        "at the end {:.2g} % of the particles stood in pairs, closer to one neighbour than to the other "
        "by a factor of {:.1f} or more",
        100 * value, paired_gaps);
  return fmt::format("energy grew by {:.2g} % of the largest kinetic energy, with nothing that drives the water",
                     100 * value);
}

}  // namespace

Watch::Watch(Simulation& simulation) {
  const Field* depth = simulation.store().find("depth");
  const std::int64_t n = simulation.store().role_begin(1);
  if (depth == nullptr || n == 0) return;
  const double* h = depth->component[0].data();
  const auto [least, most] = std::minmax_element(h, h + n);
  if (*least > 0) depth_scale_ = *most;  // a scene that begins with dry particles may keep some
}

void Watch::see(const std::string& name, double value, double bound, double time, Worst worst,
                const std::string& where) {
  Sign& sign = signs_[name];
  const bool smallest = worst == Worst::smallest;
  const bool counts =
      !sign.seen || std::isnan(value) || worst == Worst::latest || (smallest ? value < sign.value : value > sign.value);
  const bool bad = smallest ? !(value >= bound) : !(value <= bound);
  sign.bound = bound;
  sign.seen = true;
  if (counts) sign.value = value;
  if (bad && sign.first < 0) sign.first = time;
  if (!bad && worst == Worst::latest) sign.first = -1;
  if (bad && counts) sign.where = where;
}

void Watch::look(Simulation& simulation) {
  const double start = now();
  look_at_mass(simulation);
  if (simulation.scene().dimension == 1) look_along_line(simulation);
  if (!looked_) {
    if (const auto mean = neighbours_in_pores(simulation))
      see("pores", *mean, fewest_neighbours_in_pores, simulation.time(), Worst::smallest);
  }
  look_at_depth(simulation);
  look_at_energy(simulation);
  looked_ = true;
  seconds_ += now() - start;
}

void Watch::look_at_mass(Simulation& simulation) {
  if (simulation.graph().conserved() < 0) return;
  const Ledger& ledger = simulation.boundaries().ledger();
  const MassLedger mass{ledger.initial, ledger.in, ledger.out, simulation.boundaries().inside()};
  see("mass", std::abs(mass.imbalance()), 1e-10, simulation.time());
}

void Watch::look_at_depth(const Simulation& simulation) {
  const Field* field = simulation.store().find("depth");
  const std::int64_t n = simulation.store().role_begin(1);
  if (field == nullptr || n == 0 || depth_scale_ == 0) return;
  const double* h = field->component[0].data();
  std::int64_t least = 0;
  for (std::int64_t i = 1; i < n; ++i) {
    if (!(h[i] >= h[least])) least = i;
  }
  see("depth", h[least] / depth_scale_, 1e-6, simulation.time(), Worst::smallest,
      fmt::format(", near x = {:.4g} m", simulation.store().data("position")[least]));
}

void Watch::look_along_line(const Simulation& simulation) {
  const ParticleStore& store = simulation.store();
  const std::int64_t water = store.role_begin(1);
  if (water == 0 || store.find("smoothing_length") == nullptr) return;
  const double *x = store.data("position"), *l = store.data("smoothing_length");
  std::vector<std::int64_t> order(static_cast<std::size_t>(water));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [x](std::int64_t a, std::int64_t b) { return x[a] < x[b]; });
  LineView line;
  std::vector<std::int64_t> ids;
  const double kappa = simulation.neighbourhood().kappa();
  for (const std::int64_t i : order) {
    line.x.push_back(x[i]);
    line.reach.push_back(kappa * l[i]);
    ids.push_back(store.ids()[static_cast<std::size_t>(i)]);
  }
  line.others.assign(x + water, x + store.all());
  const LineLook found = look_along(line);
  if (!looked_) one_sided_ = found.one_sided;  // gaps between bodies of water that the scene begins with
  const double time = simulation.time();
  see("neighbours", static_cast<double>(found.one_sided), static_cast<double>(one_sided_), time, Worst::largest,
      fmt::format(", the first near x = {:.4g} m", found.one_sided_at));
  see("support", found.stretched, 0.02, time);
  // Volumes by summation want even gaps; particles that know their length may stand as they like.
  if (store.find("extent") == nullptr) see("spacing", found.paired, 0.1, time, Worst::latest);
  const double before = signs_.count("order") != 0 ? signs_["order"].value : 0;
  const double fresh = order_.empty() ? 0 : static_cast<double>(overtakings(order_, ids));
  see("order", before + fresh / static_cast<double>(water), 0.01, time);
  order_ = std::move(ids);
}

// Kinetic energy and that of the water column, sum V (u^2 / 2 + g h / 2 + g b), and of vertical motion, (dh/dt)^2 / 6, where
// the equations have it: no wave, shock, friction or wall makes more of it. Compared with its smallest value so far, in units of the largest kinetic energy so far.
void Watch::look_at_energy(Simulation& simulation) {
  const ParticleStore& store = simulation.store();
  for (const int role : {2, 3, 4}) closed_ = closed_ && store.role_begin(role) == store.role_begin(role + 1);
  const Field *depth = store.find("depth"), *velocity = store.find("velocity"), *volume = store.find("volume");
  if (!closed_ || depth == nullptr || velocity == nullptr || volume == nullptr) return;
  const std::int64_t n = store.role_begin(1);
  const double *h = depth->component[0].data(), *v = volume->component[0].data();
  // A summation depth stands on the smoothed bed, fluxes between particles on the bed itself.
  const bool summed = store.find("extent") == nullptr && store.find("smoothed_bed_level") != nullptr;
  if (summed) simulation.refresh({"smoothed_bed_level"});
  std::vector<double> bed(static_cast<std::size_t>(n), 0.0);
  if (summed) {
    std::copy_n(store.data("smoothed_bed_level"), n, bed.data());
  } else {
    const riffle_services& services = simulation.services();
    services.bed(services.context, n, store.data("position"), store.dim() > 1 ? store.data("position", 1) : nullptr,
                 bed.data(), nullptr, nullptr);
  }
  const Field* rising = store.find("depth_rate");
  const double g = simulation.scene().gravity;
  double kinetic = 0, potential = 0, column = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    double u2 = 0;
    for (const auto& component : velocity->component) u2 += component.data()[i] * component.data()[i];
    if (rising != nullptr) u2 += std::pow(rising->component[0].data()[i], 2) / 3;
    kinetic += 0.5 * v[i] * u2;
    column += 0.5 * g * v[i] * h[i];
    potential += g * v[i] * bed[static_cast<std::size_t>(i)];
  }
  const double energy = kinetic + column + potential;
  liveliest_ = std::max(liveliest_, kinetic);
  if (!looked_) energy_ = energy;
  // 1e-6 of the column is water that moves with 1e-3 of its wave speed
  see("energy", (energy - energy_) / std::max(liveliest_, 1e-6 * column), 0.05, simulation.time());
  energy_ = std::min(energy_, energy);
}

std::vector<Verdict> Watch::verdicts() const {
  std::vector<Verdict> all;
  for (const auto& [name, sign] : signs_) {
    Verdict verdict;
    verdict.name = name;
    verdict.text = sentence(name, sign.value, sign.first >= 0 ? sign.where : "");
    verdict.severity = sign.first >= 0 ? Severity::suspect : Severity::note;
    verdict.value = sign.value;
    verdict.bound = sign.bound;
    if (sign.first >= 0) verdict.first_seen = sign.first;
    all.push_back(std::move(verdict));
  }
  return all;
}

nlohmann::json Watch::state() const {
  nlohmann::json signs = nlohmann::json::object();
  for (const auto& [name, s] : signs_) signs[name] = {s.value, s.bound, s.first, s.where};
  return {{"signs", signs},          {"order", order_},         {"depth_scale", depth_scale_}, {"energy", energy_},
          {"liveliest", liveliest_}, {"one_sided", one_sided_}, {"looked", looked_},           {"closed", closed_}};
}

void Watch::restore(const nlohmann::json& state) {
  for (const auto& [name, s] : state.at("signs").items()) {
    signs_[name] = {s.at(0).get<double>(), s.at(1).get<double>(), s.at(2).get<double>(), true,
                    s.at(3).get<std::string>()};
  }
  state.at("order").get_to(order_);
  state.at("depth_scale").get_to(depth_scale_);
  state.at("energy").get_to(energy_);
  state.at("liveliest").get_to(liveliest_);
  state.at("one_sided").get_to(one_sided_);
  state.at("looked").get_to(looked_);
  state.at("closed").get_to(closed_);
}

}  // namespace riffle
