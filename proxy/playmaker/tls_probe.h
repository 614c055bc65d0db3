// Why a TLS connection does not come about: gRPC itself says only that the handshake failed.
#pragma once

#include <string>

#include "proxy/playmaker/grpc_target.h"

namespace cls::proxy {

/// Connects once by itself, for five seconds at most. What is wrong with speaking to this target as
/// it says, in words for a user: its certificate is not trusted, has expired, bears another name;
/// it does not take ours; it speaks plain text where TLS was expected, or TLS where it was not.
/// Empty when nothing of the kind was seen, also when nobody is there.
std::string tls_trouble(const GrpcTarget& target, int agent);

}  // namespace cls::proxy
