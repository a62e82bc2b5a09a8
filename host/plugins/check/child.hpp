// A check in a process of its own: a crash is a failure of the plugin and not the end of the program.
#pragma once

#include <chrono>
#include <functional>

#include "host/plugins/check/checks.hpp"

namespace riffle::check {

// Runs `work` in a forked child and brings its findings back. A child that dies, throws or takes longer than `limit` has
// failed, and the finding says how. Must be called while the program has one thread.
Findings in_child(const std::function<Findings()>& work, std::chrono::milliseconds limit);

}  // namespace riffle::check
