#include "host/output/snapshots.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/output/atomic_file.hpp"
#include "host/output/hdf5_file.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t vtk_vertex = 1;  // VTK's number of the cell type

// Place of each axis of the case among x, y, z: the last axis of a case is up, which is z, and 1D lies along x.
std::array<std::size_t, 3> axes_of(int dim) {
  if (dim == 2) return {0, 2, 2};
  return {0, 1, 2};
}

// Columns that a field of this shape has in the file, and the column of each of its components.
struct Columns {
  std::size_t width = 1;
  std::vector<std::size_t> place{0};
};

Columns columns_of(Shape shape, int dim) {
  const auto axis = axes_of(dim);
  const auto d = static_cast<std::size_t>(dim);
  Columns columns;
  if (shape == Shape::scalar) return columns;
  columns.place.clear();
  if (shape == Shape::vector) {
    columns.width = 3;
    columns.place.assign(axis.begin(), axis.begin() + dim);
  } else if (shape == Shape::tensor) {
    columns.width = 9;
    for (std::size_t a = 0; a < d; ++a) {
      for (std::size_t b = 0; b < d; ++b) columns.place.push_back(3 * axis[a] + axis[b]);
    }
  } else {
    // VTK's order is xx yy zz xy yz xz; ours goes through the rows of the upper triangle.
    constexpr std::size_t vtk[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    columns.width = 6;
    for (std::size_t a = 0; a < d; ++a) {
      for (std::size_t b = a; b < d; ++b) columns.place.push_back(vtk[axis[a]][axis[b]]);
    }
  }
  return columns;
}

// Values of a field, a row per particle
std::vector<double> rows(const Field& field, const Columns& columns, std::size_t n) {
  std::vector<double> values(n * columns.width, 0.0);
  for (std::size_t c = 0; c < columns.place.size(); ++c) {
    const double* component = field.component[c].data();
    for (std::size_t i = 0; i < n; ++i) values[i * columns.width + columns.place[c]] = component[i];
  }
  return values;
}

void write_points(hid_t root, const ParticleStore& particles, std::size_t n) {
  const std::array<std::int64_t, 1> count{static_cast<std::int64_t>(n)};
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
    hdf5::write(root, name, std::span<const std::int64_t>(count));
  }
  const Field& position = particles.at("position");
  const Columns columns = columns_of(Shape::vector, particles.dim());
  hdf5::write(root, "Points", std::span<const double>(rows(position, columns, n)), columns.width);
  std::vector<std::int64_t> numbers(n + 1);
  for (std::size_t i = 0; i <= n; ++i) numbers[i] = static_cast<std::int64_t>(i);
  hdf5::write(root, "Offsets", std::span<const std::int64_t>(numbers), true);
  hdf5::write(root, "Connectivity", std::span<const std::int64_t>(numbers).first(n), true);
  hdf5::write(root, "Types", std::span<const std::uint8_t>(std::vector<std::uint8_t>(n, vtk_vertex)), true);
}

void write_point_data(hid_t root, const ParticleStore& particles, const std::vector<std::string>& fields,
                      std::size_t n) {
  const hdf5::Handle data = hdf5::create_group(root, "PointData");
  for (const std::string& name : fields) {
    if (name == "position") continue;
    const Field& field = particles.at(name);
    const Columns columns = columns_of(field.description.shape, particles.dim());
    hdf5::write(data.id(), name, std::span<const double>(rows(field, columns, n)),
                columns.width > 1 ? columns.width : 0);
  }
  hdf5::write(data.id(), "id", std::span<const std::int64_t>(particles.ids()).first(n), true);
  std::vector<std::uint8_t> roles(n);
  for (int role = 0; role < role_count; ++role) {
    for (std::int64_t i = particles.role_begin(role); i < particles.role_begin(role + 1); ++i) {
      roles[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(role);
    }
  }
  hdf5::write(data.id(), "role", std::span<const std::uint8_t>(roles), true);
}

std::string name_of(std::size_t number) {
  return fmt::format("snapshots/{:06}.hdf", number);
}

}  // namespace

void write_snapshot(const fs::path& path, const ParticleStore& particles, const std::vector<std::string>& fields,
                    double time, std::int64_t step) {
  const hdf5::Silence silence;
  const auto n = static_cast<std::size_t>(particles.owned());
  const hdf5::MemoryFile file;
  {
    const hdf5::Handle root = hdf5::create_group(file.id(), "VTKHDF");
    const std::array<std::int64_t, 2> version{1, 0};
    hdf5::write_attribute(root.id(), "Version", std::span<const std::int64_t>(version));
    hdf5::write_attribute(root.id(), "Type", "UnstructuredGrid");
    write_points(root.id(), particles, n);
    write_point_data(root.id(), particles, fields, n);
    const hdf5::Handle data = hdf5::create_group(root.id(), "FieldData");
    hdf5::write(data.id(), "TimeValue", std::span<const double>(std::array<double, 1>{time}));
    hdf5::write(data.id(), "step", std::span<const std::int64_t>(std::array<std::int64_t, 1>{step}));
  }
  write_atomically(path, file.image());
}

SnapshotWriter::SnapshotWriter(fs::path folder, std::vector<std::string> fields)
    : folder_(std::move(folder)), fields_(std::move(fields)) {}

void SnapshotWriter::resume(std::int64_t count) {
  std::vector<double> times;
  if (fs::exists(index())) {
    const auto json = nlohmann::json::parse(read_file(index()), nullptr, false);
    if (json.is_object() && json.contains("files")) {
      for (const auto& entry : json["files"]) {
        if (entry.is_object() && entry.contains("time") && entry["time"].is_number()) times.push_back(entry["time"]);
      }
    }
  }
  if (times.size() < static_cast<std::size_t>(count)) {
    throw std::runtime_error(fmt::format("{} lists {} snapshots, the checkpoint was written after {}", index().string(),
                                         times.size(), count));
  }
  times_.assign(times.begin(), times.begin() + count);
  write_index();
  std::error_code ignored;
  for (auto number = times_.size(); number < times.size(); ++number) fs::remove(folder_ / name_of(number), ignored);
}

fs::path SnapshotWriter::write(const ParticleStore& particles, double time, std::int64_t step) {
  fs::create_directories(folder_ / "snapshots");
  const fs::path path = folder_ / name_of(times_.size());
  write_snapshot(path, particles, fields_, time, step);
  times_.push_back(time);
  write_index();
  return path;
}

void SnapshotWriter::write_index() const {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (std::size_t number = 0; number < times_.size(); ++number) {
    files.push_back({{"name", name_of(number)}, {"time", times_[number]}});
  }
  const nlohmann::ordered_json json{{"file-series-version", "1.0"}, {"files", files}};
  write_atomically(index(), json.dump(1) + "\n");
}

}  // namespace riffle
