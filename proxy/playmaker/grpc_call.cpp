// Serializing a request, parsing the reply, classifying failures.
#include "proxy/playmaker/grpc_call.h"

#include <grpc/support/time.h>

#include <cassert>

#include "proto/sorted_maps.h"

namespace cls::proxy {
namespace {

// Serializes into the slice that the transport sends: no copy, one allocation.
grpc::ByteBuffer serialize(const google::protobuf::Message& message) {
  grpc::Slice slice(message.ByteSizeLong());
  proto::write_with_sorted_maps(message, const_cast<std::uint8_t*>(slice.begin()), slice.size());
  return grpc::ByteBuffer(&slice, 1);
}

// On the monotonic clock, which is never adjusted.
gpr_timespec deadline_after(RpcTimeout timeout) {
  return gpr_time_add(gpr_now(GPR_CLOCK_MONOTONIC),
                      gpr_time_from_millis(timeout.count(), GPR_TIMESPAN));
}

}  // namespace

void GrpcCall::start(grpc::GenericStub& stub, grpc::CompletionQueue& queue, proto::Rpc rpc,
                     const google::protobuf::Message& request, RpcTimeout timeout,
                     bool wait_for_ready) {
  assert(!in_flight_ && "an agent has at most one call in flight");
  message_ = nullptr;
  arena_.Reset();
  reader_.reset();
  context_.emplace();
  response_.Clear();
  rpc_ = rpc;
  cancelled_ = false;
  in_flight_ = true;
  started_ = std::chrono::steady_clock::now();
  if (timeout != kNoTimeout) context_->set_deadline(deadline_after(timeout));
  context_->set_wait_for_ready(wait_for_ready);
  reader_ = stub.PrepareUnaryCall(&*context_, path(rpc), serialize(request), &queue);
  reader_->StartCall();
  reader_->Finish(&response_, &grpc_status_, this);
}

void GrpcCall::cancel() {
  if (!in_flight_) return;
  cancelled_ = true;
  context_->TryCancel();
}

void GrpcCall::finish() {
  assert(in_flight_);
  in_flight_ = false;
  latency_ = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - started_);
  status_ = rpc_status(rpc_, grpc_status_.error_code(), grpc_status_.error_message());
  if (status_.ok()) return read_message();
  if (cancelled_ && status_.outcome == RpcOutcome::kError) status_.outcome = RpcOutcome::kCancelled;
}

void GrpcCall::read_message() {
  google::protobuf::Message* message = proto::reply_prototype(rpc_).New(&arena_);
  grpc::Slice bytes;
  if (!response_.TrySingleSlice(&bytes).ok() && !response_.DumpToSingleSlice(&bytes).ok()) {
    bytes = grpc::Slice();
  }
  if (message->ParseFromArray(bytes.begin(), static_cast<int>(bytes.size()))) {
    message_ = message;
    return;
  }
  status_.outcome = RpcOutcome::kProtocolError;
  status_.message = std::string(name(rpc_)) + ": reply of " + std::to_string(bytes.size()) +
                    " bytes is not a " + message->GetTypeName();
}

}  // namespace cls::proxy
