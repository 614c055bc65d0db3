// Handing each rpc to the logic.
#include "mock-server/game_service.h"

namespace cls::mock_server {
namespace {

grpc::ServerUnaryReactor* finish(grpc::CallbackServerContext* context) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(grpc::Status::OK);
  return reactor;
}

}  // namespace

grpc::ServerUnaryReactor* GameService::GetPlayerActions(grpc::CallbackServerContext* context,
                                                        const protos::State* request,
                                                        protos::PlayerActions* response) {
  logic_.answer(proto::Rpc::kGetPlayerActions, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::GetCoachActions(grpc::CallbackServerContext* context,
                                                       const protos::State* request,
                                                       protos::CoachActions* response) {
  logic_.answer(proto::Rpc::kGetCoachActions, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::GetTrainerActions(grpc::CallbackServerContext* context,
                                                         const protos::State* request,
                                                         protos::TrainerActions* response) {
  logic_.answer(proto::Rpc::kGetTrainerActions, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendInitMessage(grpc::CallbackServerContext* context,
                                                       const protos::InitMessage* request,
                                                       protos::Empty* response) {
  logic_.answer(proto::Rpc::kSendInitMessage, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendServerParams(grpc::CallbackServerContext* context,
                                                        const protos::ServerParam* request,
                                                        protos::Empty* response) {
  logic_.answer(proto::Rpc::kSendServerParams, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendPlayerParams(grpc::CallbackServerContext* context,
                                                        const protos::PlayerParam* request,
                                                        protos::Empty* response) {
  logic_.answer(proto::Rpc::kSendPlayerParams, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendPlayerType(grpc::CallbackServerContext* context,
                                                      const protos::PlayerType* request,
                                                      protos::Empty* response) {
  logic_.answer(proto::Rpc::kSendPlayerType, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::Register(grpc::CallbackServerContext* context,
                                                const protos::RegisterRequest* request,
                                                protos::RegisterResponse* response) {
  logic_.answer(proto::Rpc::kRegister, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::SendByeCommand(grpc::CallbackServerContext* context,
                                                      const protos::RegisterResponse* request,
                                                      protos::Empty* response) {
  logic_.answer(proto::Rpc::kSendByeCommand, *request, *response);
  return finish(context);
}

grpc::ServerUnaryReactor* GameService::GetBestPlannerAction(
    grpc::CallbackServerContext* context, const protos::BestPlannerActionRequest* request,
    protos::BestPlannerActionResponse* response) {
  logic_.answer(proto::Rpc::kGetBestPlannerAction, *request, *response);
  return finish(context);
}

}  // namespace cls::mock_server
