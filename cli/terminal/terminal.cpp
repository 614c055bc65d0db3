// Terminal capabilities and the status line.
#include "cli/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/text/printable.h"
#include "base/text/wrap_text.h"

namespace cls::cli {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool is_dumb() {
  const char* term = std::getenv("TERM");
  return term == nullptr || std::string_view(term) == "dumb";
}

int width_of(int descriptor) {
  constexpr int kDefaultWidth = 80;
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kDefaultWidth;
  return size.ws_col;
}

}  // namespace

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1 && !is_dumb(); }

OutputOptions& output_options() {
  static OutputOptions options;
  return options;
}

bool stdout_supports_color() {
  if (output_options().no_color || is_set("NO_COLOR")) return false;
  if (is_set("CLICOLOR_FORCE")) return true;
  return isatty(STDOUT_FILENO) == 1 && !is_dumb();
}

int terminal_width() { return width_of(STDERR_FILENO); }

bool stdout_is_terminal() { return isatty(STDOUT_FILENO) == 1; }

std::size_t stdout_width() { return static_cast<std::size_t>(width_of(STDOUT_FILENO)); }

std::string message_line(std::string_view text) {
  constexpr std::size_t kIndent = 5;

  const std::string safe = base::printable_lines(text);

  if (!stderr_is_terminal()) return fmt::format("cls: {}\n", safe);
  return fmt::format("cls: {}\n",
                     base::wrap_text(safe, static_cast<std::size_t>(terminal_width()), kIndent));
}

void TerminalLine::show(std::string_view text) {
  const auto width = static_cast<std::size_t>(terminal_width() - 1);

  const std::string safe = base::printable(text);
  fmt::print(stderr, "\r\x1b[K{}", std::string_view(safe).substr(0, width));
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

std::string duration_text(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

std::string time_left(double seconds) { return duration_text(seconds) + " left"; }

}  // namespace cls::cli
