#include "host/output/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>

namespace riffle {
namespace {

constexpr double bar_interval = 0.1, line_interval = 5;  // s

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Columns of the terminal; a line that fills the last one would wrap and could not be redrawn.
std::size_t usable_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return static_cast<std::size_t>(known ? size.ws_col : 80) - 1;
}

std::string duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

ProgressStyle progress_style(bool quiet) {
  if (quiet) return ProgressStyle::silent;
  return ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

Progress::Progress(ProgressStyle style, const ProgressSpan& span, std::ostream& out, std::function<double()> clock)
    : style_(style),
      span_(span),
      out_(out),
      clock_(clock ? std::move(clock) : std::function<double()>(steady_seconds)),
      time_(span.begin),
      step_(span.first_step) {
  started_ = written_at_ = clock_();
}

Progress::~Progress() {
  if (line_open_) out_ << std::endl;
}

double Progress::share() const {
  const double of_time = span_.end > span_.begin ? (time_ - span_.begin) / (span_.end - span_.begin) : 0;
  const double of_steps =
      span_.max_steps > span_.first_step
          ? static_cast<double>(step_ - span_.first_step) / static_cast<double>(span_.max_steps - span_.first_step)
          : 0;
  return std::clamp(std::max(of_time, of_steps), 0.0, 1.0);
}

std::string Progress::state(double now) const {
  const double done = share(), elapsed = now - started_;
  std::string text = fmt::format("{:5.1f} %  t = {:.4g} / {:g} s  step {}", 100 * done, time_, span_.end, step_);
  if (step_ > span_.first_step) text += fmt::format("  dt = {:.2e} s ({})", dt_, limiter_);
  if (done > 0 && done < 1) text += fmt::format("  {} left", duration(elapsed * (1 - done) / done));
  if (done >= 1) text += fmt::format("  in {}", duration(elapsed));
  return text;
}

void Progress::write() {
  const double now = clock_();
  written_at_ = now;
  const std::string text = state(now);
  if (style_ == ProgressStyle::lines) {
    out_ << text << std::endl;
    return;
  }
  const std::size_t width = usable_width();
  std::string line = text.substr(0, width);
  if (line.size() + 13 <= width) {
    const std::size_t length = std::min<std::size_t>(width - line.size() - 3, 40);
    const auto filled = static_cast<std::size_t>(share() * static_cast<double>(length));
    line = fmt::format("[{:=<{}}{: <{}}] {}", "", filled, "", length - filled, line);
  }
  out_ << '\r' << line << "\x1b[K" << std::flush;
  line_open_ = true;
}

void Progress::update(double time, std::int64_t step, double dt, std::string_view limiter) {
  if (style_ == ProgressStyle::silent) return;
  time_ = time;
  step_ = step;
  dt_ = dt;
  limiter_.assign(limiter);
  if (clock_() - written_at_ >= (style_ == ProgressStyle::bar ? bar_interval : line_interval)) write();
}

void Progress::finish() {
  if (style_ == ProgressStyle::silent) return;
  write();
  if (line_open_) out_ << std::endl;
  line_open_ = false;
}

}  // namespace riffle
