#include "host/study/pool.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>

namespace riffle {
namespace {

constexpr double grace = 5;  // s between asking a child to end and making it

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Running {
  std::size_t job = 0;
  double started = 0, stop_at = 0;
  bool asked = false;
};

// SIGCHLD and the signals that end a study are taken one by one by next(), not by handlers.
class Signals {
 public:
  Signals() {
    sigemptyset(&set_);
    for (const int number : {SIGCHLD, SIGINT, SIGTERM}) sigaddset(&set_, number);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
  }
  ~Signals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  [[nodiscard]] const sigset_t& before() const { return before_; }

  // The number of the next signal, or 0 when none came within so many seconds.
  [[nodiscard]] int next(double seconds) const {
    timespec wait{};
    wait.tv_sec = static_cast<time_t>(seconds);
    wait.tv_nsec = static_cast<long>(1e9 * (seconds - static_cast<double>(wait.tv_sec)));
    const int number = sigtimedwait(&set_, nullptr, &wait);
    return number > 0 ? number : 0;
  }

 private:
  sigset_t set_{}, before_{};
};

// Only calls that are safe between fork and exec.
[[noreturn]] void become(char* const* arguments, const char* said, pid_t parent, const sigset_t& signals) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(125);  // it died before the line above
  sigprocmask(SIG_SETMASK, &signals, nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  const int out = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  if (out >= 0) {
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
  }
  execv(arguments[0], arguments);
  _exit(127);
}

class Pool {
 public:
  Pool(const std::vector<Job>& jobs, const PoolOptions& options,
       const std::function<void(std::size_t, const JobEnd&)>& ended)
      : jobs_(jobs), options_(options), ended_(ended) {}

  void run() {
    while (next_ < jobs_.size() || !running_.empty()) {
      while (next_ < jobs_.size() && fits(jobs_[next_])) start(next_++);
      const int signal = signals_.next(patience());
      if (signal == SIGINT || signal == SIGTERM) interrupt();
      collect();
      stop_slow_ones();
    }
  }

 private:
  [[nodiscard]] bool fits(const Job& job) const {
    if (running_.empty()) return true;
    return !options_.exclusive && busy_ + job.threads <= options_.cores;
  }

  [[nodiscard]] double patience() const {
    double until = now() + 3600;
    for (const auto& [pid, child] : running_) until = std::min(until, child.stop_at);
    return std::max(until - now(), 0.0);
  }

  void start(std::size_t index) {
    const Job& job = jobs_[index];
    std::vector<std::string> words = job.command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string said = job.said.empty() ? "/dev/null" : job.said.string();
    const pid_t parent = getpid(), child = fork();
    if (child == 0) become(arguments.data(), said.c_str(), parent, signals_.before());
    if (child < 0) {
      stop_all();
      throw std::runtime_error(std::string("no further process can be started: ") + std::strerror(errno));
    }
    const double limit = job.time_limit > 0 ? now() + job.time_limit : std::numeric_limits<double>::infinity();
    running_[child] = {index, now(), limit, false};
    busy_ += job.threads;
  }

  void collect() {
    int status = 0;
    for (pid_t pid = 0; (pid = waitpid(-1, &status, WNOHANG)) > 0;) {
      const auto found = running_.find(pid);
      if (found == running_.end()) continue;
      const Running child = found->second;
      running_.erase(found);
      busy_ -= jobs_[child.job].threads;
      JobEnd end;
      end.wall_seconds = now() - child.started;
      end.too_slow = child.asked;
      if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
      if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
      ended_(child.job, end);
    }
  }

  void stop_slow_ones() {
    for (auto& [pid, child] : running_) {
      if (now() < child.stop_at) continue;
      kill(pid, child.asked ? SIGKILL : SIGTERM);
      child.asked = true;
      child.stop_at = now() + grace;
    }
  }

  void stop_all() {
    for (const auto& [pid, child] : running_) kill(pid, SIGKILL);
    for (const auto& [pid, child] : running_) {
      while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) continue;
    }
    running_.clear();
  }

  [[noreturn]] void interrupt() {
    stop_all();
    throw Interrupted("interrupted");
  }

  const std::vector<Job>& jobs_;
  const PoolOptions options_;
  const std::function<void(std::size_t, const JobEnd&)>& ended_;
  Signals signals_;
  std::map<pid_t, Running> running_;
  std::size_t next_ = 0;
  int busy_ = 0;
};

}  // namespace

void run_jobs(const std::vector<Job>& jobs, const PoolOptions& options,
              const std::function<void(std::size_t, const JobEnd&)>& ended) {
  Pool(jobs, options, ended).run();
}

int usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) != 0) return 1;
  return std::max(1, CPU_COUNT(&set));
}

std::string shell_words(const std::vector<std::string>& command) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+:,%@";
  std::string line;
  for (const std::string& word : command) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? "'\\''" : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace riffle
