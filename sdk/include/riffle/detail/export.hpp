// From an author's class to the tables of riffle/abi.h. The only place where exceptions are caught.
#pragma once

#include <array>
#include <cstdio>
#include <exception>
#include <tuple>
#include <type_traits>

#include "riffle/abi.h"
#include "riffle/block.hpp"
#include "riffle/values.hpp"

#define RIFFLE_DETAIL_BUILD __VERSION__

namespace riffle {

// What a pass reads and writes: one line each.
constexpr riffle_read at_i(const riffle_field& f, std::uint32_t flags = 0) {
  return {sizeof(riffle_read), RIFFLE_AT_I, flags, 0, &f};
}
constexpr riffle_read at_j(const riffle_field& f, std::uint32_t flags = 0) {
  return {sizeof(riffle_read), RIFFLE_AT_J, flags, 0, &f};
}
constexpr riffle_read difference(const riffle_field& f, std::uint32_t flags = 0) {
  return {sizeof(riffle_read), RIFFLE_DIFFERENCE, flags, 0, &f};
}
constexpr riffle_read mean(const riffle_field& f, std::uint32_t flags = 0) {
  return {sizeof(riffle_read), RIFFLE_MEAN, flags, 0, &f};
}
constexpr riffle_read pair(const riffle_field& f, std::uint32_t flags = 0) {
  return {sizeof(riffle_read), RIFFLE_PAIR, flags, 0, &f};
}
constexpr riffle_write set(const riffle_field& f, std::uint32_t flags = 0) {
  return {sizeof(riffle_write), RIFFLE_SET, flags, 0, &f};
}
constexpr riffle_write sum(const riffle_field& f) {
  return {sizeof(riffle_write), RIFFLE_SUM, 0, 0, &f};
}
constexpr riffle_write least(const riffle_field& f) {
  return {sizeof(riffle_write), RIFFLE_MIN, 0, 0, &f};
}
constexpr riffle_write largest(const riffle_field& f) {
  return {sizeof(riffle_write), RIFFLE_MAX, 0, 0, &f};
}

constexpr riffle_field scalar_field(const char* name, const char* unit, const char* meaning, std::uint32_t flags = 0) {
  return {sizeof(riffle_field), RIFFLE_SCALAR, flags, 0, name, unit, meaning};
}
constexpr riffle_field vector_field(const char* name, const char* unit, const char* meaning, std::uint32_t flags = 0) {
  return {sizeof(riffle_field), RIFFLE_VECTOR, flags, 0, name, unit, meaning};
}
constexpr riffle_evolved evolved_field(const riffle_field& field, const riffle_field& rate,
                                       const riffle_field* damping = nullptr, const char* when = nullptr) {
  return {sizeof(riffle_evolved), 0, &field, &rate, damping, when};
}

template <class... P>
struct Passes {};
template <class... V>
struct Votes {};

namespace detail {

// OPTIONAL(member, type, default): Member<member>::of<P>() is P::member where it exists, else the default.
#define RIFFLE_DETAIL_OPTIONAL(member, type, fallback)       \
  template <class P, class = void>                           \
  struct get_##member {                                      \
    static constexpr type value = fallback;                  \
  };                                                         \
  template <class P>                                         \
  struct get_##member<P, std::void_t<decltype(P::member)>> { \
    static constexpr type value = P::member;                 \
  };
// Optional members of a plugin class.
RIFFLE_DETAIL_OPTIONAL(dims, std::uint32_t, 0xEu)    // bit d: dimension d; all by default
RIFFLE_DETAIL_OPTIONAL(leaves_out, const char*, "")  // what the model does not contain, where it fails
RIFFLE_DETAIL_OPTIONAL(conserved, const riffle_field*, nullptr)
RIFFLE_DETAIL_OPTIONAL(requires_integrator, const char*, nullptr)
RIFFLE_DETAIL_OPTIONAL(state_size, std::int32_t, 0)
// Optional members of a pass.
RIFFLE_DETAIL_OPTIONAL(pass_name, const char*, nullptr)
RIFFLE_DETAIL_OPTIONAL(pass_type, std::int32_t, -1)   // RIFFLE_PASS_...; viscosity: pair, others: particle
RIFFLE_DETAIL_OPTIONAL(pass_flags, std::uint32_t, 0)  // RIFFLE_WITH_SELF | RIFFLE_INITIAL | ...
RIFFLE_DETAIL_OPTIONAL(targets, std::uint32_t, 0)
RIFFLE_DETAIL_OPTIONAL(sources, std::uint32_t, 0)
RIFFLE_DETAIL_OPTIONAL(neighbours, std::uint32_t, RIFFLE_GATHER)
RIFFLE_DETAIL_OPTIONAL(iteration, const char*, nullptr)
RIFFLE_DETAIL_OPTIONAL(when, const char*, nullptr)
RIFFLE_DETAIL_OPTIONAL(every, const char*, nullptr)
RIFFLE_DETAIL_OPTIONAL(interval, const char*, nullptr)
// Optional members of a vote.
RIFFLE_DETAIL_OPTIONAL(scaled, std::uint32_t, 1)
#undef RIFFLE_DETAIL_OPTIONAL

#define RIFFLE_DETAIL_HAS(member)           \
  template <class P, class = void>          \
  struct has_##member : std::false_type {}; \
  template <class P>                        \
  struct has_##member<P, std::void_t<decltype(&P::member)>> : std::true_type {};
RIFFLE_DETAIL_HAS(parameters)
RIFFLE_DETAIL_HAS(reads)
RIFFLE_DETAIL_HAS(writes)
RIFFLE_DETAIL_HAS(iterations)
RIFFLE_DETAIL_HAS(evolved)
RIFFLE_DETAIL_HAS(initial)
RIFFLE_DETAIL_HAS(gives)
RIFFLE_DETAIL_HAS(describe)
RIFFLE_DETAIL_HAS(evaluate)
RIFFLE_DETAIL_HAS(exact)
RIFFLE_DETAIL_HAS(begin)
RIFFLE_DETAIL_HAS(edit)
RIFFLE_DETAIL_HAS(images)
RIFFLE_DETAIL_HAS(refuses)
RIFFLE_DETAIL_HAS(connect)
RIFFLE_DETAIL_HAS(profile)
#undef RIFFLE_DETAIL_HAS

template <class P, class = void>
struct passes_of {  // a class that is its own pass, or none
  using type = std::conditional_t<has_reads<P>::value, Passes<P>, Passes<>>;
};
template <class P>
struct passes_of<P, std::void_t<typename P::passes>> {
  using type = typename P::passes;
};
template <class P, class = void>
struct votes_of {
  using type = Votes<>;
};
template <class P>
struct votes_of<P, std::void_t<typename P::votes>> {
  using type = typename P::votes;
};

// Null-terminated table of pointers to the elements of an array.
template <class T, std::size_t N>
constexpr std::array<const T*, N + 1> table(const T (&items)[N]) {
  std::array<const T*, N + 1> pointers{};
  for (std::size_t k = 0; k < N; ++k) pointers[k] = &items[k];
  return pointers;
}
template <class T, std::size_t N>
constexpr std::array<const T*, N + 1> table(const T* const (&items)[N]) {
  std::array<const T*, N + 1> pointers{};
  for (std::size_t k = 0; k < N; ++k) pointers[k] = items[k];
  return pointers;
}

constexpr bool same_word(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) ++a, ++b;
  return *a == *b;
}

// Runs `work`, turning what it throws into an error with text.
template <class Work>
std::int32_t guarded(riffle_error* error, Work work) noexcept {
  try {
    work();
    return RIFFLE_OK;
  } catch (const std::exception& e) {
    if (error != nullptr) std::snprintf(error->message, sizeof error->message, "%s", e.what());
  } catch (...) {
    if (error != nullptr) std::snprintf(error->message, sizeof error->message, "an exception of unknown type");
  }
  return RIFFLE_ERROR;
}

template <class P, class Pass>
struct PassTable {
  static std::int32_t run(const void* self, const riffle_block* block, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (std::is_same_v<P, Pass>) {
        static_cast<const P*>(self)->run(Block(*block));
      } else if constexpr (type != RIFFLE_PASS_GLOBAL) {
        Pass::run(*static_cast<const P*>(self), Block(*block));
      }
    });
  }
  static std::int32_t run_global(const void* self, const riffle_block* block, const riffle_pairs* pairs,
                                 riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (type == RIFFLE_PASS_GLOBAL) Pass::run(*static_cast<const P*>(self), Block(*block), *pairs);
    });
  }
  static constexpr std::int32_t type = get_pass_type<Pass>::value >= 0 ? get_pass_type<Pass>::value
                                       : same_word(P::kind, "viscosity")
                                           ? static_cast<std::int32_t>(RIFFLE_PASS_PAIR)
                                           : static_cast<std::int32_t>(RIFFLE_PASS_PARTICLE);
  static constexpr auto reads = [] {
    if constexpr (has_reads<Pass>::value)
      return table(Pass::reads);
    else
      return std::array<const riffle_read*, 1>{};
  }();
  static constexpr auto writes = table(Pass::writes);
  static constexpr const char* name = [] {
    if constexpr (std::is_same_v<P, Pass>)
      return get_pass_name<P>::value != nullptr ? get_pass_name<P>::value : P::id;
    else
      return Pass::pass_name;
  }();
  static constexpr riffle_pass value{sizeof(riffle_pass),
                                     static_cast<std::uint32_t>(type),
                                     get_targets<Pass>::value,
                                     get_sources<Pass>::value,
                                     get_neighbours<Pass>::value,
                                     get_pass_flags<Pass>::value,
                                     name,
                                     reads.data(),
                                     writes.data(),
                                     get_iteration<Pass>::value,
                                     get_when<Pass>::value,
                                     get_every<Pass>::value,
                                     get_interval<Pass>::value,
                                     type == RIFFLE_PASS_GLOBAL ? nullptr : &run,
                                     type == RIFFLE_PASS_GLOBAL ? &run_global : nullptr};
};

template <class P, class Vote>
struct VoteTable {
  static double limit(const void* self, const riffle_block* block) noexcept {
    return Vote::limit(*static_cast<const P*>(self), Block(*block));
  }
  static constexpr auto reads = table(Vote::reads);
  static constexpr riffle_vote value{sizeof(riffle_vote),
                                     get_targets<Vote>::value,
                                     get_scaled<Vote>::value,
                                     0,
                                     Vote::name,
                                     get_when<Vote>::value,
                                     reads.data(),
                                     &limit};
};

template <class P, class List>
struct pass_tables;
template <class P, class... Pass>
struct pass_tables<P, Passes<Pass...>> {
  static constexpr std::array<const riffle_pass*, sizeof...(Pass) + 1> value{&PassTable<P, Pass>::value..., nullptr};
};
template <class P, class List>
struct vote_tables;
template <class P, class... Vote>
struct vote_tables<P, Votes<Vote...>> {
  static constexpr std::array<const riffle_vote*, sizeof...(Vote) + 1> value{&VoteTable<P, Vote>::value..., nullptr};
};

#define RIFFLE_DETAIL_TABLE(member, type)  \
  static constexpr auto member = [] {      \
    if constexpr (has_##member<P>::value)  \
      return table(P::member);             \
    else                                   \
      return std::array<const type*, 1>{}; \
  }();

template <class P>
struct Plugin {
  RIFFLE_DETAIL_TABLE(parameters, riffle_parameter)
  RIFFLE_DETAIL_TABLE(iterations, riffle_iteration)
  RIFFLE_DETAIL_TABLE(evolved, riffle_evolved)
  RIFFLE_DETAIL_TABLE(initial, riffle_field)
  RIFFLE_DETAIL_TABLE(gives, riffle_field)
  RIFFLE_DETAIL_TABLE(refuses, riffle_refusal)

  static void* create(std::int32_t dim, const riffle_value* const* values, riffle_error* error) noexcept {
    void* self = nullptr;
    guarded(error, [&] {
      if constexpr (has_parameters<P>::value) {
        self = new P(Values(dim, P::parameters, parameters.size() - 1, values));
      } else {
        self = new P(Values(dim, nullptr, 0, values));
      }
    });
    return self;
  }
  static void destroy(void* self) noexcept { delete static_cast<P*>(self); }
  static void kernel(const void* self, riffle_kernel* out) noexcept {
    if constexpr (has_describe<P>::value) *out = static_cast<const P*>(self)->describe();
  }
  static std::int32_t evaluate_kernel(const void* self, std::int64_t n, const double* r, const double* inverse_l,
                                      std::uint32_t want, double* const* out) noexcept {
    if constexpr (has_evaluate<P>::value) static_cast<const P*>(self)->evaluate(n, r, inverse_l, want, out);
    return RIFFLE_OK;
  }
  static std::int32_t evaluate_reference(const void* self, const riffle_points* points, double* const* values,
                                         double* const* scales, std::uint8_t* defined, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (has_exact<P>::value) static_cast<const P*>(self)->exact(*points, values, scales, defined);
    });
  }
  static std::int32_t begin(const void* self, const riffle_editor* editor, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (has_begin<P>::value) static_cast<const P*>(self)->begin(*editor);
    });
  }
  static std::int32_t edit(const void* self, const riffle_editor* editor, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (has_edit<P>::value) static_cast<const P*>(self)->edit(*editor);
    });
  }
  static std::int32_t images(const void* self, const riffle_editor* editor, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (has_images<P>::value) static_cast<const P*>(self)->images(*editor);
    });
  }

  static std::int32_t connect(void* self, const riffle_services* services, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (has_connect<P>::value) static_cast<P*>(self)->connect(*services);
    });
  }
  static std::int32_t evaluate_profile(const void* self, std::int64_t n, const double* x, const double* y,
                                       double* value, double* slope_x, double* slope_y, riffle_error* error) noexcept {
    return guarded(error, [&] {
      if constexpr (has_profile<P>::value) static_cast<const P*>(self)->profile(n, x, y, value, slope_x, slope_y);
    });
  }

  static constexpr riffle_plugin value{sizeof(riffle_plugin),
                                       get_dims<P>::value,
                                       P::id,
                                       P::kind,
                                       P::version,
                                       P::summary,
                                       P::source,
                                       get_leaves_out<P>::value,
                                       parameters.data(),
                                       pass_tables<P, typename passes_of<P>::type>::value.data(),
                                       iterations.data(),
                                       vote_tables<P, typename votes_of<P>::type>::value.data(),
                                       evolved.data(),
                                       initial.data(),
                                       get_conserved<P>::value,
                                       get_requires_integrator<P>::value,
                                       &create,
                                       &destroy,
                                       has_describe<P>::value ? &kernel : nullptr,
                                       has_evaluate<P>::value ? &evaluate_kernel : nullptr,
                                       get_state_size<P>::value,
                                       0,
                                       has_begin<P>::value ? &begin : nullptr,
                                       has_edit<P>::value ? &edit : nullptr,
                                       has_images<P>::value ? &images : nullptr,
                                       gives.data(),
                                       has_exact<P>::value ? &evaluate_reference : nullptr,
                                       refuses.data(),
                                       has_connect<P>::value ? &connect : nullptr,
                                       has_profile<P>::value ? &evaluate_profile : nullptr};
};
#undef RIFFLE_DETAIL_TABLE

template <class... P>
struct Library {
  static constexpr const riffle_plugin* plugins[] = {&Plugin<P>::value..., nullptr};
};

}  // namespace detail
}  // namespace riffle
