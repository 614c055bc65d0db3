// The ten rpcs of the wire as values: names, messages.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cls::proto {

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

/// "GetPlayerActions" and so on; all of them in the order of the enumeration.
std::string_view name(Rpc rpc);
const std::vector<std::string_view>& rpc_names();
std::optional<Rpc> rpc_from_name(std::string_view name);

/// True for the three calls that ask for a decision: their request is a State.
constexpr bool is_decision(Rpc rpc) {
  return rpc == Rpc::kGetPlayerActions || rpc == Rpc::kGetCoachActions ||
         rpc == Rpc::kGetTrainerActions;
}

/// An empty request or reply, to make others from.
const google::protobuf::Message& request_prototype(Rpc rpc);
const google::protobuf::Message& reply_prototype(Rpc rpc);

/// Who asks, as far as a request says so.
struct Caller {
  std::string_view team;
  int unum = 0;       ///< 0: not said
  int client_id = 0;  ///< of Register's answer
};
Caller caller_of(Rpc rpc, const google::protobuf::Message& request);

}  // namespace cls::proto
