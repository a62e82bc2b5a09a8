#include "host/output/profiles.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "host/output/atomic_file.hpp"
#include "host/output/build_info.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

TEST(Profile, IsSortedAlongXWithAHeaderThatExplainsIt) {
  const TemporaryFolder folder;
  const std::vector<double> x{2, 1, 3}, depth{20, 10, 30};
  write_profile(folder.path() / "p.csv", {"wet-0.5", 6}, {{"x", "m", x}, {"depth", "m", depth}});
  EXPECT_EQ(read_file(folder.path() / "p.csv"), "# case: wet-0.5\n# time: 6 s\n# riffle: " + riffle_version() +
                                                    "\n# units: x [m], depth [m]\nx,depth\n1,10\n2,20\n3,30\n");
}

TEST(Profile, NumbersReadBackToTheSameBits) {
  const TemporaryFolder folder;
  const std::vector<double> x{0.1, 1.0 / 3, 6.02214076e23}, y{-0.0, 5e-324, std::nextafter(1.0, 2.0)};
  write_profile(folder.path() / "p.csv", {"c", 0}, {{"x", "m", x}, {"y", "m", y}});
  std::istringstream lines(read_file(folder.path() / "p.csv"));
  std::string line;
  while (std::getline(lines, line) && line != "x,y") continue;
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_TRUE(std::getline(lines, line));
    char* rest = nullptr;
    EXPECT_EQ(std::strtod(line.c_str(), &rest), x[i]);
    const double back = std::strtod(rest + 1, nullptr);
    EXPECT_EQ(back, y[i]);
    EXPECT_EQ(std::signbit(back), std::signbit(y[i]));
  }
}

TEST(Profile, ParticlesAtOnePlaceKeepTheirOrder) {
  const TemporaryFolder folder;
  const std::vector<double> x{1, 0, 1, 1}, id{3, 9, 1, 2};
  write_profile(folder.path() / "p.csv", {"c", 0}, {{"x", "m", x}, {"id", "1", id}});
  EXPECT_TRUE(contains(read_file(folder.path() / "p.csv"), "x,id\n0,9\n1,3\n1,1\n1,2\n"));
}

TEST(Profile, ALineBreakInTheNameDoesNotEndTheComment) {
  const TemporaryFolder folder;
  const std::vector<double> x{1};
  write_profile(folder.path() / "p.csv", {"a\nb", 0}, {{"x", "m", x}});
  EXPECT_TRUE(contains(read_file(folder.path() / "p.csv"), "# case: a b\n"));
}

}  // namespace
}  // namespace riffle
