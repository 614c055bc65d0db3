// One unary gRPC call at a time for one agent.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>

#include <chrono>
#include <memory>
#include <optional>

#include "proto/state_writer.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/playmaker/replies.h"

namespace cls::proxy {

/// Reused for every call of its agent. Sequence: start(), the completion queue returns this object
/// as its tag, finish(), reply().
class GrpcCall {
 public:
  GrpcCall() = default;
  GrpcCall(const GrpcCall&) = delete;
  GrpcCall& operator=(const GrpcCall&) = delete;

  /// Serializes `request` and sends it.
  void start(grpc::GenericStub& stub, grpc::CompletionQueue& queue, int agent, proto::Rpc rpc,
             const google::protobuf::Message& request, RpcTimeout timeout, bool wait_for_ready);
  void cancel();

  /// Parses the reply; once, after the queue returned the call.
  void finish();
  /// The reply to the latest call; its message is valid until the next start().
  const Reply& reply() const { return reply_; }

 private:
  void read_message();

  std::optional<grpc::ClientContext> context_;
  std::unique_ptr<grpc::GenericClientAsyncResponseReader> reader_;
  grpc::ByteBuffer response_;
  grpc::Status grpc_status_;
  proto::StateWriter states_;
  ReplyMemory memory_;
  Reply reply_;
  std::chrono::steady_clock::time_point started_;
  bool in_flight_ = false;
  bool cancelled_ = false;
};

}  // namespace cls::proxy
