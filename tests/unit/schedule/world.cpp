#include "tests/unit/schedule/world.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace riffle::test {

namespace {

std::vector<std::string> all_given(const WorldOptions& options) {
  std::vector<std::string> given = options.given;
  if (!options.written_length) given.emplace_back("smoothing_length");
  return given;
}

riffle_kernel kernel_of(const Graph& graph) {
  riffle_kernel kernel{};
  if (graph.kernel() < 0) return kernel;
  const ActivePlugin& plugin = graph.plugins()[static_cast<std::size_t>(graph.kernel())];
  plugin.table->kernel(plugin.self, &kernel);
  return kernel;
}

}  // namespace

void Ran::note(const char* name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  names_.insert(name);
}

std::set<std::string> Ran::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(names_, {});
}

Ran& ran() {
  static Ran one;
  return one;
}

Toys& Toys::add(const riffle_plugin& table, const std::map<std::string, double>& numbers,
                const std::map<std::string, std::string>& words) {
  ActivePlugin made;
  made.slot = made.id = table.id;
  made.kind = table.kind;
  made.table = &table;
  std::vector<riffle_value> values;
  for (auto p = table.parameters; *p != nullptr; ++p) {
    ParameterValue value;
    value.name = (*p)->name;
    value.number = numbers.count(value.name) != 0 ? numbers.at(value.name) : (*p)->fallback;
    if ((*p)->type == RIFFLE_CHOICE)
      value.text = words.count(value.name) != 0 ? words.at(value.name) : (*p)->fallback_text;
    made.values.push_back(value);
  }
  for (const auto& v : made.values) values.push_back({sizeof(riffle_value), 1, v.number, v.text.c_str(), nullptr});
  std::vector<const riffle_value*> pointers;
  for (const auto& v : values) pointers.push_back(&v);
  pointers.push_back(nullptr);
  riffle_error error{sizeof(riffle_error), {}};
  void* self = table.create(dim_, pointers.data(), &error);
  if (self == nullptr) throw std::runtime_error(error.message);
  keep_.emplace_back(self, table.destroy);
  made.self = self;
  active.push_back(made);
  return *this;
}

World::World(Toys made, WorldOptions wanted)
    : toys(std::move(made)),
      options(std::move(wanted)),
      graph(options.dim, toys.active, all_given(options), options.wanted),
      store(options.dim),
      kernel_(kernel_of(graph)),
      neighbourhood(store, kernel_.support, options.skin, [this](std::vector<Image>& images) {
        if (options.images) options.images(store, images);
      }) {
  for (const auto& field : graph.fields()) {
    if (field.pair_source != PairSource::none) continue;
    store.add_field(field.description, field.attribute ? FieldUse::attribute : FieldUse::derived);
  }
  store.add_field({"smoothing_length", "m", "", Shape::scalar, false, false, false, false}, FieldUse::attribute);
  place();
  evaluator = std::make_unique<Evaluator>(graph, store, neighbourhood, options.runner);
  evaluator->everything_changed();
}

void World::place() {
  store.resize_owned(options.per_role);
  const std::int64_t n = store.owned();
  std::iota(store.ids().begin(), store.ids().end(), 0);
  const auto side = static_cast<std::int64_t>(std::ceil(std::pow(static_cast<double>(n), 1.0 / options.dim) - 1e-9));
  const double spacing = 1.0 / static_cast<double>(side);
  std::vector<std::int64_t> cell(static_cast<std::size_t>(std::pow(side, options.dim) + 0.5));
  std::iota(cell.begin(), cell.end(), 0);
  std::shuffle(cell.begin(), cell.end(), random_);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3), factor(0.75, 1.25), any(0.5, 1.5);
  for (std::int64_t i = 0; i < n; ++i) {
    std::int64_t rest = cell[static_cast<std::size_t>(i)];
    for (int c = 0; c < options.dim; ++c, rest /= side)
      store.data("position", c)[i] = (static_cast<double>(rest % side) + 0.5 + jitter(random_)) * spacing;
    store.data("smoothing_length")[i] = options.length * spacing * (options.uniform_length ? 1.0 : factor(random_));
    store.data("cell_measure")[i] = std::pow(spacing, options.dim);
  }
  for (const auto& name : options.given) {
    for (auto& component : store.at(name).component) {
      for (std::int64_t i = 0; i < n; ++i) component.data()[i] = any(random_);
    }
  }
}

void World::compute(const std::vector<std::string>& fields, double time, double dt) {
  std::vector<int> wanted;
  for (const auto& name : fields) wanted.push_back(graph.field(name));
  evaluator->compute(wanted, time, dt);
}

std::vector<double> World::values(const std::string& field, int component) const {
  const double* v = store.data(field, component);
  return {v, v + store.owned()};
}

void World::move(double largest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-largest, largest);
  for (std::int64_t i = 0; i < store.owned(); ++i) {
    for (int c = 0; c < store.dim(); ++c) store.data("position", c)[i] += step(random);
  }
  changed("position");
}

double World::kernel_value(int bit, double r, double l) const {
  const ActivePlugin& plugin = graph.plugins()[static_cast<std::size_t>(graph.kernel())];
  const std::vector<double> distance(8, r), inverse(8, 1 / l);
  std::vector<double> values(8);
  double* out[RIFFLE_KERNEL_OUTPUTS] = {};
  out[bit] = values.data();
  plugin.table->evaluate_kernel(plugin.self, 8, distance.data(), inverse.data(), 1u << bit, out);
  return values[0];
}

std::uint32_t World::role(std::int64_t index) const {
  while (index >= store.owned()) index = neighbourhood.images()[static_cast<std::size_t>(index - store.owned())].origin;
  return 1u << store.role_of(index);
}

void each_pair(const World& world, const NeighbourRequest& request,
               const std::function<void(const FoundPair&)>& visit) {
  const double* l = world.store.data("smoothing_length");
  const double* x[3] = {};
  for (int c = 0; c < world.store.dim(); ++c) x[c] = world.store.data("position", c);
  std::vector<std::uint32_t> roles;
  for (std::int64_t i = 0; i < world.store.all(); ++i) roles.push_back(world.role(i));
  for (std::int64_t i = 0; i < world.store.owned(); ++i) {
    if ((roles[static_cast<std::size_t>(i)] & request.targets) == 0) continue;
    for (std::int64_t j = 0; j < world.store.all(); ++j) {
      if (j == i || (roles[static_cast<std::size_t>(j)] & request.sources) == 0) continue;
      FoundPair pair{i, j, 0, {}};
      double r2 = 0;
      for (int c = 0; c < world.store.dim(); ++c) {
        pair.dx[c] = x[c][i] - x[c][j];
        r2 += pair.dx[c] * pair.dx[c];
      }
      pair.r = std::sqrt(r2);
      const double reach = request.reach == Reach::gather    ? l[i]
                           : request.reach == Reach::scatter ? l[j]
                                                             : std::max(l[i], l[j]);
      if (pair.r < world.kernel().support * reach) visit(pair);
    }
  }
}

std::vector<double> brute_force_sum(const World& world, const NeighbourRequest& request,
                                    const std::function<double(const FoundPair&)>& term) {
  std::vector<double> sums(static_cast<std::size_t>(world.store.owned()), 0.0);
  each_pair(world, request, [&](const FoundPair& pair) { sums[static_cast<std::size_t>(pair.i)] += term(pair); });
  return sums;
}

}  // namespace riffle::test
