// Replays a match of upstream's coach: same States and same substitutions.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "proxy/coach/coach_agent.h"
#include "soccer/memory_channel.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"
#include "tests/support/transcript.h"

namespace cls::tests {
namespace {

using protos::Player;
using protos::State;
using Players = google::protobuf::RepeatedPtrField<Player>;

std::map<int, const Player*> by_number(const Players& players) {
  std::map<int, const Player*> map;
  for (const Player& player : players) map[player.uniform_number()] = &player;
  return map;
}

/// Sums over all decisions.
struct Difference {
  double position = 0.0;  ///< the largest
  double velocity = 0.0;
  double angle = 0.0;
  int missing = 0;  ///< players that one of both does not show
  int types = 0;    ///< of the own team
  int opponent_types_known = 0;
  int opponent_types_other = 0;
  int marks = 0;
  std::map<std::string, std::vector<int>> fields;  ///< cycles in which they differ, by name
};

void compare(const protos::RpcVector2D& a, const protos::RpcVector2D& b, double& worst) {
  worst = std::max({worst, std::fabs(static_cast<double>(a.x()) - b.x()),
                    std::fabs(static_cast<double>(a.y()) - b.y())});
}

void compare(const Players& ours, const Players& theirs, bool own_team, Difference& out) {
  const auto mine = by_number(ours);
  const auto others = by_number(theirs);

  for (const auto& [unum, other] : others) {
    const auto found = mine.find(unum);
    if (found == mine.end()) {
      ++out.missing;
      continue;
    }
    const Player& player = *found->second;
    compare(player.position(), other->position(), out.position);
    compare(player.velocity(), other->velocity(), out.velocity);
    for (const double turn : {player.body_direction() - other->body_direction(),
                              player.face_direction() - other->face_direction()}) {
      out.angle = std::max(out.angle, soccer::AngleDeg(turn).abs());
    }
    if (player.side() != other->side() || player.is_goalie() != other->is_goalie() ||
        player.is_kicking() != other->is_kicking() ||
        player.is_tackling() != other->is_tackling()) {
      ++out.marks;
    }
    if (own_team) out.types += player.type_id() == other->type_id() ? 0 : 1;
    if (own_team || other->type_id() < 0 || player.type_id() < 0) continue;
    ++out.opponent_types_known;
    out.opponent_types_other += player.type_id() == other->type_id() ? 0 : 1;
  }

  out.missing += static_cast<int>(mine.size() > others.size() ? mine.size() - others.size() : 0);
}

void compare(const State& ours, const State& theirs, Difference& out) {
  const protos::WorldModel& a = ours.world_model();
  const protos::WorldModel& b = theirs.world_model();
  compare(a.ball().position(), b.ball().position(), out.position);
  compare(a.ball().velocity(), b.ball().velocity(), out.velocity);
  compare(a.teammates(), b.teammates(), true, out);
  compare(a.opponents(), b.opponents(), false, out);

  // At the end of the match upstream's coach disconnects without handling the last messages.
  if (a.game_mode_type() == protos::TimeOver) return;
  const auto field = [&](const char* name, auto x, auto y) {
    if (x != y) out.fields[name].push_back(b.cycle());
  };

  field("our_team_name", a.our_team_name(), b.our_team_name());
  field("their_team_name", a.their_team_name(), b.their_team_name());
  field("our_side", a.our_side(), b.our_side());
  field("cycle", a.cycle(), b.cycle());
  field("game_mode_type", a.game_mode_type(), b.game_mode_type());
  field("left_team_score", a.left_team_score(), b.left_team_score());
  field("right_team_score", a.right_team_score(), b.right_team_score());
  field("our_team_score", a.our_team_score(), b.our_team_score());
  field("their_team_score", a.their_team_score(), b.their_team_score());
  field("is_our_set_play", a.is_our_set_play(), b.is_our_set_play());
  field("is_their_set_play", a.is_their_set_play(), b.is_their_set_play());
  field("is_penalty_kick_mode", a.is_penalty_kick_mode(), b.is_penalty_kick_mode());
  field("last_set_play_start_time", a.last_set_play_start_time(), b.last_set_play_start_time());
}

TEST(CoachReplay, MatchesUpstreamStatesAndSubstitutions) {
  const auto udp = data("aligned/udp/coach_l.txt.gz");
  const auto grpc = data("aligned/grpc/coach.GetCoachActions.req.pb.gz");
  if (!udp || !grpc) GTEST_SKIP() << "no data: set CLS_DATA";
  const std::string text = read_file(*udp);
  const std::vector<std::string> requests = split_messages(read_file(*grpc));

  auto [client, server] = soccer::make_memory_channel();
  proxy::CoachOptions options;
  options.team_name = "PROXY";
  proxy::CoachAgent coach(std::move(client), options);
  ASSERT_TRUE(coach.connect());
  protos::CoachActions wish;
  wish.add_actions()->mutable_do_helios_substitute();

  Difference difference;
  std::size_t decisions = 0;
  std::multiset<std::string> theirs;

  for (const Spoken& spoken : read_transcript(text)) {
    if (!spoken.by_server) {
      theirs.emplace(spoken.message);
      continue;
    }
    server->send(spoken.message);
    coach.perceive();
    if (!coach.decision_due()) continue;
    State recorded;
    ASSERT_LT(decisions, requests.size());
    ASSERT_TRUE(recorded.ParseFromString(requests[decisions++]));
    compare(coach.state(), recorded, difference);
    coach.act(wish);
  }

  std::multiset<std::string> ours;
  for (std::string said; server->receive(said);) ours.insert(said);
  // It sends (bye) once more at the end of the match.
  theirs.erase("(bye)");

  EXPECT_EQ(decisions, requests.size());
  EXPECT_LT(difference.position, 1e-4);
  EXPECT_LT(difference.velocity, 1e-5);
  EXPECT_LT(difference.angle, 0.01);
  EXPECT_EQ(difference.missing, 0);
  EXPECT_EQ(difference.types, 0);
  EXPECT_EQ(difference.marks, 0);
  EXPECT_GT(difference.opponent_types_known, 1000);
  EXPECT_EQ(difference.opponent_types_other, 0);
  for (const auto& [name, cycles] : difference.fields) {
    ADD_FAILURE() << name << " differs in " << testing::PrintToString(cycles);
  }
  EXPECT_EQ(ours, theirs);
  EXPECT_EQ(coach.server().errors.unreadable, 0) << coach.server().errors.first_unreadable;
}

}  // namespace
}  // namespace cls::tests
