// The rpcs of a Playmaker as a gRPC service, at full speed.
#pragma once

#include "mock-server/game_logic.h"
#include "mock-server/script/message_pool.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {

/// Callback service: handlers run on gRPC's threads and never block.
class GameService : public protos::Game::CallbackService {
 public:
  /// `logic` must outlive the service.
  explicit GameService(GameLogic& logic) : logic_(logic) {
    SetMessageAllocatorFor_GetPlayerActions(&messages_);
  }

  grpc::ServerUnaryReactor* GetPlayerActions(grpc::CallbackServerContext* context,
                                             const protos::State* request,
                                             protos::PlayerActions* response) override;
  grpc::ServerUnaryReactor* GetCoachActions(grpc::CallbackServerContext* context,
                                            const protos::State* request,
                                            protos::CoachActions* response) override;
  grpc::ServerUnaryReactor* GetTrainerActions(grpc::CallbackServerContext* context,
                                              const protos::State* request,
                                              protos::TrainerActions* response) override;
  grpc::ServerUnaryReactor* SendInitMessage(grpc::CallbackServerContext* context,
                                            const protos::InitMessage* request,
                                            protos::Empty* response) override;
  grpc::ServerUnaryReactor* SendServerParams(grpc::CallbackServerContext* context,
                                             const protos::ServerParam* request,
                                             protos::Empty* response) override;
  grpc::ServerUnaryReactor* SendPlayerParams(grpc::CallbackServerContext* context,
                                             const protos::PlayerParam* request,
                                             protos::Empty* response) override;
  grpc::ServerUnaryReactor* SendPlayerType(grpc::CallbackServerContext* context,
                                           const protos::PlayerType* request,
                                           protos::Empty* response) override;
  grpc::ServerUnaryReactor* Register(grpc::CallbackServerContext* context,
                                     const protos::RegisterRequest* request,
                                     protos::RegisterResponse* response) override;
  grpc::ServerUnaryReactor* SendByeCommand(grpc::CallbackServerContext* context,
                                           const protos::RegisterResponse* request,
                                           protos::Empty* response) override;
  grpc::ServerUnaryReactor* GetBestPlannerAction(
      grpc::CallbackServerContext* context, const protos::BestPlannerActionRequest* request,
      protos::BestPlannerActionResponse* response) override;

 private:
  GameLogic& logic_;
  MessagePool<protos::State, protos::PlayerActions> messages_;
};

}  // namespace cls::mock_server
