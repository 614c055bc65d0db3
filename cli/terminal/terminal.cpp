// Terminal capabilities and the status line.
#include "cli/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace cls::cli {
namespace {

bool is_dumb() {
  const char* term = std::getenv("TERM");
  return term == nullptr || std::string_view(term) == "dumb";
}

}  // namespace

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1 && !is_dumb(); }

bool stdout_supports_color(bool no_color_option) {
  const char* no_color = std::getenv("NO_COLOR");
  if (no_color_option || (no_color != nullptr && *no_color != '\0')) return false;
  return isatty(STDOUT_FILENO) == 1 && !is_dumb();
}

int terminal_width() {
  constexpr int kDefaultWidth = 80;
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kDefaultWidth;
  return size.ws_col;
}

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
