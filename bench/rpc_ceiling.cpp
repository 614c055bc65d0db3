// The smallest Playmaker, and teams that do nothing but ask it.
#include "bench/rpc_ceiling.h"

#include <grpcpp/grpcpp.h>
#include <sys/resource.h>

#include <array>
#include <barrier>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "mock-server/script/message_pool.h"
#include "proto/playmaker.grpc.pb.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"
#include "tests/support/temporary_folder.h"

namespace cls::bench {
namespace {

using Clock = std::chrono::steady_clock;

class SmallestService : public protos::Game::CallbackService {
 public:
  SmallestService() { SetMessageAllocatorFor_GetPlayerActions(&messages_); }

 private:
  grpc::ServerUnaryReactor* GetPlayerActions(grpc::CallbackServerContext* context,
                                             const protos::State*,
                                             protos::PlayerActions* actions) override {
    protos::Body_GoToPoint& go = *actions->add_actions()->mutable_body_go_to_point();
    go.mutable_target_point()->set_x(10.0F);
    go.set_max_dash_power(100.0F);
    actions->add_actions()->mutable_neck_turn_to_ball_or_scan();
    grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
    reactor->Finish(grpc::Status::OK);
    return reactor;
  }

  mock_server::MessagePool<protos::State, protos::PlayerActions> messages_;
};

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Match {
  tests::TemporaryFolder folder;
  SmallestService service;
  std::unique_ptr<grpc::Server> server;
  std::array<std::unique_ptr<proxy::Playmaker>, 2> teams;
};

void start(Match& match, Transport transport) {
  proxy::GrpcTarget target;
  target.host = "127.0.0.1";
  grpc::ServerBuilder builder;
  builder.RegisterService(&match.service);
  if (transport == Transport::kTcp) {
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &target.port);
  } else if (transport == Transport::kUnixSocket) {
    target.unix_path = (match.folder.path() / "socket").string();
    builder.AddListeningPort("unix:" + target.unix_path, grpc::InsecureServerCredentials());
  }
  match.server = builder.BuildAndStart();
  if (match.server == nullptr) throw std::runtime_error("no server to measure");
  for (auto& team : match.teams) {
    team = transport == Transport::kInProcess
               ? proxy::make_grpc_playmaker(
                     match.server->InProcessChannel(grpc::ChannelArguments()), "in process")
               : proxy::make_grpc_playmaker(target);
  }
}

void ask_all(proxy::Playmaker& team, const protos::State& state) {
  for (int unum = 1; unum <= 11; ++unum) {
    team.begin_player_actions(unum, state, std::chrono::seconds(10));
  }
}

void take_all(proxy::Playmaker& team) {
  while (const auto reply = team.next_reply()) {
    if (!reply->status.ok()) throw std::runtime_error(reply->status.message);
  }
}

int play_alone(Match& match, const protos::State& state, Clock::time_point end) {
  int cycles = 0;
  for (; Clock::now() < end; ++cycles) {
    for (auto& team : match.teams) ask_all(*team, state);
    for (auto& team : match.teams) take_all(*team);
  }
  return cycles;
}

int play_in_two_threads(Match& match, const protos::State& state, Clock::time_point end) {
  int cycles = 0;
  bool over = false;
  std::barrier meeting(2, [&]() noexcept {
    ++cycles;
    over = Clock::now() >= end;
  });
  const auto play = [&](proxy::Playmaker& team) {
    while (!over) {
      ask_all(team, state);
      take_all(team);
      meeting.arrive_and_wait();
    }
  };
  std::thread other([&] { play(*match.teams[1]); });
  play(*match.teams[0]);
  other.join();
  return cycles;
}

}  // namespace

RpcCeiling measure_rpc_ceiling(Transport transport, int threads, const protos::State& state,
                               double seconds) {
  Match match;
  start(match, transport);
  for (auto& team : match.teams) {  // connected before the clock runs
    ask_all(*team, state);
    take_all(*team);
  }
  const auto begin = Clock::now();
  const double cpu_begin = cpu_seconds();
  const auto end =
      begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const int cycles =
      threads == 2 ? play_in_two_threads(match, state, end) : play_alone(match, state, end);
  const std::chrono::duration<double> took = Clock::now() - begin;
  return {cycles / took.count(), (cpu_seconds() - cpu_begin) * 1e6 / cycles};
}

protos::State usual_state() {
  constexpr long kUsualSize = 9700;
  std::string best;
  const std::string stream = tests::read_file(tests::fixture("grpc/GetPlayerActions.req.pb.gz"));
  const auto off = [](const std::string& message) {
    return std::labs(static_cast<long>(message.size()) - kUsualSize);
  };
  for (const std::string& message : tests::split_messages(stream)) {
    if (best.empty() || off(message) < off(best)) best = message;
  }
  protos::State state;
  if (!state.ParseFromString(best)) throw std::runtime_error("a broken fixture");
  return state;
}

}  // namespace cls::bench
