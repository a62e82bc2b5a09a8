// 64-byte aligned array of int32 that grows without touching its new places: a list of millions of pairs is written
// once, by the threads that fill it.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

namespace riffle {

class IndexArray {
 public:
  static constexpr std::int64_t slack = 16;  // values readable and writable past the end

  [[nodiscard]] std::int32_t* data() { return data_.get(); }
  [[nodiscard]] const std::int32_t* data() const { return data_.get(); }
  [[nodiscard]] std::int64_t size() const { return size_; }
  [[nodiscard]] std::int64_t capacity() const { return capacity_; }
  [[nodiscard]] std::int32_t operator[](std::int64_t k) const { return data_[static_cast<std::size_t>(k)]; }
  std::int32_t& operator[](std::int64_t k) { return data_[static_cast<std::size_t>(k)]; }

  // Makes room for n values; keeps those that are there.
  void reserve(std::int64_t n) {
    if (data_ != nullptr && n <= capacity_) return;
    const auto bytes = (static_cast<std::size_t>(n + slack) * sizeof(std::int32_t) + 63) / 64 * 64;
    std::unique_ptr<std::int32_t[], Free> fresh(static_cast<std::int32_t*>(std::aligned_alloc(64, bytes)));
    if (fresh == nullptr) throw std::bad_alloc();
    if (data_ != nullptr) std::memcpy(fresh.get(), data_.get(), static_cast<std::size_t>(size_) * sizeof(std::int32_t));
    data_ = std::move(fresh);
    capacity_ = n;
  }

  // Keeps the first min(old, new) values; new ones are undefined.
  void resize(std::int64_t n) {
    if (data_ == nullptr || n > capacity_) reserve(n + n / 2);
    size_ = n;
  }

 private:
  struct Free {
    void operator()(std::int32_t* p) const { std::free(p); }
  };

  std::unique_ptr<std::int32_t[], Free> data_;
  std::int64_t size_ = 0, capacity_ = 0;
};

}  // namespace riffle
