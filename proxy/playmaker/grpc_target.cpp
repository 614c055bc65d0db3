// Ports and addresses of the agents of a team.
#include "proxy/playmaker/grpc_target.h"

namespace cls::proxy {

int port_of(const GrpcTarget& target, int agent) {
  constexpr int kCoachStep = 13;
  // Coach and trainer, agents 12 and 13, share a port.
  const int step = !target.port_step ? 0 : agent > 11 ? kCoachStep : agent;
  return target.port + step;
}

std::string address(const GrpcTarget& target, int agent) {
  if (!target.unix_path.empty()) return "unix:" + target.unix_path;
  return target.host + ":" + std::to_string(port_of(target, agent));
}

}  // namespace cls::proxy
