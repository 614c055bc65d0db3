// Clients that may play for one side only, and two teams of one name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/world/roster.h"
#include "tests/simulator/sessions/match_clients.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr ClientRights kLeftOnly{true, false, false, false};
constexpr ClientRights kRightOnly{false, true, false, false};
constexpr ClientRights kWatch{false, false, false, true};
constexpr ClientRights kNothing{false, false, false, false};

class ClientRightsTest : public MatchClients {
 protected:
  ClientRightsTest() { start(); }

  AdmissionResult ask(const std::string& request, const ClientRights& rights,
                      ListeningPort port = ListeningPort::kPlayers) {
    return server_->admit(port, request, rights);
  }
  ClientId connect(const std::string& request, const ClientRights& rights,
                   ListeningPort port = ListeningPort::kPlayers) {
    return MatchClients::connect(request, port, rights);
  }
  bool intrudes(const std::string& request, const ClientRights& rights,
                ListeningPort port = ListeningPort::kPlayers) {
    return std::holds_alternative<Intrusion>(ask(request, rights, port));
  }
};

TEST_F(ClientRightsTest, DecideTheSideWhateverComesFirst) {
  EXPECT_EQ(connect("(init B (version 18))", kRightOnly), soccer::slot_of(Side::kRight, 1));
  EXPECT_EQ(connect("(init A (version 18))", kLeftOnly), soccer::slot_of(Side::kLeft, 1));
  EXPECT_EQ(world().team(Side::kLeft).name.view(), "A");
  EXPECT_EQ(world().team(Side::kRight).name.view(), "B");
}

TEST_F(ClientRightsTest, GiveASideOneName) {
  connect("(init A (version 18))", kLeftOnly);
  EXPECT_TRUE(intrudes("(init B (version 18))", kLeftOnly));
  EXPECT_TRUE(world().team(Side::kRight).name.empty()) << "not even reserved";
  EXPECT_EQ(connect("(init B (version 18))", kRightOnly), soccer::slot_of(Side::kRight, 1));
}

TEST_F(ClientRightsTest, RefusePlayersAndCoachesOfTheOtherSide) {
  connect("(init A (version 18))", kLeftOnly);
  connect("(init B (version 18))", kRightOnly);
  EXPECT_TRUE(intrudes("(reconnect B 1)", kLeftOnly));
  EXPECT_TRUE(intrudes("(init B (version 18))", kLeftOnly, ListeningPort::kOnlineCoaches));
  EXPECT_EQ(refusal(ask("(reconnect B 1)", kLeftOnly)), ErrorCode::kNoSuchTeamOrPlayer);
  EXPECT_EQ(connect("(reconnect A 1)", kLeftOnly), soccer::slot_of(Side::kLeft, 1));
  EXPECT_EQ(connect("(init B (version 18))", kRightOnly, ListeningPort::kOnlineCoaches),
            kRightCoach);
}

TEST_F(ClientRightsTest, RefuseAllThatIsNotGranted) {
  connect("(init A (version 18))", {});
  for (const ClientRights& rights : {kWatch, kNothing}) {
    EXPECT_TRUE(intrudes("(init A (version 18))", rights));
    EXPECT_TRUE(intrudes("(reconnect A 1)", rights));
    EXPECT_TRUE(intrudes("(init A (version 18))", rights, ListeningPort::kOnlineCoaches));
    EXPECT_TRUE(intrudes("(init (version 18))", rights, ListeningPort::kTrainers));
  }
  EXPECT_TRUE(intrudes("(dispinit version 4)", kNothing));
  EXPECT_TRUE(intrudes("(dispinit version 4)", kLeftOnly));
  EXPECT_NE(connect("(dispinit version 4)", kWatch), kNoClient);
}

class TwinsTest : public ClientRightsTest {
 protected:
  TwinsTest() {
    left_ = connect("(init Twins (version 18))", kLeftOnly);
    right_ = connect("(init Twins (version 18))", kRightOnly);
    for (const ClientId client : {left_, right_}) {
      server_->receive(client, "(move -10 0)");
      messages(client);
    }
    server_->execute();
  }

  ClientId left_ = kNoClient;
  ClientId right_ = kNoClient;
};

TEST_F(TwinsTest, HaveNamesOfTheirOwn) {
  EXPECT_EQ(left_, soccer::slot_of(Side::kLeft, 1));
  EXPECT_EQ(right_, soccer::slot_of(Side::kRight, 1));
  EXPECT_EQ(world().team(Side::kLeft).name.view(), "Twins");
  EXPECT_EQ(world().team(Side::kRight).name.view(), "Twins_r");
}

// A program that looks for its own name must find its own players, and no others.
TEST_F(TwinsTest, SeeThemselvesUnderTheNameThatTheyChose) {
  EXPECT_EQ(visible_team_name(world(), Side::kLeft, Side::kLeft).view(), "Twins");
  EXPECT_EQ(visible_team_name(world(), Side::kLeft, Side::kRight).view(), "Twins_r");
  EXPECT_EQ(visible_team_name(world(), Side::kRight, Side::kRight).view(), "Twins");
  EXPECT_EQ(visible_team_name(world(), Side::kRight, Side::kLeft).view(), "Twins_l");
  EXPECT_EQ(visible_team_name(world(), Side::kNeutral, Side::kRight).view(), "Twins_r");
}

TEST_F(TwinsTest, ReconnectAndHaveCoaches) {
  EXPECT_EQ(connect("(reconnect Twins 1)", kRightOnly), right_);
  const ClientId coach =
      connect("(init Twins (version 18))", kRightOnly, ListeningPort::kOnlineCoaches);
  EXPECT_EQ(coach, kRightCoach);
  EXPECT_THAT(answers(coach, "(team_names)"),
              Contains(HasSubstr("(ok team_names (team l Twins_l) (team r Twins)")));
}

TEST_F(TwinsTest, AttendToTheirOwnByName) {
  connect("(init Twins (version 18))", kRightOnly);
  answers(right_, "(attentionto Twins 2)");
  EXPECT_EQ(world().player(right_).attention, soccer::slot_of(Side::kRight, 2));
}

// Programs of two teams in one, against the first of these teams alone.
class MixedTeamTest : public ClientRightsTest {
 protected:
  MixedTeamTest() {
    first_ = connect("(init A (version 18) (goalie))", kMixed);
    second_ = connect("(init B (version 18))", kMixed);
    opponent_ = connect("(init A (version 18))", kRightOnly);
    server_->receive(first_, "(move -10 0)");
    server_->receive(second_, "(move -9 0)");
    server_->receive(opponent_, "(move -5 0)");
    server_->execute();
    server_->step();
    server_->receive(opponent_, "(turn 180)");  // to the left team
    server_->execute();
    server_->step();
  }

  // The next see message; players do not get one in every cycle.
  std::string seen_by(ClientId client) {
    messages(client);
    for (int cycle = 0; cycle < 5; ++cycle) {
      step();
      server_->see(99);
      for (const std::string& text : messages(client)) {
        if (text.starts_with("(see ")) return text;
      }
    }
    return {};
  }

  static constexpr ClientRights kMixed{true, false, false, false, "A+B"};
  ClientId first_ = kNoClient;
  ClientId second_ = kNoClient;
  ClientId opponent_ = kNoClient;
};

TEST_F(MixedTeamTest, HasOneNameAndTheNumbersOfItsPlayers) {
  EXPECT_EQ(first_, soccer::slot_of(Side::kLeft, 1));
  EXPECT_EQ(second_, soccer::slot_of(Side::kLeft, 2));
  EXPECT_EQ(world().team(Side::kLeft).name.view(), "A+B");
  EXPECT_EQ(world().team(Side::kRight).name.view(), "A");
  EXPECT_THAT(seen_by(opponent_), HasSubstr("((p \"A+B\" 1 goalie)"));
}

// A program takes players of its own name for its team, and others for the opponent.
TEST_F(MixedTeamTest, PlayersSeeTheirTeamUnderTheirOwnName) {
  const std::string seen = seen_by(first_);
  EXPECT_THAT(seen, HasSubstr("((p \"A\" 2)"));
  EXPECT_THAT(seen, HasSubstr("((p \"A_r\" 1)")) << "the opponent has another name";
  EXPECT_THAT(seen_by(second_), HasSubstr("((p \"A\" 1)")) << "the opponent, as it is";
}

TEST_F(MixedTeamTest, PlayersNameTeamsInCommandsAsTheySeeThem) {
  const auto attends = [this](ClientId client, const std::string& command) {
    answers(client, command);
    return world().player(client).attention;
  };
  EXPECT_EQ(attends(first_, "(attentionto A 2)"), second_);
  EXPECT_EQ(attends(first_, "(attentionto A_r 1)"), opponent_);
  EXPECT_EQ(attends(second_, "(attentionto B 1)"), first_);
  EXPECT_EQ(attends(second_, "(attentionto A 1)"), opponent_);

  EXPECT_THAT(answers(first_, "(ear (off A))"), ElementsAre());
  EXPECT_THAT(answers(first_, "(ear (off C))"), ElementsAre("(error no team with name C)"));
}

TEST_F(MixedTeamTest, CoachAndReconnectedPlayersKeepTheirNames) {
  const ClientId coach = connect("(init B (version 18))", kMixed, ListeningPort::kOnlineCoaches);
  EXPECT_EQ(coach, kLeftCoach);
  EXPECT_THAT(answers(coach, "(team_names)"),
              Contains(HasSubstr("(ok team_names (team l B) (team r A)")));
  EXPECT_EQ(connect("(reconnect A 1)", kMixed), first_);
  answers(first_, "(move -10 0)");
  EXPECT_THAT(seen_by(first_), HasSubstr("((p \"A\" 2)"));
}

TEST_F(ClientRightsTest, KeepLongNamesWithinTheLimit) {
  connect("(init FifteenLetters_ (version 18))", kLeftOnly);
  connect("(init FifteenLetters_ (version 18))", kRightOnly);
  EXPECT_EQ(world().team(Side::kRight).name.view(), "FifteenLetter_r");
}

}  // namespace
}  // namespace cls::simulator
