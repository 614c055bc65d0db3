// The rpcs of a Playmaker that does things wrong on purpose: bytes in, bytes out.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <set>

#include "mock-server/faults.h"
#include "mock-server/game_logic.h"
#include "proto/playmaker.grpc.pb.h"

namespace cls::mock_server {

/// The service with every rpc raw, so that a reply may be anything.
using RawGame = protos::Game::WithRawCallbackMethod_GetBestPlannerAction<
    protos::Game::WithRawCallbackMethod_SendByeCommand<protos::Game::WithRawCallbackMethod_Register<
        protos::Game::WithRawCallbackMethod_SendPlayerType<
            protos::Game::WithRawCallbackMethod_SendPlayerParams<
                protos::Game::WithRawCallbackMethod_SendServerParams<
                    protos::Game::WithRawCallbackMethod_SendInitMessage<
                        protos::Game::WithRawCallbackMethod_GetTrainerActions<
                            protos::Game::WithRawCallbackMethod_GetCoachActions<
                                protos::Game::WithRawCallbackMethod_GetPlayerActions<
                                    protos::Game::Service>>>>>>>>>>;

/// Answers by `logic`, and does with the answer what the faults say. Crash and restart are played
/// (calls fail as they would, a restarted Playmaker knows nobody) unless `die` is given.
class FaultyService : public RawGame {
 public:
  /// `logic` must outlive the service. `die` is called, from a thread of gRPC's, when a crash is
  /// due; it should not return.
  FaultyService(GameLogic& logic, Faults faults, std::function<void()> die)
      : logic_(logic),
        faults_(std::move(faults)),
        die_(std::move(die)),
        restarting_(faults_.restart_at_cycle == 0) {}

  grpc::ServerUnaryReactor* GetPlayerActions(grpc::CallbackServerContext* /*context*/,
                                             const grpc::ByteBuffer* request,
                                             grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kGetPlayerActions, *request, *reply);
  }
  grpc::ServerUnaryReactor* GetCoachActions(grpc::CallbackServerContext* /*context*/,
                                            const grpc::ByteBuffer* request,
                                            grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kGetCoachActions, *request, *reply);
  }
  grpc::ServerUnaryReactor* GetTrainerActions(grpc::CallbackServerContext* /*context*/,
                                              const grpc::ByteBuffer* request,
                                              grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kGetTrainerActions, *request, *reply);
  }
  grpc::ServerUnaryReactor* SendInitMessage(grpc::CallbackServerContext* /*context*/,
                                            const grpc::ByteBuffer* request,
                                            grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kSendInitMessage, *request, *reply);
  }
  grpc::ServerUnaryReactor* SendServerParams(grpc::CallbackServerContext* /*context*/,
                                             const grpc::ByteBuffer* request,
                                             grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kSendServerParams, *request, *reply);
  }
  grpc::ServerUnaryReactor* SendPlayerParams(grpc::CallbackServerContext* /*context*/,
                                             const grpc::ByteBuffer* request,
                                             grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kSendPlayerParams, *request, *reply);
  }
  grpc::ServerUnaryReactor* SendPlayerType(grpc::CallbackServerContext* /*context*/,
                                           const grpc::ByteBuffer* request,
                                           grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kSendPlayerType, *request, *reply);
  }
  grpc::ServerUnaryReactor* Register(grpc::CallbackServerContext* /*context*/,
                                     const grpc::ByteBuffer* request,
                                     grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kRegister, *request, *reply);
  }
  grpc::ServerUnaryReactor* SendByeCommand(grpc::CallbackServerContext* /*context*/,
                                           const grpc::ByteBuffer* request,
                                           grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kSendByeCommand, *request, *reply);
  }
  grpc::ServerUnaryReactor* GetBestPlannerAction(grpc::CallbackServerContext* /*context*/,
                                                 const grpc::ByteBuffer* request,
                                                 grpc::ByteBuffer* reply) override {
    return serve(proto::Rpc::kGetBestPlannerAction, *request, *reply);
  }

 private:
  grpc::ServerUnaryReactor* serve(proto::Rpc rpc, const grpc::ByteBuffer& bytes,
                                  grpc::ByteBuffer& reply);
  Fate decide_fate(proto::Rpc rpc, const google::protobuf::Message& request);
  void answer(proto::Rpc rpc, const google::protobuf::Message& request, grpc::ByteBuffer& reply);

  GameLogic& logic_;
  Faults faults_;
  std::function<void()> die_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

  std::mutex mutex_;
  bool dead_ = false;
  bool restarting_;        ///< the restart has begun, or is over
  std::set<int> clients_;  ///< that registered since then
};

}  // namespace cls::mock_server
