// Straight frictionless walls on faces of the domain: every particle within reach of a wall has a mirror image behind
// it, with the normal velocity reversed, so that nothing flows through and nothing is held back along it.
//
// Images are made anew with each neighbour list. With smoothing lengths that vary, a particle must be imaged when
// itself or any other particle can see across the wall to its image: when its distance d to the wall is below its own
// reach or below max_j (reach_j - d_j). Where walls of two axes meet, the images of the one are mirrored in the other.
// A water particle that has stepped across a wall has changed places with its own image, so it is taken back with
// position mirrored and normal velocity (and acceleration, where the integrator holds one) reversed: nothing leaks and
// energy is kept. Ghost particles after Diwakar & Mohapatra (2023), fig. 1a, free slip.
// Not in it: friction and no slip; moving or oblique walls; second images in a domain narrower than a particle's reach.
#include <algorithm>
#include <limits>
#include <riffle/sdk.hpp>
#include <string>
#include <vector>

struct MirrorWall {
  static constexpr auto id = "mirror-wall", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Frictionless straight walls by mirror images";
  static constexpr auto source = "Diwakar & Mohapatra (2023) fig. 1a, free slip";
  static constexpr auto leaves_out = "friction, moving and oblique walls; images of images between two opposite walls";
  static constexpr riffle_parameter parameters[] = {
      riffle::boolean("x_min", true, "the face at the smallest x is a wall"),
      riffle::boolean("x_max", true, "the face at the largest x is a wall"),
      riffle::boolean("y_min", false, "the face at the smallest y is a wall (three dimensions)"),
      riffle::boolean("y_max", false, "the face at the largest y is a wall (three dimensions)"),
      riffle::boolean("z_min", false, "the face at the smallest z is a wall (two and three dimensions)"),
      riffle::boolean("z_max", false, "the face at the largest z is a wall (two and three dimensions)"),
      riffle::real("x_min_position", "m", 0, -1e6, 1e6, "where that wall stands", 0, "domain.x_min"),
      riffle::real("x_max_position", "m", 1, -1e6, 1e6, "where that wall stands", 0, "domain.x_max"),
      // No defaults from the domain for the axes that not every dimension has: a manifest cannot inherit what is not.
      riffle::real("y_min_position", "m", 0, -1e6, 1e6, "where that wall stands; to be given when y_min is true"),
      riffle::real("y_max_position", "m", 0, -1e6, 1e6, "where that wall stands; to be given when y_max is true"),
      riffle::real("z_min_position", "m", 0, -1e6, 1e6, "where that wall stands; to be given when z_min is true"),
      riffle::real("z_max_position", "m", 0, -1e6, 1e6, "where that wall stands; to be given when z_max is true")};

  struct Wall {
    int axis;
    double position, inward;  // inward: +1 at a lower face, -1 at an upper one
    [[nodiscard]] double distance(double x) const { return inward * (x - position); }
  };
  struct Image {
    std::int64_t index, origin;
  };

  explicit MirrorWall(const riffle::Values& v) {
    const int dim = v.dim(), axis_of[] = {0, dim == 3 ? 1 : -1, dim >= 2 ? dim - 1 : -1};  // x | x z | x y z
    for (int a = 0; a < 3; ++a) {
      const std::string name(1, "xyz"[a]);
      for (const bool lower : {true, false}) {
        const std::string face = name + (lower ? "_min" : "_max"), position = face + "_position";
        if (!v.flag(face.c_str())) continue;
        if (axis_of[a] < 0) {
          throw std::invalid_argument(face + " = true, but there is no " + name + " in " + std::to_string(dim) +
                                      (dim == 1 ? " dimension" : " dimensions"));
        }
        if (a > 0 && !v.given(position.c_str())) {
          throw std::invalid_argument(face + " = true needs " + position + ", the place of that wall");
        }
        const bool second = !lower && !walls.empty() && walls.back().axis == axis_of[a];
        walls.push_back({axis_of[a], v.number(position.c_str()), lower ? 1.0 : -1.0});
        if (second && !(walls[walls.size() - 2].position < walls.back().position)) {
          throw std::invalid_argument(name + "_min_position must lie below " + position);
        }
      }
    }
  }

  void edit(const riffle_editor& e) const {
    for (const Wall& wall : walls) {
      const double* x = e.read(e.context, "position", wall.axis);
      const double position = wall.position, inward = wall.inward;
      std::int64_t beyond = 0;
#pragma omp simd reduction(+ : beyond)
      for (std::int64_t k = 0; k < e.count; ++k) beyond += inward * (x[k] - position) < 0 ? 1 : 0;
      for (std::int64_t k = 0; beyond > 0 && k < e.count; ++k) {
        if (e.role[k] == RIFFLE_FLUID && wall.distance(x[k]) < 0) reflect(e, wall, k);
      }
    }
  }

  // Asking to write marks fields as changed, so it is done only for particles that have crossed.
  static void reflect(const riffle_editor& e, const Wall& wall, std::int64_t k) {
    double* x = e.write(e.context, "position", wall.axis);
    x[k] = 2 * wall.position - x[k];
    for (const char* reversed : {"velocity", "acceleration", "momentum"}) {
      if (double* v = e.write(e.context, reversed, wall.axis)) v[k] = -v[k];
    }
  }

  void images(const riffle_editor& e) const {
    std::vector<Image> made;
    for (int axis = 0; axis < e.dim; ++axis) {
      const std::size_t of_other_axes = made.size();
      for (const Wall& wall : walls) {
        if (wall.axis != axis) continue;
        const std::vector<Image> origins = near(wall, e, made, of_other_axes);
        double plane[3] = {0, 0, 0};
        plane[axis] = wall.position;
        for (const Image& from : origins) {
          made.push_back({e.image(e.context, from.index, RIFFLE_MIRROR, axis, plane), from.origin});
        }
      }
    }
  }

  // The particles, and the first `images` images, that the wall mirrors. Collected before any image is made, because
  // the arrays of the editor may move then.
  static std::vector<Image> near(const Wall& wall, const riffle_editor& e, const std::vector<Image>& made,
                                 std::size_t images) {
    const double* x = e.read(e.context, "position", wall.axis);
    const auto inside = [&](std::int64_t k) { return e.role[k] == RIFFLE_FLUID || wall.distance(x[k]) >= 0; };
    const double position = wall.position, inward = wall.inward;
    constexpr std::int64_t run = 64;               // most are far from it: whole runs of them are passed over at once
    std::vector<std::pair<double, double>> looks;  // of each run: the least distance, the largest reach
    double zone = 0, bound = 0;
    for (std::int64_t first = 0; first < e.count; first += run) {
      const std::int64_t last = std::min(first + run, e.count);
      double least = std::numeric_limits<double>::infinity(), largest = 0;
#ifndef __clang__  // which cannot vectorise a least or largest value, and warns
#pragma omp simd reduction(min : least) reduction(max : largest)
#endif
      for (std::int64_t k = first; k < last; ++k) {
        const double distance = inward * (x[k] - position);
        least = distance < least ? distance : least;
        largest = e.reach[k] > largest ? e.reach[k] : largest;
      }
      looks.emplace_back(least, largest);
      bound = std::max(bound, largest);
      for (std::int64_t k = first; least < largest && k < last; ++k) {
        if (inside(k)) zone = std::max(zone, e.reach[k] - wall.distance(x[k]));
      }
    }
    bound = std::max(bound, zone);
    std::vector<Image> found;
    const auto add = [&](Image candidate) {
      const std::int64_t k = candidate.origin;
      if (e.role[k] == RIFFLE_PROBE || !inside(k)) return;
      if (wall.distance(x[k]) < std::max(zone, e.reach[k])) found.push_back(candidate);
    };
    for (std::int64_t first = 0; first < e.count; first += run) {
      if (looks[static_cast<std::size_t>(first / run)].first >= bound) continue;
      for (std::int64_t k = first; k < std::min(first + run, e.count); ++k) {
        if (wall.distance(x[k]) < bound) add({k, k});
      }
    }
    for (std::size_t m = 0; m < images; ++m) add(made[m]);
    return found;
  }
  std::vector<Wall> walls;
};

RIFFLE_PLUGIN(MirrorWall)
