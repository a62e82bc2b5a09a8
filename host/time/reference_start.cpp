#include "host/time/reference_start.hpp"

#include "host/plugins/call.hpp"
#include "host/plugins/instance.hpp"
#include "host/schedule/run_error.hpp"

namespace riffle {
namespace {

// One component of one field of a reference.
class OfReference : public Function::Implementation {
 public:
  OfReference(std::shared_ptr<const PluginInstance> reference, std::size_t row, std::size_t rows)
      : reference_(std::move(reference)), row_(row), rows_(rows) {}

  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                double* out) const override {
    const int dim = reference_->dim();
    const auto size = static_cast<std::size_t>(n);
    std::vector<std::vector<double>> value(rows_, std::vector<double>(size)), scale = value;
    std::vector<double*> values, scales;
    for (std::size_t r = 0; r < rows_; ++r) {
      values.push_back(value[r].data());
      scales.push_back(scale[r].data());
    }
    std::vector<std::uint8_t> defined(size);
    const riffle_points points{sizeof(riffle_points), dim, n, {x, dim == 2 ? z : y, dim == 3 ? z : nullptr}, t};
    riffle_error error = no_error();
    const auto status = call_plugin(error, [&] {
      return may_throw(reference_->table().evaluate_reference)(reference_->self(), &points, values.data(),
                                                               scales.data(), defined.data(), &error);
    });
    if (status != RIFFLE_OK) throw RunError(reference_->name() + ": " + message_of(error));
    for (std::size_t k = 0; k < size; ++k) out[k] = defined[k] != 0 ? value[row_][k] : 0;
  }

 private:
  std::shared_ptr<const PluginInstance> reference_;
  std::size_t row_, rows_;
};

}  // namespace

void begin_with_reference(Case& scene, const Registry& registry, const riffle_services& services) {
  if (scene.initial_from_reference.empty()) return;
  const PluginChoice& choice = scene.reference->plugin;
  const auto reference = std::make_shared<const PluginInstance>(*registry.plugin("reference", choice.id),
                                                                scene.dimension, choice.values, &services);
  std::map<std::string, std::pair<std::size_t, std::size_t>> place;  // first row and count of rows
  std::size_t rows = 0;
  for (auto f = reference->table().gives; f != nullptr && *f != nullptr; ++f) {
    const auto count = static_cast<std::size_t>(components(static_cast<Shape>((*f)->shape), scene.dimension));
    place[(*f)->name] = {rows, count};
    rows += count;
  }
  for (const std::string& name : scene.initial_from_reference) {
    const auto [first, count] = place.at(name);
    auto& functions = scene.initial[name];
    functions.clear();
    for (std::size_t c = 0; c < count; ++c) {
      functions.emplace_back(std::make_shared<const OfReference>(reference, first + c, rows), "reference");
    }
  }
}

}  // namespace riffle
