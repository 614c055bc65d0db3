// A minimal Playmaker, and teams that only call it.
#include "bench/rpc_ceiling.h"

#include <google/protobuf/arena.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/support/message_allocator.h>

#include <array>
#include <barrier>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "proto/grpc_settings.h"
#include "proto/playmaker.grpc.pb.h"
#include "proto/team_playmaker.grpc.pb.h"
#include "proxy/playmaker/batch_playmaker.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"
#include "tests/support/temporary_folder.h"

namespace cls::bench {
namespace {

namespace wire = cls::playmaker::v1;

void decide(protos::PlayerActions& actions) {
  protos::Body_GoToPoint& go = *actions.add_actions()->mutable_body_go_to_point();
  go.mutable_target_point()->set_x(10.0F);
  go.set_max_dash_power(100.0F);
  actions.add_actions()->mutable_neck_turn_to_ball_or_scan();
}

/// Request and response messages in reused memory: no allocation for each of their parts.
/// For a callback service: SetMessageAllocatorFor_METHOD(). Must outlive the server. Retains as
/// many pairs of messages as were in use at the same time.
template <typename Request, typename Response>
class MessagePool : public grpc::MessageAllocator<Request, Response> {
 public:
  MessagePool() = default;
  MessagePool(const MessagePool&) = delete;
  MessagePool& operator=(const MessagePool&) = delete;
  ~MessagePool() override {
    // Synchronizes with the last Release() on a thread of gRPC.
    const std::lock_guard lock(mutex_);
    idle_.clear();
  }

  grpc::MessageHolder<Request, Response>* AllocateMessages() override {
    std::unique_ptr<Pair> pair;
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        pair = std::move(idle_.back());
        idle_.pop_back();
      }
    }
    if (pair == nullptr) pair = std::make_unique<Pair>(*this);
    pair->prepare();
    return pair.release();  // Release() returns it to the pool
  }

 private:
  class Pair : public grpc::MessageHolder<Request, Response> {
   public:
    explicit Pair(MessagePool& pool)
        : pool_(pool), block_(kBlockSize), arena_(block_.data(), block_.size()) {}

    void prepare() {
      arena_.Reset();
      this->set_request(google::protobuf::Arena::CreateMessage<Request>(&arena_));
      this->set_response(google::protobuf::Arena::CreateMessage<Response>(&arena_));
    }

    void Release() override {
      const std::lock_guard lock(pool_.mutex_);
      pool_.idle_.emplace_back(this);
    }

   private:
    // Fits a State of a busy cycle; for a larger one the arena grows during that call.
    static constexpr std::size_t kBlockSize = 96 * 1024;

    MessagePool& pool_;
    std::vector<char> block_;
    google::protobuf::Arena arena_;
  };

  std::mutex mutex_;
  std::vector<std::unique_ptr<Pair>> idle_;
};

grpc::ServerUnaryReactor* finish(grpc::CallbackServerContext* context) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(grpc::Status::OK);
  return reactor;
}

class MinimalService : public protos::Game::CallbackService {
 public:
  MinimalService() { SetMessageAllocatorFor_GetPlayerActions(&messages_); }

 private:
  grpc::ServerUnaryReactor* GetPlayerActions(grpc::CallbackServerContext* context,
                                             const protos::State*,
                                             protos::PlayerActions* actions) override {
    decide(*actions);
    return finish(context);
  }

  MessagePool<protos::State, protos::PlayerActions> messages_;
};

/// Parses each State, as a Playmaker does.
class MinimalTeamService : public wire::TeamPlaymaker::CallbackService {
 public:
  explicit MinimalTeamService(wire::Encoding encoding) : encoding_(encoding) {}

 private:
  grpc::ServerUnaryReactor* RegisterTeam(grpc::CallbackServerContext* context,
                                         const wire::RegisterTeamRequest* request,
                                         wire::RegisterTeamResponse* response) override {
    response->set_version(proto::kTeamPlaymakerVersion);
    response->set_encoding(encoding_);
    for (const auto& agent : request->agents()) {
      response->add_agents()->set_agent(agent.agent());
    }
    return finish(context);
  }

  grpc::ServerUnaryReactor* GetTeamActions(grpc::CallbackServerContext* context,
                                           const wire::GetTeamActionsRequest* request,
                                           wire::GetTeamActionsResponse* response) override {
    static thread_local std::vector<char> block(2 << 20);
    google::protobuf::Arena arena(block.data(), block.size());

    for (const auto& agent : request->agents()) {
      auto& state = *google::protobuf::Arena::CreateMessage<protos::State>(&arena);
      if (!state.ParseFromString(agent.message())) throw std::runtime_error("unreadable State");
      protos::PlayerActions actions;
      decide(actions);
      wire::AgentReply& reply = *response->add_agents();
      reply.set_agent(agent.agent());
      actions.SerializeToString(reply.mutable_message());
    }

    return finish(context);
  }

  wire::Encoding encoding_;
};

struct Match {
  explicit Match(wire::Encoding encoding) : team_service(encoding) {}

  tests::TemporaryFolder folder;
  MinimalService service;
  MinimalTeamService team_service;
  std::unique_ptr<grpc::Server> server;
  std::array<std::unique_ptr<proxy::Playmaker>, 2> teams;
};

void register_team(proxy::Playmaker& team) {
  proxy::TeamRegistration registration;
  registration.parameters = std::make_shared<player::MatchParameters>();
  for (int unum = 1; unum <= 11; ++unum) registration.agents.push_back({unum, {}});
  team.announce_team(registration);
  for (int unum = 1; unum <= 11; ++unum) {
    const auto reply = team.call(unum, proto::Rpc::kRegister, registration.agents.front().second,
                                 std::chrono::seconds(10));
    if (!reply.status.ok()) throw std::runtime_error(reply.status.message);
  }
}

void start(Match& match, Transport transport, Asking asking) {
  proxy::GrpcTarget target;
  target.host = "127.0.0.1";
  grpc::ServerBuilder builder;
  builder.RegisterService(&match.service);
  builder.RegisterService(&match.team_service);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, proto::kTeamCallWindow);

  if (transport == Transport::kTcp) {
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &target.port);
  } else if (transport == Transport::kUnixSocket) {
    target.unix_path = (match.folder.path() / "socket").string();
    builder.AddListeningPort("unix:" + target.unix_path, grpc::InsecureServerCredentials());
  }

  match.server = builder.BuildAndStart();
  if (match.server == nullptr) throw std::runtime_error("cannot start the gRPC server to measure");

  for (auto& team : match.teams) {
    team = transport == Transport::kInProcess
               ? proxy::make_grpc_playmaker(
                     match.server->InProcessChannel(grpc::ChannelArguments()), "in process")
               : proxy::make_grpc_playmaker(target);
    if (asking == Asking::kEachAgent) continue;
    team = proxy::make_batch_playmaker(std::move(team), proxy::BatchMode::kRequired);
    register_team(*team);
  }
}

void begin_all(proxy::Playmaker& team, const protos::State& state) {
  for (int unum = 1; unum <= 11; ++unum) {
    team.begin(unum, proto::Rpc::kGetPlayerActions, state, std::chrono::seconds(10));
  }
  team.send();
}

void receive_all(proxy::Playmaker& team) {
  while (const auto reply = team.next_reply()) {
    if (!reply->status.ok()) throw std::runtime_error(reply->status.message);
  }
}

int play_in_one_thread(Match& match, const protos::State& state, Clock::time_point end) {
  int cycles = 0;
  for (; Clock::now() < end; ++cycles) {
    for (auto& team : match.teams) begin_all(*team, state);
    for (auto& team : match.teams) receive_all(*team);
  }
  return cycles;
}

int play_in_two_threads(Match& match, const protos::State& state, Clock::time_point end) {
  int cycles = 0;
  bool over = false;
  std::barrier end_of_cycle(2, [&]() noexcept {
    ++cycles;
    over = Clock::now() >= end;
  });

  const auto play = [&](proxy::Playmaker& team) {
    while (!over) {
      begin_all(team, state);
      receive_all(team);
      end_of_cycle.arrive_and_wait();
    }
  };

  std::thread other([&] { play(*match.teams[1]); });
  play(*match.teams[0]);
  other.join();
  return cycles;
}

}  // namespace

RpcCeiling measure_rpc_ceiling(Transport transport, int threads, Asking asking,
                               const protos::State& state, double seconds) {
  Match match(asking == Asking::kTeamLean ? wire::LEAN_STATES : wire::STATES);
  start(match, transport, asking);
  for (auto& team : match.teams) {  // connect before the measurement
    begin_all(*team, state);
    receive_all(*team);
  }

  const auto begin = Clock::now();
  const double cpu_begin = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  const auto end =
      begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const int cycles =
      threads == 2 ? play_in_two_threads(match, state, end) : play_in_one_thread(match, state, end);
  const double took = seconds_since(begin);
  const double cpu = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_begin;
  return {cycles / took, cpu * 1e6 / cycles};
}

protos::State typical_state() {
  constexpr long kTypicalSize = 9700;
  std::string best;
  const std::string stream = tests::read_file(tests::fixture("grpc/GetPlayerActions.req.pb.gz"));
  const auto distance = [](const std::string& message) {
    return std::labs(static_cast<long>(message.size()) - kTypicalSize);
  };

  for (const std::string& message : tests::split_messages(stream)) {
    if (best.empty() || distance(message) < distance(best)) best = message;
  }

  protos::State state;
  if (!state.ParseFromString(best)) throw std::runtime_error("corrupt fixture");
  return state;
}

}  // namespace cls::bench
