// Blocks of made-up pairs and particles, laid out as the block runner lays out real ones, to see what a pass does with
// them. Contracts at load and `riffle check` use them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/plugins/unit.hpp"
#include "riffle/abi.h"

namespace riffle {

// How long a kilogram, a metre and a second are: powers of two, so that rescaling is exact.
struct UnitScale {
  double kilogram = 1, metre = 1, second = 1;
  [[nodiscard]] double of(const Unit& unit, int dim) const;
};

// The numbers. Each depends only on the field, the side, the component and the item (pair or particle), so that blocks
// cut or ordered differently hold the same ones. Lengths, depths, densities and whatever the dictionary does not know
// are positive; velocities, slopes, pressures have either sign. Geometry and kernel outputs fit the positions,
// velocities and smoothing lengths.
struct SyntheticScene {
  int dim = 1;
  std::uint64_t seed = 1;
  UnitScale scale;
  bool swapped = false;    // i and j change places in every pair
  bool at_rest = false;    // all velocities are zero
  bool optional = true;    // optional reads are provided
  bool with_self = false;  // every sixteenth pair is that of a particle with itself

  // Value of a read for one item, in SI divided by nothing: already multiplied by `scale`.
  [[nodiscard]] double value(const riffle_field& field, std::uint32_t where, int component, std::int64_t item) const;

 private:
  [[nodiscard]] double at(const riffle_field& field, bool neighbour, int component, std::int64_t item) const;
  [[nodiscard]] double separation(int component, std::int64_t item) const;
  [[nodiscard]] double of_pair(const riffle_field& field, std::uint32_t where, int component, std::int64_t item) const;
  [[nodiscard]] double kernel(const std::string& name, double r, double l) const;
};

// Items 0 .. n-1.
std::vector<std::int64_t> first_items(std::int64_t n);

// Arrays of one call and what they hold after it. Outputs that the pass must set hold NaN before; those to which it adds
// hold 0. Behind each array lie canaries: behind the last pair padded to a multiple of 8, behind the last particle.
class SyntheticBlock {
 public:
  SyntheticBlock(const SyntheticScene& scene, const riffle_pass& pass, const std::vector<std::int64_t>& items);
  SyntheticBlock(const SyntheticScene& scene, const riffle_vote& vote, const std::vector<std::int64_t>& items);
  ~SyntheticBlock();
  SyntheticBlock(const SyntheticBlock&) = delete;
  SyntheticBlock& operator=(const SyntheticBlock&) = delete;

  [[nodiscard]] const riffle_block& block() const { return block_; }
  [[nodiscard]] std::int64_t size() const { return block_.n; }
  [[nodiscard]] int outputs() const { return static_cast<int>(out_.size()); }
  [[nodiscard]] int components(int output) const {
    return static_cast<int>(out_[static_cast<std::size_t>(output)].size());
  }
  [[nodiscard]] const double* in(int read, int component = 0) const { return block_.in[read][component]; }
  [[nodiscard]] const double* out(int output, int component = 0) const { return block_.out[output][component]; }

  // From now on a write to an input is a segmentation fault.
  void protect_inputs();
  // Index of the first output whose canaries are gone; -1 when all are there.
  [[nodiscard]] int overrun_output() const;

 private:
  using Rows = std::vector<std::vector<double*>>;
  SyntheticBlock(const SyntheticScene& scene, bool pairs, const riffle_read* const* reads,
                 const riffle_write* const* writes, const std::vector<std::int64_t>& items);
  void fill(const SyntheticScene& scene, const riffle_read* const* reads, const std::vector<std::int64_t>& items);

  std::int64_t writable_ = 0;  // values per array that the pass may touch
  std::size_t stride_ = 0;     // doubles from one array to the next
  double *inputs_ = nullptr, *outputs_ = nullptr;
  std::size_t input_bytes_ = 0, output_bytes_ = 0;
  Rows in_, out_;
  std::vector<const double* const*> in_table_;
  std::vector<double* const*> out_table_;
  riffle_block block_{};
};

}  // namespace riffle
