// What the boundary does, in one line; author (year). This one closes the domain in x to a ring: water that leaves at one
// end enters at the other, and particles near one end see images of those near the other.
//
// A boundary works between steps, on one thread. `begin` runs once at the start, `edit` after each step, `images` each
// time a neighbour list is made; have those that you need. Particles are added, removed and retagged through the editor,
// which keeps the ledger of mass.
#include <algorithm>
#include <riffle/sdk.hpp>
#include <stdexcept>
#include <vector>

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "boundary", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year)";
  static constexpr auto leaves_out = "what it does not contain, and where it fails";

  static constexpr riffle_parameter parameters[] = {
      riffle::real("begin_of_ring", "m", 0, -1e6, 1e6, "x where the ring begins", 0, "domain.x_min"),
      riffle::real("end_of_ring", "m", 1, -1e6, 1e6, "x where it ends, which is where it begins", 0, "domain.x_max")};

  explicit MyPlugin(const riffle::Values& v) : first(v.number("begin_of_ring")), last(v.number("end_of_ring")) {
    if (first >= last) throw std::invalid_argument("begin_of_ring must lie below end_of_ring");
  }

  void edit(const riffle_editor& e) const {
    double* x = e.write(e.context, "position", 0);
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (x[k] < first) x[k] += last - first;
      if (x[k] >= last) x[k] -= last - first;
    }
  }

  void images(const riffle_editor& e) const {
    const double* x = e.read(e.context, "position", 0);
    double reach = 0;  // how far anybody sees
    for (std::int64_t k = 0; k < e.count; ++k) reach = std::max(reach, e.reach[k]);
    std::vector<std::int64_t> near_first, near_last;  // collected first: arrays may move when an image is made
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (x[k] - first < reach) near_first.push_back(k);
      if (last - x[k] < reach) near_last.push_back(k);
    }
    const double forward[3] = {last - first, 0, 0}, backward[3] = {first - last, 0, 0};
    for (const std::int64_t k : near_first) e.image(e.context, k, RIFFLE_SHIFT, 0, forward);
    for (const std::int64_t k : near_last) e.image(e.context, k, RIFFLE_SHIFT, 0, backward);
  }
  double first, last;
};

RIFFLE_PLUGIN(MyPlugin)
