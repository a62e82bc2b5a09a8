// riffle/sdk.hpp: write a closure as a small class. Header-only C++17 over the C boundary of riffle/abi.h.
//
//   struct MyDrag {
//     static constexpr auto id = "my-drag", kind = "drag", version = "1.0.0";
//     static constexpr auto summary = "one line", source = "author, year, equation";
//     static constexpr riffle_parameter parameters[] = {riffle::real("n", "1", 0.03, 0, 1, "what it is, how to choose")};
//     static constexpr riffle_read reads[] = {riffle::at_i(riffle::fields::velocity), ...};
//     static constexpr riffle_write writes[] = {riffle::sum(riffle::fields::drag_rate)};
//     explicit MyDrag(const riffle::Values& values) : n(values.number("n")) {}
//     void run(const riffle::Block& b) const { RIFFLE_EACH(k, b) b.out(0)[k] += ...; }
//     double n;
//   };
//   RIFFLE_PLUGIN(MyDrag)
//
// A class with one pass has `reads`, `writes` and `run` itself; one with several has `using passes = riffle::Passes<A,
// B, ...>`, where each of A, B, ... has them, with a static `run(const Plugin&, const Block&)`. Optional members are
// listed at the end of riffle/detail/export.hpp. Exceptions thrown in a constructor or in run become errors with text.
#pragma once

#include "riffle/block.hpp"
#include "riffle/detail/export.hpp"
#include "riffle/fields.hpp"
#include "riffle/values.hpp"

// Makes a library of one or more plugins.
#define RIFFLE_PLUGIN(...)                                               \
  extern "C" RIFFLE_EXPORT constexpr riffle_library riffle_plugin_entry{ \
      sizeof(riffle_library), RIFFLE_ABI_MAJOR,    RIFFLE_ABI_MINOR,     \
      sizeof(double),         RIFFLE_DETAIL_BUILD, riffle::detail::Library<__VA_ARGS__>::plugins};
