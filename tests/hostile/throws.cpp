// Functions of C++ that throw, for tables written in C, where no compiler notices that they must not.
#include <riffle/abi.h>

#include <stdexcept>

extern "C" {
__attribute__((visibility("hidden"))) void* throwing_create(int32_t, const riffle_value* const*, riffle_error*) {
  throw std::runtime_error("no memory for the table of roughness");
}
__attribute__((visibility("hidden"))) int32_t throwing_run(const void*, const riffle_block* block, riffle_error*) {
  throw std::out_of_range("particle " + std::to_string(block->first) + " is not in the table of roughness");
}
}
