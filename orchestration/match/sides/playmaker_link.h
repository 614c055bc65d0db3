// Reaching the Playmaker that an endpoint names.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "mock-server/server.h"
#include "orchestration/match/options/endpoint.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::orchestration::match {

/// Where a running Playmaker listens; for kAddress and kUnixSocket.
proxy::GrpcTarget target_of(const Endpoint& endpoint);

/// What there is to say of a Playmaker that did not answer in time: "; it speaks TLS (say
/// tls:...)", or nothing. Asks it once, for five seconds at most.
std::string silence_hint(const Endpoint& endpoint);

/// The bundled Playmaker with the endpoint's script or behaviour; for kMock. The error says which
/// behaviour is unknown.
base::Result<std::unique_ptr<mock_server::Server>> start_mock(const Endpoint& endpoint);

}  // namespace cls::orchestration::match
