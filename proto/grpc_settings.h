// Settings of gRPC that hold for the whole process.
#pragma once

namespace cls::proto {

/// Every client and server of gRPC calls it before its first channel: turns off abseil's search for
/// deadlocks, a debugging aid of distributions' builds that costs each lock. Thread safe.
void apply_grpc_settings();

/// gRPC logs what its users report better, on stderr. Drops that unless GRPC_VERBOSITY is set.
void silence_grpc_log();

}  // namespace cls::proto
