// Client of a Playmaker that speaks Thrift.
#pragma once

#include <memory>

#include "proxy/playmaker/grpc_target.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Thrift's binary protocol over TCP without frames, as the framework's proxy speaks it: a
/// connection for each agent, opened with its first call. `target` has neither TLS nor a path.
/// Calls are single ones; the RPCs of TeamPlaymaker end as kUnimplemented.
std::unique_ptr<Playmaker> make_thrift_playmaker(const GrpcTarget& target);

}  // namespace cls::proxy
