// Child processes on the cores of this machine. A child that crashes or hangs harms nobody; children die with the parent,
// so that a study that was killed leaves nothing running.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace riffle {

struct Job {
  std::vector<std::string> command;  // a program by its path, and its arguments
  int threads = 1;                   // cores that it takes
  double time_limit = 0;             // s of wall time, then it is stopped; 0: none
  std::filesystem::path said;        // what it prints goes here
};

struct JobEnd {
  int exit_code = 0, signal = 0;  // signal: 0 unless one ended it
  bool too_slow = false;
  double wall_seconds = 0;
};

// The user pressed Ctrl-C, or the process was asked to end.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct PoolOptions {
  int cores = 1;           // jobs run together while their threads fit; one always runs
  bool exclusive = false;  // one at a time
};

// Runs all jobs, in order as far as cores allow; `ended` is called for each, by its index, in this process. Throws
// Interrupted, after all children have been stopped.
void run_jobs(const std::vector<Job>& jobs, const PoolOptions& options,
              const std::function<void(std::size_t, const JobEnd&)>& ended);

// Cores that this process may use.
int usable_cores();

// As one would type it in a shell.
std::string shell_words(const std::vector<std::string>& command);

}  // namespace riffle
