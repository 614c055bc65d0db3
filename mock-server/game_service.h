// The rpcs of a Playmaker, answered by a behaviour.
#pragma once

#include <atomic>

#include "mock-server/behaviour.h"
#include "mock-server/message_pool.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {

/// Serves any number of agents. Register hands out client ids 1, 2, 3, ... in order of arrival.
/// Callback service: handlers run on gRPC's threads and never block.
class GameService : public protos::Game::CallbackService {
 public:
  /// `behaviour` must outlive the service.
  explicit GameService(const Behaviour& behaviour) : behaviour_(behaviour) {
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

  /// CPU time spent in decisions so far, in nanoseconds.
  std::int64_t decision_nanoseconds() const { return decision_nanoseconds_; }

 private:
  const Behaviour& behaviour_;
  MessagePool<protos::State, protos::PlayerActions> messages_;
  std::atomic<int> next_client_{1};
  std::atomic<std::int64_t> decision_nanoseconds_{0};
};

}  // namespace cls::mock_server
