#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

std::size_t components(const riffle_field& field, int dim) {
  const auto d = static_cast<std::size_t>(dim);
  switch (field.shape) {
    case RIFFLE_VECTOR: return d;
    case RIFFLE_SYMMETRIC: return d * (d + 1) / 2;
    case RIFFLE_TENSOR: return d * d;
    default: return 1;
  }
}

// One pointer per component, moved to `first`.
std::vector<double*> moved(std::vector<std::vector<double>>& arrays, std::size_t first) {
  std::vector<double*> pointers;
  for (auto& array : arrays) pointers.push_back(array.data() + first);
  return pointers;
}

}  // namespace

BlockCase::BlockCase(const riffle_pass& pass, int dim, std::size_t n) : pass_(pass), dim_(dim) {
  constexpr std::size_t room = 8;
  for (const riffle_read* read : entries(pass.reads)) {
    in_.emplace_back(components(*read->field, dim), std::vector<double>(n + room, 1.0));
  }
  for (const riffle_write* write : entries(pass.writes)) {
    std::vector<double> array(n, 0.0);
    array.resize(n + room, canary);
    out_.emplace_back(components(*write->field, dim), array);
  }
}

void BlockCase::run(const Instance& instance, std::size_t first, std::size_t count) {
  std::vector<std::vector<double*>> in, out;
  for (auto& arrays : in_) in.push_back(moved(arrays, first));
  for (auto& arrays : out_) out.push_back(moved(arrays, first));
  std::vector<const double* const*> in_tables;
  std::vector<double* const*> out_tables;
  for (auto& pointers : in) in_tables.push_back(pointers.data());
  for (auto& pointers : out) out_tables.push_back(pointers.data());
  const riffle_block block{sizeof(riffle_block),
                           dim_,
                           static_cast<std::int64_t>(count),
                           static_cast<std::int64_t>(first),
                           time_,
                           dt_,
                           in_tables.data(),
                           out_tables.data()};
  riffle_error error{sizeof(riffle_error), {}};
  if (pass_.run(instance.self(), &block, &error) != RIFFLE_OK) throw std::runtime_error(error.message);
}

}  // namespace riffle::contract
