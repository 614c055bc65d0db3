// Connection requests, and the replies of rcssserver to valid and invalid ones.
#include <gtest/gtest.h>

#include "soccer/commands/connection_request.h"

namespace cls::soccer {
namespace {

void format(const GameRequest& request, std::string& text) {
  std::visit([&](const auto& one) { soccer::format(one, text); }, request);
}

// The error of a request, or its text in the form of this program.
template <typename Request>
std::string read(std::string_view datagram) {
  Request request;
  if (const auto error = parse(datagram, request)) return std::string(name(*error));
  std::string text;
  format(request, text);
  return text;
}

std::string game(std::string_view datagram) { return read<GameRequest>(datagram); }
std::string coach(std::string_view datagram) { return read<CoachInit>(datagram); }
std::string trainer(std::string_view datagram) { return read<TrainerInit>(datagram); }

TEST(ConnectionRequest, ParsesPlayerInitLikeRcssserver) {
  EXPECT_EQ(game("(init LeftTeam (version 19))"), "(init LeftTeam (version 19))");
  EXPECT_EQ(game("(init LeftTeam (version 18) (goalie))"), "(init LeftTeam (version 18) (goalie))");
  EXPECT_EQ(game("(init A/B:C@D[E (version 18))"), "(init A/B:C@D[E (version 18))");
  EXPECT_EQ(game("(init A,b=c?d (version 18.9)(goalie))"),
            "(init A,b=c?d (version 18.9) (goalie))");
  EXPECT_EQ(game("(init  A/B:C@D[E(version 18)(goalie))\n"),
            "(init A/B:C@D[E (version 18) (goalie))");
  EXPECT_EQ(game("(init A (goalie) (version 18))"), "(init A (version 18) (goalie))");
  EXPECT_EQ(game("(init A)"), "(init A (version 3))");
}

TEST(ConnectionRequest, RejectsPlayerInitLikeRcssserver) {
  EXPECT_EQ(game("(init  (version 19))"), "illegal_teamname");
  EXPECT_EQ(game("(init T\xc3\xab\x61m (version 19))"), "illegal_teamname_or_too_long_teamname");
  EXPECT_EQ(game("(init ThisNameIsTooLong (version 19))"), "illegal_teamname_or_too_long_teamname");
  EXPECT_EQ(game("(init Z*Z (version 18))"), "illegal_teamname_or_too_long_teamname");
  EXPECT_EQ(game("(init A"), "illegal_teamname_or_too_long_teamname");
  EXPECT_EQ(game("(init X"), "illegal_teamname_or_too_long_teamname");
  EXPECT_EQ(game("(init A B (version 18))"), "illegal_teamname_or_too_long_teamname");

  EXPECT_EQ(game("(init LeftTeam (foo))"), "illegal_command_form");
  EXPECT_EQ(game("(init LeftTeam (version x))"), "illegal_command_form");
  EXPECT_EQ(game("(init LeftTeam (version 18)"), "illegal_command_form");
  EXPECT_EQ(game("(init)"), "unknown_command");
  EXPECT_EQ(game("(turn 10)"), "unknown_command");
  EXPECT_EQ(game(""), "unknown_command");
}

TEST(ConnectionRequest, DoesNotValidateVersions) {
  EXPECT_EQ(game("(init LeftTeam (version 20))"), "(init LeftTeam (version 20))");
}

TEST(ConnectionRequest, ParsesReconnect) {
  EXPECT_EQ(game("(reconnect LeftTeam 1)"), "(reconnect LeftTeam 1)");
  EXPECT_EQ(game("(reconnect A/B:C@D[E 5)"), "(reconnect A/B:C@D[E 5)");
  EXPECT_EQ(game("(reconnect A/B:C@D[E)"), "illegal_command_form");
  EXPECT_EQ(game("(reconnect )"), "illegal_command_form");
}

TEST(ConnectionRequest, ParsesMonitorInit) {
  EXPECT_EQ(game("(dispinit)"), "(dispinit)");
  EXPECT_EQ(game("(dispinit version 3)"), "(dispinit version 3)");
  EXPECT_EQ(game("(dispinit version -1)"), "(dispinit version -1)");
  EXPECT_EQ(game("(dispinit version 6)"), "(dispinit version 6)");
  EXPECT_EQ(game("(dispinit version x)"), "unknown_command");
}

TEST(ConnectionRequest, ParsesOnlineCoachInit) {
  EXPECT_EQ(coach("(init LeftTeam MyCoach (version 18))"), "(init LeftTeam MyCoach (version 18))");
  EXPECT_EQ(coach("(init HELIOS_L (version 18))"), "(init HELIOS_L (version 18))");
  EXPECT_EQ(coach("(init A C)"), "(init A C (version 5))");
  EXPECT_EQ(coach("(init A/B:C@D[E (version 4))"), "(init A/B:C@D[E (version 4))");
  EXPECT_EQ(coach("(init (version 18))"), "illegal_command_form");
  EXPECT_EQ(coach("(init A)"), "illegal_command_form");
  EXPECT_EQ(coach("(look)"), "illegal_command_form");
  EXPECT_EQ(coach("(init A C* (version 18))"), "illegal_coachname_or_too_long_coachname");
  EXPECT_EQ(coach("(init A " + std::string(128, 'c') + " (version 18))"),
            "illegal_coachname_or_too_long_coachname");
  EXPECT_EQ(coach("(init A (version x))"), "illegal_command_form");
}

TEST(ConnectionRequest, ParsesTrainerInit) {
  EXPECT_EQ(trainer("(init (version 18))"), "(init (version 18))");
  EXPECT_EQ(trainer("(init)"), "(init (version 3))");
  EXPECT_EQ(trainer("(init (version 0.5))"), "illegal_command_form");
  EXPECT_EQ(trainer("(init"), "illegal_command_form");
  EXPECT_EQ(trainer("(start)"), "illegal_command_form");
  EXPECT_EQ(trainer(""), "illegal_command_form");
}

}  // namespace
}  // namespace cls::soccer
