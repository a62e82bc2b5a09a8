// How far a run is: a bar with time, step, dt and its limiter and the time left, redrawn ten times a second at most, on
// a terminal; elsewhere a line every few seconds; or nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace riffle {

enum class ProgressStyle { bar, lines, silent };

// For what goes to stderr: a bar on a terminal, lines otherwise, nothing when quiet.
ProgressStyle progress_style(bool quiet);

struct ProgressSpan {
  double begin = 0, end = 0;    // s of simulated time; begin is where this program took over
  std::int64_t first_step = 0;  // likewise
  std::int64_t max_steps = 0;   // 0: none
};

class Progress {
 public:
  // `clock` gives seconds from any origin; by default a steady clock.
  Progress(ProgressStyle style, const ProgressSpan& span, std::ostream& out, std::function<double()> clock = {});
  ~Progress();  // leaves the terminal in a fresh line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Called after every step; cheap when it is not yet time to write. `limiter`: the name of what decided dt (s).
  void update(double time, std::int64_t step, double dt, std::string_view limiter);

  // Writes the last state, whatever the clock says, and ends the bar's line.
  void finish();

 private:
  void write();
  [[nodiscard]] double share() const;
  [[nodiscard]] std::string state(double now) const;

  ProgressStyle style_;
  ProgressSpan span_;
  std::ostream& out_;
  std::function<double()> clock_;
  double started_ = 0, written_at_ = 0, time_ = 0, dt_ = 0;
  std::int64_t step_ = 0;
  std::string limiter_;
  bool line_open_ = false;
};

}  // namespace riffle
