// Times several pieces of code against one another on a machine that does other things too.
#pragma once

#include <functional>
#include <vector>

namespace riffle::bench {

// CPU time of the calling thread, s. Code that hands work to other threads must be run with one.
double thread_cpu_time();

// Runs each callable once to warm up, then all of them in turn `repeats` times, so that whatever slows the machine
// slows all of them, and returns the median CPU time of each, s.
std::vector<double> time_interleaved(const std::vector<std::function<void()>>& callables, int repeats);

}  // namespace riffle::bench
