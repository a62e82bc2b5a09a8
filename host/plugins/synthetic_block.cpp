#include "host/plugins/synthetic_block.hpp"

#include <sys/mman.h>

#include <cstring>
#include <limits>
#include <new>

#include "host/plugins/descriptor_checks.hpp"
#include "host/plugins/dictionary.hpp"

namespace riffle {
namespace {

constexpr std::int64_t canary_count = 8;
constexpr std::uint64_t canary_bits = 0x7ff4dead0ca9a127U;  // a NaN that no arithmetic makes

double canary() {
  double value = 0;
  std::memcpy(&value, &canary_bits, sizeof value);
  return value;
}

bool is_canary(const double* value) {
  return std::memcmp(value, &canary_bits, sizeof canary_bits) == 0;
}

constexpr std::int64_t round_up(std::int64_t n, std::int64_t step) {
  return (n + step - 1) / step * step;
}

// Whole pages, so that they can be protected.
double* allocate_pages(std::size_t bytes) {
  if (bytes == 0) return nullptr;
  void* pages = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) throw std::bad_alloc();
  return static_cast<double*>(pages);
}

int component_count(const riffle_field& field, int dim) {
  return riffle::components(static_cast<Shape>(field.shape), dim);
}

}  // namespace

SyntheticBlock::SyntheticBlock(const SyntheticScene& scene, const riffle_pass& pass,
                               const std::vector<std::int64_t>& items)
    : SyntheticBlock(scene, pass.type == RIFFLE_PASS_PAIR, pass.reads, pass.writes, items) {}

SyntheticBlock::SyntheticBlock(const SyntheticScene& scene, const riffle_vote& vote,
                               const std::vector<std::int64_t>& items)
    : SyntheticBlock(scene, false, vote.reads, nullptr, items) {}

SyntheticBlock::SyntheticBlock(const SyntheticScene& scene, bool pairs, const riffle_read* const* reads,
                               const riffle_write* const* writes, const std::vector<std::int64_t>& items) {
  const auto n = static_cast<std::int64_t>(items.size());
  writable_ = pairs ? round_up(n, 8) : n;
  stride_ = static_cast<std::size_t>(round_up(writable_ + canary_count, 8));

  std::size_t input_arrays = 0, output_arrays = 0;
  for (const riffle_read* read : Table(reads)) {
    input_arrays += static_cast<std::size_t>(component_count(*read->field, scene.dim));
  }
  for (const riffle_write* write : Table(writes)) {
    output_arrays += static_cast<std::size_t>(component_count(*write->field, scene.dim));
  }
  input_bytes_ = input_arrays * stride_ * sizeof(double);
  output_bytes_ = output_arrays * stride_ * sizeof(double);
  inputs_ = allocate_pages(input_bytes_);
  outputs_ = allocate_pages(output_bytes_);

  double* next = inputs_;
  for (const riffle_read* read : Table(reads)) {
    auto& row = in_.emplace_back();
    for (int c = 0; c < component_count(*read->field, scene.dim); ++c, next += stride_) row.push_back(next);
  }
  fill(scene, reads, items);
  next = outputs_;
  for (const riffle_write* write : Table(writes)) {
    const bool adds = !pairs && write->how == RIFFLE_SUM;
    auto& row = out_.emplace_back();
    for (int c = 0; c < component_count(*write->field, scene.dim); ++c, next += stride_) {
      row.push_back(next);
      std::fill_n(next, writable_, adds ? 0.0 : std::numeric_limits<double>::quiet_NaN());
      std::fill_n(next + writable_, stride_ - static_cast<std::size_t>(writable_), canary());
    }
  }

  std::size_t k = 0;
  for (const riffle_read* read : Table(reads)) {
    const bool absent = (read->flags & RIFFLE_OPTIONAL) != 0 && !scene.optional;
    in_table_.push_back(absent ? nullptr : in_[k].data());
    ++k;
  }
  for (auto& row : out_) out_table_.push_back(row.data());
  block_ = {sizeof(riffle_block), scene.dim,        n, 0, 0.75 * scene.scale.second, 0.0009765625 * scene.scale.second,
            in_table_.data(),     out_table_.data()};
}

SyntheticBlock::~SyntheticBlock() {
  if (inputs_ != nullptr) munmap(inputs_, input_bytes_);
  if (outputs_ != nullptr) munmap(outputs_, output_bytes_);
}

void SyntheticBlock::fill(const SyntheticScene& scene, const riffle_read* const* reads,
                          const std::vector<std::int64_t>& items) {
  for (std::size_t k = 0; k < in_.size(); ++k) {
    for (std::size_t c = 0; c < in_[k].size(); ++c) {
      double* values = in_[k][c];
      for (std::size_t p = 0; p < items.size(); ++p) {
        values[p] = scene.value(*reads[k]->field, reads[k]->where, static_cast<int>(c), items[p]);
      }
      // The padding of a real block holds values of some pair; what lies behind it is nobody's business.
      const auto n = static_cast<std::int64_t>(items.size());
      std::fill(values + n, values + writable_, n > 0 ? values[0] : 0.0);
      std::fill(values + writable_, values + stride_, canary());
    }
  }
}

void SyntheticBlock::protect_inputs() {
  if (inputs_ != nullptr) mprotect(inputs_, input_bytes_, PROT_READ);
}

int SyntheticBlock::overrun_output() const {
  for (std::size_t k = 0; k < out_.size(); ++k) {
    for (const double* values : out_[k]) {
      for (std::size_t p = static_cast<std::size_t>(writable_); p < stride_; ++p) {
        if (!is_canary(values + p)) return static_cast<int>(k);
      }
    }
  }
  return -1;
}

}  // namespace riffle
