// Messages as values: agents that read values know and do the same as agents that read text.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "proto/sorted_maps.h"
#include "proxy/agent/player_agent.h"
#include "simulator/server/lockstep_server.h"
#include "soccer/messages/values.h"
#include "tests/support/text_channel.h"

namespace cls::proxy {
namespace {

/// Counts messages that are values.
class CountingChannel : public soccer::Channel {
 public:
  CountingChannel(std::unique_ptr<soccer::Channel> inner, int& count)
      : inner_(std::move(inner)), count_(count) {}

  bool send(std::string_view message) override { return inner_->send(message); }
  bool receive(std::string& message) override {
    if (!inner_->receive(message)) return false;
    count_ += soccer::read_values(message, see_) || soccer::read_values(message, sense_);
    return true;
  }
  bool ask_for_values() override { return inner_->ask_for_values(); }

 private:
  std::unique_ptr<soccer::Channel> inner_;
  int& count_;
  soccer::See see_;
  soccer::SenseBody sense_;
};

/// Players on a server in lockstep, the goalie of each team first and then in turn.
class Players {
 public:
  Players(int version, bool text, int count) {
    simulator::MatchConfig config;
    config.seed = 5;
    config.server.auto_mode = true;
    config.server.kick_off_wait = 5;
    server_ = std::move(simulator::LockstepServer::create(config)).value();
    for (int i = 0; i < count; ++i) {
      AgentOptions options;
      options.team_name = i % 2 == 0 ? "left" : "right";
      options.protocol = version;
      options.goalie = i < 2;
      std::unique_ptr<soccer::Channel> channel = server_->connect();
      if (text) channel = std::make_unique<tests::TextChannel>(std::move(channel));
      channel = std::make_unique<CountingChannel>(std::move(channel), values_);
      agents_.push_back(std::make_unique<PlayerAgent>(std::move(channel), options));
      const auto connected = connect_agent(*agents_.back(), [&] {
        server_->accept_clients();
        return false;
      });
      EXPECT_TRUE(connected) << connected.error().message;
    }
  }

  /// States of the decisions of a cycle and the commands that follow.
  std::vector<std::string> play_cycle() {
    server_->run_cycle();
    std::vector<std::string> done;
    for (const auto& agent : agents_) {
      agent->perceive();
      if (!agent->decision_due()) continue;
      proto::write_with_sorted_maps(agent->state(), done.emplace_back());
      agent->act(actions_of(*agent));
      done.push_back(agent->sent_commands());
    }
    return done;
  }

  /// Number of messages that were values.
  int values() const { return values_; }
  int unreadable() const {
    int sum = 0;
    for (const auto& agent : agents_) sum += static_cast<int>(agent->server().errors.unreadable);
    return sum;
  }

 private:
  // Runs, kicks, tackles, points and looks around.
  static protos::PlayerActions actions_of(const PlayerAgent& agent) {
    protos::PlayerActions actions;
    protos::Body_SmartKick& kick = *actions.add_actions()->mutable_body_smart_kick();
    kick.mutable_target_point()->set_x(50.0F);
    kick.set_first_speed(2.5F);
    kick.set_first_speed_threshold(1.0F);
    kick.set_max_steps(2);
    if (agent.unum() == 3) actions.add_actions()->mutable_body_tackle_to_point();
    actions.add_actions()->mutable_body_intercept();
    actions.add_actions()->mutable_neck_turn_to_ball_or_scan();
    if (agent.unum() == 2) actions.add_actions()->mutable_point_to()->set_x(10.0F);
    return actions;
  }

  std::unique_ptr<simulator::LockstepServer> server_;
  std::vector<std::unique_ptr<PlayerAgent>> agents_;
  int values_ = 0;
};

class Values : public testing::TestWithParam<int> {};

TEST_P(Values, GiveTheSameWorldsAsText) {
  constexpr int kPlayers = 12;
  constexpr int kCycles = 150;
  Players values(GetParam(), false, kPlayers);
  Players text(GetParam(), true, kPlayers);

  std::size_t decisions = 0;
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    const std::vector<std::string> from_values = values.play_cycle();
    ASSERT_TRUE(from_values == text.play_cycle()) << "cycle " << cycle;
    decisions += from_values.size() / 2;
  }

  EXPECT_GT(decisions, 100U * kPlayers);
  EXPECT_GT(values.values(), 150 * kPlayers);
  EXPECT_EQ(text.values(), 0);
  EXPECT_EQ(values.unreadable(), 0);
  EXPECT_EQ(text.unreadable(), 0);
}

INSTANTIATE_TEST_SUITE_P(Versions, Values, testing::Values(14, 15, 16, 17, 18, 19));

}  // namespace
}  // namespace cls::proxy
