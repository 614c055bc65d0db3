// gRPC's own log lines.
#pragma once

namespace cls::proto {

/// gRPC logs what its users report better, on stderr. Drops that unless GRPC_VERBOSITY is set.
void silence_grpc_log();

}  // namespace cls::proto
