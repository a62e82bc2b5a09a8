#include "host/bench/dam_break.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <vector>

#include "host/manifest/read.hpp"
#include "host/neighbours/neighbours.hpp"
#include "host/time/simulation.hpp"

namespace riffle::bench {

namespace {

constexpr double column_width = 0.146, column_height = 0.292, sound_speed = 24;  // m, m, m/s

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Scene {
  std::filesystem::path file;
  explicit Scene(const std::string& text) {
    file = std::filesystem::temp_directory_path() / fmt::format("riffle-bench-{}.toml", ::getpid());
    std::ofstream(file) << text;
  }
  ~Scene() { std::filesystem::remove(file); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
};

}  // namespace

std::string dam_break_manifest(std::int64_t particles, double cfl) {
  const double spacing = std::sqrt(column_width * column_height / static_cast<double>(particles));
  return fmt::format(R"([case]
name = "bench-dam-break-2d"

[domain]
dimension = 2
x = [0, 0.584]
z = [0, 0.4]
smoothing_ratio = 1.414

[initial]
particles = {{ spacing = {}, perturbation = 0.2 }}
inside = "x < {} && z < {}"

[plugins.equations]
id = "wcsph"
sound_speed = {}
surface = {}

[plugins.kernel]
id = "wendland-c2"

[plugins.viscosity]
id = "monaghan"
alpha = 0.02

[plugins.filter]
id = "delta-sph"

[plugins.walls]
kind = "boundary"
id = "adami-wall"
x_min = true
x_max = true

[time]
end = 10
integrator = "semi-implicit-euler"
cfl = {}
)",
                     spacing, column_width, column_height, sound_speed, column_height, cfl);
}

DamBreakFigures bench_dam_break(const Registry& registry, const DamBreakRequest& request) {
  const Scene file(dam_break_manifest(request.particles, request.cfl));
  const Case scene = read_case(file.file, {}, registry);
  SimulationOptions options;
  options.threads = std::min(2, omp_get_num_procs());
  Simulation simulation(scene, registry, options);
  const double forever = std::numeric_limits<double>::max();
  for (int k = 0; k < request.warm_up; ++k) simulation.step(forever);
  DamBreakFigures out;
  out.particles = simulation.store().role_begin(1);
  const auto particles = static_cast<double>(out.particles);
  std::vector<double> cpu, wall1, wall2;
  double simulated = 0;
  for (int r = 0; r < request.repeats; ++r) {
    for (const int threads : {1, 2}) {
      omp_set_num_threads(std::min(threads, options.threads));
      const double c = cpu_now(), w = wall_now(), t = simulation.time();
      for (int k = 0; k < request.steps; ++k) simulation.step(forever);
      (threads == 1 ? wall1 : wall2).push_back(wall_now() - w);
      if (threads == 1) {
        cpu.push_back(cpu_now() - c);
        simulated += simulation.time() - t;
      }
    }
  }
  const double spacing = std::sqrt(simulation.store().data("cell_measure")[0]);
  const double dt = simulated / (request.repeats * request.steps);
  out.evaluations_per_second_per_core = particles * request.steps / median(cpu);
  out.step_over_spacing = dt * sound_speed / spacing;
  out.advance_rate = out.evaluations_per_second_per_core * out.step_over_spacing;
  out.speedup_2_threads = median(wall1) / median(wall2);
  out.bytes_per_particle = static_cast<double>(simulation.bytes()) / static_cast<double>(simulation.store().owned());
  ParticleView view;  // within the support itself, without the skin of the lists
  view.dim = 2;
  view.owned = view.all = simulation.store().owned();
  for (int c = 0; c < 2; ++c) view.x[c] = simulation.store().data("position", c);
  view.l = simulation.store().data("smoothing_length");
  NeighbourList list;
  build(view, simulation.neighbourhood().kappa(), 0, {}, list);
  double sum = 0;
  for (std::int64_t i = 0; i < out.particles; ++i) sum += list.count[static_cast<std::size_t>(i)];
  out.neighbours = sum / particles;
  return out;
}

}  // namespace riffle::bench
