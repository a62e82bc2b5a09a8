// Who is near whom: keeps images and neighbour lists in step with the particles.
//
// Lists are built with a skin and kept until some particle may have crossed it. In one dimension particles are kept
// sorted along x, groups of passes walk along the line without any list (line.hpp), and a list is only built, for the
// current positions, when somebody asks for it. Lists and images are a pure function of particle
// order and of positions and smoothing lengths at the last build; those are kept for checkpoints, so that a resumed run
// sums in the same order.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "host/neighbours/neighbours.hpp"
#include "host/neighbours/verlet.hpp"
#include "host/schedule/images.hpp"
#include "host/schedule/runner.hpp"

namespace riffle {

struct NeighbourhoodState {  // what a checkpoint holds of it
  std::vector<double> x[3], l;
  std::int64_t builds = 0;
};

class Neighbourhood : public ListProvider {
 public:
  // `kappa`: support of the kernel in smoothing lengths. `make_images` asks boundaries for images; may be empty.
  Neighbourhood(ParticleStore& store, double kappa, double skin, std::function<void(std::vector<Image>&)> make_images);

  void require(const NeighbourRequest& request);
  void forget_requests();
  // Makes lists valid for the current positions and smoothing lengths. True when they were rebuilt, and with them the
  // images; owned particles may then have a new order.
  bool prepare();
  // Particles were added, removed or retagged: the next prepare() rebuilds.
  void invalidate() { valid_ = false; }

  [[nodiscard]] const NeighbourList& list(const NeighbourRequest& request) const override;
  [[nodiscard]] double kappa() const override { return kappa_; }
  [[nodiscard]] bool on_a_line(const NeighbourRequest& request) const override;
  [[nodiscard]] const std::vector<Image>& images() const { return images_; }
  void reach(std::vector<double>& out) const;  // how far each owned particle must see, skin included
  [[nodiscard]] std::int64_t builds() const { return state_.builds; }
  [[nodiscard]] std::size_t bytes() const;

  // Without positions when the lists are void anyway and the next prepare() makes new ones.
  [[nodiscard]] NeighbourhoodState state() const;
  // Restores lists and images as they were; current positions and smoothing lengths stay untouched.
  void restore(const NeighbourhoodState& state);

 private:
  void build();
  void find_roles_between();
  void sort();
  void sort_line();
  [[nodiscard]] bool still_valid() const;
  [[nodiscard]] ParticleView view() const;

  struct Entry {
    NeighbourRequest request;
    NeighbourList list;
    VerletCheck check;
    bool current = false;  // in one dimension: built for the present positions
  };
  ParticleStore& store_;
  double kappa_, skin_;
  std::function<void(std::vector<Image>&)> make_images_;
  std::vector<std::unique_ptr<Entry>> lists_;
  std::vector<Image> images_;
  std::vector<std::uint8_t> role_;
  NeighbourhoodState state_;
  std::uint32_t present_ = 0,
                between_ = 0;  // roles that have particles or images; and those that have any within the water
  bool valid_ = false;
};

}  // namespace riffle
