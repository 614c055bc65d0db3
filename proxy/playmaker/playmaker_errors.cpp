// Texts about errors of a Playmaker.
#include "proxy/playmaker/playmaker_errors.h"

#include <fmt/format.h>

#include <utility>

#include "proto/status_name.h"

namespace cls::proxy {
namespace {

// grpcio's words when a method returns something else than its reply message.
constexpr std::string_view kSerializeError = "Failed to serialize response!";

std::string hint(const PlaymakerError& error) {
  if (error.message != kSerializeError) return {};
  return fmt::format(" (the method returned no {}: its return value has the wrong type)",
                     reply_prototype(error.rpc).GetDescriptor()->name());
}

}  // namespace

bool is_error(const RpcStatus& status) {
  return status.outcome == RpcOutcome::kError || status.outcome == RpcOutcome::kProtocolError;
}

std::string agent_name(int agent) {
  if (agent == kCoachNumber) return "the coach";
  if (agent == kTrainerNumber) return "the trainer";
  return fmt::format("player {}", agent);
}

PlaymakerError describe_error(const Reply& reply, int cycle) {
  const bool unreadable = reply.status.outcome == RpcOutcome::kProtocolError;
  const std::string prefix = fmt::format("{}: ", name(reply.rpc));
  std::string message = reply.status.message;
  if (message.starts_with(prefix)) message.erase(0, prefix.size());

  return {.agent = reply.agent,
          .cycle = cycle,
          .rpc = reply.rpc,
          .status =
              std::string(unreadable ? "unreadable reply" : proto::status_name(reply.status.code)),
          .message = std::move(message),
          .calls = {}};
}

std::string PlaymakerError::describe() const {
  return fmt::format("{}: {} failed at cycle {}: {}: {}{}", agent_name(agent), name(rpc), cycle,
                     status, message, hint(*this));
}

recording::RecordedCall record_call(int agent, proto::Rpc rpc, int step,
                                    const google::protobuf::Message& request) {
  recording::RecordedCall call;
  call.set_agent(agent);
  call.set_rpc(std::string(name(rpc)));
  call.set_step(step);
  request.SerializeToString(call.mutable_request());
  return call;
}

}  // namespace cls::proxy
