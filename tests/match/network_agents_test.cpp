// A team of cls on the embedded server over UDP, as a match ends it.
#include "match/sides/network_agents.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "simulator/server/udp_server.h"

namespace cls::match {
namespace {

using namespace std::chrono_literals;

/// A server of a match without end, in a thread of its own.
class EndlessServer {
 public:
  EndlessServer() {
    simulator::UdpConfig config;
    config.port = 0;
    config.match.server.synch_mode = true;
    udp_ = std::move(*simulator::UdpServer::open(config));
    thread_ = std::thread([this] { udp_->run(stop_); });
  }
  ~EndlessServer() {
    stop_ = true;
    thread_.join();
  }

  int port() const { return udp_->port(); }

 private:
  std::unique_ptr<simulator::UdpServer> udp_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

std::unique_ptr<NetworkAgents> team_of_mocks(const MatchOptions& options,
                                             NetworkSettings settings) {
  SideSetup setup;
  setup.name = "Lions";
  setup.batch = proxy::BatchMode::kAuto;
  auto connection = connect_playmaker(options.left, setup);
  AgentParts parts{{soccer::Side::kLeft, "Lions", "mock:hold"},
                   *std::move(connection),
                   team_options(setup, options.left, options),
                   options};
  return *NetworkAgents::create(std::move(parts), std::move(settings));
}

// The result of a side is read when it is terminated: on a starved host its thread may still have
// much to do then.
TEST(NetworkAgents, RestWhenTheyAreTerminated) {
  const EndlessServer server;
  std::atomic<bool> began = false;
  std::atomic<bool> ended = false;
  NetworkSettings settings;
  settings.server_port = server.port();
  settings.on_ready = [&](const proxy::Team&) {
    began = true;
    std::this_thread::sleep_for(3s);
    ended = true;
  };
  MatchOptions options;
  options.left = *parse_endpoint("mock:hold");

  const auto agents = team_of_mocks(options, std::move(settings));
  EXPECT_FALSE(agents->join({}, {}));
  for (int i = 0; i < 1000 && !began; ++i) std::this_thread::sleep_for(20ms);
  ASSERT_TRUE(began);
  agents->leave();
  agents->terminate();
  EXPECT_TRUE(ended);
  EXPECT_GT(agents->result().cpu_seconds, 0.0);
}

}  // namespace
}  // namespace cls::match
