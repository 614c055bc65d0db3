// Answering the rpcs.
#include "mock-server/game_service.h"

#include <ctime>

namespace cls::mock_server {
namespace {

grpc::ServerUnaryReactor* finish(grpc::CallbackServerContext* context) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(grpc::Status::OK);
  return reactor;
}

std::int64_t thread_cpu_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

// The planner's best candidate; the lowest index of equal ones.
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

grpc::ServerUnaryReactor* GameService::GetPlayerActions(grpc::CallbackServerContext* context,
                                                        const protos::State* request,
                                                        protos::PlayerActions* response) {
  const std::int64_t before = thread_cpu_nanoseconds();
  behaviour_.decide(*request, *response);
  decision_nanoseconds_ += thread_cpu_nanoseconds() - before;
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::GetCoachActions(grpc::CallbackServerContext* context,
                                                       const protos::State*,
                                                       protos::CoachActions*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::GetTrainerActions(grpc::CallbackServerContext* context,
                                                         const protos::State*,
                                                         protos::TrainerActions*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendInitMessage(grpc::CallbackServerContext* context,
                                                       const protos::InitMessage*, protos::Empty*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendServerParams(grpc::CallbackServerContext* context,
                                                        const protos::ServerParam*,
                                                        protos::Empty*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendPlayerParams(grpc::CallbackServerContext* context,
                                                        const protos::PlayerParam*,
                                                        protos::Empty*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendPlayerType(grpc::CallbackServerContext* context,
                                                      const protos::PlayerType*, protos::Empty*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::Register(grpc::CallbackServerContext* context,
                                                const protos::RegisterRequest* request,
                                                protos::RegisterResponse* response) {
  response->set_client_id(next_client_++);
  response->set_agent_type(request->agent_type());
  response->set_team_name(request->team_name());
  response->set_uniform_number(request->uniform_number());
  response->set_rpc_server_language_type(protos::CPP);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendByeCommand(grpc::CallbackServerContext* context,
                                                      const protos::RegisterResponse*,
                                                      protos::Empty*) {
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::GetBestPlannerAction(
    grpc::CallbackServerContext* context, const protos::BestPlannerActionRequest* request,
    protos::BestPlannerActionResponse* response) {
  response->set_index(best_of(*request));
  return finish(context);
}

}  // namespace cls::mock_server
