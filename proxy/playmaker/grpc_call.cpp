// Serialising a request, reading an answer, naming what went wrong.
#include "proxy/playmaker/grpc_call.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <grpc/support/time.h>

#include <cassert>

namespace cls::proxy {
namespace {

constexpr const char* kService = "/protos.Game/";

// Straight into the slice that goes to the transport: no copy, one allocation. The entries of maps
// go by key: their own order changes from process to process, and a Playmaker that loops over one
// would play differently every time.
grpc::ByteBuffer serialised(const google::protobuf::MessageLite& message) {
  grpc::Slice slice(message.ByteSizeLong());
  {
    google::protobuf::io::ArrayOutputStream bytes(const_cast<std::uint8_t*>(slice.begin()),
                                                  static_cast<int>(slice.size()));
    google::protobuf::io::CodedOutputStream out(&bytes);  // writes its last bytes at its end
    out.SetSerializationDeterministic(true);
    message.SerializeWithCachedSizes(&out);
  }
  return grpc::ByteBuffer(&slice, 1);
}

// On the clock that nobody sets.
gpr_timespec deadline_after(RpcTimeout timeout) {
  return gpr_time_add(gpr_now(GPR_CLOCK_MONOTONIC),
                      gpr_time_from_millis(timeout.count(), GPR_TIMESPAN));
}

RpcOutcome outcome_of(grpc::StatusCode code, bool cancelled) {
  switch (code) {
    case grpc::StatusCode::OK:
      return RpcOutcome::kOk;
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return RpcOutcome::kDeadline;
    case grpc::StatusCode::UNAVAILABLE:
      return RpcOutcome::kUnavailable;
    case grpc::StatusCode::UNIMPLEMENTED:
      return RpcOutcome::kUnimplemented;
    default:
      return cancelled ? RpcOutcome::kCancelled : RpcOutcome::kError;
  }
}

// Messages of other programs go into one-line reports.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

}  // namespace

void GrpcCall::start(grpc::GenericStub& stub, grpc::CompletionQueue& queue, const char* method,
                     const google::protobuf::MessageLite& request, Answer answer,
                     RpcTimeout timeout, bool wait_for_ready) {
  assert(!in_flight_ && "an agent asks one thing at a time");
  message_ = nullptr;
  arena_.Reset();
  reader_.reset();
  context_.emplace();
  response_.Clear();
  method_ = method;
  answer_ = answer;
  cancelled_ = false;
  in_flight_ = true;
  started_ = std::chrono::steady_clock::now();
  if (timeout != kNoTimeout) context_->set_deadline(deadline_after(timeout));
  context_->set_wait_for_ready(wait_for_ready);
  reader_ = stub.PrepareUnaryCall(&*context_, std::string(kService) + method, serialised(request),
                                  &queue);
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
  const grpc::StatusCode code = grpc_status_.error_code();
  status_.outcome = outcome_of(code, cancelled_);
  status_.code = static_cast<int>(code);
  status_.message.clear();
  if (status_.ok()) {
    read_message();
    return;
  }
  status_.message = std::string(method_) + ": " + one_line(grpc_status_.error_message());
}

google::protobuf::MessageLite* GrpcCall::make_message() {
  using google::protobuf::Arena;
  switch (answer_) {
    case Answer::kRegister:
      return Arena::CreateMessage<protos::RegisterResponse>(&arena_);
    case Answer::kPlayer:
      return Arena::CreateMessage<protos::PlayerActions>(&arena_);
    case Answer::kCoach:
      return Arena::CreateMessage<protos::CoachActions>(&arena_);
    case Answer::kTrainer:
      return Arena::CreateMessage<protos::TrainerActions>(&arena_);
    case Answer::kPlanner:
      return Arena::CreateMessage<protos::BestPlannerActionResponse>(&arena_);
    case Answer::kEmpty:
      break;
  }
  return Arena::CreateMessage<protos::Empty>(&arena_);
}

void GrpcCall::read_message() {
  google::protobuf::MessageLite* message = make_message();
  grpc::Slice bytes;
  if (!response_.TrySingleSlice(&bytes).ok() && !response_.DumpToSingleSlice(&bytes).ok()) {
    bytes = grpc::Slice();
  }
  if (message->ParseFromArray(bytes.begin(), static_cast<int>(bytes.size()))) {
    message_ = message;
    return;
  }
  status_.outcome = RpcOutcome::kProtocolError;
  status_.message = std::string(method_) + ": the answer (" + std::to_string(bytes.size()) +
                    " bytes) is not a " + message->GetTypeName();
}

}  // namespace cls::proxy
