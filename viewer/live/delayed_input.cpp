// Holds bytes back for a time.
#include <chrono>
#include <deque>
#include <string>
#include <utility>

#include "viewer/live/live_input.h"

namespace cls::viewer {
namespace {

using std::chrono::steady_clock;

class DelayedInput : public LiveInput {
 public:
  DelayedInput(std::unique_ptr<LiveInput> input, std::chrono::milliseconds delay)
      : input_(std::move(input)), delay_(delay) {}

  std::size_t read(char* to, std::size_t size) override {
    fetch();
    if (held_.empty() || held_.front().first > steady_clock::now() - delay_) return 0;
    std::string& bytes = held_.front().second;
    const std::size_t count = bytes.copy(to, size);
    bytes.erase(0, count);
    if (bytes.empty()) held_.pop_front();
    return count;
  }

  State state() override { return held_.empty() ? input_->state() : State::kOpen; }

 private:
  void fetch() {
    std::string block(kBlock, '\0');
    while (const std::size_t count = input_->read(block.data(), block.size())) {
      held_.emplace_back(steady_clock::now(), block.substr(0, count));
    }
  }

  static constexpr std::size_t kBlock = std::size_t{64} << 10;

  std::unique_ptr<LiveInput> input_;
  std::chrono::milliseconds delay_;
  std::deque<std::pair<steady_clock::time_point, std::string>> held_;
};

}  // namespace

std::unique_ptr<LiveInput> delayed(std::unique_ptr<LiveInput> input,
                                   std::chrono::milliseconds delay) {
  return std::make_unique<DelayedInput>(std::move(input), delay);
}

}  // namespace cls::viewer
