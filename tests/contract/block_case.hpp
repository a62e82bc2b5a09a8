// A block of made-up values for one pass, with room to see whether the pass writes past its end.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {

inline constexpr double canary = 7.25e77;

class BlockCase {
 public:
  BlockCase(const riffle_pass& pass, int dim, std::size_t n);
  // Components of read k, component c of read k / write k: n values and some room.
  std::vector<std::vector<double>>& read(std::size_t k) { return in_[k]; }
  std::vector<double>& in(std::size_t k, std::size_t c = 0) { return in_[k][c]; }
  std::vector<double>& out(std::size_t k, std::size_t c = 0) { return out_[k][c]; }
  [[nodiscard]] const std::vector<std::vector<std::vector<double>>>& outputs() const { return out_; }
  void at(double time, double dt) {
    time_ = time;
    dt_ = dt;
  }
  // Runs the pass on values [first, first + count). Throws std::runtime_error with the plugin's sentence.
  void run(const Instance& instance, std::size_t first, std::size_t count);

 private:
  const riffle_pass& pass_;
  int dim_;
  double time_ = 0.5, dt_ = 0.001;
  std::vector<std::vector<std::vector<double>>> in_, out_;
};

}  // namespace riffle::contract
