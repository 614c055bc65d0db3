// Changes to each message of the server.
#include "tests/proxy/agent/lying_channel.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cls::tests {
namespace {

constexpr std::size_t kOldMessages = 60;
constexpr std::size_t kMaxDelay = 30;

constexpr std::array<std::string_view, 14> kInventions = {
    "",
    "(",
    ")",
    "(think)",
    "(done)",
    "(init l 3 before_kick_off)",
    "(init r 12 play_on)",
    "(reconnect l play_on)",
    "(error unsupported_version)",
    "(warning compression)",
    "(sense_body 2147483647)",
    "(hear 5 referee goal_l_99999999999)",
    "(ok clang (ver 7 8))",
    "\xff\xfe(see 1)\x1b[2J",
};

}  // namespace

bool LyingChannel::send(std::string_view message) {
  liar_.on_send(message);
  return server_->send(message);
}

bool LyingChannel::receive(std::string& message) {
  for (std::string received; server_->receive(received);) {
    if (old_.size() < kOldMessages || liar_.below(20) == 0) old_.push_back(received);
    if (liar_.lies == Lies::kNone) {
      deliver(std::move(received));
    } else {
      distort(std::move(received));
    }
  }

  if (waiting_.empty()) return false;
  message = std::move(waiting_.front());
  waiting_.pop_front();
  return true;
}

// Messages that were held back follow when enough others have passed.
void LyingChannel::deliver(std::string message) {
  waiting_.push_back(std::move(message));
  if (liar_.lies != Lies::kNone) ++liar_.messages;
  for (Late& late : late_) {
    if (late.after-- == 0 || liar_.lies == Lies::kNone) {
      waiting_.push_back(std::exchange(late.message, {}));
      late.after = 0;
    }
  }
  std::erase_if(late_, [](const Late& late) { return late.message.empty(); });
}

void LyingChannel::distort(std::string message) {
  const std::size_t kind = liar_.below(100);
  if (kind < 25) ++liar_.told;
  if (kind < 4) return;  // lost

  if (kind < 8) {
    message.resize(liar_.below(message.size() + 1));
  } else if (kind < 12) {
    deliver(message);
  } else if (kind < 16) {
    late_.push_back({std::move(message), liar_.below(kMaxDelay)});
    return;
  } else if (kind < 20 && !waiting_.empty()) {
    std::swap(waiting_.back(), message);
  } else if (kind < 25 && liar_.lies == Lies::kServer) {
    invent(message);
  } else if (kind < 30 && liar_.lies == Lies::kServer) {
    ++liar_.told;
    message = liar_.mutator.mutate(std::move(message));
  }

  deliver(std::move(message));
}

void LyingChannel::invent(const std::string& message) {
  const std::size_t kind = liar_.below(4);
  if (kind == 0 && !liar_.foreign.empty()) {
    deliver(liar_.foreign[liar_.below(liar_.foreign.size())]);
  } else if (kind == 1) {
    deliver(old_[liar_.below(old_.size())]);
  } else if (kind == 2) {
    // The server sends the same parameters again, changed.
    deliver(liar_.mutator.mutate(old_[liar_.below(std::min(old_.size(), std::size_t{25}))]));
  } else if (liar_.below(10) == 0) {
    deliver(message.substr(0, message.size() / 2) + std::string(8000, '('));
  } else {
    deliver(std::string(kInventions[liar_.below(kInventions.size())]));
  }
}

}  // namespace cls::tests
