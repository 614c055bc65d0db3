// A bar, the rate and the time left.
#include "cli/terminal/log_progress.h"

#include <fmt/format.h>

#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

constexpr std::chrono::milliseconds kLogInterval{100};
constexpr std::chrono::seconds kPlainInterval{30};  // without a terminal
constexpr double kMinElapsed = 0.5;                 // s; the rate is too noisy before

}  // namespace

LogProgress::LogProgress(std::size_t parts, const char* parts_name)
    : parts_(parts),
      parts_name_(parts_name),
      on_terminal_(stderr_is_terminal()),
      shown_(parts > 1 && !output_options().quiet) {}

std::string LogProgress::status(std::size_t count, double elapsed) const {
  std::string text = fmt::format("{}/{} {}", count, parts_, parts_name_);
  if (on_terminal_) {
    const double share = static_cast<double>(count) / static_cast<double>(parts_);
    text = progress_bar(share) + " " + text;
  }
  if (elapsed <= kMinElapsed) return text;

  const double speed = static_cast<double>(count) / elapsed;
  if (speed >= 1.0) text += fmt::format("  {:.0f} {}/s", speed, parts_name_);
  if (count > 0) text += "  " + time_left(static_cast<double>(parts_ - count) / speed);
  return text;
}

void LogProgress::update(std::size_t count) {
  if (!shown_) return;

  const std::unique_lock lock(mutex_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || now - last_shown_ < (on_terminal_ ? kLogInterval : kPlainInterval)) return;

  last_shown_ = now;
  const std::string text = status(count, std::chrono::duration<double>(now - start_).count());
  if (on_terminal_) {
    line_.show(text);
  } else {
    fmt::print(stderr, "cls: {}\n", text);
  }
}

}  // namespace cls::cli
