// A bar, the rate and the time left.
#include "cli/terminal/log_progress.h"

#include <fmt/format.h>

#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

constexpr std::chrono::milliseconds kLogInterval{100};
constexpr double kMinElapsed = 0.5;  // s; the rate is too noisy before

}  // namespace

LogProgress::LogProgress(std::size_t parts, const char* parts_name)
    : parts_(parts),
      parts_name_(parts_name),
      shown_(parts > 1 && stderr_is_terminal() && !output_options().quiet) {}

void LogProgress::update(std::size_t count) {
  if (!shown_) return;

  const std::unique_lock lock(mutex_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || now - last_shown_ < kLogInterval) return;

  last_shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double share = static_cast<double>(count) / static_cast<double>(parts_);
  std::string text = fmt::format("{} {}/{} {}", progress_bar(share), count, parts_, parts_name_);

  if (elapsed > kMinElapsed) {
    const double speed = static_cast<double>(count) / elapsed;
    if (speed >= 1.0) text += fmt::format("  {:.0f} {}/s", speed, parts_name_);
    if (count > 0) text += "  " + time_left(static_cast<double>(parts_ - count) / speed);
  }

  line_.show(text);
}

}  // namespace cls::cli
