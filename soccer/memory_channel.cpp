// Connected in-memory channels.
#include "soccer/memory_channel.h"

#include <string>
#include <vector>

namespace cls::soccer {
namespace {

// Messages waiting in one direction, one behind the other in memory that is reused.
class Mailbox {
 public:
  Mailbox() {
    bytes_.reserve(kUsualBytes);
    ends_.reserve(kUsualMessages);
  }

  void put(std::string_view message) {
    bytes_ += message;
    ends_.push_back(bytes_.size());
  }

  bool take(std::string& message) {
    if (next_ == ends_.size()) return false;

    const std::size_t begin = next_ == 0 ? 0 : ends_[next_ - 1];
    message.assign(bytes_, begin, ends_[next_] - begin);

    ++next_;
    if (next_ == ends_.size()) clear();
    return true;
  }

 private:
  // More messages than a client receives in a cycle.
  static constexpr std::size_t kUsualBytes = 16384;
  static constexpr std::size_t kUsualMessages = 64;

  void clear() {
    bytes_.clear();
    ends_.clear();
    next_ = 0;
  }

  std::string bytes_;
  std::vector<std::size_t> ends_;
  std::size_t next_ = 0;  ///< to take
};

struct Link {
  Mailbox directions[2];
  bool reads_values[2] = {false, false};  ///< by end
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

  bool ask_for_values() override { return link_->reads_values[out_] = true; }
  bool peer_reads_values() const override { return link_->reads_values[1 - out_]; }

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
