// Connected in-memory channels.
#include "soccer/memory_channel.h"

#include <string>
#include <vector>

namespace cls::soccer {
namespace {

// Messages waiting in one direction. Slots keep their capacity after they are taken.
class Mailbox {
 public:
  void put(std::string_view message) {
    if (end_ == slots_.size()) slots_.emplace_back();
    slots_[end_++].assign(message);
  }

  bool take(std::string& message) {
    if (begin_ == end_) return false;
    std::swap(message, slots_[begin_++]);
    if (begin_ == end_) begin_ = end_ = 0;
    return true;
  }

 private:
  std::vector<std::string> slots_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

struct Link {
  Mailbox directions[2];
  bool open = true;
};

class MemoryChannel : public Channel {
 public:
  MemoryChannel(std::shared_ptr<Link> link, int out) : link_(std::move(link)), out_(out) {}
  MemoryChannel(const MemoryChannel&) = delete;
  MemoryChannel& operator=(const MemoryChannel&) = delete;
  ~MemoryChannel() override { link_->open = false; }

  bool send(std::string_view message) override {
    if (!link_->open) return false;
    link_->directions[out_].put(message);
    return true;
  }

  bool receive(std::string& message) override { return link_->directions[1 - out_].take(message); }

 private:
  std::shared_ptr<Link> link_;
  int out_;
};

}  // namespace

std::pair<std::unique_ptr<Channel>, std::unique_ptr<Channel>> make_memory_channel() {
  const auto link = std::make_shared<Link>();
  return {std::make_unique<MemoryChannel>(link, 0), std::make_unique<MemoryChannel>(link, 1)};
}

}  // namespace cls::soccer
