// Construction and cycles of the match.
#include "tests/support/mock_match.h"

#include <chrono>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <utility>

#include "mock-server/script/named_behaviors.h"
#include "proxy/playmaker/direct_playmaker.h"
#include "proxy/playmaker/grpc_playmaker.h"

namespace cls::tests {

/// Runs the right team's cycles in its own thread.
class MockMatch::Worker {
 public:
  explicit Worker(proxy::Team& team)
      : thread_([this, &team] {
          for (;;) {
            start_.acquire();
            if (over_) return;
            team.run_cycle();
            done_.release();
          }
        }) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    over_ = true;
    start_.release();
    thread_.join();
  }

  void start() { start_.release(); }
  void finish() { done_.acquire(); }

 private:
  std::binary_semaphore start_{0};
  std::binary_semaphore done_{0};
  bool over_ = false;
  std::thread thread_;
};

namespace {

template <typename T>
T taken(base::Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

std::unique_ptr<proxy::Playmaker> playmaker_of(mock_server::Server& mock, MockCalls calls) {
  if (calls == MockCalls::kGrpcInProcess) {
    return proxy::make_grpc_playmaker(mock.in_process_channel(), "mock");
  }
  return proxy::make_direct_playmaker(
      [&mock](proto::Rpc rpc, const google::protobuf::Message& request,
              google::protobuf::Message& reply) { mock.handle(rpc, request, reply); });
}

}  // namespace

MockMatch::MockMatch(std::uint64_t seed, int threads, MockCalls calls) {
  simulator::MatchConfig config;
  config.seed = seed;
  config.server.auto_mode = true;
  config.server.kick_off_wait = 20;
  config.server.nr_extra_halfs = 0;
  config.server.penalty_shoot_outs = false;
  server_ = taken(simulator::LockstepServer::create(config));
  server_->record(&game_log_, &text_log_);

  for (std::size_t side = 0; side < teams_.size(); ++side) {
    mocks_[side] = taken(mock_server::Server::start(taken(mock_server::make_behavior("simple"))));
    playmakers_[side] = playmaker_of(*mocks_[side], calls);
    proxy::TeamOptions options;
    options.name = side == 0 ? "left" : "right";
    teams_[side] = std::make_unique<proxy::Team>(options, *playmakers_[side]);
    const auto connected = teams_[side]->connect([&] { return server_->connect(); },
                                                 [&] {
                                                   server_->accept_clients();
                                                   return false;
                                                 });
    if (!connected) throw std::runtime_error(connected.error().message);
    const proxy::RpcStatus introduced = teams_[side]->register_agents();
    if (!introduced.ok()) throw std::runtime_error(introduced.message);
  }

  if (threads == 2) worker_ = std::make_unique<Worker>(*teams_[1]);
}

MockMatch::~MockMatch() = default;

void MockMatch::run_teams() {
  if (worker_ != nullptr) {
    worker_->start();
    teams_[0]->run_cycle();
    worker_->finish();
    return;
  }
  for (const auto& team : teams_) team->begin_cycle();
  for (const auto& team : teams_) team->finish_cycle();
}

bool MockMatch::play(int steps) {
  for (int i = 0; i < steps; ++i) {
    if (server_->finished()) return false;
    const auto begin = std::chrono::steady_clock::now();
    server_->run_cycle();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    simulator_seconds_ += took.count();
    run_teams();
  }
  return true;
}

}  // namespace cls::tests
