// Plays agent scripts.
#include "tests/fuzz/agent_script.h"

#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text/number_text.h"
#include "proxy/agent/player_agent.h"
#include "proxy/coach/coach_agent.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/player_command.h"
#include "soccer/memory_channel.h"
#include "tests/fuzz/require.h"
#include "tests/proxy/playmaker/random_message.h"
#include "tests/support/text_channel.h"

namespace cls::tests {
namespace {

/// Later than every deadline of an agent.
constexpr proxy::Instant kMuchLater = proxy::Instant(std::chrono::hours(1));

/// Replies of the scripted Playmaker.
struct Answer {
  std::string actions;
  std::optional<int> random;  ///< instead of `actions`: the seed of random ones
  std::optional<int> node;
  bool missing = false;

  template <typename Actions>
  Actions as() const {
    Actions parsed;
    if (random) {
      RandomMessages(static_cast<std::uint64_t>(*random)).fill(parsed);
      return parsed;
    }
    google::protobuf::LogSilencer no_complaints;
    google::protobuf::TextFormat::Parser parser;
    if (!parser.ParseFromString(actions, &parsed)) parsed.Clear();
    return parsed;
  }
};

class Player {
 public:
  Player(std::unique_ptr<soccer::Channel> channel, bool goalie)
      : agent_(std::move(channel), options(goalie)) {
    agent_.connect();
  }

  /// Returns true after a decision.
  bool listen(const Answer& answer) {
    agent_.perceive();
    if (!agent_.ready() || !agent_.decision_due(kMuchLater)) return false;
    require(!agent_.state(kMuchLater).SerializeAsString().empty());
    if (answer.missing) {
      agent_.act_without_reply();
    } else if (!agent_.act(answer.as<protos::PlayerActions>())) {
      agent_.act_on_planner_choice(answer.node);
    }
    return true;
  }

  static bool can_say(std::string_view datagram) {
    std::vector<soccer::PlayerCommand> commands;
    return !soccer::parse_player_commands(datagram, commands);
  }

 private:
  static proxy::AgentOptions options(bool goalie) {
    proxy::AgentOptions options;
    options.team_name = soccer::TeamName("Fuzz");
    options.goalie = goalie;
    options.on_late = proxy::OnLate::kLast;
    return options;
  }

  proxy::PlayerAgent agent_;
};

class Coach {
 public:
  Coach(std::unique_ptr<soccer::Channel> channel, soccer::CoachRole role)
      : role_(role), agent_(std::move(channel), {role, soccer::TeamName("Fuzz")}) {
    agent_.connect();
  }

  /// Returns true after a decision.
  bool listen(const Answer& answer) {
    agent_.perceive();
    if (!agent_.ready() || !agent_.decision_due()) return false;
    require(!agent_.state().SerializeAsString().empty());
    if (answer.missing) {
      agent_.act_without_reply();
    } else if (agent_.is_trainer()) {
      agent_.act(answer.as<protos::TrainerActions>());
    } else {
      agent_.act(answer.as<protos::CoachActions>());
    }
    return true;
  }

  bool can_say(std::string_view datagram) const {
    soccer::CoachCommand command;
    return !soccer::parse(datagram, role_, command);
  }

 private:
  soccer::CoachRole role_;
  proxy::CoachAgent agent_;
};

std::optional<int> number_after(std::string_view word, std::string_view line) {
  int number = 0;
  if (!line.starts_with(word) || base::parse_int_prefix(line.substr(word.size()), number) == 0) {
    return std::nullopt;
  }
  return number;
}

template <typename Agent>
int play(std::string_view script, soccer::Channel& server, Agent& agent) {
  int decisions = 0;
  Answer answer;
  std::string said;
  server.receive(said);  // the init

  while (!script.empty()) {
    const std::string_view line = script.substr(0, script.find('\n'));
    script.remove_prefix(std::min(line.size() + 1, script.size()));
    if (line.starts_with("a ")) {
      answer.actions = line.substr(2);
      answer.random.reset();
      answer.missing = false;
    } else if (const auto seed = number_after("r ", line)) {
      answer.random = seed;
      answer.missing = false;
    } else if (const auto node = number_after("n ", line)) {
      answer.node = node;
    } else if (line == "l") {
      answer.missing = true;
    } else {
      server.send(line);
      if (agent.listen(answer)) ++decisions;
    }
    while (server.receive(said)) require(agent.can_say(said));
  }

  return decisions;
}

}  // namespace

int play_agent_script(std::string_view script) {
  const char who = script.empty() ? 'p' : script.front();
  script.remove_prefix(std::min(script.find('\n'), script.size()));
  auto [server, memory] = soccer::make_memory_channel();
  auto client = std::make_unique<TextChannel>(std::move(memory));
  if (who == 'c' || who == 't') {
    const auto role = who == 'c' ? soccer::CoachRole::kOnlineCoach : soccer::CoachRole::kTrainer;
    Coach coach(std::move(client), role);
    return play(script, *server, coach);
  }
  Player player(std::move(client), who == 'g');
  return play(script, *server, player);
}

}  // namespace cls::tests
