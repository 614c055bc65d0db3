// Channels of gRPC to a Playmaker in another network.
#pragma once

#include <grpcpp/support/channel_arguments.h>

#include "base/system/tcp_connect.h"

namespace cls::proxy {

/// Channels with these arguments connect, each time, over a socket of `make`, so that waiting,
/// reconnecting and the state of the connection are those of any channel. An attempt fails when
/// `make` has no socket.
void connect_over(base::TcpSocketMaker make, grpc::ChannelArguments& arguments);

}  // namespace cls::proxy
