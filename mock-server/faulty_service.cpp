// Answers that come late, broken or never.
#include "mock-server/faulty_service.h"

#include <grpcpp/alarm.h>
#include <grpcpp/grpcpp.h>

#include <memory>

namespace cls::mock_server {
namespace {

using google::protobuf::Message;

// gRPC takes messages up to 4 MiB unless told otherwise.
constexpr std::size_t kTooLarge = 5u << 20u;

// One call under way: finishes after a time, or only when the caller gives up.
class Answer : public grpc::ServerUnaryReactor {
 public:
  void finish_after(int milliseconds, grpc::Status status) {
    if (milliseconds <= 0) return Finish(std::move(status));
    const auto when = std::chrono::system_clock::now() + std::chrono::milliseconds(milliseconds);
    alarm_.Set(when, [this, status](bool /*fired*/) { Finish(status); });
  }

  void never() {
    const std::lock_guard lock(mutex_);
    waits_for_ever_ = true;
    if (cancelled_) Finish(grpc::Status::CANCELLED);
  }

  void OnCancel() override {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
    if (waits_for_ever_) Finish(grpc::Status::CANCELLED);
  }

  void OnDone() override { delete this; }

 private:
  grpc::Alarm alarm_;
  std::mutex mutex_;
  bool cancelled_ = false;
  bool waits_for_ever_ = false;
};

grpc::ByteBuffer buffer_of(const std::string& bytes) {
  const grpc::Slice slice(bytes);
  return grpc::ByteBuffer(&slice, 1);
}

bool read(const grpc::ByteBuffer& bytes, Message& message) {
  grpc::Slice slice;
  return bytes.TrySingleSlice(&slice).ok() || bytes.DumpToSingleSlice(&slice).ok()
             ? message.ParseFromArray(slice.begin(), static_cast<int>(slice.size()))
             : false;
}

grpc::Status error_of(const Fate& fate, const Faults& faults) {
  switch (fate.what) {
    case Fate::What::kError:
      return {static_cast<grpc::StatusCode>(*status_code(faults.status)), "a fault of the mock"};
    case Fate::What::kUnimplemented:
      return {grpc::StatusCode::UNIMPLEMENTED, "not implemented by the mock, on purpose"};
    case Fate::What::kCrash:
    case Fate::What::kGone:
      return {grpc::StatusCode::UNAVAILABLE, "the mock is down, on purpose"};
    case Fate::What::kUnknown:
      return {grpc::StatusCode::UNKNOWN, "unknown client_id: the mock was restarted, on purpose"};
    default:
      return grpc::Status::OK;
  }
}

}  // namespace

Fate FaultyService::decide_fate(proto::Rpc rpc, const Message& request) {
  Fate fate = fate_of(faults_, rpc, request);
  const std::lock_guard lock(mutex_);
  if (fate.what == Fate::What::kCrash) dead_ = true;
  if (dead_) return {Fate::What::kCrash, 0};
  if (faults_.restart_at_cycle && is_decision(rpc)) {
    const int cycle = static_cast<const protos::State&>(request).world_model().cycle();
    const int gone = cycle - *faults_.restart_at_cycle;
    if (gone >= 0) restarting_ = true;
    if (gone >= 0 && gone < faults_.restart_cycles) return {Fate::What::kGone, 0};
    if (gone >= 0 && clients_.count(caller_of(rpc, request).client_id) == 0) {
      return {Fate::What::kUnknown, 0};
    }
  }
  return fate;
}

void FaultyService::answer(proto::Rpc rpc, const Message& request, grpc::ByteBuffer& reply) {
  std::unique_ptr<Message> message(reply_prototype(rpc).New());
  logic_.answer(rpc, request, *message);
  if (rpc == proto::Rpc::kRegister) {
    auto& identity = static_cast<protos::RegisterResponse&>(*message);
    if (faults_.wrong_client_id) {
      identity.set_client_id(1);
      identity.set_uniform_number(1);
    }
    const std::lock_guard lock(mutex_);
    if (restarting_) clients_.insert(identity.client_id());
  }
  reply = buffer_of(message->SerializeAsString());
}

grpc::ServerUnaryReactor* FaultyService::serve(proto::Rpc rpc, const grpc::ByteBuffer& bytes,
                                               grpc::ByteBuffer& reply) {
  auto* call = new Answer;  // deletes itself when done
  std::unique_ptr<Message> request(request_prototype(rpc).New());
  if (!read(bytes, *request)) {
    call->finish_after(0, {grpc::StatusCode::INTERNAL, "the request is no message of this rpc"});
    return call;
  }
  Fate fate = decide_fate(rpc, *request);
  if (fate.what == Fate::What::kCrash && die_) die_();
  const auto up_for = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - start_);
  fate.delay_ms = std::max(fate.delay_ms, faults_.slow_start_ms - static_cast<int>(up_for.count()));
  switch (fate.what) {
    case Fate::What::kNever:
      call->never();
      return call;
    case Fate::What::kAnswer:
      answer(rpc, *request, reply);
      break;
    case Fate::What::kGarbage:
      reply = buffer_of(std::string(64, '\xff'));
      break;
    case Fate::What::kOversize: {
      protos::PlayerActions large;
      large.add_actions()->mutable_debug_client()->set_message(std::string(kTooLarge, 'x'));
      reply = buffer_of(large.SerializeAsString());
      break;
    }
    default:
      break;
  }
  call->finish_after(fate.delay_ms, error_of(fate, faults_));
  return call;
}

}  // namespace cls::mock_server
