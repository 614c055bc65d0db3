// Why a Playmaker cannot be reached: what answers at its address.
#pragma once

#include <string>

#include "proxy/playmaker/grpc_target.h"

namespace cls::proxy {

struct GrpcProbe {
  /// "nothing listens at localhost:50051"; empty: an HTTP/2 server answers, as gRPC servers are.
  std::string problem;
  /// True when the program that answers speaks another protocol: waiting longer is useless.
  bool is_other_protocol = false;
};

/// Opens a connection of its own; takes up to 2 s, with TLS up to 7 s.
GrpcProbe probe_grpc(const GrpcTarget& target, int agent);

}  // namespace cls::proxy
