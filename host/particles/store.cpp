#include "host/particles/store.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>

namespace riffle {

const char* role_name(int role) {
  static constexpr std::array<const char*, role_count> names{"fluid", "wall", "inflow", "outflow", "piston", "probe"};
  return names.at(static_cast<std::size_t>(role));
}

void AlignedArray::Free::operator()(double* p) const {
  std::free(p);
}

AlignedArray::AlignedArray(std::size_t n) {
  resize(n);
}

void AlignedArray::resize(std::size_t n) {
  if (n == size_) return;
  const std::size_t rounded = (n + 7) / 8 * 8;
  if (data_ == nullptr || rounded > capacity_) {
    const std::size_t room = data_ == nullptr ? std::max<std::size_t>(rounded, 8) : (rounded + rounded / 8 + 7) / 8 * 8;
    auto* fresh = static_cast<double*>(std::aligned_alloc(64, room * sizeof(double)));
    if (fresh == nullptr) throw std::bad_alloc();
    if (size_ > 0) std::memcpy(fresh, data_.get(), size_ * sizeof(double));
    data_.reset(fresh);
    capacity_ = room;
  }
  if (n > size_) std::fill(data_.get() + size_, data_.get() + rounded, 0.0);
  size_ = n;
}

Field& ParticleStore::add_field(const FieldDescription& description, FieldUse use) {
  auto& slot = fields_[description.name];
  if (slot == nullptr) {
    slot = std::make_unique<Field>();
    slot->description = description;
    slot->use = use;
    slot->component.resize(static_cast<std::size_t>(components(description.shape, dim_)));
    make_room();
  }
  return *slot;
}

Field* ParticleStore::find(const std::string& name) {
  const auto found = fields_.find(name);
  return found == fields_.end() ? nullptr : found->second.get();
}

const Field* ParticleStore::find(const std::string& name) const {
  const auto found = fields_.find(name);
  return found == fields_.end() ? nullptr : found->second.get();
}

Field& ParticleStore::at(const std::string& name) {
  Field* field = find(name);
  if (field == nullptr) throw std::logic_error("the particle store has no field \"" + name + "\"");
  return *field;
}

const Field& ParticleStore::at(const std::string& name) const {
  const Field* field = find(name);
  if (field == nullptr) throw std::logic_error("the particle store has no field \"" + name + "\"");
  return *field;
}

double* ParticleStore::data(const std::string& name, int component) {
  return at(name).component[static_cast<std::size_t>(component)].data();
}

const double* ParticleStore::data(const std::string& name, int component) const {
  return at(name).component[static_cast<std::size_t>(component)].data();
}

int ParticleStore::role_of(std::int64_t i) const {
  int role = 0;
  while (i >= role_begin_[static_cast<std::size_t>(role) + 1]) ++role;
  return role;
}

void ParticleStore::resize_owned(const std::array<std::int64_t, role_count>& per_role) {
  owned_ = 0;
  for (std::size_t r = 0; r < role_count; ++r) {
    role_begin_[r] = owned_;
    owned_ += per_role[r];
  }
  role_begin_[role_count] = owned_;
  images_ = 0;
  ids_.resize(static_cast<std::size_t>(owned_));
  make_room();
}

void ParticleStore::resize_images(std::int64_t n) {
  images_ = n;
  make_room();
}

void ParticleStore::make_room() {
  const auto needed = static_cast<std::size_t>(owned_ + images_ + 1);
  for (auto& [name, field] : fields_) {
    for (auto& array : field->component) array.resize(needed);
  }
}

void ParticleStore::rearrange(const std::vector<std::int64_t>& order,
                              const std::array<std::int64_t, role_count>& per_role,
                              const std::vector<std::int64_t>& ids) {
  std::vector<double> kept(order.size());
  for (auto& [name, field] : fields_) {
    for (auto& array : field->component) {
      for (std::size_t k = 0; k < order.size(); ++k) kept[k] = array.data()[order[k]];
      array.resize(order.size() + 1);
      std::copy(kept.begin(), kept.end(), array.data());
    }
  }
  resize_owned(per_role);
  for (std::size_t k = 0; k < order.size(); ++k) ids_[k] = ids[static_cast<std::size_t>(order[k])];
}

void ParticleStore::permute(const std::vector<std::int64_t>& order) {
  const auto n = static_cast<std::size_t>(owned_);
  std::vector<double> old(n);
  for (auto& [name, field] : fields_) {
    for (auto& array : field->component) {
      double* values = array.data();
      std::copy(values, values + n, old.begin());
      for (std::size_t k = 0; k < n; ++k) values[k] = old[static_cast<std::size_t>(order[k])];
    }
  }
  std::vector<std::int64_t> old_ids(ids_);
  for (std::size_t k = 0; k < n; ++k) ids_[k] = old_ids[static_cast<std::size_t>(order[k])];
}

std::size_t ParticleStore::bytes() const {
  std::size_t sum = ids_.size() * sizeof(std::int64_t);
  for (const auto& [name, field] : fields_) {
    for (const auto& array : field->component) sum += array.size() * sizeof(double);
  }
  return sum;
}

}  // namespace riffle
