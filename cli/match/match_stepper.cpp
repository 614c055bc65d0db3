// Waiting for a key between cycles.
#include "cli/match/match_stepper.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdio>

namespace cls::cli {
namespace {

constexpr int kLookMs = 100;

}  // namespace

bool MatchStepper::read_line(std::string& line) {
  while (signal_.load() == 0) {
    if (const std::size_t end = pending_.find('\n'); end != std::string::npos) {
      line = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return true;
    }
    pollfd wait{input_, POLLIN, 0};
    if (poll(&wait, 1, kLookMs) <= 0) continue;
    std::array<char, 256> bytes;
    const ssize_t count = read(input_, bytes.data(), bytes.size());
    if (count <= 0) return false;
    pending_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return false;
}

void MatchStepper::obey(const std::string& line) {
  waiting_ = false;
  int cycles = 1;
  if (line == "q") {
    ending_ = true;
  } else if (line == "c") {
    going_on_ = true;
  } else if (!line.empty()) {
    const char* end = line.data() + line.size();
    const auto [stop, code] = std::from_chars(line.data(), end, cycles);
    waiting_ = code != std::errc{} || stop != end || cycles < 1;
  }
  if (waiting_) {
    fmt::print(stderr, "Enter: one cycle; a number: so many; c: go on; q: end\n");
  } else {
    passing_ = cycles - 1;
  }
}

void MatchStepper::before_decisions(const simulator::World& world) {
  if (going_on_ || ending_ || world.clock.time < first_) return;
  if (passing_ > 0) {
    --passing_;
    return;
  }
  waiting_ = true;
  while (waiting_) {
    const auto& ball = world.ball.position;
    fmt::print(stderr, "cycle {}{} {}  {} : {}  ball ({:.2f}, {:.2f})  > ", world.clock.time,
               world.clock.stoppage > 0 ? fmt::format("+{}", world.clock.stoppage) : "",
               name(world.mode), world.team(soccer::Side::kLeft).score,
               world.team(soccer::Side::kRight).score, ball.x, ball.y);
    std::fflush(stderr);
    std::string line;
    if (read_line(line)) {
      obey(line);
    } else {
      fmt::print(stderr, "\n");
      going_on_ = true;
      waiting_ = false;
    }
  }
}

bool MatchStepper::after_cycle(const simulator::World& /*world*/) { return !ending_; }

}  // namespace cls::cli
