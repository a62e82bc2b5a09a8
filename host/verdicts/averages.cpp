#include "host/verdicts/averages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riffle {

namespace {

constexpr double fewest = 0.2;  // particles in a bin per sample, as a share of a full row, below which it is no row

// Mean of the samples of one half of the window.
template <class Samples, class Value>
double mean_of(const Samples& samples, std::size_t first, std::size_t last, const Value& value) {
  double sum = 0;
  for (std::size_t k = first; k < last; ++k) sum += value(samples[k]);
  return last > first ? sum / static_cast<double>(last - first) : 0;
}

Verdict judged(const char* name, double value, double bound, std::string text) {
  Verdict verdict;
  verdict.name = name;
  verdict.text = std::move(text);
  verdict.value = value;
  verdict.bound = bound;
  verdict.severity = value <= bound ? Severity::note : Severity::suspect;
  return verdict;
}

}  // namespace

Averages::Averages(const Simulation& simulation, double from)
    : from_(from), density_(simulation.scene().density), gravity_(simulation.scene().gravity) {
  const ParticleStore& store = simulation.store();
  const auto up = static_cast<std::size_t>(store.dim() - 1);
  open_ = store.role_begin(2) < store.role_begin(4);
  if (store.role_begin(1) == 0) return;
  spacing_ = simulation.scene().placement.spacing;
  low_ = simulation.scene().lower[up];
  length_ = simulation.scene().upper[0] - simulation.scene().lower[0];
  if (store.dim() == 3) length_ *= (simulation.scene().upper[1] - simulation.scene().lower[1]) / spacing_;
  count_.assign(static_cast<std::size_t>(std::ceil((simulation.scene().upper[up] - low_) / spacing_ - 1e-9)), 0.0);
}

void Averages::sample(Simulation& simulation) {
  if (simulation.time() < from_ * (1 - 1e-12) || count_.empty()) return;
  simulation.refresh(averaged_fields());
  const ParticleStore& store = simulation.store();
  const std::int64_t n = store.role_begin(1);
  const int up = store.dim() - 1;
  const auto optional = [&](const char* name, int component) {
    const Field* field = store.find(name);
    return field != nullptr ? field->component[static_cast<std::size_t>(component)].data() : nullptr;
  };
  const double *z = store.data("position", up), *u = store.data("velocity", 0), *w = store.data("velocity", up);
  const double *mass = store.data("mass"), *pressure = optional("pressure", 0), *drag = optional("drag_rate", 0);
  const double *force = optional("body_force", 0), *modelled = optional("modelled_shear_stress", 0);
  const double* virial = optional("virial_shear_stress", 0);
  const auto array = [&](const char* name) -> std::vector<double>& {
    auto& sums = sums_[name];
    sums.resize(count_.size(), 0.0);
    return sums;
  };
  std::vector<double>&su = array("u"), &sw = array("w"), &suw = array("uw"), &suu = array("uu"), &sww = array("ww");
  std::vector<double>&sp = array("p"), &spp = array("pp"), &sm = array("modelled"), &sv = array("virial");
  Whole whole{simulation.time(), 0, 0, 0, 0, 0, 0};
  for (std::int64_t i = 0; i < n; ++i) {
    const double bin = (z[i] - low_) / spacing_;
    whole.mass += mass[i];
    whole.momentum += mass[i] * u[i];
    if (force != nullptr) whole.driving += mass[i] * force[i];
    if (drag != nullptr) whole.drag += mass[i] * drag[i] * u[i];
    if (!(bin >= 0) || bin >= static_cast<double>(count_.size())) continue;
    const auto k = static_cast<std::size_t>(bin);
    count_[k] += 1;
    su[k] += u[i];
    sw[k] += w[i];
    suw[k] += u[i] * w[i];
    suu[k] += u[i] * u[i];
    sww[k] += w[i] * w[i];
    if (pressure != nullptr) {
      // less the hydrostatic one of the bin's middle, so that a bin's spread is noise
      const double p = pressure[i] + density_ * gravity_ * (z[i] - (low_ + (std::floor(bin) + 0.5) * spacing_));
      sp[k] += p;
      spp[k] += p * p;
    }
    if (modelled != nullptr) sm[k] += modelled[i];
    if (virial != nullptr) sv[k] += virial[i];
  }
  whole.velocity = whole.mass > 0 ? whole.momentum / whole.mass : 0;
  // The surface by the levels of the highest particles: the mean over the topmost row's worth of them, half a spacing up.
  std::vector<double> levels(z, z + n);
  const auto row = std::clamp<std::int64_t>(std::llround(length_ / spacing_), 1, n);
  std::nth_element(levels.begin(), levels.end() - row, levels.end());
  double top = 0;
  for (auto k = levels.end() - row; k != levels.end(); ++k) top += *k;
  whole.depth = top / static_cast<double>(row) + 0.5 * spacing_ - low_;
  whole_.push_back(whole);
  ++samples_;
}

double Averages::sum(const std::string& name, std::size_t bin) const {
  const auto found = sums_.find(name);
  return found == sums_.end() ? 0 : found->second[bin];
}
double Averages::mean(const std::string& name, std::size_t bin) const {
  return sum(name, bin) / count_[bin];
}

// The shear stress at the bed of uniform flow: what drives the water, per area.
double Averages::stress_scale() const {
  const double driving = mean_of(whole_, 0, whole_.size(), [](const Whole& w) { return w.driving; });
  return std::abs(driving) / length_;
}

FlowAverages Averages::result() const {
  FlowAverages out;
  out.samples = samples_;
  if (samples_ == 0) return out;
  const double row = static_cast<double>(samples_) * length_ / spacing_;
  for (std::size_t k = 0; k < count_.size(); ++k) {
    if (count_[k] < fewest * row) continue;
    out.z.push_back(low_ + (static_cast<double>(k) + 0.5) * spacing_);
    const double u = mean("u", k), w = mean("w", k);
    out.velocity.push_back(u);
    out.rms_x.push_back(std::sqrt(std::max(0.0, mean("uu", k) - u * u)));
    out.rms_z.push_back(std::sqrt(std::max(0.0, mean("ww", k) - w * w)));
    out.modelled.push_back(mean("modelled", k));
    out.virial.push_back(mean("virial", k));
    out.resolved.push_back(-density_ * (mean("uw", k) - u * w));
    out.pressure.push_back(mean("p", k));
  }
  const std::size_t n = whole_.size();
  out.from = whole_.front().time;
  out.to = whole_.back().time;
  out.mean_velocity = mean_of(whole_, 0, n, [](const Whole& w) { return w.velocity; });
  out.depth = mean_of(whole_, 0, n, [](const Whole& w) { return w.depth; });
  const double driving = mean_of(whole_, 0, n, [](const Whole& w) { return w.driving; });
  if (n > 1 && driving != 0) {
    const double impulse = driving * (out.to - out.from);
    out.balance = 1 - (whole_.back().momentum - whole_.front().momentum) / impulse;
    out.drag_share = mean_of(whole_, 0, n, [](const Whole& w) { return w.drag; }) / driving;
  }
  return out;
}

std::vector<Verdict> Averages::verdicts() const {
  std::vector<Verdict> all;
  const FlowAverages flow = result();
  const std::size_t n = whole_.size();
  if (n < 4 || flow.z.empty()) return all;
  const auto velocity = [](const Whole& w) { return w.velocity; };
  const auto depth = [](const Whole& w) { return w.depth; };
  const double scale = std::max(std::abs(flow.mean_velocity), 1e-300);
  const double change = std::abs(mean_of(whole_, n / 2, n, velocity) - mean_of(whole_, 0, n / 2, velocity)) / scale;
  all.push_back(judged("steady", change, 0.01,
                       fmt::format("the mean velocity of the second half of the averages differs by {:.2g} % from that "
                                   "of the first",
                                   100 * change)));
  if (flow.balance) {
    const double off = std::abs(*flow.balance - 1);
    all.push_back(judged("balance", off, 0.02,
                         fmt::format("drag{} hold back {:.4g} of what drives the water",
                                     open_ ? ", walls and open ends" : " and walls", *flow.balance)));
    const double tau = stress_scale();
    double virial = 0;
    for (std::size_t k = 1; k + 1 < flow.z.size(); ++k) virial = std::max(virial, std::abs(flow.virial[k]) / tau);
    all.push_back(judged("virial", virial, 0.05,
                         fmt::format("pressure forces between particles carry up to {:.2g} % of the bed stress, which "
                                     "in a fluid they cannot",
                                     100 * virial)));
  }
  const double drift = std::abs(whole_.back().depth / whole_.front().depth - 1);
  const double end_drift = std::abs(mean_of(whole_, n - n / 4, n, depth) / mean_of(whole_, 0, n / 4, depth) - 1);
  all.push_back(
      judged("depth-drift", std::min(drift, end_drift), 0.05,
             fmt::format("the depth changed by {:.2g} % during the averages", 100 * std::min(drift, end_drift))));
  double noise = 0, w2 = 0, rows = 0;
  const double row = static_cast<double>(samples_) * length_ / spacing_;
  for (std::size_t k = 0; k < count_.size(); ++k) {
    if (count_[k] < fewest * row) continue;
    const double p = mean("p", k);
    noise += std::max(0.0, mean("pp", k) - p * p);
    w2 += mean("ww", k);
    rows += 1;
  }
  noise = std::sqrt(noise / rows) / (density_ * gravity_ * flow.depth);
  all.push_back(judged("pressure-noise", noise, 0.1,
                       fmt::format("pressures scatter by {:.2g} % of that at the bed", 100 * noise)));
  const double agitation = std::sqrt(w2 / rows) / scale;
  all.push_back(judged("agitation", agitation, 0.05,
                       fmt::format("vertical velocities are {:.2g} % of the mean velocity (rms)", 100 * agitation)));
  return all;
}

nlohmann::json Averages::state() const {
  nlohmann::json whole = nlohmann::json::array();
  for (const Whole& w : whole_) whole.push_back({w.time, w.velocity, w.depth, w.momentum, w.driving, w.drag, w.mass});
  return {{"samples", samples_}, {"count", count_}, {"sums", sums_}, {"whole", whole}};
}

void Averages::restore(const nlohmann::json& state) {
  state.at("samples").get_to(samples_);
  state.at("count").get_to(count_);
  state.at("sums").get_to(sums_);
  whole_.clear();
  for (const auto& w : state.at("whole"))
    whole_.push_back({w.at(0), w.at(1), w.at(2), w.at(3), w.at(4), w.at(5), w.at(6)});
}

}  // namespace riffle
