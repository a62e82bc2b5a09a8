// Writes known particles as snapshots in 1, 2 and 3 dimensions, for read_snapshots.py to read back with VTK's reader.
// The values are formulas of the particle's number that the script knows too.
#include <array>
#include <filesystem>
#include <string>

#include "host/output/snapshots.hpp"

namespace {

constexpr int particles_per_role = 5;

riffle::ParticleStore store_of(int dim) {
  using riffle::FieldUse;
  using riffle::Shape;
  riffle::ParticleStore store(dim);
  store.add_field({"position", "m", "", Shape::vector}, FieldUse::evolved);
  store.add_field({"velocity", "m.s-1", "", Shape::vector}, FieldUse::evolved);
  store.add_field({"depth", "m", "", Shape::scalar}, FieldUse::derived);
  store.add_field({"stress", "kg.m-1.s-2", "", Shape::symmetric}, FieldUse::derived);
  store.add_field({"velocity_gradient", "s-1", "", Shape::tensor}, FieldUse::derived);
  // Fluid, no wall, inflow: groups are told apart by where they begin, also after an empty one.
  store.resize_owned({particles_per_role, 0, particles_per_role, 0, 0, 0});
  store.resize_images(3);
  for (std::int64_t i = 0; i < store.owned(); ++i) store.ids()[static_cast<std::size_t>(i)] = 1000 - i;
  double offset = 0;
  for (const char* name : {"position", "velocity", "depth", "stress", "velocity_gradient"}) {
    riffle::Field& field = store.at(name);
    offset += 100;
    for (std::size_t c = 0; c < field.component.size(); ++c) {
      // A third is not a number with few digits: what comes back was neither rounded nor stored as float.
      for (std::int64_t i = 0; i < store.all(); ++i) {
        field.component[c].data()[i] = offset + 10 * static_cast<double>(c) + static_cast<double>(i) / 3;
      }
    }
  }
  return store;
}

}  // namespace

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  for (const int dim : {1, 2, 3}) {
    const std::filesystem::path run = folder / (std::to_string(dim) + "d");
    std::filesystem::create_directories(run);
    riffle::SnapshotWriter writer(run, {"position", "velocity", "depth", "stress", "velocity_gradient"});
    const riffle::ParticleStore store = store_of(dim);
    writer.write(store, 0, 0);
    writer.write(store, 0.1 + 0.2, 42);
  }
  return 0;
}
