// Parsing, and the status of failures.
#include "proxy/playmaker/replies.h"

#include <fmt/format.h>

#include <utility>

#include "proto/status_name.h"

namespace cls::proxy {

using google::protobuf::Message;
using proto::Rpc;

Message& ReplyMemory::create(Rpc rpc) {
  arena_.Reset();
  return *proto::reply_prototype(rpc).New(&arena_);
}

void ReplyMemory::parse(std::string_view bytes, Reply& reply) {
  Message& message = create(reply.rpc);
  const std::size_t limit = proto::max_reply_bytes(reply.rpc);

  if (bytes.size() <= limit &&
      message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    reply.message = &message;
    return;
  }

  reply.status.outcome = RpcOutcome::kProtocolError;
  reply.status.message =
      bytes.size() > limit ? fmt::format("{}: reply of {} bytes, more than the {} that cls accepts",
                                         name(reply.rpc), bytes.size(), limit)
                           : fmt::format("{}: reply of {} bytes is not a {}", name(reply.rpc),
                                         bytes.size(), message.GetTypeName());
}

Reply empty_reply(int agent, Rpc rpc) { return failed_reply(agent, rpc, {}); }

Reply failed_reply(int agent, Rpc rpc, RpcStatus status) {
  return {.agent = agent, .rpc = rpc, .status = std::move(status)};
}

Reply cancelled_reply(int agent, Rpc rpc) {
  return failed_reply(agent, rpc, {RpcOutcome::kCancelled, proto::kStatusCancelled, "cancelled"});
}

}  // namespace cls::proxy
