// Interactive stepping on stdin.
#include "cli/match/match_stepper.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdio>

#include "base/text/number_text.h"

namespace cls::cli {
namespace {

constexpr int kPollIntervalMs = 100;

}  // namespace

bool MatchStepper::read_line(std::string& line) {
  while (signal_.load() == 0) {
    if (const std::size_t end = pending_.find('\n'); end != std::string::npos) {
      line = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return true;
    }

    pollfd wait{input_, POLLIN, 0};
    if (poll(&wait, 1, kPollIntervalMs) <= 0) continue;
    std::array<char, 256> bytes;
    const ssize_t count = read(input_, bytes.data(), bytes.size());
    if (count <= 0) return false;
    pending_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return false;
}

void MatchStepper::execute(const std::string& line) {
  waiting_ = false;
  int cycles = 1;

  if (line == "q") {
    quit_ = true;
  } else if (line == "c") {
    continue_ = true;
  } else if (!line.empty()) {
    cycles = base::parse_int(line).value_or(0);
    waiting_ = cycles < 1;
  }

  if (waiting_) {
    fmt::print(stderr, "Enter: one cycle; N: N cycles; c: continue; q: quit\n");
  } else {
    skip_ = cycles - 1;
  }
}

void MatchStepper::before_decisions(const match::MatchView& view) {
  if (continue_ || quit_ || view.progress.cycle < first_) return;
  if (skip_ > 0) {
    --skip_;
    return;
  }

  waiting_ = true;
  while (waiting_) {
    const match::MatchProgress& progress = view.progress;
    fmt::print(stderr, "cycle {}{} {}  {} : {}  {}> ", progress.cycle,
               view.stoppage > 0 ? fmt::format("+{}", view.stoppage) : "", name(progress.mode),
               progress.left_score, progress.right_score,
               view.ball ? fmt::format("ball ({:.2f}, {:.2f})  ", view.ball->x, view.ball->y) : "");
    std::fflush(stderr);

    std::string line;
    if (read_line(line)) {
      execute(line);
    } else {
      fmt::print(stderr, "\n");
      continue_ = true;
      waiting_ = false;
    }
  }
}

bool MatchStepper::after_cycle(const match::MatchView& /*view*/) { return !quit_; }

}  // namespace cls::cli
