// The reasons are those of docs/actions.md.
#include "proxy/actions/failure_reasons.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "proto/playmaker.pb.h"
#include "tests/support/files.h"

namespace cls::proxy {
namespace {

// Calls `row` with the first and the last cell of each row of the table of actions.
template <typename Row>
void read_table(Row row) {
  std::istringstream page(tests::read_file(tests::source_folder() / "docs/actions.md"));
  for (std::string line; std::getline(page, line);) {
    static const std::regex kActionRow("\\| (`[^|]*) \\| (main|side) \\|.*\\|\\s*([^|]*?)\\s*\\|");
    std::smatch cells;
    if (std::regex_match(line, cells, kActionRow)) row(cells[1].str(), cells[3].str());
  }
}

TEST(FailureReasons, AreThoseOfTheDocumentation) {
  std::set<std::string> named;
  read_table([&](const std::string& names, const std::string& reason) {
    static const std::regex kName("`([a-z_]+)`");
    for (std::sregex_iterator name(names.begin(), names.end(), kName), end; name != end; ++name) {
      const std::string action = (*name)[1];
      EXPECT_EQ(fails_when(action), reason) << action;
      named.insert(action);
    }
  });

  EXPECT_GE(named.size(), 45U);
  EXPECT_EQ(fails_when("view_wide"), "width unchanged");
  EXPECT_EQ(fails_when("no_such_action"), "");
}

// An action that always falls back to a scan cannot fail because a player is unknown.
TEST(FailureReasons, BelongToTheActionItself) {
  EXPECT_EQ(fails_when("turn_neck"), "a number is not finite");
  EXPECT_EQ(fails_when("change_view"), "width unchanged; no such width");
  EXPECT_EQ(fails_when("point_to_of"), "arm locked");
  EXPECT_EQ(fails_when("attention_to"), "own uniform number; no such uniform number");
  EXPECT_EQ(fails_when("attention_to_of"), "");
  EXPECT_EQ(fails_when("neck_turn_to_player_or_scan"), "player unknown");
  EXPECT_EQ(fails_when("neck_scan_field"), "");
  EXPECT_EQ(fails_when("neck_turn_to_point"), "");
}

TEST(FailureReasons, NameActionsOfTheInterface) {
  const auto* type = protos::PlayerAction::descriptor();
  for (const char* action : {"catch", "body_stop_dash", "bhv_do_heard_pass_recieve", "view_wide"}) {
    EXPECT_NE(type->FindFieldByName(action), nullptr) << action;
    EXPECT_NE(fails_when(action), "");
  }
}

}  // namespace
}  // namespace cls::proxy
