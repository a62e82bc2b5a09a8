#include "host/study/advise/plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>

#include "host/manifest/read.hpp"
#include "host/study/advise/channel.hpp"
#include "host/study/advise/column.hpp"
#include "host/study/advise/plane_probe.hpp"
#include "host/study/advise/scout.hpp"
#include "host/study/advise/temporary_folder.hpp"
#include "host/study/advise/uniform.hpp"
#include "host/study/advise/verify.hpp"
#include "host/study/attempt.hpp"

namespace riffle {
namespace {

constexpr double undriven = 1e-4;  // acceleration over gravity of water that stays where it is

class PlaneAdviser {
 public:
  PlaneAdviser(const AdviceRequest& request, const Case& scene, const Registry& registry,
               const std::vector<ModelNotes>& models, Advice& advice)
      : request_(request),
        scene_(scene),
        registry_(registry),
        models_(models),
        advice_(advice),
        scales_(probe_plane(scene, registry)) {}

  void advise() {
    add_figures();
    advice_.cpu_given = estimated_cost(request_, quiet_output(), registry_);
    const double gravity = scene_.gravity > 0 ? scene_.gravity : 9.81;  // of a scene without: as if it had some
    const bool still = scales_.initial_speed < 1e-3 * std::sqrt(gravity * scales_.depth);
    if (still && scales_.driving < undriven * gravity && scales_.drop < 1.5 * scales_.spacing) {
      rest();
      return;
    }
    const bool uniform = uniform_along_x(scene_);
    add("change along the flow", uniform ? 0 : 1,
        uniform ? "nothing in the scene knows where along x it is" : "the scene is not the same everywhere along x",
        "");
    add_drag();
    add_eddies();
    add("viscosity of the water", scales_.laminar_stress,
        "its stress over the force that drives the water, at the speed above", switch_off("laminar"));
    add_sound();
    if (uniform && is_developed() && propose_column()) return;
    if (!uniform) judge_as_channel();
    propose_parts();
    if (!channel_.empty()) propose_channel();
  }

 private:
  void figure(const char* key, const char* name, const char* unit, double value) {
    if (std::isfinite(value)) advice_.figures.push_back({key, name, unit, value});
  }
  void add(const std::string& name, double contributes, const std::string& how, const std::string& change) {
    Term term;
    term.name = name;
    term.contributes = contributes;
    term.how = how;
    term.kept = !(contributes <= request_.tolerance);
    advice_.terms.push_back(term);
    if (change.empty()) return;
    part_of_[name] = change;
    if (!term.kept) parts_.push_back(change);
  }

  void add_figures() {
    const double nu = scene_.viscosity, none = std::numeric_limits<double>::quiet_NaN();
    figure("mean_depth", "mean depth of the columns of water", "m", scales_.depth);
    figure("depth_over_length", "depth over length of the water", "1", scales_.depth / scales_.length);
    figure("particles_over_depth", "particles over the depth", "1", scales_.depth / scales_.spacing);
    figure("driving_acceleration", "what drives the water along x", "m/s2", scales_.driving);
    figure("driving", "the same over gravity", "1", scene_.gravity > 0 ? scales_.driving / scene_.gravity : none);
    figure("speed", "speed that this brings it to", "m/s", scales_.speed);
    figure("froude_number", "Froude number", "1", scales_.speed / std::sqrt(scene_.gravity * scales_.depth));
    figure("reynolds_number", "Reynolds number of the depth", "1", nu > 0 ? scales_.speed * scales_.depth / nu : none);
    figure("mach_number", "speed over that of sound", "1",
           scales_.sound_speed > 0 ? scales_.speed / scales_.sound_speed : none);
    if (scales_.porous) figure("porosity", "smallest porosity", "1", scales_.smallest_porosity);
    if (scales_.grain > 0) {
      figure("grains_over_depth", "grain over depth", "1", scales_.grain / scales_.depth);
      figure("pore_reynolds_number", "Reynolds number of the grains", "1",
             nu > 0 ? scales_.speed * scales_.grain / nu : none);
    }
    if (scales_.has_drag()) {
      figure("drag_share", "share of the water on which drag acts", "1", scales_.drag_share);
      figure("form_drag", "share of drag that grows with speed", "1",
             scales_.whole_drag > 0 ? 1 - scales_.viscous_drag / scales_.whole_drag : none);
      figure("grain_time_over_step", "time scale of drag over the time step", "1",
             scales_.whole_drag > 0 ? 1 / (scales_.whole_drag * scales_.step) : none);
    }
  }

  void rest() {
    Term motion;
    motion.name = "motion";
    motion.contributes = 0;
    motion.how = fmt::format("columns of water accelerate by {:.1e} m/s2", scales_.driving);
    advice_.terms.push_back(motion);
    advice_.model = "none: nothing drives the water, and its initial state is the answer; one step shows it";
    advice_.proposal = {"time.max_steps=1"};
    advice_.cpu_proposed = estimated_cost_of_one_step();
  }

  void add_drag() {
    if (!scales_.has_drag()) return;
    const double force = scales_.whole_drag * scales_.speed * scales_.drag_share;
    add("drag", force / std::max(scales_.driving, force), "its force over that which drives the water", "");
    if (scales_.whole_drag > 0) {
      add("viscous part of drag", scales_.viscous_drag / scales_.whole_drag,
          "drag of water at rest over that at the speed above", "");
      add("form part of drag", 1 - scales_.viscous_drag / scales_.whole_drag, "the rest of it", "");
    }
    if (scales_.whole_drag * scales_.step > 1)
      advice_.notes.push_back(fmt::format(
          "drag acts within {:.2g} time steps: time.drag must stay implicit, or the step be cut to {:.2g} s",
          1 / (scales_.whole_drag * scales_.step), 1 / scales_.whole_drag));
  }

  void add_eddies() {
    if (chosen(scene_, "turbulence") == nullptr) return;
    add("eddies", scales_.eddy_stress, "stress of a parabola of that speed over the force that drives the water",
        in_slots("plugins.turbulence.id=none", scene_));
  }

  // A switch of the equation set that is on: what turns it off.
  [[nodiscard]] std::string switch_off(const std::string& name) const {
    for (const ParameterValue& value : chosen(scene_, "equations")->values) {
      if (value.name == name && value.number != 0) return in_slots("plugins.equations." + name + "=false", scene_);
    }
    return "";
  }

  // Ten times the fastest water and the fastest wave keeps the density within a hundredth (Monaghan 1994).
  void add_sound() {
    if (!(scales_.sound_speed > 0)) return;
    add("compressibility", std::pow(scales_.speed / scales_.sound_speed, 2), "the square of the Mach number", "");
    const double needed = 10 * std::max(scales_.speed, std::sqrt(scene_.gravity * scales_.depth));
    if (needed > 0 && scales_.sound_speed > 1.2 * needed) {
      parts_.push_back(in_slots(fmt::format("plugins.equations.sound_speed={:.2g}", needed), scene_));
      advice_.notes.push_back(
          fmt::format("a speed of sound of {:.2g} m/s is ten times the fastest wave; {:.3g} m/s takes "
                      "{:.2g} times as many steps",
                      needed, scales_.sound_speed, scales_.sound_speed / needed));
    }
  }

  // s: several times that in which the driving force alone brings the water to its speed.
  [[nodiscard]] double development_time() const { return 3 * scales_.speed / scales_.driving; }

  [[nodiscard]] bool begins_developed() const { return scales_.initial_speed > 0.3 * scales_.speed; }

  // Whether the water has the time to come to a steady profile, or begins with one.
  bool is_developed() {
    if (scene_.time.end >= development_time() || begins_developed()) return true;
    advice_.notes.push_back(
        "the flow is the same everywhere along x but still speeds up at the end: a column of steady flow "
        "is what it would come to");
    return false;
  }

  [[nodiscard]] double estimated_cost_of_one_step() const {
    AdviceRequest one = request_;
    one.overrides.insert(one.overrides.end(), advice_.proposal.begin(), advice_.proposal.end());
    one.overrides.push_back(fmt::format("time.end={:.3g}", scales_.step));
    return estimated_cost(one, quiet_output(), registry_);
  }

  bool propose_column() {
    std::string obstacle;
    for (const ModelNotes& model : models_) {
      if (!model.keeps_term(over_the_depth) || model.keeps_term(along_the_flow)) continue;
      const bool has_it = scene_.reference && scene_.reference->plugin.id == model.plugin->id;  // and knows it best
      if (!has_it && !has_closures_of(model, scene_)) continue;
      Overrides proposal{"time.max_steps=1"};
      if (!has_it) proposal.push_back("reference.id=" + model.plugin->id);
      for (const ParameterDescription& parameter : model.plugin->parameters) {
        if (has_it || !parameter.inherit.empty()) continue;
        const std::string value = column_value(model, parameter, scene_, scales_);
        if (!value.empty()) proposal.push_back("reference." + parameter.name + '=' + value);
      }
      Overrides all = request_.overrides;
      for (const Overrides& changes : {proposal, quiet_output()}) all.insert(all.end(), changes.begin(), changes.end());
      const Trial trial = attempt(request_.manifest, all, registry_);
      if (!trial.refusals.empty()) {
        obstacle = trial.refusals.front();
        continue;
      }
      advice_.proposal = proposal;
      advice_.model = model.plugin->id +
                      ": a column of water, solved once; one step writes it beside the particles, exact in profile.csv";
      for (Term& term : advice_.terms) {
        if (term.name == "compressibility") term.kept = false;
      }
      advice_.cpu_proposed = estimated_cost_of_one_step();
      if (request_.verify) verify_column();
      return true;
    }
    advice_.notes.push_back("a column of water would tell all, and no installed one has these closures" +
                            (obstacle.empty() ? std::string() : ": " + obstacle));
    return false;
  }

  // What depth-averaging would leave out: the same columns as a channel, judged by its rules.
  void judge_as_channel() {
    for (const ModelNotes& model : models_) {
      if (model.plugin->kind != "equations" || !model.keeps_term(along_the_flow)) continue;
      const ChannelManifest channel = as_channel(scene_, scales_.columns, model, registry_);
      if (channel.text.empty()) {
        advice_.notes.push_back("no depth-averaged model is weighed, for " + channel.obstacle);
        return;
      }
      const TemporaryFolder folder;
      AdviceRequest request = request_;
      request.manifest = folder.path() / "channel.toml";
      request.overrides.clear();
      request.verify = false;
      std::ofstream(request.manifest) << channel.text;
      Advice shallow;
      try {
        advise_on_channel(request, read_case(request.manifest, {}, registry_), registry_, models_, shallow);
      } catch (const std::exception& error) {
        advice_.notes.push_back(std::string("no depth-averaged model is weighed: ") + error.what());
        return;
      }
      const Term& dispersion = shallow.terms.front();
      add(vertical_acceleration, dispersion.contributes, "the same columns as a channel: " + dispersion.how, "");
      Overrides least = shallow.proposal;
      if (dispersion.trial) least = dispersion.trial->without;
      advice_.terms.back().trial = pair_of(least, {});
      advice_.terms.back().trial->manifest_without = channel.text;
      channel_ = channel.text;
      channel_changes_ = shallow.proposal;
      channel_model_ = shallow.model;
      return;
    }
  }

  void propose_channel() {
    const auto found = std::find_if(advice_.terms.begin(), advice_.terms.end(),
                                    [](const Term& term) { return term.name == vertical_acceleration; });
    found->kept = found->matters(request_.tolerance);
    if (!found->kept) {
      advice_.manifest = channel_;
      advice_.proposal = channel_changes_;
      advice_.model = channel_model_ + ", from the manifest below";
      const TemporaryFolder folder;
      AdviceRequest request;
      request.manifest = folder.path() / "channel.toml";
      std::ofstream(request.manifest) << channel_;
      advice_.cpu_proposed = estimated_cost(request, with_quiet(channel_changes_), registry_);
    }
  }

  void verify() {
    verify_terms(request_,
                 {scene_.lower[0],
                  scene_.upper[0],
                  {scene_.lower[0], scene_.upper[0]},
                  scales_.spacing,
                  scene_.time.end,
                  [&](const Overrides& changes) {
                    return advice_.cpu_given * number_in(changes, "time.end", scene_.time.end) / scene_.time.end;
                  }},
                 advice_);
  }

  void verify_column() {
    Term& along = advice_.terms.front();
    TermTrial trial;
    trial.against_reference = true;
    trial.without = trial.with = advice_.proposal;
    trial.with.erase(std::find(trial.with.begin(), trial.with.end(), "time.max_steps=1"));
    const double turns = 20 * scales_.depth / scales_.speed;  // of water that begins as it ends
    const double steady = std::min(scene_.time.end, begins_developed() ? turns : development_time());
    const double cost = advice_.cpu_given * steady / scene_.time.end;
    if (cost > request_.budget) {
      trial.problem =
          fmt::format("particles would take {:.2g} s of CPU time to become steady, which --budget {:.0f} allows", cost,
                      10 * std::ceil(0.1 * cost));
      along.trial = trial;
      return;
    }
    trial.with.push_back(fmt::format("time.end={:.3g}", steady));
    along.trial = trial;
    along.how +=
        "; measured: by how much the velocity of the particles, when it is steady, differs from the column's, which is "
        "their own error";
    verify();
  }

  // What may be left out by its estimate is left out in a run, and what the surface says decides.
  void verify_parts() {
    for (Term& term : advice_.terms) {
      const auto found = part_of_.find(term.name);
      if (found != part_of_.end()) term.trial = pair_of({found->second}, {});
    }
    verify();
    for (Term& term : advice_.terms) {
      if (!term.trial || !term.trial->done) continue;
      term.kept = term.matters(request_.tolerance);
      const auto part = part_of_.find(term.name);
      if (part == part_of_.end()) continue;
      const std::string& change = part->second;
      parts_.erase(std::remove(parts_.begin(), parts_.end(), change), parts_.end());
      if (!term.kept) parts_.push_back(change);
    }
  }

  void propose_parts() {
    if (request_.verify) verify_parts();
    advice_.proposal = parts_;
    advice_.model =
        chosen(scene_, "equations")->id + (parts_.empty() ? " as it is: nothing that it has can be left out"
                                                          : " without what changes less than the tolerance");
    advice_.cpu_proposed = parts_.empty() ? advice_.cpu_given : estimated_cost(request_, with_quiet(parts_), registry_);
  }
  [[nodiscard]] static Overrides with_quiet(Overrides changes) {
    for (const std::string& change : quiet_output()) changes.push_back(change);
    return changes;
  }

  const AdviceRequest& request_;
  const Case& scene_;
  const Registry& registry_;
  const std::vector<ModelNotes>& models_;
  Advice& advice_;
  PlaneScales scales_;
  Overrides parts_, channel_changes_;
  std::string channel_, channel_model_;         // the scene as a channel, where it can be one
  std::map<std::string, std::string> part_of_;  // of terms that can be left out: by what
};

}  // namespace

void advise_on_plane(const AdviceRequest& request, const Case& scene, const Registry& registry,
                     const std::vector<ModelNotes>& models, Advice& advice) {
  PlaneAdviser(request, scene, registry, models, advice).advise();
}

}  // namespace riffle
