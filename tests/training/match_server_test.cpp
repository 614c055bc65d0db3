// Episodes against the server of matches: the same commands give the same game log, the same
// messages the same world models.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>

#include "mock-server/script/named_behaviors.h"
#include "player/behaviors/automatic_play.h"
#include "player/movement/home_positions.h"
#include "player/perception/perception.h"
#include "proxy/actions/executor.h"
#include "proxy/messages/state_message.h"
#include "simulator/sessions/match_server.h"
#include "soccer/memory_channel.h"
#include "soccer/protocol/message_kind.h"
#include "tests/training/stage.h"
#include "training/episode/episode.h"

namespace cls::tests {
namespace {

using simulator::Slot;
using soccer::Side;

class TextSink : public base::ByteSink {
 public:
  explicit TextSink(std::string& out) : out_(&out) {}
  void write(std::string_view text) override { *out_ += text; }
  base::Result<void> close() override { return {}; }

 private:
  std::string* out_;
};

// The lines of a game log without those that appear with the first frame only: the episode records
// its start, a match server records from the first step on.
std::vector<std::string> comparable_lines(const std::string& log, bool has_start) {
  std::vector<std::string> lines;
  std::istringstream in(log);
  bool drop = has_start;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("(playmode ") || line.starts_with("(team ")) continue;
    if (drop && line.starts_with("(show ")) {
      drop = false;
      continue;
    }
    lines.push_back(line);
  }
  return lines;
}

// The lines of a text log that are not a handshake.
std::vector<std::string> command_lines(const std::string& log) {
  std::vector<std::string> lines;
  std::istringstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.find("(init ") == std::string::npos) lines.push_back(line);
  }
  return lines;
}

/// A match server with 22 clients in memory, in the situation of an episode.
class ServerMatch {
 public:
  explicit ServerMatch(const training::Episode& episode) : sink_(log), text_sink_(text_log) {
    const simulator::World& start = episode.world();
    simulator::MatchConfig config;
    config.server = start.params();
    config.player = start.rules->player;
    config.seed = training::kTypesSeed;
    auto server = simulator::MatchServer::create(config);
    if (!server) throw std::runtime_error(server.error().message);
    server_ = std::move(*server);
    server_->record(&sink_, &text_sink_);
    for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) connect(slot);
    server_->modify_world([&](simulator::World& world, simulator::Events&) { world = start; });
  }

  void play_cycle(const training::Episode& episode) {
    for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
      if (!server_->world().player(slot).enabled) continue;
      std::string text;
      for (const soccer::PlayerCommand& command : episode.commands(slot)) {
        ASSERT_TRUE(soccer::format(command, text));
      }
      server_->receive(slot, text);
    }
    server_->execute();
    server_->step();
    server_->sense();
  }

  /// The messages to the client in `slot` since the last call.
  std::vector<std::string> received(Slot slot) {
    std::vector<std::string> messages;
    std::string message;
    while (clients_[static_cast<std::size_t>(slot)]->receive(message)) messages.push_back(message);
    return messages;
  }

  void finish() { server_->finish(); }

  std::string log;
  std::string text_log;

 private:
  void connect(Slot slot) {
    const std::string request = std::string("(init ") +
                                (soccer::side_of_slot(slot) == Side::kLeft ? "left" : "right") +
                                " (version 18))";
    auto [server_end, client_end] = soccer::make_memory_channel();
    const auto admission = server_->admit(simulator::ListeningPort::kPlayers, request);
    server_->complete_handshake(std::get<simulator::Admission>(admission), std::move(server_end),
                                request);
    clients_[static_cast<std::size_t>(slot)] = std::move(client_end);
  }

  TextSink sink_;
  TextSink text_sink_;
  std::unique_ptr<simulator::MatchServer> server_;
  std::array<std::unique_ptr<soccer::Channel>, soccer::kPlayersOnPitch> clients_;
};

/// Random actions of the agents of an episode.
class RandomActions {
 public:
  explicit RandomActions(const training::Setup& setup) : setup_(setup) {
    ids_.resize(setup.id_count() > 0 ? setup.agent_count() : 0);
    values_.resize(setup.agent_count() * setup.value_count());
  }

  training::AgentActions draw() {
    for (std::int32_t& id : ids_) id = random_.integer(static_cast<int>(setup_.id_count()));
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const training::Column& column = setup_.value_columns[i % setup_.value_count()];
      values_[i] = static_cast<float>(
          random_.uniform(static_cast<double>(column.low), static_cast<double>(column.high)));
    }
    return {ids_.data(), values_.data()};
  }

 private:
  const training::Setup& setup_;
  soccer::RandomStream random_{11, "actions"};
  std::vector<std::int32_t> ids_;
  std::vector<float> values_;
};

class TrainingMatchServer : public testing::TestWithParam<const char*> {};

TEST_P(TrainingMatchServer, CommandsOfAnEpisodeGiveItsGameLog) {
  const auto setup = setup_of(GetParam());
  training::Episode episode(setup);
  episode.reset(17, setup->options);
  std::string recorded;
  std::string commands;
  TextSink sink(recorded);
  TextSink text_sink(commands);
  simulator::MatchRecorder recorder;
  recorder.begin({.game = &sink, .text = &text_sink}, *episode.world().rules);
  recorder.step(episode.world());
  ServerMatch match(episode);
  RandomActions actions(*setup);

  for (int cycle = 0; cycle < 120 && !episode.ended(); ++cycle) {
    episode.step(actions.draw(), &recorder);
    match.play_cycle(episode);
  }

  EXPECT_GT(episode.cycles(), 20);
  recorder.finish(episode.world());
  match.finish();
  const bool has_start = recorded.find("(show 0 ") != std::string::npos;
  const auto expected = comparable_lines(recorded, has_start);
  const auto played = comparable_lines(match.log, false);
  ASSERT_EQ(played.size(), expected.size());

  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(played[i], expected[i]) << "line " << i;
  }

  EXPECT_EQ(command_lines(match.text_log), command_lines(commands));
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, TrainingMatchServer,
    testing::Values(
        R"({"task": "HalfFieldOffense", "offense": 2, "defense": 2, "actions": "hfo"})",
        R"({"task": "HalfFieldOffense", "offense": 2, "defense": 1, "actions": "low"})",
        R"({"task": "HalfFieldDefense", "offense": 3, "defense": 3, "agents": "both",
            "features": "ego", "actions": "low_flat", "types": "random"})",
        R"({"task": "Match", "agents": "both", "actions": "hfo"})",
        R"({"task": "HalfFieldOffense", "offense": 2, "defense": 2, "actions": "hfo",
            "obs": "world_model"})",
        R"({"task": "Match", "agents": "both", "actions": "hfo", "obs": "world_model"})"));

/// The world model of a client that reads the messages of a match server.
void read_messages(const std::vector<std::string>& messages, player::WorldModel& world) {
  for (const std::string& message : messages) {
    soccer::SenseBody sense;
    soccer::See see;
    soccer::Hear hear;
    switch (soccer::message_kind(message)) {
      case soccer::MessageKind::kSenseBody:
        ASSERT_TRUE(soccer::parse(message, sense));
        on_sense_body(world, sense);
        break;
      case soccer::MessageKind::kSee:
        ASSERT_TRUE(soccer::parse(message, see));
        on_see(world, see);
        break;
      case soccer::MessageKind::kHear:
        ASSERT_TRUE(soccer::parse(message, hear));
        on_hear(world, hear);
        break;
      default:
        break;
    }
  }

  update_derived(world);
}

void expect_equal(const player::PlayerList& one, const player::PlayerList& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].unum, other[i].unum);
    EXPECT_EQ(one[i].position, other[i].position);
    EXPECT_EQ(one[i].velocity, other[i].velocity);
    EXPECT_EQ(one[i].covariance, other[i].covariance);
    EXPECT_EQ(one[i].pos_count, other[i].pos_count);
  }
}

void expect_equal(const player::WorldModel& one, const player::WorldModel& other) {
  EXPECT_EQ(one.game.time, other.game.time);
  EXPECT_EQ(one.game.mode, other.game.mode);
  EXPECT_EQ(one.game.our_score, other.game.our_score);
  EXPECT_EQ(one.self.position, other.self.position);
  EXPECT_EQ(one.self.velocity, other.self.velocity);
  EXPECT_EQ(one.self.body.degrees(), other.self.body.degrees());
  EXPECT_EQ(one.self.neck.degrees(), other.self.neck.degrees());
  EXPECT_EQ(one.self.stamina, other.self.stamina);
  EXPECT_EQ(one.ball.position, other.ball.position);
  EXPECT_EQ(one.ball.velocity, other.ball.velocity);
  EXPECT_EQ(one.ball.pos_count, other.ball.pos_count);
  expect_equal(one.teammates, other.teammates);
  expect_equal(one.opponents, other.opponents);
  expect_equal(one.unknowns, other.unknowns);
}

class TrainingWorldModel : public testing::TestWithParam<const char*> {};

TEST_P(TrainingWorldModel, IsThatOfAClientOfAMatchServer) {
  const auto setup = setup_of(GetParam());
  training::Episode episode(setup);
  episode.reset(5, setup->options);
  ServerMatch match(episode);
  std::vector<player::WorldModel> clients;

  for (std::size_t agent = 0; agent < setup->agent_count(); ++agent) {
    match.received(setup->cast.agents[agent]);  // of the handshake
    clients.push_back(*episode.world_model(agent));
  }

  RandomActions actions(*setup);
  for (int cycle = 0; cycle < 100 && !episode.ended(); ++cycle) {
    episode.step(actions.draw(), nullptr);
    match.play_cycle(episode);
    for (std::size_t agent = 0; agent < clients.size(); ++agent) {
      const int slot = setup->cast.agents[agent];
      const auto commands = episode.commands(slot);
      record_sent_commands(clients[agent], {commands.begin(), commands.end()});
      read_messages(match.received(slot), clients[agent]);
      expect_equal(*episode.world_model(agent), clients[agent]);
      if (HasFailure()) FAIL() << "agent " << agent << ", cycle " << cycle;
    }
  }

  EXPECT_GT(episode.cycles(), 20);
}

/// A player of a match: States to the mock Playmaker, its replies to commands.
struct MatchAgent {
  explicit MatchAgent(const training::MatchPlayer& player)
      : world(player.senses.world), memory(player.memory) {}

  std::vector<soccer::PlayerCommand> decide(const mock_server::Behavior& behavior) {
    proxy::fill_state(world, home_positions(world), needs_preprocess(world), state);
    protos::PlayerActions actions;
    behavior.decide(state, actions);
    player::CommandSlots slots(world);
    player::ActionReport report;
    proxy::execute(actions, world, memory, slots, report);
    std::vector<soccer::PlayerCommand> commands;
    slots.compose(commands);
    record_sent_commands(world, commands);
    return commands;
  }

  player::WorldModel world;
  player::ActionMemory memory;
  protos::State state;
};

std::string text_of(std::span<const soccer::PlayerCommand> commands) {
  std::string text;
  for (const soccer::PlayerCommand& command : commands) EXPECT_TRUE(format(command, text));
  return text;
}

struct MatchPlayers {
  const char* behavior;
  const char* config;
};

// Names the test; without it the name would be the addresses of this run.
void PrintTo(const MatchPlayers& players, std::ostream* out) { *out << players.behavior; }

class TrainingMatchPlayers : public testing::TestWithParam<MatchPlayers> {};

TEST_P(TrainingMatchPlayers, DecideAsTheAgentsOfAMatch) {
  const auto behavior = mock_server::make_behavior(GetParam().behavior);
  ASSERT_TRUE(behavior);

  const auto setup = setup_of(GetParam().config);
  training::Episode episode(setup);
  std::set<std::size_t> kinds;

  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    episode.reset(seed, setup->options);
    ServerMatch match(episode);
    std::map<int, MatchAgent> agents;
    for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
      match.received(slot);  // of the handshake
      const training::MatchPlayer* player = episode.match_player(slot);
      if (player != nullptr) agents.emplace(slot, *player);
    }
    EXPECT_EQ(agents.size(), setup->match_players.size());
    RandomActions actions(*setup);
    for (int cycle = 0; cycle < 150 && !episode.ended(); ++cycle) {
      episode.step(actions.draw(), nullptr);
      for (auto& [slot, agent] : agents) {
        const auto commands = agent.decide(**behavior);
        ASSERT_EQ(text_of(episode.commands(slot)), text_of(commands))
            << "slot " << slot << ", cycle " << cycle;
        for (const soccer::PlayerCommand& command : commands) kinds.insert(command.index());
      }
      match.play_cycle(episode);
      for (auto& [slot, agent] : agents) read_messages(match.received(slot), agent.world);
    }
  }

  EXPECT_GE(kinds.size(), 5U) << "kinds of commands";
}

INSTANTIATE_TEST_SUITE_P(
    Teams, TrainingMatchPlayers,
    testing::Values(
        MatchPlayers{"simple", R"({"task": "HalfFieldOffense", "offense": 3, "defense": 4,
                        "num_agents": 1, "actions": "hfo", "opponent": "mock",
                        "teammates": "mock"})"},
        MatchPlayers{"planner", R"({"task": "HalfFieldOffense", "offense": 3, "defense": 4,
                        "num_agents": 1, "actions": "hfo", "opponent": "planner",
                        "teammates": "planner"})"},
        MatchPlayers{"planner", R"({"task": "Match", "num_agents": 1, "actions": "hfo",
                        "opponent": "planner", "teammates": "planner"})"},
        MatchPlayers{"simple", R"({"task": "Match", "num_agents": 5, "actions": "hfo",
                        "opponent": "mock", "teammates": "mock"})"}));

INSTANTIATE_TEST_SUITE_P(
    Tasks, TrainingWorldModel,
    testing::Values(R"({"task": "HalfFieldOffense", "offense": 2, "defense": 2, "actions": "hfo",
                        "obs": "world_model"})",
                    R"({"task": "Match", "agents": "both", "actions": "hfo", "types": "random",
                        "obs": "world_model"})"));

}  // namespace
}  // namespace cls::tests
