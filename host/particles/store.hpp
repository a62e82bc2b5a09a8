// The particle store: fields on demand, one contiguous array of double per component.
//
// Layout of every array: [owned | images | one dummy]. Owned particles are grouped by role (fluid first, then wall,
// inflow, outflow, piston, probe), so that a pass over one role is a pass over a contiguous range. Images (mirror and
// periodic copies; later: particles of other processes) follow; the dummy pads neighbour lists.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/plugins/description.hpp"

namespace riffle {

inline constexpr int role_count = 6;  // fluid, wall, inflow, outflow, piston, probe
const char* role_name(int role);

// What a field is to the schedule; decides what a checkpoint holds.
enum class FieldUse {
  evolved,    // advanced by the integrator: in checkpoints
  attribute,  // constant after t = 0: in checkpoints
  carried,    // its previous value is read again: in checkpoints
  derived     // recomputed from the others
};

// 64-byte aligned array of double with spare capacity.
class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(std::size_t n);
  [[nodiscard]] double* data() { return data_.get(); }
  [[nodiscard]] const double* data() const { return data_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  void resize(std::size_t n);  // keeps the first min(old, new) values; new ones are 0

 private:
  struct Free {
    void operator()(double* p) const;
  };
  std::unique_ptr<double[], Free> data_;
  std::size_t size_ = 0, capacity_ = 0;
};

struct Field {
  FieldDescription description;
  FieldUse use = FieldUse::derived;
  std::vector<AlignedArray> component;
};

class ParticleStore {
 public:
  explicit ParticleStore(int dim) : dim_(dim) {}

  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] std::int64_t owned() const { return owned_; }
  [[nodiscard]] std::int64_t images() const { return images_; }
  [[nodiscard]] std::int64_t all() const { return owned_ + images_; }  // the dummy has this index
  // owned particles of a role: [role_begin(r), role_begin(r + 1))
  [[nodiscard]] std::int64_t role_begin(int role) const { return role_begin_[static_cast<std::size_t>(role)]; }

  // Adds the field unless it exists. Returns it; references stay valid.
  Field& add_field(const FieldDescription& description, FieldUse use);
  [[nodiscard]] Field* find(const std::string& name);
  [[nodiscard]] const Field* find(const std::string& name) const;
  [[nodiscard]] Field& at(const std::string& name);
  [[nodiscard]] const Field& at(const std::string& name) const;
  [[nodiscard]] const std::map<std::string, std::unique_ptr<Field>>& fields() const { return fields_; }
  [[nodiscard]] double* data(const std::string& name, int component = 0);
  [[nodiscard]] const double* data(const std::string& name, int component = 0) const;

  [[nodiscard]] std::vector<std::int64_t>& ids() { return ids_; }
  [[nodiscard]] const std::vector<std::int64_t>& ids() const { return ids_; }
  [[nodiscard]] int role_of(std::int64_t i) const;

  // Sets the numbers per role (sum = owned) and makes room; values of new places are 0. Ids are left to the caller.
  void resize_owned(const std::array<std::int64_t, role_count>& per_role);
  void resize_images(std::int64_t n);
  // New owned particles: place k gets what was at place order[k] of the owned ones and of the images behind them, which
  // are given up; ids[i] is the id of old place i.
  void rearrange(const std::vector<std::int64_t>& order, const std::array<std::int64_t, role_count>& per_role,
                 const std::vector<std::int64_t>& ids);
  // Reorders owned particles: new place k gets old place order[k]. Roles must stay grouped.
  void permute(const std::vector<std::int64_t>& order);

  [[nodiscard]] std::size_t bytes() const;  // of all arrays

 private:
  void make_room();

  int dim_;
  std::int64_t owned_ = 0, images_ = 0;
  std::array<std::int64_t, role_count + 1> role_begin_{};
  std::map<std::string, std::unique_ptr<Field>> fields_;
  std::vector<std::int64_t> ids_;
};

}  // namespace riffle
