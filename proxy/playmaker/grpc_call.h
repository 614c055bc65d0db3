// One unary call at a time of one agent: bytes out, status and message back.
#pragma once

#include <google/protobuf/arena.h>
#include <google/protobuf/message_lite.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Reused for every call of its agent. The order is start(), the completion queue returning this
/// object as its tag, finish(), message(); then again.
class GrpcCall {
 public:
  /// What the answer is read into.
  enum class Answer { kEmpty, kRegister, kPlayer, kCoach, kTrainer, kPlanner };

  GrpcCall() = default;
  GrpcCall(const GrpcCall&) = delete;
  GrpcCall& operator=(const GrpcCall&) = delete;

  /// Serialises `request` and sends it. `method` is the name of the rpc.
  void start(grpc::GenericStub& stub, grpc::CompletionQueue& queue, const char* method,
             const google::protobuf::MessageLite& request, Answer answer, RpcTimeout timeout,
             bool wait_for_ready);
  bool in_flight() const { return in_flight_; }
  void cancel();

  /// Takes the answer in; once, after the queue returned the call.
  void finish();
  const RpcStatus& status() const { return status_; }
  std::chrono::microseconds latency() const { return latency_; }
  Answer answer() const { return answer_; }
  /// The answer; null unless the status is ok. Lives until the next start().
  const google::protobuf::MessageLite* message() const { return message_; }

 private:
  google::protobuf::MessageLite* make_message();
  void read_message();

  std::optional<grpc::ClientContext> context_;
  std::unique_ptr<grpc::GenericClientAsyncResponseReader> reader_;
  grpc::ByteBuffer response_;
  grpc::Status grpc_status_;
  std::array<char, 8192> block_;  // of the arena, so that usual answers take no other memory
  google::protobuf::Arena arena_{block_.data(), block_.size()};
  google::protobuf::MessageLite* message_ = nullptr;
  const char* method_ = "";
  Answer answer_ = Answer::kEmpty;
  RpcStatus status_;
  std::chrono::steady_clock::time_point started_;
  std::chrono::microseconds latency_{0};
  bool in_flight_ = false;
  bool cancelled_ = false;
};

}  // namespace cls::proxy
