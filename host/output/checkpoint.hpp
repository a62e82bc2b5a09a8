// Checkpoints: the state from which a run goes on bit for bit. What is in it is the caller's business: a text (JSON)
// and named lists of numbers, which come back exactly, NaN payloads, -0.0 and empty lists included.
//
// A folder keeps the last two: checkpoint.h5 and, before it, checkpoint.previous.h5. The file is HDF5 behind a header
// of 512 bytes of text (a "user block", so h5ls and h5dump look into it) that holds the format, the length and a CRC-64
// of all that follows: damage and truncation are found before a single byte is interpreted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace riffle {

struct Checkpoint {
  std::string meta;  // JSON
  // Names must not be empty, "." or hold '/', which HDF5 would take for a path: std::logic_error.
  std::map<std::string, std::vector<double>> reals;
  std::map<std::string, std::vector<std::int64_t>> integers;
};

// Complete under its name or not there. Throws std::runtime_error with one sentence; an old file is then untouched.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// Throws std::runtime_error with one sentence that names the file: missing, not a Riffle checkpoint, of a newer format,
// or damaged.
Checkpoint read_checkpoint(const std::filesystem::path& path);

// Writes <folder>/checkpoint.h5 and keeps the one before it. At every moment one of the two is good.
void save_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

struct LoadedCheckpoint {
  Checkpoint checkpoint;
  std::filesystem::path file;  // where it came from
  std::string warning;         // why it is not the newest, or empty
};

// The newest readable checkpoint of a run. Throws std::runtime_error when there is none, saying why for each.
LoadedCheckpoint load_checkpoint(const std::filesystem::path& folder);

}  // namespace riffle
