// How the host calls into a plugin. No exception may cross the boundary, and the SDK lets none through; but a function
// that was cast to fit the table can still throw. Called through a pointer type that may throw, it becomes an ordinary
// failure here instead of the end of the program.
#pragma once

#include <cstdint>
#include <cstring>
#include <exception>
#include <string>

#include "riffle/abi.h"

namespace riffle {

// The same function as one that may throw.
template <class Result, class... Arguments>
constexpr auto may_throw(Result (*function)(Arguments...) noexcept) -> Result (*)(Arguments...) {
  return function;
}

inline void set_message(riffle_error& error, const std::string& text) {
  const std::size_t length = text.size() < sizeof error.message ? text.size() : sizeof error.message - 1;
  std::memcpy(error.message, text.data(), length);
  error.message[length] = '\0';
}

// What the plugin wrote, on one line; plugins in C may forget the end.
inline std::string message_of(const riffle_error& error) {
  std::string text(error.message, strnlen(error.message, sizeof error.message));
  for (char& c : text) c = c == '\n' || c == '\r' ? ' ' : c;
  return text.empty() ? "it gave no reason" : text;
}

inline riffle_error no_error() {
  riffle_error error{};
  error.size = sizeof error;
  return error;
}

// `call` returns a status; an exception becomes RIFFLE_ERROR with its text.
template <class Call>
std::int32_t call_plugin(riffle_error& error, Call call) {
  try {
    return call();
  } catch (const std::exception& e) {
    set_message(error, std::string("an exception left the plugin: ") + e.what());
  } catch (...) {
    set_message(error, "an exception of unknown type left the plugin");
  }
  return RIFFLE_ERROR;
}

// RIFFLE_OK, or another status with a message in `error` (see message_of).
inline std::int32_t run_pass(const riffle_pass& pass, const void* self, const riffle_block& block,
                             riffle_error& error) {
  return call_plugin(error, [&] { return may_throw(pass.run)(self, &block, &error); });
}

}  // namespace riffle
