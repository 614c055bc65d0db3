// Players whose server sends the full state, on a recorded conversation with rcssserver.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <string>

#include "proxy/agent/player_agent.h"
#include "tests/support/files.h"
#include "tests/support/transcript.h"

namespace cls::proxy {
namespace {

/// Delivers the messages of the server; what is sent is lost.
class RecordedServer : public soccer::Channel {
 public:
  explicit RecordedServer(std::deque<std::string>& messages) : messages_(messages) {}
  bool send(std::string_view /*message*/) override { return true; }
  bool receive(std::string& message) override {
    if (messages_.empty()) return false;
    message = messages_.front();
    messages_.pop_front();
    return true;
  }

 private:
  std::deque<std::string>& messages_;
};

/// A player on the recording.
class Recording {
 public:
  explicit Recording(FullStateUse use) {
    for (const auto& spoken : tests::read_transcript(text_)) {
      if (spoken.by_server) recorded_.emplace_back(spoken.message);
    }
    AgentOptions options;
    options.team_name = soccer::TeamName("us");
    options.protocol = 19;
    options.full_state = use;
    agent = std::make_unique<PlayerAgent>(std::make_unique<RecordedServer>(pending_), options);
  }

  /// Plays up to the first decision after a (fullstate ...); its State.
  const protos::State* state() {
    bool has_full_state = false;
    while (!recorded_.empty()) {
      has_full_state = has_full_state || recorded_.front().starts_with("(fullstate ");
      pending_.push_back(std::move(recorded_.front()));
      recorded_.pop_front();
      agent->perceive();
      constexpr std::chrono::seconds kLater{10};
      if (has_full_state && agent->decision_due(Instant() + kLater)) {
        return &agent->state(Instant() + kLater);
      }
    }

    return nullptr;
  }

  std::unique_ptr<PlayerAgent> agent;

 private:
  const std::string text_ =
      tests::read_file(tests::fixture("protocol/player-realtime-fullstate-v19.txt.gz"));
  std::deque<std::string> recorded_;
  std::deque<std::string> pending_;
};

TEST(FullStateUse, HasNames) {
  for (const auto use :
       {FullStateUse::kIgnore, FullStateUse::kReference, FullStateUse::kOverride}) {
    EXPECT_EQ(parse_full_state_use(name(use)), use);
  }
  EXPECT_EQ(parse_full_state_use("some"), std::nullopt);
}

TEST(FullStateUse, IsPartOfTheStateByDefault) {
  EXPECT_EQ(AgentOptions().full_state, FullStateUse::kReference);
  Recording recording(FullStateUse::kReference);
  const protos::State* state = recording.state();
  ASSERT_NE(state, nullptr);
  ASSERT_TRUE(state->has_full_world_model());
  EXPECT_EQ(state->full_world_model().ball().pos_count(), 0);
  EXPECT_EQ(state->full_world_model().self().pos_count(), 0);
  EXPECT_GT(state->world_model().self().pos_count(), 0) << "no see message yet";
}

TEST(FullStateUse, CanBeIgnored) {
  Recording recording(FullStateUse::kIgnore);
  const protos::State* state = recording.state();
  ASSERT_NE(state, nullptr);
  EXPECT_FALSE(state->has_full_world_model());
}

TEST(FullStateUse, CanReplaceTheEstimates) {
  Recording recording(FullStateUse::kOverride);
  const protos::State* state = recording.state();
  ASSERT_NE(state, nullptr);
  EXPECT_EQ(state->world_model().self().pos_count(), 0);
  EXPECT_EQ(state->world_model().ball().pos_count(), 0);
  EXPECT_EQ(recording.agent->world().ball.pos_count, player::kNever) << "the senses are unchanged";
}

}  // namespace
}  // namespace cls::proxy
