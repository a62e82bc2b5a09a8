// The state of the particles as a time series that ParaView opens: snapshots.hdf.series, an index in JSON with the
// times, and snapshots/000000.hdf, ..., each a complete VTKHDF file (version 1.0, unstructured grid, one vertex per
// particle).
//
// One file per time, because VTK 9.1 and ParaView 5.11 (Debian 12) know no time inside a VTKHDF file; and `.hdf`,
// because that is the only ending those offer to their VTKHDF reader. Later versions read both just as well.
//
// Point data: the chosen fields under their names, `id`, and `role` (0 fluid, 1 wall, 2 inflow, 3 outflow, 4 piston, 5
// probe). Vectors have 3 components, symmetric tensors 6 (xx yy zz xy yz xz, VTK's order), tensors 9. Axes are those of
// the manifest: 1D on x, the vertical plane on x and z, so a 2D scene is seen along y. Images (mirror and periodic
// copies) are left out. Field data: TimeValue (s) and step.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host/particles/store.hpp"

namespace riffle {

class SnapshotWriter {
 public:
  // `folder`: that of the run. `fields`: names to write; position is always written, as the points.
  SnapshotWriter(std::filesystem::path folder, std::vector<std::string> fields);

  // Goes on after the first `count` snapshots of the index, as a checkpoint recorded them; later ones are removed.
  // Throws std::runtime_error when the index holds fewer.
  void resume(std::int64_t count);

  // Writes the next snapshot and then the index. Throws std::runtime_error with one sentence; a field that the store
  // does not have is a std::logic_error. Returns the file.
  std::filesystem::path write(const ParticleStore& particles, double time, std::int64_t step);

  [[nodiscard]] std::int64_t written() const { return static_cast<std::int64_t>(times_.size()); }
  [[nodiscard]] std::filesystem::path index() const { return folder_ / "snapshots.hdf.series"; }

 private:
  void write_index() const;

  std::filesystem::path folder_;
  std::vector<std::string> fields_;
  std::vector<double> times_;
};

// One state in a file of its own, outside any series; for the state of a run that has blown up.
void write_snapshot(const std::filesystem::path& path, const ParticleStore& particles,
                    const std::vector<std::string>& fields, double time, std::int64_t step);

}  // namespace riffle
