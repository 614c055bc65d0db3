// `--record-choices`: what players with the ball chose, as options.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "player/options/option_ids.h"
#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

/// A row of the array, without the observation.
struct Choice {
  int cycle = 0;
  int unum = 0;
  int option = 0;
  std::string action;
  std::string legal;  ///< a byte for each option
};

constexpr std::size_t kActionBytes = 32;
constexpr std::size_t kRowBytes = 3 * 4 + kActionBytes + player::kOptionCount + 4 * 817;

std::vector<Choice> choices_of(const std::string& bytes) {
  const std::size_t header =
      10 + static_cast<unsigned char>(bytes.at(8)) + 256 * static_cast<unsigned char>(bytes.at(9));
  EXPECT_EQ(header % 64, 0U);
  EXPECT_EQ((bytes.size() - header) % kRowBytes, 0U);
  std::vector<Choice> choices;
  for (std::size_t at = header; at < bytes.size(); at += kRowBytes) {
    std::int32_t numbers[3];
    std::memcpy(numbers, bytes.data() + at, sizeof numbers);
    Choice& choice = choices.emplace_back();
    choice.cycle = numbers[0];
    choice.unum = numbers[1];
    choice.option = numbers[2];
    choice.action = std::string(bytes.substr(at + sizeof numbers, kActionBytes).c_str());
    choice.legal = bytes.substr(at + sizeof numbers + kActionBytes, player::kOptionCount);
  }
  return choices;
}

/// Those where a policy would choose, too; there are some.
std::vector<Choice> asked(std::vector<Choice> choices) {
  std::erase_if(choices, [](const Choice& choice) { return choice.option == -2; });
  EXPECT_FALSE(choices.empty());
  return choices;
}

class Choices : public testing::Test, public cls::tests::ClsFolder {
 protected:
  Choices() : ClsFolder(std::chrono::seconds(180)) {}

  CommandResult match(const std::string& left, const std::vector<std::string>& more = {}) const {
    return run(joined({"match", left, "mock:simple", "--left-name", "left", "--seed", "7",
                       "--cycles", "300", "--quiet", "--force", "--dir", "match"},
                      more));
  }

  /// Of the left side.
  std::vector<Choice> chosen(const std::string& left) const {
    EXPECT_THAT(match(left, {"--record-choices"}), Exits(0));
    return choices_of(read_file(folder_.path() / "match/left-choices.npy"));
  }

  /// Of a team whose players with the ball send `action`, with the ball in play.
  std::vector<Choice> chosen_by(const std::string& action) const {
    write("team.json",
          R"({"rules": [{"when": {"mode": "PlayOn", "state": {"self.is_kickable": true}},
                           "reply": [)" +
              action + R"(]}], "otherwise": "simple"})");
    return chosen("mock:team.json");
  }
};

TEST_F(Choices, AreThoseOfThePlannerWhereItPlays) {
  std::set<int> options;
  for (const Choice& choice : asked(chosen("mock:planner"))) {
    EXPECT_EQ(choice.action, "helios_offensive_planner");
    ASSERT_GE(choice.option, 0) << choice.cycle;
    EXPECT_EQ(choice.legal.at(static_cast<std::size_t>(choice.option)), 1) << choice.cycle;
    EXPECT_EQ(choice.legal[player::kAutoOption], 0);
    options.insert(choice.option);
  }
  EXPECT_GT(options.size(), 3U);
}

TEST_F(Choices, AreThoseOfAPolicy) {
  for (const Choice& choice : asked(chosen("policy:random"))) {
    EXPECT_EQ(choice.action, "policy");
    ASSERT_GE(choice.option, 0);
    EXPECT_EQ(choice.legal.at(static_cast<std::size_t>(choice.option)), 1);
  }
}

TEST_F(Choices, AreReadOffTheActions) {
  for (const auto& [action, name, option] :
       {std::tuple(R"({"body_hold_ball": {}})", "body_hold_ball", player::kHoldOption),
        {R"({"body_clear_ball": {}})", "body_clear_ball", player::kClearOption},
        {R"({"body_turn_to_angle": {"angle": 90}})", "body_turn_to_angle", player::kHoldOption},
        {R"({"dash": {"power": 1}})", "dash", -1}}) {
    for (const Choice& choice : asked(chosen_by(action))) {
      EXPECT_EQ(choice.action, name);
      EXPECT_EQ(choice.option, option) << action;
    }
  }
}

TEST_F(Choices, OfADribbleAreItsDirection) {
  int dribbles = 0;
  for (
      const Choice& choice : asked(chosen_by(
          R"({"body_dribble": {"target_point": {"x": 500, "y": 0}, "dash_power": 100, "dash_count": 2}})"))) {
    if (choice.option == -1) continue;  // opponents stop all of them
    EXPECT_THAT(choice.option,
                AllOf(Ge(player::kDribbleOption + 6), Le(player::kDribbleOption + 10)))
        << "within 45 degrees of the way to their goal line";
    ++dribbles;
  }
  EXPECT_GT(dribbles, 0);
}

TEST_F(Choices, OfAKickAreWhereItLeads) {
  for (
      const Choice& choice : asked(chosen_by(
          R"({"body_kick_one_step": {"target_point": {"x": 52.5, "y": 0}, "first_speed": 2.7}})"))) {
    EXPECT_THAT(choice.option, AnyOf(player::kShootOption, player::kClearOption));
  }
  for (
      const Choice& choice : asked(chosen_by(
          R"({"body_kick_one_step": {"target_point": {"x": 0, "y": 200}, "first_speed": 2.7}})"))) {
    EXPECT_EQ(choice.option, -1) << "nothing leads there";
  }
}

TEST_F(Choices, ChangeNothingInTheMatch) {
  EXPECT_THAT(match("mock:planner"), Exits(0));
  const std::string plain = read_file(folder_.path() / "match/match.rcg");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "match/left-choices.npy"));
  EXPECT_THAT(match("mock:planner", {"--record-choices"}), Exits(0));
  EXPECT_TRUE(read_file(folder_.path() / "match/match.rcg") == plain);
  const std::string left = read_file(folder_.path() / "match/left-choices.npy");
  EXPECT_THAT(match("mock:planner", {"--record-choices"}), Exits(0));
  EXPECT_TRUE(read_file(folder_.path() / "match/left-choices.npy") == left) << "reproducible";
}

TEST_F(Choices, NeedASideThatChooses) {
  EXPECT_THAT(run({"match", "team:a", "team:b", "--record-choices"}),
              Exits(2, HasSubstr("--record-choices needs a side with a Playmaker")));
}

}  // namespace
}  // namespace cls::tests
