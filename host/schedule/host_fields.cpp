#include "host/schedule/host_fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <riffle/sdk.hpp>

#include "host/schedule/nearest_point.hpp"

namespace riffle {

namespace f = fields;

struct HostFields::Instance {
  static constexpr auto id = "host", kind = "host", version = "1.0.0";
  static constexpr auto summary = "Fields that the host offers where nobody else does", source = "";
  static constexpr riffle_parameter parameters[] = {boolean("columns", false, "there is a vertical axis")};

  struct Count {
    static constexpr auto pass_name = "neighbour count";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {pair(f::distance), at_i(f::smoothing_length)};
    static constexpr riffle_write writes[] = {sum(f::neighbour_count)};
    static void run(const Instance& self, const Block& b) {
      const double kappa = self.kappa;
      RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] < kappa * b.in(1)[k] ? 1.0 : 0.0;
    }
  };
  struct Nearest {
    static constexpr auto pass_name = "nearest spacing";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {pair(f::distance), at_i(f::smoothing_length)};
    static constexpr riffle_write writes[] = {least(f::nearest_spacing)};
    static void run(const Instance& self, const Block& b) {
      const double kappa = self.kappa;
      RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] < kappa * b.in(1)[k] ? b.in(0)[k] : infinity;
    }
  };
  struct KernelSum {
    static constexpr auto pass_name = "kernel sum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF;
    static constexpr riffle_read reads[] = {at_i(f::kernel),
                                            at_j(f::cell_measure),
                                            at_j(f::mass, RIFFLE_OPTIONAL),
                                            at_j(f::density, RIFFLE_OPTIONAL),
                                            at_j(f::volume, RIFFLE_OPTIONAL),
                                            at_j(f::depth, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {sum(f::kernel_sum)};
    static void run(const Instance&, const Block& b) {
      const double* w = b.in(0);
      double* out = b.out(0);
      const int amount = b.has(2) && b.has(3) ? 2 : b.has(4) && b.has(5) ? 4 : 0;
      if (amount == 0) {
        RIFFLE_EACH(k, b) out[k] = b.in(1)[k] * w[k];
      } else {
        const double *numerator = b.in(amount), *denominator = b.in(amount + 1);
        RIFFLE_EACH(k, b) out[k] = numerator[k] / denominator[k] * w[k];
      }
    }
  };
  struct WallDistance {
    static constexpr auto pass_name = "wall distance";
    static constexpr auto pass_type = RIFFLE_PASS_GLOBAL;
    static constexpr riffle_read reads[] = {at_i(f::position)};
    static constexpr riffle_write writes[] = {set(f::wall_distance)};
    static void run(const Instance& self, const Block& b, const riffle_pairs&) { self.wall_distance(b); }
  };
  struct Depth {
    static constexpr auto pass_name = "local depth";
    static constexpr auto pass_type = RIFFLE_PASS_GLOBAL;
    static constexpr auto when = "columns=true";
    static constexpr riffle_read reads[] = {at_i(f::position), at_i(f::cell_measure),
                                            at_i(f::bed_level, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {set(f::local_depth)};
    static void run(const Instance& self, const Block& b, const riffle_pairs&) { self.local_depth(b); }
  };
  using passes = riffle::Passes<Count, Nearest, KernelSum, WallDistance, Depth>;

  Instance() = default;
  explicit Instance(const Values&) {}

  const ParticleStore* store = nullptr;
  const std::vector<Image>* copies = nullptr;
  double kappa = 0;

 private:
  void wall_distance(const Block& b) const;
  void local_depth(const Block& b) const;
};

namespace {

using Point = NearestPoint::Point;

// b.in(0) is the position.
Point position(const Block& b, std::int64_t i) {
  Point x{};
  for (int c = 0; c < b.dim(); ++c) x[static_cast<std::size_t>(c)] = b.in(0, c)[i];
  return x;
}

bool is_water(std::uint32_t role) {
  return (role & (RIFFLE_FLUID | RIFFLE_INFLOW | RIFFLE_OUTFLOW)) != 0;
}

}  // namespace

void HostFields::Instance::wall_distance(const Block& b) const {
  const auto wall = [this](std::int64_t i) { return 1u << store->role_of(i) == RIFFLE_WALL; };
  std::vector<Point> walls;
  for (std::int64_t i = store->role_begin(1); i < store->role_begin(2); ++i) walls.push_back(position(b, i));
  std::vector<std::pair<int, double>> planes;
  for (std::size_t k = 0; k < copies->size(); ++k) {
    const Image& image = (*copies)[k];
    std::int64_t origin = image.origin;
    while (origin >= store->owned()) origin = (*copies)[static_cast<std::size_t>(origin - store->owned())].origin;
    if (wall(origin)) walls.push_back(position(b, store->owned() + static_cast<std::int64_t>(k)));
    if (!image.mirror) continue;
    const std::pair<int, double> plane(image.axis, image.a[static_cast<std::size_t>(image.axis)]);
    if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
  }
  const NearestPoint nearest(b.dim(), std::move(walls));
  double* distance = b.out(0);
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < b.size(); ++i) {
    const Point x = position(b, i);
    double least = std::sqrt(nearest.distance_squared(x));
    for (const auto& [axis, at] : planes) least = std::min(least, std::abs(x[static_cast<std::size_t>(axis)] - at));
    distance[i] = least;
  }
}

void HostFields::Instance::local_depth(const Block& b) const {
  const double* z = b.in(0, b.dim() - 1);
  const double* cell = b.in(1);
  double spacing = 0;
  std::vector<char> water(static_cast<std::size_t>(b.size()));
  for (std::int64_t i = 0; i < b.size(); ++i) {
    water[static_cast<std::size_t>(i)] = is_water(1u << store->role_of(i)) ? 1 : 0;
    if (water[static_cast<std::size_t>(i)] != 0) spacing = std::max(spacing, std::pow(cell[i], 1.0 / b.dim()));
  }
  struct Column {
    double low = infinity, high = -infinity;
  };
  using Key = std::pair<std::int64_t, std::int64_t>;
  std::map<Key, Column> columns;
  const auto column_of = [&](std::int64_t i) {
    const auto part = [&](int axis) { return static_cast<std::int64_t>(std::floor(b.in(0, axis)[i] / (2 * spacing))); };
    return Key(part(0), b.dim() == 3 ? part(1) : 0);
  };
  for (std::int64_t i = 0; i < b.size(); ++i) {
    if (water[static_cast<std::size_t>(i)] == 0) continue;
    const double half = 0.5 * std::pow(cell[i], 1.0 / b.dim());
    Column& column = columns[column_of(i)];
    column.low = std::min(column.low, z[i] - half);
    column.high = std::max(column.high, z[i] + half);
  }
  for (std::int64_t i = 0; i < b.size(); ++i) {
    const auto found = spacing > 0 ? columns.find(column_of(i)) : columns.end();
    if (found == columns.end()) {
      b.out(0)[i] = 0;
      continue;
    }
    const double bed = b.has(2) ? b.in(2)[i] : found->second.low;
    b.out(0)[i] = std::max(0.0, found->second.high - bed);
  }
}

HostFields::HostFields() : instance_(std::make_unique<Instance>()) {}

HostFields::~HostFields() = default;

ActivePlugin HostFields::plugin(int dim) const {
  ParameterValue columns;
  columns.name = "columns";
  columns.number = dim > 1 ? 1 : 0;
  return {"host", Instance::id, Instance::kind, &detail::Plugin<Instance>::value, instance_.get(), {columns}, true};
}

void HostFields::connect(const ParticleStore& store, double kappa, const std::vector<Image>& images) {
  instance_->store = &store;
  instance_->kappa = kappa;
  instance_->copies = &images;
}

}  // namespace riffle
