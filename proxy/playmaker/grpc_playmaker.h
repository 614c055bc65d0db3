// A Playmaker reached by gRPC: in this process, over TCP or over a local socket.
#pragma once

#include <memory>
#include <string>

#include "proxy/playmaker/grpc_target.h"
#include "proxy/playmaker/playmaker.h"

namespace grpc {
class Channel;
}

namespace cls::proxy {

/// A Playmaker behind a channel that exists already (an in-process one). `name` is what messages to
/// the user call it. The server must outlive the returned object.
std::unique_ptr<Playmaker> make_grpc_playmaker(std::shared_ptr<grpc::Channel> channel,
                                               std::string name);

/// A Playmaker at an address; nothing is sent before the first call. All agents share one
/// connection (with port_step each has its own), which no other object of the process shares. A
/// broken connection is tried again every 200 ms at most.
std::unique_ptr<Playmaker> make_grpc_playmaker(const GrpcTarget& target);

}  // namespace cls::proxy
