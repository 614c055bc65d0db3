// Asking the terminal.
#include "cli/terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

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

bool stdout_takes_colour(bool no_colour_option) {
  const char* no_colour = std::getenv("NO_COLOR");
  if (no_colour_option || (no_colour != nullptr && *no_colour != '\0')) return false;
  return isatty(STDOUT_FILENO) == 1 && !is_dumb();
}

int terminal_width() {
  constexpr int kUsual = 80;
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsual;
  return size.ws_col;
}

}  // namespace cls::cli
