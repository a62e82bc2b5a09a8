#include "host/study/advise/plane_probe.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>

#include "host/time/simulation.hpp"

namespace riffle {
namespace {

// The scene at rest, whose velocities can be set.
class Probe {
 public:
  Probe(const Case& scene, const Registry& registry) : scene_(scene), simulation_(scene, registry, one_thread()) {}

  PlaneScales run() {
    measure_water();
    read_parameters();
    measure_porosity();
    const std::vector<double> at_rest = velocities();
    if (simulation_.graph().field("drag_rate") >= 0) scales_.viscous_drag = mean_drag(1e-9);
    put(at_rest);
    measure_driving();
    find_speed();
    measure_stress();
    return scales_;
  }

 private:
  static SimulationOptions one_thread() {
    SimulationOptions options;
    options.threads = 1;
    return options;
  }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(simulation_.store().role_begin(1)); }
  [[nodiscard]] int up() const { return scene_.dimension - 1; }
  [[nodiscard]] double wave_speed() const { return std::sqrt(scene_.gravity * scales_.depth); }
  [[nodiscard]] std::size_t column(std::size_t i) const {
    return static_cast<std::size_t>((simulation_.store().data("position")[i] - scene_.lower[0]) /
                                    (2 * scales_.spacing));
  }

  void measure_water() {
    const ParticleStore& store = simulation_.store();
    const double *x = store.data("position"), *z = store.data("position", up()), *cell = store.data("cell_measure");
    scales_.particles = static_cast<std::int64_t>(count());
    if (count() == 0) throw std::runtime_error("there is no water in the scene");
    scales_.spacing = std::pow(cell[0], 1.0 / scene_.dimension);
    std::map<std::size_t, std::pair<double, double>> ends;  // of each column
    for (std::size_t i = 0; i < count(); ++i) {
      auto& [low, high] = ends.try_emplace(column(i), z[i], z[i]).first->second;
      low = std::min(low, z[i]);
      high = std::max(high, z[i]);
    }
    double sum = 0, squares = 0;
    for (const auto& [k, end] : ends) {
      const double height = end.second - end.first + scales_.spacing;
      sum += height;
      squares += height * height;
    }
    const auto cells =
        static_cast<std::size_t>(std::ceil((scene_.upper[0] - scene_.lower[0]) / (2 * scales_.spacing) - 1e-9));
    scales_.columns = {scene_.lower[0], scene_.lower[0] + 2 * scales_.spacing * static_cast<double>(cells),
                       scales_.spacing, std::vector<double>(cells, 0), std::vector<double>(cells, 0)};
    double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
    for (const auto& [k, end] : ends) {
      lowest = std::min(lowest, end.second);
      highest = std::max(highest, end.second);
      if (k >= cells) continue;
      scales_.columns.bottom[k] = end.first - 0.5 * scales_.spacing;
      scales_.columns.height[k] = end.second - end.first + scales_.spacing;
    }
    scales_.drop = highest - lowest;
    const auto n = static_cast<double>(ends.size());
    scales_.bottom = *std::min_element(z, z + count()) - 0.5 * scales_.spacing;
    scales_.depth = sum / n;
    scales_.unevenness = std::sqrt(std::max(0.0, squares / n - scales_.depth * scales_.depth)) / scales_.depth;
    const auto [first, last] = std::minmax_element(x, x + count());
    scales_.length = *last - *first + scales_.spacing;
  }

  void read_parameters() {
    for (const PluginChoice& choice : scene_.plugins) {
      for (const ParameterValue& value : choice.values) {
        if (value.name == "sound_speed") scales_.sound_speed = value.number;
        if (choice.kind == "drag" && value.name == "grain_diameter") scales_.grain = value.number;
      }
    }
  }

  void measure_porosity() {
    if (simulation_.graph().field("porosity") < 0) return;
    simulation_.refresh({"porosity"});
    if (simulation_.store().find("porosity") == nullptr) return;
    const double* porosity = simulation_.store().data("porosity");
    for (std::size_t i = 0; i < count(); ++i)
      scales_.smallest_porosity = std::min(scales_.smallest_porosity, porosity[i]);
    scales_.porous = scales_.smallest_porosity < 1;
  }

  [[nodiscard]] std::vector<double> velocities() const {
    const double* u = simulation_.store().data("velocity");
    return {u, u + count()};
  }
  void put(const std::vector<double>& along_x) {
    std::copy(along_x.begin(), along_x.end(), simulation_.store().data("velocity"));
    simulation_.evaluator().changed(simulation_.graph().field("velocity"));
  }

  // Of the water on which it acts, when all water moves at this speed.
  double mean_drag(double speed) {
    put(std::vector<double>(count(), speed));
    simulation_.refresh({"drag_rate"});
    if (simulation_.store().find("drag_rate") == nullptr) return 0;
    const double* rate = simulation_.store().data("drag_rate");
    double sum = 0, acts = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      sum += rate[i];
      acts += rate[i] > 0 ? 1 : 0;
    }
    scales_.drag_share = std::max(scales_.drag_share, acts / static_cast<double>(count()));
    return acts > 0 ? sum / acts : 0;
  }

  // From rest, for a flow that begins steady has nothing left that drives it. Columns as a whole, so that settling between particles does not count, and by how much they gain in the second half of a
  // time in which sound crosses the water twice and twice again: what settles does not go on.
  void measure_driving() {
    constexpr int fewest_steps = 60;
    constexpr double longest = 1.5;  // s
    const double way = std::min(2 * std::max(scales_.length, scales_.depth), 8 * scales_.depth);
    const double crossings = std::min(scales_.sound_speed > 0 ? way / scales_.sound_speed : 0, 0.4 * scene_.time.end);
    for (const double u : velocities()) scales_.initial_speed += std::abs(u) / static_cast<double>(count());
    const std::vector<double> before(count(), 0);
    put(before);
    const auto go_on = [&](int half) {
      const std::clock_t start = std::clock();
      const double until = simulation_.time() + crossings;
      for (int k = 0;
           (k < fewest_steps || simulation_.time() < until) && simulation_.time() < 0.5 * scene_.time.end * (1 + half);
           ++k) {
        scales_.step = simulation_.step(scene_.time.end).dt;
        if (static_cast<double>(std::clock() - start) > longest * CLOCKS_PER_SEC) break;
      }
      return simulation_.time();
    };
    const double first_time = go_on(0), first = gained(before), second_time = go_on(1), second = gained(before);
    const double gain = second_time > first_time ? (second - first) / (second_time - first_time) : 0;
    scales_.driving = std::max(0.0, gain) + held_back();
  }

  // What drag takes from the columns now: seepage is steady within a few steps, and driven all the same.
  double held_back() {
    if (simulation_.graph().field("drag_rate") < 0) return 0;
    simulation_.refresh({"drag_rate"});
    if (simulation_.store().find("drag_rate") == nullptr) return 0;
    const double *rate = simulation_.store().data("drag_rate"), *u = simulation_.store().data("velocity");
    std::map<std::size_t, double> columns;
    for (std::size_t i = 0; i < count(); ++i) columns[column(i)] += rate[i] * u[i];
    double total = 0;
    for (const auto& [k, sum] : columns) total += std::abs(sum);
    return total / static_cast<double>(count());
  }

  [[nodiscard]] double gained(const std::vector<double>& before) const {
    const std::vector<double> now = velocities();
    const std::size_t n = std::min(before.size(), now.size());
    std::map<std::size_t, double> columns;
    double was = 0;
    for (std::size_t i = 0; i < n; ++i) was += before[i] / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) columns[column(i)] += now[i] - was;
    double total = 0;
    for (const auto& [k, sum] : columns) total += std::abs(sum);
    return total / static_cast<double>(n);
  }

  // What is driven moves at the speed of its waves at most, at ten shear velocities where it is long, and where a drag acts
  // on all of it, as fast as that lets it.
  void find_speed() {
    const double driven = scales_.driving * scene_.time.end;
    const double waves = scene_.gravity > 0 ? 2 * wave_speed() : std::numeric_limits<double>::max();
    const double bound = std::min(waves, std::max(10 * std::sqrt(scales_.driving * scales_.depth),
                                                  std::sqrt(2 * scales_.driving * scales_.length)));
    scales_.speed = std::max(std::min(driven, bound), scales_.initial_speed);
    if (!scales_.has_drag() || !(scales_.speed > 0)) return;
    double low = 0, high = scales_.speed;
    if (scales_.drag_share > 0.9) {
      for (int k = 0; k < 30; ++k) {
        const double middle = 0.5 * (low + high);
        (mean_drag(middle) * middle > scales_.driving ? high : low) = middle;
      }
      scales_.speed = 0.5 * (low + high);
    }
    scales_.whole_drag = mean_drag(scales_.speed);
  }

  // Of u = speed * 3/2 (1 - (1 - s)^2) over the depth: its mean is the speed, its slope 3 speed / depth (1 - s).
  void measure_stress() {
    const double force = scales_.driving * scales_.depth;
    if (!(force > 0)) return;
    scales_.laminar_stress = scene_.viscosity * 1.5 * scales_.speed / scales_.depth / force;
    if (simulation_.graph().field("eddy_viscosity") < 0) return;
    const double* z = simulation_.store().data("position", up());
    std::vector<double> profile(count()), slope(count());
    for (std::size_t i = 0; i < count(); ++i) {
      const double rest = std::clamp(1 - (z[i] - scales_.bottom) / scales_.depth, 0.0, 1.0);
      profile[i] = 1.5 * scales_.speed * (1 - rest * rest);
      slope[i] = 3 * scales_.speed / scales_.depth * rest;
    }
    put(profile);
    simulation_.refresh({"eddy_viscosity"});
    if (simulation_.store().find("eddy_viscosity") == nullptr) return;
    const double* eddies = simulation_.store().data("eddy_viscosity");
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) sum += eddies[i] * slope[i];
    scales_.eddy_stress = sum / static_cast<double>(count()) / force;
  }

  const Case& scene_;
  Simulation simulation_;
  PlaneScales scales_;
};

}  // namespace

PlaneScales probe_plane(const Case& scene, const Registry& registry) {
  return Probe(scene, registry).run();
}

}  // namespace riffle
