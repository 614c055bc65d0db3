// A Playmaker in this process, called as a function.
#pragma once

#include <functional>
#include <memory>

#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Fills the empty `reply`; the messages are of the RPC's types. Must not block: no deadline ends
/// it.
using DirectHandler = std::function<void(proto::Rpc rpc, const google::protobuf::Message& request,
                                         google::protobuf::Message& reply)>;
/// The same where a call may fail.
using FallibleHandler = std::function<RpcStatus(
    proto::Rpc rpc, const google::protobuf::Message& request, google::protobuf::Message& reply)>;

/// Makes each decision in begin(), on the caller's thread and without serializing a message.
/// Replies come in the order of the calls; all are ok until cancel().
std::unique_ptr<Playmaker> make_direct_playmaker(DirectHandler handler);

/// The same; replies have the status that the handler returns.
std::unique_ptr<Playmaker> make_fallible_playmaker(FallibleHandler handler);

}  // namespace cls::proxy
