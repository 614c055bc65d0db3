// Parsing requests, injecting faults, serializing replies.
#include "mock-server/service/playmaker_service.h"

#include <google/protobuf/arena.h>
#include <grpcpp/alarm.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/support/server_callback.h>

#include <algorithm>
#include <utility>

namespace cls::mock_server {
namespace {

using google::protobuf::Message;
using proto::Rpc;

// gRPC accepts messages up to 4 MiB by default.
constexpr std::size_t kOversizeBytes = 5u << 20u;

using MessageTraits = grpc::SerializationTraits<Message>;

grpc::Status parse(const grpc::ByteBuffer& bytes, Message& message) {
  grpc::ByteBuffer copy = bytes;  // of references to the slices; Deserialize() clears it
  const grpc::Status status = MessageTraits::Deserialize(&copy, &message);
  if (status.ok()) return status;
  return {grpc::StatusCode::INTERNAL, "the request does not parse"};
}

grpc::Status serialize(const Message& message, grpc::ByteBuffer& bytes) {
  bool own_buffer = false;
  return MessageTraits::Serialize(message, &bytes, &own_buffer);
}

grpc::ByteBuffer buffer_of(const std::string& bytes) {
  const grpc::Slice slice(bytes);
  return grpc::ByteBuffer(&slice, 1);
}

// A call that finishes after a delay, or only when the client cancels it.
class DelayedReply : public grpc::ServerUnaryReactor {
 public:
  void finish_after(int milliseconds, grpc::Status status) {
    if (milliseconds <= 0) return Finish(std::move(status));
    const auto when = std::chrono::system_clock::now() + std::chrono::milliseconds(milliseconds);
    alarm_.Set(when, [this, status](bool /*fired*/) { Finish(status); });
  }

  void hang() {
    const std::lock_guard lock(mutex_);
    hanging_ = true;
    if (cancelled_) Finish(grpc::Status::CANCELLED);
  }

  void OnCancel() override {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
    if (hanging_) Finish(grpc::Status::CANCELLED);
  }

  void OnDone() override { delete this; }

 private:
  grpc::Alarm alarm_;
  std::mutex mutex_;
  bool cancelled_ = false;
  bool hanging_ = false;
};

grpc::Status status_of(const Fault& fault, const Faults& faults) {
  switch (fault.what) {
    case Fault::What::kError:
      return {static_cast<grpc::StatusCode>(*status_code(faults.status)), "injected error"};
    case Fault::What::kUnimplemented:
      return {grpc::StatusCode::UNIMPLEMENTED, "injected fault: unimplemented"};
    case Fault::What::kCrash:
    case Fault::What::kGone:
      return {grpc::StatusCode::UNAVAILABLE, "injected fault: the mock is down"};
    case Fault::What::kUnknownClient:
      return {grpc::StatusCode::UNKNOWN, "injected fault: unknown client_id after a restart"};
    default:
      return grpc::Status::OK;
  }
}

}  // namespace

/// Memory of one call, reused: no allocation for each of the many parts of a State.
class PlaymakerService::Workspace {
 public:
  Workspace() : block_(kBlockSize), arena_(block_.data(), block_.size()) {}

  Message& create(const Message& prototype) { return *prototype.New(&arena_); }
  void reset() { arena_.Reset(); }

 private:
  // A State of a busy cycle fits; the arena grows temporarily for a larger one.
  static constexpr std::size_t kBlockSize = 96 * 1024;

  std::vector<char> block_;
  google::protobuf::Arena arena_;
};

PlaymakerService::PlaymakerService(RequestHandler& handler, Faults faults,
                                   std::function<void()> die)
    : handler_(handler),
      faults_(std::move(faults)),
      faulty_(faults_.any()),
      die_(std::move(die)),
      restarting_(faults_.restart_at_cycle == 0) {
  using grpc::ByteBuffer;
  for (int i = 0; i < proto::kRpcs; ++i) {
    // As the generated WithRawCallbackMethod_NAME does for each method.
    MarkMethodRawCallback(
        i, new grpc::internal::CallbackUnaryHandler<ByteBuffer, ByteBuffer>(
               [this, rpc = static_cast<Rpc>(i)](grpc::CallbackServerContext* context,
                                                 const ByteBuffer* request, ByteBuffer* reply) {
                 return handle(rpc, *context, *request, *reply);
               }));
  }
}

PlaymakerService::~PlaymakerService() = default;

std::unique_ptr<PlaymakerService::Workspace> PlaymakerService::acquire_workspace() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<Workspace>();
  auto workspace = std::move(idle_.back());
  idle_.pop_back();
  return workspace;
}

void PlaymakerService::release_workspace(std::unique_ptr<Workspace> workspace) {
  workspace->reset();
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(workspace));
}

grpc::ServerUnaryReactor* PlaymakerService::handle(Rpc rpc, grpc::CallbackServerContext& context,
                                                   const grpc::ByteBuffer& request,
                                                   grpc::ByteBuffer& reply) {
  auto workspace = acquire_workspace();
  Message& parsed = workspace->create(request_prototype(rpc));
  Message& message = workspace->create(reply_prototype(rpc));
  grpc::ServerUnaryReactor* reactor = nullptr;
  grpc::Status status = parse(request, parsed);
  if (status.ok() && faulty_) {
    reactor = handle_with_faults(rpc, parsed, message, reply);
  } else {
    if (status.ok()) {
      handler_.handle(rpc, parsed, message);
      status = serialize(message, reply);
    }
    reactor = context.DefaultReactor();
    reactor->Finish(status);
  }
  release_workspace(std::move(workspace));
  return reactor;
}

Fault PlaymakerService::choose_fault(Rpc rpc, const Message& request) {
  const Fault fault = draw_fault(faults_, rpc, request);
  const std::lock_guard lock(mutex_);
  if (fault.what == Fault::What::kCrash) dead_ = true;
  if (dead_) return {Fault::What::kCrash, 0};
  if (faults_.restart_at_cycle && is_decision(rpc)) {
    const int cycle = static_cast<const protos::State&>(request).world_model().cycle();
    const int elapsed = cycle - *faults_.restart_at_cycle;
    if (elapsed >= 0) restarting_ = true;
    if (elapsed >= 0 && elapsed < faults_.restart_cycles) return {Fault::What::kGone, 0};
    if (elapsed >= 0 && clients_.count(caller_of(rpc, request).client_id) == 0) {
      return {Fault::What::kUnknownClient, 0};
    }
  }
  return fault;
}

void PlaymakerService::alter_identity(protos::RegisterResponse& identity) {
  if (faults_.wrong_client_id) {
    identity.set_client_id(1);
    identity.set_uniform_number(1);
  }
  const std::lock_guard lock(mutex_);
  if (restarting_) clients_.insert(identity.client_id());
}

grpc::ServerUnaryReactor* PlaymakerService::handle_with_faults(Rpc rpc, const Message& request,
                                                               Message& message,
                                                               grpc::ByteBuffer& reply) {
  auto* call = new DelayedReply;  // deletes itself when done
  Fault fault = choose_fault(rpc, request);
  if (fault.what == Fault::What::kCrash && die_) die_();
  const auto up_for = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - start_);
  fault.delay_ms =
      std::max(fault.delay_ms, faults_.slow_start_ms - static_cast<int>(up_for.count()));
  switch (fault.what) {
    case Fault::What::kHang:
      call->hang();
      return call;
    case Fault::What::kNone:
      handler_.handle(rpc, request, message);
      if (rpc == Rpc::kRegister) alter_identity(static_cast<protos::RegisterResponse&>(message));
      serialize(message, reply);
      break;
    case Fault::What::kGarbage:
      reply = buffer_of(std::string(64, '\xff'));
      break;
    case Fault::What::kOversize: {
      protos::PlayerActions large;
      large.add_actions()->mutable_debug_client()->set_message(std::string(kOversizeBytes, 'x'));
      reply = buffer_of(large.SerializeAsString());
      break;
    }
    default:
      break;
  }
  call->finish_after(fault.delay_ms, status_of(fault, faults_));
  return call;
}

}  // namespace cls::mock_server
