// Progress line of a running match.
#include "cli/terminal/progress_line.h"

#include <fmt/format.h>

namespace cls::cli {
namespace {

constexpr std::chrono::milliseconds kPictureInterval{100};

}  // namespace

std::string progress_text(const match::MatchProgress& progress, double cycles_per_second) {
  const double share = progress.last_cycle > 0 ? static_cast<double>(progress.cycle) /
                                                     static_cast<double>(progress.last_cycle)
                                               : 0.0;

  std::string text =
      fmt::format("{} {}/{}  {}:{}  {}", progress_bar(share), progress.cycle, progress.last_cycle,
                  progress.left_score, progress.right_score, name(progress.mode));

  if (cycles_per_second > 0.0) {
    const double left = (progress.last_cycle - progress.cycle) / cycles_per_second;
    text += fmt::format("  {:.0f} cycles/s  {}", cycles_per_second, time_left(left));
  }
  return text;
}

void ProgressLine::on_phase(std::string_view what) {
  if (shown_) line_.show(what);
}

void ProgressLine::on_cycle(const match::MatchProgress& progress) {
  if (!shown_) return;

  const Clock::time_point now = Clock::now();
  if (cycles_at_start_ < 0 && progress.cycle > 0) {
    cycles_at_start_ = progress.cycle;
    first_cycle_ = now;
  }
  if (now - last_shown_ < kPictureInterval) return;
  last_shown_ = now;

  const double elapsed = std::chrono::duration<double>(now - first_cycle_).count();
  const bool known = cycles_at_start_ >= 0 && elapsed > 0.5;
  line_.show(progress_text(progress, known ? (progress.cycle - cycles_at_start_) / elapsed : 0.0));
}

void ProgressLine::on_notice(std::string_view line) {
  if (quiet_) return;
  line_.clear();
  fmt::print(stderr, "{}", message_line(line));
}

void ProgressLine::on_warning(std::string_view line) {
  if (quiet_) return;
  line_.clear();
  fmt::print(stderr, "{}", message_line(fmt::format("warning: {}", line)));
}

}  // namespace cls::cli
