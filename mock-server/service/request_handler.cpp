// Replies by RPC.
#include "mock-server/service/request_handler.h"

#include <ctime>

namespace cls::mock_server {
namespace {

std::int64_t thread_cpu_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

// The candidate with the highest evaluation; the lowest index among equals.
int best_of(const protos::BestPlannerActionRequest& request) {
  int best = 0;
  double best_value = 0.0;

  bool found = false;
  for (const auto& [index, candidate] : request.pairs()) {
    const double value = candidate.evaluation();
    if (!found || value > best_value || (value == best_value && index < best)) {
      found = true;
      best = index;
      best_value = value;
    }
  }

  return best;
}

}  // namespace

void RequestHandler::handle_register(const protos::RegisterRequest& request,
                                     protos::RegisterResponse& reply) {
  reply.set_client_id(next_client_++);
  reply.set_agent_type(request.agent_type());
  reply.set_team_name(request.team_name());
  reply.set_uniform_number(request.uniform_number());
  reply.set_rpc_server_language_type(protos::CPP);
}

void RequestHandler::handle(proto::Rpc rpc, const google::protobuf::Message& request,
                            google::protobuf::Message& reply) {
  if (expectations_ != nullptr) expectations_->add(rpc, request);

  const std::int64_t before = thread_cpu_nanoseconds();
  const auto state = [&request]() -> const protos::State& {
    return static_cast<const protos::State&>(request);
  };

  switch (rpc) {
    case proto::Rpc::kRegister:
      handle_register(static_cast<const protos::RegisterRequest&>(request),
                      static_cast<protos::RegisterResponse&>(reply));
      break;
    case proto::Rpc::kGetPlayerActions:
      behavior_.decide(state(), static_cast<protos::PlayerActions&>(reply));
      break;
    case proto::Rpc::kGetCoachActions:
      behavior_.decide_as_coach(state(), static_cast<protos::CoachActions&>(reply));
      break;
    case proto::Rpc::kGetTrainerActions:
      behavior_.decide_as_trainer(state(), static_cast<protos::TrainerActions&>(reply));
      break;
    case proto::Rpc::kGetBestPlannerAction:
      static_cast<protos::BestPlannerActionResponse&>(reply).set_index(
          best_of(static_cast<const protos::BestPlannerActionRequest&>(request)));
      break;
    default:
      break;  // replies with an Empty
  }

  decision_nanoseconds_ += thread_cpu_nanoseconds() - before;
}

}  // namespace cls::mock_server
