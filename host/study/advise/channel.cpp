#include "host/study/advise/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host/study/advise/channel_figures.hpp"
#include "host/study/advise/verify.hpp"
#include "host/study/attempt.hpp"

namespace riffle {
namespace {

constexpr double patience = 5;           // s of CPU for one scout
constexpr int fewest = 200, most = 800;  // particles of a scout
constexpr int most_in_trials = 4000;
constexpr double at_rest = 1e-3;      // Froude number of water that stands still
constexpr double steady_share = 0.7;  // of the time, after which ending early is not worth a line

Overrides operator+(Overrides a, const Overrides& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Overrides with_count(double count) {
  return {fmt::format("initial.particles.count={:.0f}", std::ceil(count))};
}

std::string two_digits_up(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return fmt::format("{:g}", std::ceil(value / digit - 1e-9) * digit);
}

// A refusal without the file and line in front of it, which are those of the case as it was given.
std::string without_place(const std::string& line) {
  const std::size_t sentence = line.find(": ");
  return sentence == std::string::npos ? line : line.substr(sentence + 2);
}

class ChannelAdviser {
 public:
  ChannelAdviser(const AdviceRequest& request, const Case& scene, const Registry& registry,
                 const std::vector<ModelNotes>& models, Advice& advice)
      : request_(request), scene_(scene), registry_(registry), models_(models), advice_(advice) {
    region_ = {scene.lower[0], scene.upper[0]};
    if (scene.reference && scene.reference->region) region_ = *scene.reference->region;
  }

  void advise() {
    choose_scout();
    scales_ = scales_of(scout_, scene_, request_.tolerance);
    steady_ = scales_.steady_from < steady_share * scout_.last().time;
    dispersion_ = estimate_dispersion(scout_, scene_.gravity, steady_);
    advice_.figures = figures_of(scales_, dispersion_, scene_);
    if (scales_.froude < at_rest && apart(scout_.last(), scout_.states.front()) <= request_.tolerance) {
      advise_on_rest();
      return;
    }
    add_vertical_acceleration();
    add_friction();
    add_time();
    add_particles();
    if (request_.verify) verify();
    propose();
  }

 private:
  // By the scout's cost, which grows with the square of the number of particles; other models are up to three times dearer.
  void verify() {
    const auto cost = [&](const Overrides& changes) {
      const double ratio = number_in(changes, "initial.particles.count", scout_.particles) / scout_.particles;
      return 3 * scout_.cpu_seconds * ratio * ratio;
    };
    verify_terms(request_, {scout_.line.low, scout_.line.high, region_, 0, scout_.last().time, cost}, advice_);
  }

  [[nodiscard]] double apart(const FlowState& a, const FlowState& b) const {
    return relative_difference(scout_.line, a.depth, b.depth, region_[0], region_[1]);
  }
  [[nodiscard]] Scout run_scout(const Overrides& changes, double count) const {
    return scout(request_, changes + with_count(count), cells_, registry_, patience);
  }

  // The least model that can run the case, on as many particles as show what the depth tells.
  void choose_scout() {
    std::string problem = "no model of flow along a channel is installed";
    for (const ModelNotes& model : models_) {
      if (model.plugin->kind != "equations" || !model.keeps_term(along_the_flow) ||
          model.keeps_term(vertical_acceleration))
        continue;
      const Overrides changes = overrides_for(model, scene_, false);
      const Scout look = scout(request_, changes + with_count(fewest) + Overrides{"time.max_steps=1"}, fewest,
                               registry_, 1e-3);  // the first state is all that is wanted
      if (look.states.empty()) {
        problem = look.problem;
        continue;
      }
      const FlowState& first = look.states.front();
      const bool dry = std::any_of(first.depth.begin(), first.depth.end(), [](double h) { return !(h > 0); });
      if (dry && model.needs_water_everywhere) continue;
      const double depth = *std::max_element(first.depth.begin(), first.depth.end());
      cells_ = static_cast<int>(std::clamp(2 * (look.line.high - look.line.low) / depth, 1.0 * fewest, 1.0 * most));
      scout_ = run_scout(changes, cells_);
      if (scout_.states.size() > 2) {
        if (!scout_.good()) {
          advice_.notes.push_back(
              fmt::format("judged up to t = {:.3g} s only: {}", scout_.last().time, scout_.problem));
          scout_.problem.clear();
        }
        model_ = &model;
        least_ = changes;
        return;
      }
      problem = scout_.problem;
    }
    throw std::runtime_error("no model of flow along a channel can run this case: " + problem);
  }

  void advise_on_rest() {
    Term motion;
    motion.name = "motion";
    motion.contributes = apart(scout_.last(), scout_.states.front());
    motion.how = "last state of a scout against its first";
    const Overrides changes = least_ + with_count(fewest);
    motion.trial = pair_of(changes + Overrides{"time.max_steps=1"}, changes);
    advice_.terms.push_back(motion);
    if (request_.verify) verify();
    advice_.terms.front().kept = motion.matters(request_.tolerance);
    advice_.model = "none: the water is at rest, and its initial state is the answer; one step shows it";
    advice_.proposal = motion.trial->without;
    const double waves = unevenness();
    if (waves > 1e-9) {
      advice_.model = "none: its initial state is the answer within the tolerance; one step shows it";
      advice_.notes.push_back(
          fmt::format("there are waves of {:.2g} % of the depth, which is below the tolerance: --tolerance "
                      "{:.1g} judges by a twentieth of them",
                      100 * waves, 0.05 * waves));
    }
    add_costs();
  }

  // Mean deviation of the level at t = 0 from its mean, over the depth.
  [[nodiscard]] double unevenness() const {
    const FlowState& first = scout_.states.front();
    double level = 0, wet = 0, deviation = 0;
    for (std::size_t k = 0; k < first.depth.size(); ++k) {
      if (!(first.depth[k] > 0)) continue;
      level += first.depth[k] + scout_.line.bed[k];
      wet += 1;
    }
    for (std::size_t k = 0; k < first.depth.size(); ++k) {
      if (first.depth[k] > 0) deviation += std::abs(first.depth[k] + scout_.line.bed[k] - level / wet);
    }
    return deviation / wet / scales_.depth;
  }

  void add_vertical_acceleration() {
    Term term;
    term.name = vertical_acceleration;
    term.contributes = dispersion_.total();
    term.how = dispersion_.strongest_front > 0
                   ? fmt::format("fronts that rise by {:.3g} of the depth before them{}", dispersion_.strongest_front,
                                 dispersion_.breaks ? ", and break" : "")
                   : "pressure of vertical acceleration in a scout";
    for (const ModelNotes& model : models_) {
      if (model.plugin->kind != "equations" || !model.keeps_term(vertical_acceleration) ||
          model.keeps_term(over_the_depth))
        continue;
      const double length = scout_.line.high - scout_.line.low;
      richer_count_ = std::clamp(model.cells_per_depth * length / scales_.deepest, 1.0 * cells_, 1.0 * most_in_trials);
      const Overrides count = with_count(richer_count_);
      const Overrides changes = overrides_for(model, scene_, dispersion_.breaks);
      const Trial trial = attempt(request_.manifest, request_.overrides + changes + count + quiet_output(), registry_);
      if (!trial.refusals.empty()) {
        if (term.obstacle.empty()) term.obstacle = without_place(trial.refusals.front());
        continue;
      }
      term.obstacle.clear();
      term.trial = pair_of(least_ + count, changes + count);
      richer_ = &model;
      break;
    }
    advice_.terms.push_back(term);
  }

  [[nodiscard]] bool has_drag() const {
    return std::any_of(scene_.plugins.begin(), scene_.plugins.end(),
                       [](const PluginChoice& choice) { return choice.kind == "drag" && choice.id != "none"; });
  }

  // Friction by Darcy's factor, whichever plugin has it: 0 for none, Blasius' for a bed as smooth as glass.
  [[nodiscard]] Overrides friction_of(double factor) const {
    for (const PluginDescription* plugin : registry_.all()) {
      if (plugin->kind != "drag") continue;
      for (const ParameterDescription& parameter : plugin->parameters) {
        if (parameter.name == "friction_factor")
          return {in_slots("plugins.drag.id=" + plugin->id, scene_),
                  in_slots(fmt::format("plugins.drag.friction_factor={:.4g}", factor), scene_)};
      }
    }
    return {};
  }

  void add_friction() {
    Term term;
    term.name = "bed friction";
    const Overrides count = with_count(cells_);
    Overrides other;
    if (has_drag()) {
      other = drag_off_ = friction_of(0);
      term.how = "a scout with it against one without";
      if (!other.empty()) term.trial = pair_of(least_ + other + count, least_ + count);
    } else {
      other = friction_of(0.316 / std::pow(std::max(4 * scales_.reynolds, 1.0), 0.25));
      term.how = "a scout over a bed as smooth as glass against one without friction";
      term.obstacle = "the case leaves it out";
      if (!other.empty()) term.trial = pair_of(least_ + count, least_ + other + count);
    }
    term.contributes = std::numeric_limits<double>::quiet_NaN();
    if (!other.empty()) {
      const Scout variant = run_scout(least_ + other, cells_);
      if (variant.states.size() == scout_.states.size())
        term.contributes = has_drag() ? apart(variant.last(), scout_.last()) : apart(scout_.last(), variant.last());
      if (!variant.good()) term.how = variant.problem;
    }
    advice_.terms.push_back(term);
  }

  void add_time() {
    if (!steady_ || !(scales_.steady_from > 0)) return;
    Term term;
    term.name = "time after it is steady";
    const std::string end = two_digits_up(scales_.steady_from);
    for (const FlowState& state : scout_.states) {
      if (state.time >= scales_.steady_from * (1 - 1e-9)) {
        term.contributes = apart(state, scout_.last());
        break;
      }
    }
    term.how = fmt::format("a scout at t = {} s against its end", end);
    const Overrides changes = least_ + with_count(cells_);
    term.trial = pair_of(changes + Overrides{"time.end=" + end}, changes);
    early_end_ = "time.end=" + end;
    advice_.terms.push_back(term);
  }

  // Halving the spacing of a scheme that loses a first order at fronts leaves half of the error.
  void add_particles() {
    const Scout coarse = run_scout(least_, std::max(cells_ / 2, 100));
    if (coarse.states.size() != scout_.states.size()) return;
    const double error = apart(coarse.last(), scout_.last());  // of the scout, once more halved
    count_ = std::clamp(cells_ * error / (0.5 * request_.tolerance), 100.0, given_count());
    Term term;
    term.name = "twice as many particles";
    term.contributes = 0.5 * error * cells_ / count_;
    term.how = fmt::format("scouts of {} and {} particles", coarse.particles, scout_.particles);
    term.trial = pair_of(least_ + with_count(count_), least_ + with_count(2 * count_));
    advice_.terms.push_back(term);
  }

  [[nodiscard]] double given_count() const {
    if (scene_.placement.mode != Placement::Mode::spacing) return static_cast<double>(scene_.placement.count);
    return std::max(100.0, (scout_.line.high - scout_.line.low) / scene_.placement.spacing);
  }

  Term* term(const std::string& name) {
    const auto found =
        std::find_if(advice_.terms.begin(), advice_.terms.end(), [&](const Term& one) { return one.name == name; });
    return found == advice_.terms.end() ? nullptr : &*found;
  }

  void propose() {
    const double tolerance = request_.tolerance;
    Term* const dispersion = term(vertical_acceleration);
    dispersion->kept = richer_ != nullptr && dispersion->matters(tolerance);
    Overrides proposal = dispersion->kept ? overrides_for(*richer_, scene_, dispersion_.breaks) : least_;
    advice_.model = dispersion->kept ? richer_->plugin->id + ": flow along the channel with vertical acceleration"
                                     : model_->plugin->id + ": hydrostatic flow along the channel";
    if (dispersion->kept && dispersion_.breaks && !richer_->remark_where_water_breaks.empty())
      advice_.notes.push_back(richer_->remark_where_water_breaks);
    Term* const finer = term("twice as many particles");
    double count = finer != nullptr ? count_ : given_count();
    if (finer != nullptr && finer->matters(tolerance)) {
      count = std::min(count * std::ceil(finer->best() / tolerance), given_count());
    }
    proposal = proposal + with_count(dispersion->kept ? std::max(count, richer_count_) : count);
    Term* const friction = term("bed friction");
    friction->kept = has_drag() && !(friction->best() <= tolerance);
    advice_.model += friction->kept ? ", with bed friction" : ", without bed friction";
    if (has_drag() && !friction->kept) proposal = proposal + drag_off_;
    if (Term* const time = term("time after it is steady")) {
      time->kept = time->matters(tolerance);
      if (!time->kept) {
        proposal.push_back(early_end_);
        advice_.model += ", until it is steady";
      }
    }
    advice_.proposal = proposal;
    if (dispersion->matters(tolerance) && !dispersion->kept)
      advice_.notes.push_back("vertical acceleration matters, and no installed model can keep it here: " +
                              dispersion->obstacle);
    if (!has_drag() && friction->best() > tolerance)
      advice_.notes.push_back(
          fmt::format("the case has no bed friction; a real bed would change the depth by at least {:.2g} %",
                      100 * friction->best()));
    add_costs();
  }

  void add_costs() {
    advice_.cpu_given = estimated_cost(request_, quiet_output(), registry_);
    advice_.cpu_proposed = estimated_cost(request_, advice_.proposal + quiet_output(), registry_);
  }

  const AdviceRequest& request_;
  const Case& scene_;
  const Registry& registry_;
  const std::vector<ModelNotes>& models_;
  Advice& advice_;
  std::array<double, 2> region_{};
  const ModelNotes *model_ = nullptr, *richer_ = nullptr;
  Overrides least_;
  Overrides drag_off_;
  std::string early_end_;
  int cells_ = fewest;
  double count_ = 0, richer_count_ = 0;
  Scout scout_;
  ChannelScales scales_;
  DispersionEstimate dispersion_;
  bool steady_ = false;
};

}  // namespace

void advise_on_channel(const AdviceRequest& request, const Case& scene, const Registry& registry,
                       const std::vector<ModelNotes>& models, Advice& advice) {
  ChannelAdviser(request, scene, registry, models, advice).advise();
}

}  // namespace riffle
