// The loop between keyboard, match and terminal.
#include "cli/logs/terminal_view.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <utility>

#include "base/io/byte_sink.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "viewer/live/live_match.h"
#include "viewer/stream/chunk_reader.h"
#include "viewer/terminal/asciinema_cast.h"
#include "viewer/terminal/match_screen.h"

namespace cls::cli {
namespace {

using std::chrono::steady_clock;
using viewer::MatchScreen;
using viewer::Screen;

constexpr int kCastColumns = 80;
constexpr int kCastRows = 24;
constexpr int kMinColumns = 30;
constexpr int kMinRows = 8;
constexpr double kPictureSeconds = 0.1;

struct Size {
  int columns = kCastColumns;
  int rows = kCastRows;
};

Size terminal_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return {};
  }
  return {std::max<int>(kMinColumns, size.ws_col), std::max<int>(kMinRows, size.ws_row)};
}

void print_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count > 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return;
    }
  }
}

/// Keys without Enter and echo, on the alternate screen without a cursor; the destructor restores
/// everything. Ctrl-C arrives as a signal.
class RawTerminal {
 public:
  RawTerminal() {
    has_keys_ = ::tcgetattr(STDIN_FILENO, &before_) == 0;
    if (has_keys_) {
      termios raw = before_;
      raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
      raw.c_cc[VSUSP] = _POSIX_VDISABLE;
      ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &raw);
    }

    print_all("\x1b[?1049h\x1b[?25l\x1b[2J");
  }
  ~RawTerminal() {
    print_all("\x1b[0m\x1b[?25h\x1b[?1049l");
    if (has_keys_) ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
  }
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  /// Waits up to `seconds` for keys.
  std::vector<viewer::Key> keys(double seconds) {
    pollfd polled{has_keys_ ? STDIN_FILENO : -1, POLLIN, 0};
    if (::poll(&polled, 1, static_cast<int>(seconds * 1000.0)) <= 0) return {};

    std::array<char, 64> bytes{};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) {
      has_keys_ = false;
      return {};
    }

    bytes_.append(bytes.data(), static_cast<std::size_t>(count));
    return viewer::take_keys(bytes_);
  }

 private:
  termios before_{};
  bool has_keys_ = false;
  std::string bytes_;
};

/// The recording, if one is wanted.
class Cast {
 public:
  /// An empty `path` means no recording.
  base::Result<void> open(const std::string& path, Size size, const std::string& title) {
    if (path.empty()) return {};

    TRY_INIT(auto sink, base::FileSink::create(path));
    sink_ = std::move(sink);

    sink_->write(viewer::cast_header(size.columns, size.rows, title));
    return {};
  }
  void add(double seconds, std::string_view output) {
    if (sink_ != nullptr) sink_->write(viewer::cast_line(seconds, output));
  }
  base::Result<void> close() { return sink_ != nullptr ? sink_->close() : base::Result<void>(); }

 private:
  std::unique_ptr<base::FileSink> sink_;
};

/// Draws what changed since the last picture.
class Painter {
 public:
  Painter(Cast& cast, bool color) : cast_(cast), color_(color) {}

  std::string paint(const MatchScreen& match, Size size) {
    Screen next = match.draw(size.columns, size.rows, color_);
    if (shown_ && *shown_ == next) return "";
    const bool same_size =
        shown_ && shown_->columns() == next.columns() && shown_->rows() == next.rows();

    std::string output = same_size ? "" : "\x1b[2J";
    output += next.update(same_size ? &*shown_ : nullptr, color_);

    shown_ = std::move(next);
    return output;
  }
  void record(double seconds, std::string_view output) {
    if (!output.empty()) cast_.add(seconds, output);
  }

 private:
  Cast& cast_;
  bool color_;
  std::optional<Screen> shown_;
};

int close_cast(Cast& cast) {
  TRY_OR(kWriteFailed, cast.close());
  return kOk;
}

std::size_t frame_of_cycle(const gamelog::MatchRecord& record, int cycle) {
  const auto found = std::ranges::lower_bound(record.time, cycle);
  return static_cast<std::size_t>(found - record.time.begin());
}

// Shows the match until a key or a signal ends it. `update` adds new frames.
template <typename Update>
void run(MatchScreen& match, Painter& painter, Update update) {
  const std::atomic<int>& signal = watch_interrupts();
  RawTerminal terminal;
  const auto start = steady_clock::now();
  auto last = start;
  while (!match.has_quit() && signal.load() == 0) {
    update();
    const auto now = steady_clock::now();
    match.advance(std::chrono::duration<double>(now - last).count());
    last = now;

    const std::string output = painter.paint(match, terminal_size());
    print_all(output);
    painter.record(std::chrono::duration<double>(now - start).count(), output);

    for (const viewer::Key key : terminal.keys(kPictureSeconds)) match.press(key);
  }
}

// The whole match at its own speed, without waiting.
int write_cast(MatchScreen& match, Cast& cast) {
  Painter painter(cast, true);
  for (double seconds = 0.0;; seconds += kPictureSeconds) {
    painter.record(seconds, painter.paint(match, {}));
    if (match.at_end()) return close_cast(cast);
    match.advance(kPictureSeconds);
  }
}

// Without a terminal: a line per second.
template <typename Update>
int print_lines(MatchScreen& match, Update update) {
  const std::atomic<int>& signal = watch_interrupts();
  std::string shown;
  for (auto next = steady_clock::now(); signal.load() == 0;) {
    const bool over = update();
    if (over || steady_clock::now() >= next) {
      next = steady_clock::now() + std::chrono::seconds(1);
      match.advance(0.0);
      const std::string line = match.line();
      if (line != shown) print_all(line + "\n");
      shown = line;
    }
    if (over) break;

    ::poll(nullptr, 0, static_cast<int>(kPictureSeconds * 1000.0));
  }

  return kOk;
}

}  // namespace

int show_in_terminal(const gamelog::MatchRecord& record, const TerminalViewOptions& options) {
  MatchScreen match(record);
  if (options.at) match.seek(frame_of_cycle(record, *options.at));

  Cast cast;
  TRY_OR(kCannotCreate, cast.open(options.cast, {}, options.title));

  if (!options.cast.empty()) return write_cast(match, cast);
  if (::isatty(STDOUT_FILENO) != 1) {
    return print_error(kUsage, "--view terminal: stdout is not a terminal; --cast FILE records");
  }

  Painter painter(cast, stdout_supports_color());
  run(match, painter, [] {});
  return kOk;
}

int show_in_terminal(std::unique_ptr<viewer::LiveInput> input, const TerminalViewOptions& options) {
  const viewer::LiveMatch live(std::move(input));
  viewer::ChunkReader reader;
  MatchScreen match(reader.match().record);
  match.set_live(true);

  std::size_t received = 0;
  const auto update = [&] {
    for (;;) {
      const viewer::LiveFeed::Piece piece = live.feed()->read(received, 1 << 20);
      received += piece.bytes.size();
      const bool broken = !piece.bytes.empty() && !reader.add(piece.bytes);
      if (piece.ended || broken) match.set_live(false);
      if (piece.bytes.empty() || piece.ended || broken) return piece.ended || broken;
    }
  };

  if (::isatty(STDOUT_FILENO) != 1) return print_lines(match, update);

  Cast cast;
  TRY_OR(kCannotCreate, cast.open(options.cast, terminal_size(), options.title));

  Painter painter(cast, stdout_supports_color());
  run(match, painter, update);
  return close_cast(cast);
}

}  // namespace cls::cli
