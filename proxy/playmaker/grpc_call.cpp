// Serializing a request, parsing the reply, classifying failures.
#include "proxy/playmaker/grpc_call.h"

#include <grpc/support/time.h>

#include <cassert>
#include <string>
#include <string_view>

#include "proto/sorted_maps.h"

namespace cls::proxy {
namespace {

// gRPC gives no status while there are messages that nobody has read, and of a unary reply it reads
// one.
constexpr std::string_view kNoEnd =
    "; a message came, but not the end of the reply: does it have two messages, or no status?";

grpc::ByteBuffer serialize(const protos::State& state, proto::StateWriter& writer) {
  const std::string_view bytes = writer.write(state, proto::StateForm::kWhole);
  const grpc::Slice slice(bytes.data(), bytes.size());
  return grpc::ByteBuffer(&slice, 1);
}

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

void GrpcCall::start(grpc::GenericStub& stub, grpc::CompletionQueue& queue, int agent,
                     proto::Rpc rpc, const google::protobuf::Message& request, RpcTimeout timeout,
                     bool wait_for_ready) {
  assert(!in_flight_ && "an agent has at most one call in flight");

  reader_.reset();
  context_.emplace();
  response_.Clear();
  reply_ = empty_reply(agent, rpc);
  cancelled_ = false;
  in_flight_ = true;
  started_ = std::chrono::steady_clock::now();

  if (timeout != kNoTimeout) context_->set_deadline(deadline_after(timeout));
  context_->set_wait_for_ready(wait_for_ready);

  const grpc::ByteBuffer bytes =
      is_decision(rpc) ? serialize(static_cast<const protos::State&>(request), states_)
                       : serialize(request);
  reader_ = stub.PrepareUnaryCall(&*context_, path(rpc), bytes, &queue);
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
  reply_.latency = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - started_);
  RpcStatus& status = reply_.status;
  status = rpc_status(reply_.rpc, grpc_status_.error_code(), grpc_status_.error_message());
  if (status.ok()) return read_message();
  if (status.outcome == RpcOutcome::kDeadline && response_.Valid()) status.message += kNoEnd;
  if (cancelled_ && status.outcome == RpcOutcome::kError) status.outcome = RpcOutcome::kCancelled;
}

// gRPC takes a reply without a message, or with the beginning of one, for a reply.
void GrpcCall::read_message() {
  if (!response_.Valid()) {
    reply_.status.outcome = RpcOutcome::kProtocolError;
    reply_.status.message = std::string(proto::name(reply_.rpc)) +
                            ": a reply with the status OK, but without a message";
    return;
  }
  grpc::Slice bytes;
  if (!response_.TrySingleSlice(&bytes).ok() && !response_.DumpToSingleSlice(&bytes).ok()) {
    bytes = grpc::Slice();
  }
  memory_.parse({reinterpret_cast<const char*>(bytes.begin()), bytes.size()}, reply_);
}

}  // namespace cls::proxy
