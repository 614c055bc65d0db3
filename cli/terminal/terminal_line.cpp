// Writing over a line.
#include "cli/terminal/terminal_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "cli/terminal/terminal.h"

namespace cls::cli {

void TerminalLine::show(std::string_view text) {
  const auto width = static_cast<std::size_t>(terminal_width() - 1);
  fmt::print(stderr, "\r\x1b[K{}", text.substr(0, width));
  std::fflush(stderr);
  visible_ = true;
}

void TerminalLine::clear() {
  if (!visible_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  visible_ = false;
}

std::string progress_bar(double share) {
  constexpr int kWidth = 20;
  const int filled = static_cast<int>(kWidth * std::clamp(share, 0.0, 1.0));
  return fmt::format("[{:#<{}}{:.<{}}]", "", filled, "", kWidth - filled);
}

std::string time_left(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s left", whole);
  return fmt::format("{}:{:02} min left", whole / 60, whole % 60);
}

}  // namespace cls::cli
