// The RPCs of both Playmaker services as values: names, message types, sender.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace protos {
class RegisterResponse;
}

namespace cls::proto {

/// In the order of `service Game` in playmaker.proto, then of `service TeamPlaymaker` in
/// team_playmaker.proto.
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
  kRegisterTeam,
  kGetTeamActions,
  kGetBestPlannerActions,
  kUnregisterTeam,
};
constexpr int kAgentRpcs = 10;  ///< those of Game: each concerns one agent
constexpr int kRpcs = 14;

/// The version of TeamPlaymaker; both sides send theirs in RegisterTeam.
constexpr int kTeamPlaymakerVersion = 1;
/// Agents of a team have numbers: players their uniform numbers, the others these.
constexpr int kCoachNumber = 12;
constexpr int kTrainerNumber = 13;

/// "GetPlayerActions".
std::string_view name(Rpc rpc);
/// "/protos.Game/GetPlayerActions", the method path of gRPC.
const std::string& path(Rpc rpc);
/// Names of the RPCs of Game, in the order of the enumeration.
const std::vector<std::string_view>& agent_rpc_names();
/// The RPC with a name; nothing if there is none.
std::optional<Rpc> rpc_from_name(std::string_view name);

/// True for the three RPCs that request a decision; their request is a State.
constexpr bool is_decision(Rpc rpc) {
  return rpc == Rpc::kGetPlayerActions || rpc == Rpc::kGetCoachActions ||
         rpc == Rpc::kGetTrainerActions;
}

/// The RPC with which the agent of that number asks for a decision.
constexpr Rpc decision_of(int agent) {
  if (agent == kCoachNumber) return Rpc::kGetCoachActions;
  return agent == kTrainerNumber ? Rpc::kGetTrainerActions : Rpc::kGetPlayerActions;
}

/// True for the RPCs with which agents introduce themselves.
constexpr bool is_registration(Rpc rpc) {
  return rpc == Rpc::kRegister || rpc == Rpc::kRegisterTeam;
}

/// A reply of more bytes is a protocol error: a Playmaker must not take all memory of the host.
constexpr std::size_t kMaxReplyBytes = std::size_t{1} << 20;
/// The largest reply of a team, with those of all its agents.
constexpr std::size_t kMaxTeamReplyBytes = 12 * kMaxReplyBytes;
constexpr std::size_t max_reply_bytes(Rpc rpc) {
  return static_cast<int>(rpc) < kAgentRpcs ? kMaxReplyBytes : kMaxTeamReplyBytes;
}

/// Default instances, for New().
const google::protobuf::Message& request_prototype(Rpc rpc);
const google::protobuf::Message& reply_prototype(Rpc rpc);

/// The agent that sent a request of Game, as far as the request identifies it.
struct Caller {
  std::string_view team;
  int unum = 0;       ///< 0: unknown
  int client_id = 0;  ///< assigned by Register
};
Caller caller_of(Rpc rpc, const google::protobuf::Message& request);

/// Writes the identity received from Register into a request of Game; no effect on Register itself.
void set_identity(Rpc rpc, const protos::RegisterResponse& identity,
                  google::protobuf::Message& request);

}  // namespace cls::proto
