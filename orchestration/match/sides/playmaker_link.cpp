// From the words of an endpoint to something that can be asked.
#include "orchestration/match/sides/playmaker_link.h"

#include <utility>

#include "proxy/playmaker/tls_probe.h"

namespace cls::orchestration::match {

proxy::GrpcTarget target_of(const Endpoint& endpoint) {
  proxy::GrpcTarget target;
  target.host = endpoint.host;
  target.port = endpoint.port;
  target.port_step = endpoint.port_step;
  target.unix_path = endpoint.path;
  target.tls = endpoint.tls;
  return target;
}

std::string silence_hint(const Endpoint& endpoint) {
  constexpr int kGoalie = 1;
  if (endpoint.kind != Endpoint::Kind::kAddress) return {};
  const std::string trouble = proxy::tls_trouble(target_of(endpoint), kGoalie);
  return trouble.empty() ? trouble : "; " + trouble;
}

base::Result<std::unique_ptr<mock_server::Server>> start_mock(const Endpoint& endpoint) {
  if (endpoint.script != nullptr) {
    return mock_server::Server::start(mock_server::Mock(endpoint.script));
  }
  auto mock = mock_server::make_mock(endpoint.behaviour);
  if (!mock) return mock.error();
  return mock_server::Server::start(*std::move(mock));
}

}  // namespace cls::orchestration::match
