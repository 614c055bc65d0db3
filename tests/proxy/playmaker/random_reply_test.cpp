// Playmakers that reply at random and restart: nothing crashes, hangs or grows, and every effect is
// counted.
#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>

#include "base/io/byte_sink.h"
#include "base/io/byte_source.h"
#include "gamelog/rcg/rcg_reader.h"
#include "mock-server/script/named_behaviors.h"
#include "mock-server/server.h"
#include "mock-server/service/raw_service.h"
#include "proto/grpc_settings.h"
#include "proto/team_playmaker.pb.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/batch_playmaker.h"
#include "proxy/playmaker/direct_playmaker.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "simulator/server/lockstep_server.h"
#include "tests/proxy/playmaker/random_message.h"
#include "tests/support/temporary_folder.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using mock_server::Response;
using proto::Rpc;
using testing::HasSubstr;
using tests::RandomMessages;
namespace wire = cls::playmaker::v1;

constexpr int kCycles = 40;
// The cycle in which a Playmaker over a socket has restarted.
constexpr int kRestart = 23;
// The timeout of a Playmaker over a socket that forgets a call; short, because many are forgotten.
constexpr RpcTimeout kDeadline{250};

/// Replies at random, but in the handshake: it succeeds, so that there is a match.
class RandomPlaymaker {
 public:
  explicit RandomPlaymaker(std::uint64_t seed)
      : random_(seed),
        service_(0, proto::kAgentRpcs, 1 << 15, responder()),
        team_service_(proto::kAgentRpcs, proto::kRpcs, 1 << 18, responder()) {}
  ~RandomPlaymaker() {
    if (server_ != nullptr) server_->Shutdown(std::chrono::system_clock::now());
  }
  RandomPlaymaker(const RandomPlaymaker&) = delete;
  RandomPlaymaker& operator=(const RandomPlaymaker&) = delete;

  void serve(const std::string& address) {
    proto::apply_grpc_settings();
    grpc::ServerBuilder builder;
    builder.RegisterService(&service_);
    builder.RegisterService(&team_service_);
    builder.SetMaxReceiveMessageSize(-1);
    if (!address.empty()) {
      builder.AddListeningPort(address, grpc::InsecureServerCredentials(), &port_);
    }
    server_ = builder.BuildAndStart();
    ASSERT_NE(server_, nullptr);
  }
  int port() const { return port_; }
  std::shared_ptr<grpc::Channel> channel() {
    grpc::ChannelArguments arguments;
    proto::limit_replies(arguments);
    return server_->InProcessChannel(arguments);
  }
  std::int64_t replies() const { return replies_; }

 private:
  mock_server::RawService::Respond responder() {
    return [this](Rpc rpc, const Message& request, Message& reply, mock_server::Workspace&) {
      const std::lock_guard lock(mutex_);
      ++replies_;
      return respond(rpc, request, reply);
    };
  }

  Response respond(Rpc rpc, const Message& request, Message& reply) {
    Response response;
    if (rpc == Rpc::kRegister) {
      introduce(static_cast<const protos::RegisterRequest&>(request),
                static_cast<protos::RegisterResponse&>(reply));
      return response;
    }

    if (rpc == Rpc::kRegisterTeam) {
      introduce_team(static_cast<const wire::RegisterTeamRequest&>(request),
                     static_cast<wire::RegisterTeamResponse&>(reply));
      return response;
    }
    const bool decides = is_decision(rpc) || rpc == Rpc::kGetBestPlannerAction ||
                         rpc == Rpc::kGetTeamActions || rpc == Rpc::kGetBestPlannerActions;

    if (!decides) {
      response.bytes = later_field();
      return response;
    }

    if (random_.one_in(50)) {
      response.status = {static_cast<grpc::StatusCode>(random_.below(17)), "on \x1b[2J purpose"};
      return response;
    }
    if (random_.one_in(500)) response.delay_ms = static_cast<int>(random_.below(30));
    if (random_.one_in(2000)) response.hangs = true;

    if (rpc == Rpc::kGetTeamActions && !random_.one_in(10)) {
      answer_each(static_cast<const wire::GetTeamActionsRequest&>(request),
                  static_cast<wire::GetTeamActionsResponse&>(reply));
      return response;
    }
    response.bytes = random_.reply(reply);
    return response;
  }

  // A field of a message of a later interface.
  static std::string later_field() { return std::string("\x82\x80\x01\x05later", 9); }

  static void introduce(const protos::RegisterRequest& request,
                        protos::RegisterResponse& identity) {
    identity.set_client_id(request.uniform_number());
    identity.set_uniform_number(request.uniform_number());
    identity.set_team_name(request.team_name());
    identity.set_agent_type(request.agent_type());
  }

  static void introduce_team(const wire::RegisterTeamRequest& request,
                             wire::RegisterTeamResponse& response) {
    response.set_version(proto::kTeamPlaymakerVersion);
    for (const wire::AgentMessage& agent : request.agents()) {
      protos::RegisterRequest introduced;
      introduced.ParseFromString(agent.message());
      protos::RegisterResponse identity;
      introduce(introduced, identity);
      wire::AgentReply& reply = *response.add_agents();
      reply.set_agent(agent.agent());
      reply.set_message(identity.SerializeAsString());
    }
  }

  // Agents may miss their reply, or get two; agents that do not exist may get one.
  void answer_each(const wire::GetTeamActionsRequest& request,
                   wire::GetTeamActionsResponse& response) {
    for (const wire::AgentMessage& agent : request.agents()) {
      replies_ += agent.agent() > 1 ? 1 : 0;
      if (random_.one_in(30)) continue;
      wire::AgentReply& reply = *response.add_agents();
      reply.set_agent(random_.one_in(30) ? static_cast<int>(random_.below(40)) - 10
                                         : agent.agent());
      reply.set_message(random_.reply(proto::reply_prototype(proto::decision_of(agent.agent()))));
      if (!random_.one_in(50)) continue;
      reply.set_code(static_cast<int>(random_.below(40)) - 10);
      reply.set_error("on purpose");
    }

    if (random_.one_in(10)) random_.fill(*response.mutable_actions());
  }

  std::mutex mutex_;
  RandomMessages random_;
  std::atomic<std::int64_t> replies_{0};
  mock_server::RawService service_;
  mock_server::RawService team_service_;
  std::unique_ptr<grpc::Server> server_;
  int port_ = 0;
};

enum class Transport { kInProcess, kTcp, kUnix };

struct Form {
  const char* name;
  Transport transport;
  BatchMode batch;
};

void PrintTo(const Form& form, std::ostream* out) { *out << form.name; }

class RandomReplies : public testing::TestWithParam<Form> {
 protected:
  /// Plays some cycles; returns the number of replies.
  std::int64_t play(std::uint64_t seed) {
    auto random = std::make_unique<RandomPlaymaker>(seed);
    const std::unique_ptr<Playmaker> playmaker =
        make_batch_playmaker(connect(*random), GetParam().batch);
    const auto mock =
        std::move(*mock_server::Server::start(std::move(*mock_server::make_behavior("simple"))));
    const auto opponent =
        make_direct_playmaker([&mock](Rpc rpc, const Message& request, Message& reply) {
          mock->handle(rpc, request, reply);
        });
    base::StringSink game_log;
    base::StringSink text_log;
    const auto server = make_server(seed);
    server->record(&game_log, &text_log);
    Team left(options("left"), *playmaker);
    Team right(options("right"), *opponent);
    for (Team* team : {&left, &right}) join(*server, *team);

    std::int64_t earlier_replies = 0;
    for (int i = 0; i < kCycles && !HasFatalFailure(); ++i) {
      if (i == kRestart && GetParam().transport != Transport::kInProcess) {
        earlier_replies = random->replies();
        random.reset();
        random = std::make_unique<RandomPlaymaker>(~seed);
        random->serve(address_);
      }
      server->run_cycle();
      left.begin_cycle();
      right.begin_cycle();
      left.finish_cycle();
      right.finish_cycle();
    }

    check(left, *server);
    left.leave();
    right.leave();
    server->finish();

    check_log(game_log.bytes());
    return earlier_replies + random->replies();
  }

 private:
  static TeamOptions options(const char* name) {
    TeamOptions options;
    options.name = name;
    options.decision_timeout = kDeadline;
    options.reconnect_within = RpcTimeout{50};
    return options;
  }

  std::unique_ptr<Playmaker> connect(RandomPlaymaker& random) {
    GrpcTarget target;
    switch (GetParam().transport) {
      case Transport::kInProcess:
        random.serve("");
        return make_grpc_playmaker(random.channel(), "random");
      case Transport::kTcp:
        random.serve("127.0.0.1:0");
        target.host = "127.0.0.1";
        target.port = random.port();
        address_ = "127.0.0.1:" + std::to_string(target.port);
        break;
      case Transport::kUnix:
        target.unix_path = folder_.path() / ("socket-" + std::to_string(++sockets_));
        address_ = "unix:" + target.unix_path;
        random.serve(address_);
        break;
    }

    return make_grpc_playmaker(target);
  }

  static std::unique_ptr<simulator::LockstepServer> make_server(std::uint64_t seed) {
    simulator::MatchConfig config;
    config.seed = seed;
    config.server.auto_mode = true;
    config.server.kick_off_wait = 2;
    return std::move(*simulator::LockstepServer::create(config));
  }

  static void join(simulator::LockstepServer& server, Team& team) {
    const auto serve = [&server] {
      server.accept_clients();
      return false;
    };
    ASSERT_TRUE(team.connect([&] { return server.connect(); }, serve));
    ASSERT_TRUE(team.connect_coach(
        soccer::CoachRole::kOnlineCoach,
        [&] { return server.connect(simulator::ListeningPort::kOnlineCoaches); }, serve));
    const RpcStatus registered = team.register_agents();
    ASSERT_TRUE(registered.ok()) << registered.message;
  }

  static void check(Team& team, const simulator::LockstepServer& server) {
    for (const auto& player : team.players()) {
      const AgentStatistics& statistics = player->statistics();
      EXPECT_GE(statistics.decisions, kCycles - 1);
      EXPECT_EQ(statistics.actions.lists + statistics.actions.preprocess +
                        statistics.actions.sure_shot + statistics.actions.intention +
                        statistics.actions.force_kick + statistics.actions.heard_pass +
                        statistics.missed >=
                    statistics.decisions,
                true)
          << "a decision without a counted effect";
      EXPECT_EQ(player->server().errors.unreadable, 0) << player->server().errors.first_unreadable;
    }

    const simulator::World& world = server.world();
    EXPECT_TRUE(std::isfinite(world.ball.position.x) && std::isfinite(world.ball.velocity.y));
  }

  static void check_log(const std::string& log) {
    base::MemorySource source(log);
    const gamelog::MatchRecord record = gamelog::read_rcg(source);
    EXPECT_GE(record.frames(), static_cast<std::size_t>(kCycles) - 5);
    for (const gamelog::ParseError& error : record.errors.first) {
      EXPECT_THAT(error.message, HasSubstr("no end of the match"))
          << gamelog::format_error("log", error);
    }
  }

  tests::TemporaryFolder folder_;
  int sockets_ = 0;
  std::string address_;  ///< of the Playmaker, over a socket
};

std::int64_t wanted_replies() {
  const char* text = std::getenv("CLS_RANDOM_REPLIES");
  return text == nullptr ? 1 : std::atoll(text);
}

std::int64_t peak_memory_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

// CLS_RANDOM_REPLIES=1000000 plays until that many replies.
TEST_P(RandomReplies, DoNoHarm) {
  google::protobuf::LogSilencer no_complaints;
  std::int64_t replies = 0;
  std::uint64_t seed = 0;
  while (replies < wanted_replies() && !HasFailure()) {
    SCOPED_TRACE("seed " + std::to_string(++seed));
    replies += play(seed);
  }
  const std::int64_t memory = peak_memory_mb();
  std::printf("%lld replies, %llu matches, peak memory %lld MB\n", static_cast<long long>(replies),
              static_cast<unsigned long long>(seed), static_cast<long long>(memory));
  EXPECT_LT(memory, 2000);
}

INSTANTIATE_TEST_SUITE_P(
    , RandomReplies,
    testing::Values(Form{"Unary", Transport::kInProcess, BatchMode::kOff},
                    Form{"Batch", Transport::kInProcess, BatchMode::kRequired},
                    Form{"UnaryOverTcp", Transport::kTcp, BatchMode::kOff},
                    Form{"BatchOverTcp", Transport::kTcp, BatchMode::kRequired},
                    Form{"UnaryOverUnixSocket", Transport::kUnix, BatchMode::kOff},
                    Form{"BatchOverUnixSocket", Transport::kUnix, BatchMode::kRequired}),
    [](const auto& form) { return form.param.name; });

}  // namespace
}  // namespace cls::proxy
