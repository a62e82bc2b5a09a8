// Values of the particles along x as a table in CSV, for any plotting tool and for people.
//
//   # case: wet-0.5
//   # time: 6 s
//   # riffle: 0.1.0
//   # units: x [m], depth [m], velocity [m.s-1]
//   x,depth,velocity
//   0.0125,10,0
//
// Numbers are the shortest that read back to the same double; "nan" where a value is not defined.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace riffle {

struct ProfileColumn {
  std::string name, unit;
  std::span<const double> values;  // one per particle; all columns have the same length
};

struct ProfileHeader {
  std::string case_name;
  double time = 0;  // s
};

// Rows in the order of the first column, which is x; equal x keep the order given. A file appears complete or not at
// all. Throws std::runtime_error with one sentence.
void write_profile(const std::filesystem::path& path, const ProfileHeader& header,
                   const std::vector<ProfileColumn>& columns);

}  // namespace riffle
