// Images: copies of particles behind mirror planes and periodic faces. A field's images follow its owned values by the
// rule of its shape; nobody computes an image's field.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/particles/store.hpp"

namespace riffle {

struct Image {
  std::int64_t origin = 0;  // index of an owned particle or of an earlier image
  bool mirror = false;      // else a shift
  int axis = 0;
  std::array<double, 3> a{};  // a point of the plane, or the shift
};

// Writes the images of one field from their origins.
void refresh_images(const std::vector<Image>& images, ParticleStore& store, Field& field);

}  // namespace riffle
