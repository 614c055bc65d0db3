// gRPC client of a Playmaker: in process, over TCP or over a Unix domain socket.
#pragma once

#include <memory>
#include <string>

#include "proxy/playmaker/grpc_target.h"
#include "proxy/playmaker/playmaker.h"

namespace grpc {
class Channel;
}

namespace cls::proxy {

/// Uses an existing channel (in process). `name` is the Playmaker in messages to the user. The
/// server must outlive the returned object.
std::unique_ptr<Playmaker> make_grpc_playmaker(std::shared_ptr<grpc::Channel> channel,
                                               std::string name);

/// Connects to an address with the first call. All agents share one connection (with port_step
/// each has its own) that is not shared with other objects. Reconnect backoff: 200 ms at most.
/// `team_reply` limits the wait of call() for the reply to RegisterTeam once connected: a Playmaker
/// that does not know it should say so immediately.
std::unique_ptr<Playmaker> make_grpc_playmaker(const GrpcTarget& target,
                                               RpcTimeout team_reply = kNoTimeout);

}  // namespace cls::proxy
