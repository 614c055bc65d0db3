// Recognizes the lines of a growing game log by their first token.
#include "match/server/game_log_follower.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>

namespace cls::match {
namespace {

constexpr std::size_t kBlockBytes = 64 * 1024;
constexpr std::size_t kMaxLineHead = 128;

}  // namespace

void GameLogFollower::poll() {
  if (!fd_) fd_ = base::UniqueFd(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd_) return;

  std::array<char, kBlockBytes> block;
  while (true) {
    const ssize_t size = ::read(fd_.get(), block.data(), block.size());
    if (size <= 0) return;
    read_bytes(block.data(), static_cast<std::size_t>(size));
  }
}

void GameLogFollower::read_bytes(const char* bytes, std::size_t size) {
  while (size > 0) {
    const auto* end = static_cast<const char*>(std::memchr(bytes, '\n', size));
    const std::size_t length = end == nullptr ? size : static_cast<std::size_t>(end - bytes);
    if (line_.size() < kMaxLineHead) {
      line_.append(bytes, std::min(length, kMaxLineHead - line_.size()));
    }
    if (end == nullptr) return;

    read_line();
    line_.clear();
    bytes += length + 1;
    size -= length + 1;
  }
}

void GameLogFollower::read_line() {
  int time = 0;
  std::array<char, 32> word{};
  std::array<char, 32> left{};
  std::array<char, 32> right{};
  int left_score = 0;
  int right_score = 0;

  if (std::sscanf(line_.c_str(), "(show %d ", &time) == 1) {
    ++progress_.steps;
    progress_.match.cycle = time;
  } else if (std::sscanf(line_.c_str(), "(playmode %d %31[a-z_A-Z])", &time, word.data()) == 2) {
    if (const auto mode = soccer::parse_play_mode(word.data())) progress_.match.mode = *mode;
  } else if (std::sscanf(line_.c_str(), "(team %d %31s %31s %d %d", &time, left.data(),
                         right.data(), &left_score, &right_score) == 5) {
    progress_.match.left_score = left_score;
    progress_.match.right_score = right_score;
  }
}

}  // namespace cls::match
