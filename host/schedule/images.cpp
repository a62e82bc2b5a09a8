#include "host/schedule/images.hpp"

namespace riffle {

namespace {

// Sign that component `c` of a shape takes in a mirror normal to `axis`.
double sign(Shape shape, int dim, int axis, int c) {
  if (shape == Shape::vector) return c == axis ? -1.0 : 1.0;
  if (shape == Shape::tensor) return (c / dim == axis) != (c % dim == axis) ? -1.0 : 1.0;
  if (shape == Shape::symmetric) {
    constexpr int row[] = {0, 0, 1, 0, 1, 2}, column[] = {0, 1, 1, 2, 2, 2};
    return (row[c] == axis) != (column[c] == axis) ? -1.0 : 1.0;
  }
  return 1.0;
}

}  // namespace

void refresh_images(const std::vector<Image>& images, ParticleStore& store, Field& field) {
  const auto first = store.owned();
  const bool is_position = field.description.name == "position";
  for (std::size_t c = 0; c < field.component.size(); ++c) {
    double* values = field.component[c].data();
    for (std::size_t k = 0; k < images.size(); ++k) {
      const Image& image = images[k];
      double v = values[image.origin];
      const int axis = static_cast<int>(c);
      if (image.mirror) {
        if (is_position)
          v = axis == image.axis ? 2 * image.a[c] - v : v;
        else
          v *= sign(field.description.shape, store.dim(), image.axis, axis);
      } else if (is_position) {
        v += image.a[c];
      }
      values[first + static_cast<std::int64_t>(k)] = v;
    }
  }
}

}  // namespace riffle
