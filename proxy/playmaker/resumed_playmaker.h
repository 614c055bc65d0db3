// A Playmaker whose first replies are known: those of a saved match.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>

#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// A reply to a decision or to a choice of a planned action.
struct SavedReply {
  proto::Rpc rpc = proto::Rpc::kGetPlayerActions;
  RpcStatus status;
  std::string message;  ///< serialized; empty unless `status` is ok
};

/// By agent number, in the order of the calls.
using SavedReplies = std::map<int, std::deque<SavedReply>>;

/// Answers the decisions of each agent with its saved replies, and makes calls to `inner` when they
/// are used up. The handshake goes to `inner` from the start: it decides later.
std::unique_ptr<Playmaker> resume_with(std::unique_ptr<Playmaker> inner, SavedReplies replies);

}  // namespace cls::proxy
