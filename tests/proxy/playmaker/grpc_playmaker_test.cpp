// Calls to a Playmaker over real gRPC, and their failures.
#include "proxy/playmaker/grpc_playmaker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "proto/team_playmaker.grpc.pb.h"
#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/temporary_folder.h"

namespace cls::proxy {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using proto::Rpc;
using std::chrono::steady_clock;
using tests::GameService;
using tests::loopback;
using tests::PlaymakerServer;

constexpr RpcTimeout kPatience = 10s;

int unused_port() {
  GameService service;
  return PlaymakerServer(service).port();
}

protos::State state_of(int agent) {
  protos::State state;
  state.mutable_register_response()->set_uniform_number(agent);
  return state;
}

protos::RegisterRequest request_of(int agent) {
  protos::RegisterRequest request;
  request.set_team_name("cls");
  request.set_uniform_number(agent);
  return request;
}

Reply decision(Playmaker& playmaker, int agent, RpcTimeout timeout) {
  playmaker.begin(agent, Rpc::kGetPlayerActions, state_of(agent), timeout);
  std::optional<Reply> reply = playmaker.next_reply();
  EXPECT_TRUE(reply.has_value());
  return reply.value_or(Reply{});
}

/// Blocks until the expected number of threads has arrived.
class Barrier {
 public:
  explicit Barrier(int expected) : expected_(expected) {}
  bool wait() {
    std::unique_lock lock(mutex_);
    ++here_;
    changed_.notify_all();
    return changed_.wait_for(lock, 10s, [this] { return here_ >= expected_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int here_ = 0;
  int expected_;
};

TEST(RpcStatus, TakesACancelledRegistrationForAServerThatStops) {
  for (const proto::Rpc rpc : {proto::Rpc::kRegister, proto::Rpc::kRegisterTeam}) {
    EXPECT_EQ(rpc_status(rpc, grpc::CANCELLED, "CANCELLED").outcome, RpcOutcome::kUnavailable);
  }
  const RpcStatus decision = rpc_status(proto::Rpc::kGetPlayerActions, grpc::CANCELLED, "by hand");
  EXPECT_EQ(decision.outcome, RpcOutcome::kError);
}

TEST(GrpcPlaymaker, CallsInProcessAndOverTcpAndUnixSocket) {
  GameService service;
  PlaymakerServer server(service);
  tests::TemporaryFolder folder;
  GrpcTarget local;
  local.unix_path = (folder.path() / "playmaker").string();
  grpc::ServerBuilder builder;
  builder.AddListeningPort("unix:" + local.unix_path, grpc::InsecureServerCredentials());
  GameService local_service;
  builder.RegisterService(&local_service);
  const auto local_server = builder.BuildAndStart();

  std::vector<std::unique_ptr<Playmaker>> playmakers;
  playmakers.push_back(make_grpc_playmaker(server.in_process_channel(), "mock"));
  playmakers.push_back(make_grpc_playmaker(loopback(server.port())));
  playmakers.push_back(make_grpc_playmaker(local));

  for (const auto& playmaker : playmakers) {
    const Reply registered = playmaker->call(4, Rpc::kRegister, request_of(4), kPatience);
    ASSERT_TRUE(registered.status.ok()) << registered.status.message;
    const auto& identity = *registered.as<protos::RegisterResponse>();
    EXPECT_GT(identity.client_id(), 0);
    EXPECT_EQ(identity.team_name(), "cls");
    EXPECT_EQ(identity.uniform_number(), 4);
    const Reply reply = decision(*playmaker, 4, kPatience);
    ASSERT_TRUE(reply.status.ok()) << reply.status.message;
    EXPECT_EQ(reply.agent, 4);
    EXPECT_NE(reply.as<protos::PlayerActions>(), nullptr);
    EXPECT_GT(reply.latency.count(), 0);
  }
}

TEST(GrpcPlaymaker, SendsCoachDecisionsWithGetCoachActions) {
  GameService service;
  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(server.in_process_channel(), "mock");
  playmaker->begin(kCoachNumber, Rpc::kGetCoachActions, state_of(kCoachNumber), kPatience);
  const Reply reply = playmaker->next_reply().value();
  const auto* actions = reply.as<protos::CoachActions>();
  ASSERT_NE(actions, nullptr);
  EXPECT_EQ(reply.as<protos::PlayerActions>(), nullptr);
  EXPECT_EQ(reply.agent, kCoachNumber);
  EXPECT_TRUE(actions->actions(0).has_do_helios_substitute());
  EXPECT_FALSE(playmaker->next_reply().has_value());
}

TEST(GrpcPlaymaker, SendsAllCallsOfCycleConcurrently) {
  GameService service;
  Barrier all_here(11);
  service.on_player = [&](const protos::State& state, protos::PlayerActions& actions) {
    if (!all_here.wait()) return grpc::Status(grpc::StatusCode::ABORTED, "the others did not come");
    actions.add_actions()->mutable_dash()->set_power(
        static_cast<float>(state.register_response().uniform_number()));
    return grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));

  for (int agent = 1; agent <= 11; ++agent) {
    playmaker->begin(agent, Rpc::kGetPlayerActions, state_of(agent), kPatience);
  }

  std::set<int> answered;
  while (const auto reply = playmaker->next_reply()) {
    ASSERT_TRUE(reply->status.ok()) << reply->status.message;
    EXPECT_EQ(reply->as<protos::PlayerActions>()->actions(0).dash().power(),
              static_cast<float>(reply->agent));
    answered.insert(reply->agent);
  }
  EXPECT_EQ(answered.size(), 11U);
}

TEST(GrpcPlaymaker, RegisterWaitsForPlaymakerToStart) {
  const int port = unused_port();
  const auto playmaker = make_grpc_playmaker(loopback(port));
  GameService service;
  std::unique_ptr<PlaymakerServer> server;
  std::thread starter([&] {
    std::this_thread::sleep_for(300ms);
    server = std::make_unique<PlaymakerServer>(service, port);
  });
  const RpcStatus status = playmaker->call(1, Rpc::kRegister, request_of(1), kPatience).status;
  starter.join();
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST(GrpcPlaymaker, ReportsUnreachablePlaymakerWithinTimeout) {
  const int port = unused_port();
  const auto playmaker = make_grpc_playmaker(loopback(port));
  const auto start = steady_clock::now();
  const RpcStatus status = playmaker->call(1, Rpc::kRegister, request_of(1), 300ms).status;
  EXPECT_LT(steady_clock::now() - start, 3s);
  EXPECT_EQ(status.outcome, RpcOutcome::kUnavailable);
  EXPECT_THAT(status.message, HasSubstr("127.0.0.1:" + std::to_string(port)));
  EXPECT_THAT(status.message, HasSubstr("nothing listens"));
  EXPECT_EQ(status.message.find('\n'), std::string::npos);
}

TEST(GrpcPlaymaker, DistinguishesLateFromUnreachablePlaymaker) {
  GameService service;
  std::atomic<bool> leave{false};
  service.on_register = [&](const auto&, auto&) {
    while (!leave) std::this_thread::sleep_for(5ms);
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));
  const RpcStatus status = playmaker->call(1, Rpc::kRegister, request_of(1), 200ms).status;
  leave = true;

  EXPECT_EQ(status.outcome, RpcOutcome::kDeadline);
  EXPECT_THAT(status.message, HasSubstr("no reply to Register"));
}

TEST(GrpcPlaymaker, LimitsTheReplyToRegisterTeamOnceConnected) {
  class SilentService : public cls::playmaker::v1::TeamPlaymaker::Service {
   public:
    grpc::Status RegisterTeam(grpc::ServerContext* context,
                              const cls::playmaker::v1::RegisterTeamRequest*,
                              cls::playmaker::v1::RegisterTeamResponse*) override {
      while (!context->IsCancelled()) std::this_thread::sleep_for(5ms);
      return grpc::Status::CANCELLED;
    }
  };

  SilentService service;
  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()), 200ms);
  const RpcStatus status = playmaker
                               ->call(kTeamNumber, Rpc::kRegisterTeam,
                                      cls::playmaker::v1::RegisterTeamRequest(), kPatience)
                               .status;

  EXPECT_EQ(status.outcome, RpcOutcome::kDeadline);
  EXPECT_EQ(status.message, "127.0.0.1:" + std::to_string(server.port()) +
                                ": no reply to RegisterTeam within 200 ms");
}

TEST(GrpcPlaymaker, FailsAtDeadlineAndCallsAgain) {
  GameService service;
  std::atomic<bool> slow{true};
  service.on_player = [&](const auto&, auto&) {
    while (slow) std::this_thread::sleep_for(5ms);
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));
  const auto start = steady_clock::now();
  const Reply late = decision(*playmaker, 2, 150ms);
  const auto waited = steady_clock::now() - start;

  EXPECT_EQ(late.status.outcome, RpcOutcome::kDeadline);
  EXPECT_EQ(late.message, nullptr);
  EXPECT_GE(waited, 140ms);
  EXPECT_LT(waited, 5s);

  slow = false;
  EXPECT_TRUE(decision(*playmaker, 2, kPatience).status.ok());
}

TEST(GrpcPlaymaker, ReportsStoppedPlaymakerImmediatelyAndReconnects) {
  GameService service;
  auto server = std::make_unique<PlaymakerServer>(service);
  const int port = server->port();
  const auto playmaker = make_grpc_playmaker(loopback(port));
  ASSERT_TRUE(decision(*playmaker, 3, kPatience).status.ok());
  server->stop();
  const auto start = steady_clock::now();
  const Reply dead = decision(*playmaker, 3, kPatience);
  EXPECT_EQ(dead.status.outcome, RpcOutcome::kUnavailable);
  EXPECT_FALSE(dead.status.message.empty());
  EXPECT_LT(steady_clock::now() - start, 5s);

  PlaymakerServer again(service, port);
  Reply reply = decision(*playmaker, 3, kPatience);
  const auto limit = steady_clock::now() + 10s;

  while (!reply.status.ok() && steady_clock::now() < limit) {
    std::this_thread::sleep_for(20ms);
    reply = decision(*playmaker, 3, kPatience);
  }
  EXPECT_TRUE(reply.status.ok()) << reply.status.message;
}

// Sockets of this network stand for those of another one.
TEST(GrpcPlaymaker, ConnectsOverSocketsThatOthersMake) {
  GameService service;
  auto server = std::make_unique<PlaymakerServer>(service);
  GrpcTarget target = loopback(server->port());
  std::atomic<int> made{0};
  std::atomic<bool> refusing{false};
  target.make_socket = [&](int family) {
    if (refusing) return base::UniqueFd();
    base::UniqueFd socket(::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    ++made;
    return socket;
  };

  const auto playmaker = make_grpc_playmaker(target);
  ASSERT_TRUE(decision(*playmaker, 3, kPatience).status.ok());
  EXPECT_EQ(made, 1);
  server->stop();
  refusing = true;
  EXPECT_EQ(decision(*playmaker, 3, kPatience).status.outcome, RpcOutcome::kUnavailable);

  PlaymakerServer again(service, target.port);
  EXPECT_EQ(decision(*playmaker, 3, 300ms).status.outcome, RpcOutcome::kUnavailable);
  EXPECT_EQ(made, 1) << "none of gRPC's own";
  refusing = false;
  const Reply back =
      playmaker->call(3, Rpc::kRegister, request_of(3), kPatience);  // waits for the Playmaker
  EXPECT_TRUE(back.status.ok()) << back.status.message;
  EXPECT_GE(made, 2);
}

TEST(GrpcPlaymaker, ReportsPlaymakerThatStopsDuringCall) {
  GameService service;
  Barrier asked(2);
  service.on_player = [&](const auto&, auto&) {
    asked.wait();
    std::this_thread::sleep_for(100ms);
    return grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));
  playmaker->begin(1, Rpc::kGetPlayerActions, state_of(1), kPatience);
  std::thread killer([&] {
    asked.wait();
    server.stop();
  });
  const Reply reply = playmaker->next_reply().value();
  killer.join();

  EXPECT_EQ(reply.status.outcome, RpcOutcome::kUnavailable) << reply.status.message;
}

/// Replies with bytes that do not parse: a length beyond the end.
class Garbage : public grpc::CallbackGenericService {
  class Reactor : public grpc::ServerGenericBidiReactor {
   public:
    Reactor() {
      grpc::Slice slice("\x0a\x7f garbage");
      bytes_ = grpc::ByteBuffer(&slice, 1);
      StartRead(&request_);
    }
    void OnReadDone(bool ok) override {
      if (!ok) return;
      StartWriteAndFinish(&bytes_, grpc::WriteOptions(), grpc::Status::OK);
    }
    void OnDone() override { delete this; }

   private:
    grpc::ByteBuffer request_;
    grpc::ByteBuffer bytes_;
  };

  grpc::ServerGenericBidiReactor* CreateReactor(grpc::GenericCallbackServerContext*) override {
    return new Reactor;
  }
};

/// Stores the bytes of requests and replies with an empty message.
class Recorder : public grpc::CallbackGenericService {
 public:
  std::vector<std::string> requests() {
    const std::lock_guard lock(mutex_);
    return requests_;
  }

 private:
  class Reactor : public grpc::ServerGenericBidiReactor {
   public:
    explicit Reactor(Recorder& recorder) : recorder_(recorder) { StartRead(&request_); }
    void OnReadDone(bool ok) override {
      if (!ok) return;
      grpc::Slice slice;
      request_.DumpToSingleSlice(&slice);
      {
        const std::lock_guard lock(recorder_.mutex_);
        recorder_.requests_.emplace_back(slice.begin(), slice.end());
      }
      StartWriteAndFinish(&nothing_, grpc::WriteOptions(), grpc::Status::OK);
    }
    void OnDone() override { delete this; }

   private:
    Recorder& recorder_;
    grpc::ByteBuffer request_;
    grpc::Slice empty_;
    grpc::ByteBuffer nothing_{&empty_, 1};
  };

  grpc::ServerGenericBidiReactor* CreateReactor(grpc::GenericCallbackServerContext*) override {
    return new Reactor(*this);
  }

  std::mutex mutex_;
  std::vector<std::string> requests_;
};

TEST(GrpcPlaymaker, SerializesEqualStatesToEqualBytesForAnyMapOrder) {
  protos::State grown;
  protos::State shrunk;
  for (int unum = 1; unum <= 11; ++unum) {
    (*grown.mutable_world_model()->mutable_our_players_dict())[unum].set_id(unum);
  }
  auto& map = *shrunk.mutable_world_model()->mutable_our_players_dict();
  for (int unum = 200; unum >= -200; --unum) map[unum].set_id(unum);
  for (int unum = -200; unum <= 200; ++unum) {
    if (unum < 1 || unum > 11) map.erase(unum);
  }
  Recorder service;
  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));

  for (const protos::State* state : {&grown, &shrunk}) {
    playmaker->begin(1, Rpc::kGetPlayerActions, *state, kPatience);
    EXPECT_TRUE(playmaker->next_reply()->status.ok());
  }

  const std::vector<std::string> requests = service.requests();
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(requests[0], requests[1]);

  protos::State read;
  ASSERT_TRUE(read.ParseFromString(requests[0]));
  EXPECT_EQ(read.world_model().our_players_dict().at(7).id(), 7);
}

TEST(GrpcPlaymaker, ReportsUnparsableReplyAsProtocolError) {
  Garbage service;
  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));
  const Reply reply = decision(*playmaker, 1, kPatience);
  EXPECT_EQ(reply.status.outcome, RpcOutcome::kProtocolError);
  EXPECT_EQ(reply.message, nullptr);
  EXPECT_THAT(reply.status.message, HasSubstr("GetPlayerActions"));
  EXPECT_EQ(playmaker->call(1, Rpc::kRegister, request_of(1), kPatience).status.outcome,
            RpcOutcome::kProtocolError);
}

/// Replies with many bytes that compress well, compressed or not.
class Flood : public protos::Game::Service {
 public:
  explicit Flood(grpc_compression_algorithm algorithm) : algorithm_(algorithm) {}

  grpc::Status GetPlayerActions(grpc::ServerContext* context, const protos::State*,
                                protos::PlayerActions* response) override {
    context->set_compression_algorithm(algorithm_);
    response->add_actions()->mutable_debug_client()->set_message(std::string(64 << 20, 'x'));
    return grpc::Status::OK;
  }

 private:
  grpc_compression_algorithm algorithm_;
};

TEST(GrpcPlaymaker, RejectsHugeRepliesCompressedOrNot) {
  for (const grpc_compression_algorithm algorithm : {GRPC_COMPRESS_NONE, GRPC_COMPRESS_GZIP}) {
    Flood service(algorithm);
    PlaymakerServer server(service);
    const auto playmaker = make_grpc_playmaker(loopback(server.port()));
    const Reply reply = decision(*playmaker, 1, kPatience);
    const bool compressed = algorithm != GRPC_COMPRESS_NONE;
    EXPECT_EQ(reply.status.outcome, compressed ? RpcOutcome::kUnimplemented : RpcOutcome::kError);
    EXPECT_THAT(reply.status.message,
                HasSubstr(compressed ? "'gzip' is disabled" : "larger than max"))
        << reply.status.message;
    EXPECT_EQ(reply.message, nullptr);
  }
}

TEST(GrpcPlaymaker, DistinguishesMissingRpcFromErrorStatus) {
  protos::Game::Service older;
  PlaymakerServer older_server(older);
  EXPECT_EQ(make_grpc_playmaker(loopback(older_server.port()))
                ->call(1, Rpc::kRegister, request_of(1), kPatience)
                .status.outcome,
            RpcOutcome::kUnimplemented);

  GameService failing;
  failing.on_player = [](const auto&, auto&) {
    return grpc::Status(grpc::StatusCode::UNKNOWN, "Exception calling application:\nKeyError: 7");
  };
  PlaymakerServer failing_server(failing);
  const Reply reply = decision(*make_grpc_playmaker(loopback(failing_server.port())), 1, kPatience);
  EXPECT_EQ(reply.status.outcome, RpcOutcome::kError);
  EXPECT_EQ(reply.status.code, 2);
  EXPECT_EQ(reply.status.message, "GetPlayerActions: Exception calling application: KeyError: 7");
}

TEST(GrpcPlaymaker, CancelsCallsFromOtherThread) {
  GameService service;
  std::atomic<bool> leave{false};
  service.on_player = [&](const auto&, auto&) {
    while (!leave) std::this_thread::sleep_for(5ms);
    return grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(loopback(server.port()));
  playmaker->begin(5, Rpc::kGetPlayerActions, state_of(5), kNoTimeout);
  std::thread canceller([&] {
    std::this_thread::sleep_for(100ms);
    playmaker->cancel();
  });
  const Reply reply = playmaker->next_reply().value();
  canceller.join();
  leave = true;
  EXPECT_EQ(reply.status.outcome, RpcOutcome::kCancelled);

  const Reply later = decision(*playmaker, 6, kPatience);
  EXPECT_EQ(later.agent, 6);
  EXPECT_EQ(later.status.outcome, RpcOutcome::kCancelled);
  protos::RegisterResponse identity;
  identity.set_uniform_number(5);
  EXPECT_TRUE(playmaker->call(5, Rpc::kSendByeCommand, identity, kPatience).status.ok())
      << "SendByeCommand is sent after cancel()";
}

TEST(GrpcPlaymaker, CanBeDestroyedWithCallsInFlight) {
  GameService service;
  std::atomic<bool> leave{false};
  service.on_player = [&](const auto&, auto&) {
    while (!leave) std::this_thread::sleep_for(5ms);
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  auto playmaker = make_grpc_playmaker(loopback(server.port()));

  for (int agent = 1; agent <= 11; ++agent) {
    playmaker->begin(agent, Rpc::kGetPlayerActions, state_of(agent), kNoTimeout);
  }

  playmaker.reset();
  leave = true;
  SUCCEED();
}

TEST(GrpcTarget, ComputesPortPerAgent) {
  GrpcTarget target = loopback(50051);
  EXPECT_EQ(address(target, 7), "127.0.0.1:50051");
  target.port_step = true;
  EXPECT_EQ(address(target, 1), "127.0.0.1:50052");
  EXPECT_EQ(address(target, 11), "127.0.0.1:50062");
  EXPECT_EQ(address(target, kCoachNumber), "127.0.0.1:50064");
  EXPECT_EQ(address(target, kTrainerNumber), "127.0.0.1:50064");
  target.unix_path = "/run/playmaker";
  EXPECT_EQ(address(target, 3), "unix:/run/playmaker");
}

TEST(GrpcPlaymaker, UsesPortPerAgentWithPortStep) {
  GameService first;
  PlaymakerServer first_server(first);
  GrpcTarget target = loopback(first_server.port() - 3);
  target.port_step = true;
  const auto playmaker = make_grpc_playmaker(target);
  EXPECT_TRUE(decision(*playmaker, 3, kPatience).status.ok());
  EXPECT_EQ(first.calls(), std::vector<std::string>{"GetPlayerActions 3"});
}

}  // namespace
}  // namespace cls::proxy
