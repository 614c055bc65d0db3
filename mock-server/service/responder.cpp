// Choosing and injecting the fault of a call.
#include "mock-server/service/responder.h"

#include <algorithm>
#include <utility>

namespace cls::mock_server {
namespace {

using google::protobuf::Message;
using proto::Rpc;

// gRPC accepts messages up to 4 MiB by default.
constexpr std::size_t kOversizeBytes = 5u << 20u;

grpc::Status status_of(const Fault& fault, const Faults& faults) {
  switch (fault.what) {
    case Fault::What::kError:
      return {static_cast<grpc::StatusCode>(*status_code(faults.status)), faults.message};
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

std::string oversized_reply() {
  protos::PlayerActions large;
  large.add_actions()->mutable_debug_client()->set_message(std::string(kOversizeBytes, 'x'));
  return large.SerializeAsString();
}

}  // namespace

Responder::Responder(RequestHandler& handler, Faults faults, std::function<void()> die)
    : handler_(handler),
      faults_(std::move(faults)),
      faulty_(faults_.any()),
      die_(std::move(die)),
      restarting_(faults_.restart_at_cycle == 0) {}

Fault Responder::choose_fault(Rpc rpc, const Message& request) {
  const Fault fault = draw_fault(faults_, rpc, request);
  const std::lock_guard lock(mutex_);
  if (fault.what == Fault::What::kCrash) dead_ = true;
  if (dead_) return {Fault::What::kCrash, 0};

  if (faults_.restart_at_cycle && is_decision(rpc)) {
    const int cycle = static_cast<const protos::State&>(request).world_model().cycle();
    const int elapsed = cycle - *faults_.restart_at_cycle;
    if (elapsed < 0) return fault;
    restarting_ = true;
    if (elapsed < faults_.restart_cycles) return {Fault::What::kGone, 0};
    const bool known = clients_.contains(caller_of(rpc, request).client_id);
    if (!known) return {Fault::What::kUnknownClient, 0};
  }
  return fault;
}

void Responder::alter_identity(protos::RegisterResponse& identity) {
  if (faults_.wrong_client_id) {
    identity.set_client_id(1);
    identity.set_uniform_number(1);
  }
  const std::lock_guard lock(mutex_);
  if (restarting_) clients_.insert(identity.client_id());
}

Response Responder::respond(Rpc rpc, const Message& request, Message& message) {
  Response response;
  if (!faulty_) {
    handler_.handle(rpc, request, message);
    return response;
  }

  const Fault fault = choose_fault(rpc, request);
  if (fault.what == Fault::What::kCrash && die_) die_();

  const auto up_for = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - start_);
  response.delay_ms =
      std::max(fault.delay_ms, faults_.slow_start_ms - static_cast<int>(up_for.count()));
  response.status = status_of(fault, faults_);

  switch (fault.what) {
    case Fault::What::kHang:
      response.hangs = true;
      break;
    case Fault::What::kNone:
      handler_.handle(rpc, request, message);
      if (rpc == Rpc::kRegister) alter_identity(static_cast<protos::RegisterResponse&>(message));
      break;
    case Fault::What::kGarbage:
      response.bytes = std::string(64, '\xff');
      break;
    case Fault::What::kOversize:
      response.bytes = oversized_reply();
      break;
    default:
      break;
  }

  return response;
}

}  // namespace cls::mock_server
