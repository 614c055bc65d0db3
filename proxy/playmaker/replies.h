// Making a Reply: memory of its message, parsing, and replies of calls that have failed.
#pragma once

#include <google/protobuf/arena.h>
#include <google/protobuf/message.h>

#include <array>
#include <deque>
#include <string_view>
#include <utility>

#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Memory of an agent's latest reply; reused, so that replies of usual size need no allocation.
class ReplyMemory {
 public:
  /// An empty message of the RPC's reply type; replaces the one before.
  google::protobuf::Message& create(proto::Rpc rpc);

  /// Parses the message of `reply`, whose RPC is set. Bytes that do not parse, and more than
  /// proto::max_reply_bytes(), are a protocol error.
  void parse(std::string_view bytes, Reply& reply);

 private:
  std::array<char, 8192> block_;
  google::protobuf::Arena arena_{block_.data(), block_.size()};
};

/// Removes the first element of a queue that is not empty.
template <typename T>
T take_first(std::deque<T>& queue) {
  T first = std::move(queue.front());
  queue.pop_front();
  return first;
}

/// Ok, without a message.
Reply empty_reply(int agent, proto::Rpc rpc);
Reply failed_reply(int agent, proto::Rpc rpc, RpcStatus status);
/// To a call after cancel().
Reply cancelled_reply(int agent, proto::Rpc rpc);

}  // namespace cls::proxy
