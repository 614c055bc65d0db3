// Settings of gRPC that hold for the whole process.
#pragma once

#include <grpcpp/support/channel_arguments.h>

namespace cls::proto {

/// Every client and server of gRPC calls it before its first channel: turns off abseil's search for
/// deadlocks, a debugging aid of distributions' builds that costs each lock, and keeps gRPC until
/// the process ends, because gRPC 1.51 may hang when its last user shuts it down while it still
/// polls a lost connection. Thread safe.
void apply_grpc_settings();

/// Bytes of a call that a receiver accepts before it has read any (the window of a stream). The
/// default, 64 KB, is less than the States of a team: the sender would wait for the receiver.
constexpr int kTeamCallWindow = 1 << 20;

/// Limits what a reply takes in memory, for channels to Playmakers. Replies are not compressed,
/// because gRPC limits their size before it decompresses them.
void limit_replies(grpc::ChannelArguments& arguments);

/// gRPC logs what its users report better, on stderr. Drops that unless GRPC_VERBOSITY is set.
void silence_grpc_log();

}  // namespace cls::proto
