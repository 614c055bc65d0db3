// The RPCs of the Playmaker interface as values: names, message types, sender.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace protos {
class RegisterResponse;
}

namespace cls::proto {

/// In the order of `service Game` in playmaker.proto.
enum class Rpc : std::uint8_t {
  kRegister,
  kSendServerParams,
  kSendPlayerParams,
  kSendPlayerType,
  kSendInitMessage,
  kGetPlayerActions,
  kGetCoachActions,
  kGetTrainerActions,
  kGetBestPlannerAction,
  kSendByeCommand,
};
constexpr int kRpcs = 10;

/// "GetPlayerActions".
std::string_view name(Rpc rpc);
/// "/protos.Game/GetPlayerActions", the method path of gRPC.
const std::string& path(Rpc rpc);
/// All names, in the order of the enumeration.
const std::vector<std::string_view>& rpc_names();
std::optional<Rpc> rpc_from_name(std::string_view name);

/// True for the three RPCs that request a decision; their request is a State.
constexpr bool is_decision(Rpc rpc) {
  return rpc == Rpc::kGetPlayerActions || rpc == Rpc::kGetCoachActions ||
         rpc == Rpc::kGetTrainerActions;
}

/// Default instances, for New().
const google::protobuf::Message& request_prototype(Rpc rpc);
const google::protobuf::Message& reply_prototype(Rpc rpc);

/// The agent that sent a request, as far as the request identifies it.
struct Caller {
  std::string_view team;
  int unum = 0;       ///< 0: unknown
  int client_id = 0;  ///< assigned by Register
};
Caller caller_of(Rpc rpc, const google::protobuf::Message& request);

/// Writes the identity received from Register into a request; no effect on Register itself.
void set_identity(Rpc rpc, const protos::RegisterResponse& identity,
                  google::protobuf::Message& request);

}  // namespace cls::proto
