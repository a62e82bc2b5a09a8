#include "host/plugins/check/child.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <sstream>

namespace riffle::check {
namespace {

using Clock = std::chrono::steady_clock;

// One finding per line; its first character says what it is.
std::string encode(const Findings& findings) {
  std::string text;
  const auto add = [&](char kind, std::string line) {
    for (char& c : line) c = c == '\n' ? ' ' : c;
    text += kind + line + '\n';
  };
  for (const auto& line : findings.failures) add('F', line);
  for (const auto& line : findings.warnings) add('W', line);
  add('S', findings.summary);
  return text;
}

// False when the text is not whole: the child did not get to its end.
bool decode(const std::string& text, Findings& findings) {
  std::istringstream in(text);
  bool whole = false;
  for (std::string line; std::getline(in, line);) {
    const std::string rest = line.substr(1);
    if (line[0] == 'F') findings.fail(rest);
    if (line[0] == 'W') findings.warn(rest);
    if (line[0] == 'S') findings.summary = rest, whole = true;
  }
  return whole;
}

[[noreturn]] void run_child(const std::function<Findings()>& work, int pipe_end) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  Findings findings;
  try {
    findings = work();
  } catch (const std::exception& error) {
    findings.fail(error.what());
  } catch (...) {
    findings.fail("an exception of unknown type left the plugin");
  }
  const std::string text = encode(findings);
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = write(pipe_end, text.data() + at, text.size() - at);
    if (written <= 0) break;
    at += static_cast<std::size_t>(written);
  }
  _exit(0);  // no destructors, no buffers of the parent's streams
}

// What the child wrote until it closed the pipe; nothing more is read after the deadline.
std::string read_until(int pipe_end, Clock::time_point deadline, bool& late) {
  std::string text;
  char buffer[4096];
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd ready{pipe_end, POLLIN, 0};
    if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) == 0) {
      late = true;
      return text;
    }
    const ssize_t n = read(pipe_end, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

Findings in_child(const std::function<Findings()>& work, std::chrono::milliseconds limit) {
  Findings findings;
  int ends[2];
  if (pipe(ends) != 0) {
    findings.fail(fmt::format("no pipe to a child process: {}", std::strerror(errno)));
    return findings;
  }
  const pid_t child = fork();
  if (child < 0) {
    findings.fail(fmt::format("no child process: {}", std::strerror(errno)));
    close(ends[0]);
    close(ends[1]);
    return findings;
  }
  if (child == 0) {
    close(ends[0]);
    run_child(work, ends[1]);
  }
  close(ends[1]);
  bool late = false;
  const std::string text = read_until(ends[0], Clock::now() + limit, late);
  close(ends[0]);
  if (late) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool whole = decode(text, findings);
  if (late) {
    findings.fail(fmt::format("is not done after {} s", static_cast<double>(limit.count()) / 1000));
  } else if (WIFSIGNALED(status)) {
    findings.fail(fmt::format("crashes: {}", strsignal(WTERMSIG(status))));
  } else if (!whole) {
    findings.fail(fmt::format("ends the whole program with status {}", WEXITSTATUS(status)));
  }
  return findings;
}

}  // namespace riffle::check
