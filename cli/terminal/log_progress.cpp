// Progress line while reading several logs.
#include "cli/terminal/log_progress.h"

#include <fmt/format.h>

#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

constexpr std::chrono::milliseconds kLogInterval{100};
constexpr double kMinElapsed = 0.5;  // s; the rate is too noisy before

}  // namespace

LogProgress::LogProgress(std::size_t logs)
    : logs_(logs), shown_(logs > 1 && stderr_is_terminal() && !output_options().quiet) {}

void LogProgress::update(std::size_t count) {
  if (!shown_) return;

  const std::unique_lock lock(mutex_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || now - last_shown_ < kLogInterval) return;

  last_shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double share = static_cast<double>(count) / static_cast<double>(logs_);
  std::string text = fmt::format("{} {}/{} logs", progress_bar(share), count, logs_);

  if (elapsed > kMinElapsed) {
    const double speed = static_cast<double>(count) / elapsed;
    text += fmt::format("  {:.0f} logs/s  {}", speed,
                        time_left(static_cast<double>(logs_ - count) / speed));
  }

  line_.show(text);
}

}  // namespace cls::cli
