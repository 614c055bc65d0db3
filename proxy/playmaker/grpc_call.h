// One unary gRPC call at a time for one agent.
#pragma once

#include <google/protobuf/arena.h>
#include <google/protobuf/message.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Reused for every call of its agent. Sequence: start(), the completion queue returns this object
/// as its tag, finish(), message().
class GrpcCall {
 public:
  GrpcCall() = default;
  GrpcCall(const GrpcCall&) = delete;
  GrpcCall& operator=(const GrpcCall&) = delete;

  /// Serializes `request` and sends it.
  void start(grpc::GenericStub& stub, grpc::CompletionQueue& queue, proto::Rpc rpc,
             const google::protobuf::Message& request, RpcTimeout timeout, bool wait_for_ready);
  bool in_flight() const { return in_flight_; }
  void cancel();

  /// Parses the reply; once, after the queue returned the call.
  void finish();
  const RpcStatus& status() const { return status_; }
  std::chrono::microseconds latency() const { return latency_; }
  proto::Rpc rpc() const { return rpc_; }
  /// The reply; null unless the status is ok. Valid until the next start().
  const google::protobuf::Message* message() const { return message_; }

 private:
  void read_message();

  std::optional<grpc::ClientContext> context_;
  std::unique_ptr<grpc::GenericClientAsyncResponseReader> reader_;
  grpc::ByteBuffer response_;
  grpc::Status grpc_status_;
  std::array<char, 8192> block_;  // initial block of the arena: typical replies need no allocation
  google::protobuf::Arena arena_{block_.data(), block_.size()};
  google::protobuf::Message* message_ = nullptr;
  proto::Rpc rpc_ = proto::Rpc::kRegister;
  RpcStatus status_;
  std::chrono::steady_clock::time_point started_;
  std::chrono::microseconds latency_{0};
  bool in_flight_ = false;
  bool cancelled_ = false;
};

}  // namespace cls::proxy
