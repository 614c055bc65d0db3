// The reason why a TLS handshake failed: gRPC reports only that it failed.
#pragma once

#include <string>

#include "proxy/playmaker/grpc_target.h"

namespace cls::proxy {

/// Makes a connection of its own, for at most 5 s. Returns the problem for the user: certificate
/// not trusted, expired, for another name; client certificate missing or rejected; plain text where
/// TLS was expected, or the reverse. Empty when no such problem was found or the target is
/// unreachable.
std::string explain_tls_failure(const GrpcTarget& target, int agent);

}  // namespace cls::proxy
