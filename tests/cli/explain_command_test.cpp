// `cls explain`: every name of the interface has an entry, and docs/reference/ is up to date.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "proto/playmaker.pb.h"
#include "proto/team_playmaker.pb.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;

CommandResult explain(std::vector<std::string> words) {
  return run(joined({cls_binary(), "explain"}, words));
}

const json& all_entries() {
  static const json entries = json::parse(explain({"--list", "--json"}).out)["entries"];
  return entries;
}

const json* find_entry(const std::string& kind, const std::string& name) {
  for (const json& entry : all_entries()) {
    if (entry["kind"] == kind && entry["name"] == name) return &entry;
  }
  return nullptr;
}

void check_names(const google::protobuf::FileDescriptor* file) {
  for (int i = 0; i < file->message_type_count(); ++i) {
    const auto* message = file->message_type(i);
    EXPECT_NE(find_entry("message", message->name()), nullptr) << message->name();
    for (int j = 0; j < message->field_count(); ++j) {
      const std::string name = message->name() + "." + message->field(j)->name();
      EXPECT_NE(find_entry("field", name), nullptr) << name;
    }
  }
  for (int i = 0; i < file->enum_type_count(); ++i) {
    EXPECT_NE(find_entry("enumeration", file->enum_type(i)->name()), nullptr)
        << file->enum_type(i)->name();
  }
}

TEST(ExplainCommand, KnowsEveryMessageAndFieldOfBothInterfaces) {
  check_names(protos::State::descriptor()->file());
  check_names(playmaker::v1::RegisterTeamRequest::descriptor()->file());
}

TEST(ExplainCommand, SaysWhatEveryNameMeans) {
  for (const json& entry : all_entries()) {
    if (entry["kind"] == "action") continue;
    EXPECT_NE(entry["text"], "") << entry["name"];
  }
}

TEST(ExplainCommand, GivesNumbersUnits) {
  const std::set<std::string> numbers = {"float", "double", "int32", "RpcVector2D"};
  for (const json& entry : all_entries()) {
    if (entry["kind"] != "field") continue;
    if (!numbers.contains(entry["facts"]["type"].get<std::string>())) continue;
    EXPECT_TRUE(entry["facts"].contains("unit")) << entry["name"];
  }
}

TEST(ExplainCommand, GivesParametersTheDefaultsThatAPlaymakerReceives) {
  const json* power = find_entry("field", "ServerParam.max_power");
  ASSERT_NE(power, nullptr);
  EXPECT_EQ((*power)["facts"]["default"], "100");
  EXPECT_EQ((*power)["facts"]["setting"], "server::maxpower");
  const json* inertia = find_entry("field", "PlayerType.inertia_moment");
  ASSERT_NE(inertia, nullptr);
  EXPECT_EQ((*inertia)["facts"]["default"], "5");
  EXPECT_FALSE((*inertia)["facts"].contains("range"));
}

TEST(ExplainCommand, DescribesEveryActionModeAndEndReason) {
  const auto check_actions = [](const google::protobuf::Descriptor* message) {
    for (int i = 0; i < message->field_count(); ++i) {
      const json* entry = find_entry("action", message->field(i)->name());
      ASSERT_NE(entry, nullptr) << message->field(i)->name();
      EXPECT_TRUE((*entry)["facts"].contains("does")) << message->field(i)->name();
      if (message->name() == "PlayerAction") {
        EXPECT_TRUE((*entry)["facts"].contains("ends in")) << message->field(i)->name();
      }
    }
  };
  check_actions(protos::PlayerAction::descriptor());
  check_actions(protos::CoachAction::descriptor());

  check_actions(protos::TrainerAction::descriptor());
  const auto* modes = protos::GameModeType_descriptor();
  for (int i = 0; i < modes->value_count(); ++i) {
    const json* entry = find_entry("play mode", modes->value(i)->name());
    ASSERT_NE(entry, nullptr) << modes->value(i)->name();
    EXPECT_NE((*entry)["text"], "") << modes->value(i)->name();
  }

  for (const char* reason : {"finished", "crashed", "stalled", "late", "refused", "protocol_error",
                             "server_failed", "timed_out", "interrupted"}) {
    const json* entry = find_entry("end reason", reason);
    ASSERT_NE(entry, nullptr) << reason;
    EXPECT_NE((*entry)["text"], "") << reason;
  }
}

TEST(ExplainCommand, FindsFullNamesLastPartsAndOtherSpellings) {
  EXPECT_THAT(
      explain({"Self.stamina"}),
      Prints(0, testing::AllOf(HasSubstr("Self.stamina (field of Self)"), HasSubstr("0 to 8000"))));
  EXPECT_THAT(explain({"offside_line_x"}).out, HasSubstr("WorldModel.offside_line_x"));
  EXPECT_THAT(explain({"kick-in"}).out, HasSubstr("KickIn_ (play mode"));
  const CommandResult several = explain({"stalled", "body_smart_kick"});
  EXPECT_THAT(several.out, HasSubstr("stalled (end reason)"));
  EXPECT_THAT(several.out, HasSubstr("fails when  speed out of reach"));
}

TEST(ExplainCommand, FindsNamesAsLanguagesWriteThem) {
  for (const char* name : {"GameModeType.KickIn", "GameModeType_KickIn_", "GameModeType::KickIn"}) {
    EXPECT_THAT(explain({name}).out, HasSubstr("KickIn_ (play mode")) << name;
  }
  EXPECT_THAT(explain({"LoggerLevel.Team"}).out, HasSubstr("TEAM (value of LoggerLevel)"));
  EXPECT_THAT(explain({"PlayerAction.BodySmartKick"}).out,
              HasSubstr("body_smart_kick (action of a player)"));
  EXPECT_THAT(explain({"Self.IsKickable"}).out, HasSubstr("Self.is_kickable (field of Self)"));
  EXPECT_EQ(explain({"GameModeType.Stamina"}).exit_code, 2);
}

TEST(ExplainCommand, SearchesNamesAndExplanations) {
  EXPECT_THAT(
      explain({"--search", "offside LINE"}),
      Prints(0, testing::AllOf(HasSubstr("WorldModel.offside_line_x"),
                               HasSubstr("OffsideLineMessage"), Not(HasSubstr("Self.stamina")))));
  const CommandResult nothing = explain({"--search", "croquet"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_EQ(nothing.err, "cls: nothing explains 'croquet'\n");
}

TEST(ExplainCommand, FindsWordsOfProjectsAndPartsOfNames) {
  EXPECT_THAT(explain({"smart_kick"}), Prints(0, HasSubstr("body_smart_kick (action")));
  EXPECT_THAT(explain({"plan_attack"}), Prints(0, HasSubstr("helios_offensive_planner (action")));

  EXPECT_THAT(explain({"shoot"}), Prints(0, HasSubstr("helios_shoot (action")));

  std::istringstream lines(read_file(source_folder() / "examples/python/actions.py"));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("def ") || line.starts_with("def _")) continue;
    const std::string name = line.substr(4, line.find('(') - 4);
    EXPECT_EQ(explain({name}).exit_code, 0) << name;
  }
}

// The labels in the first column of a table, whose lines begin with `indent`.
std::set<std::string> first_column(const std::string& table, const std::string& indent) {
  std::set<std::string> labels;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = indent.size();
    if (!line.starts_with(indent) || line.size() <= begin || line[begin] == ' ') continue;
    labels.insert(line.substr(begin, line.find("  ", begin) - begin));
  }
  return labels;
}

// The text between two others.
std::string between(const std::string& text, const std::string& first, const std::string& last) {
  const std::size_t begin = text.find(first);
  return begin == std::string::npos ? "" : text.substr(begin, text.find(last, begin) - begin);
}

TEST(ExplainCommand, KnowsEveryRowOfTheTables) {
  const TemporaryFolder folder;
  const CommandResult played = run({cls_binary(), "match", "mock:hold", "mock:hold", "--mode",
                                    "synch", "--cycles", "30", "--dir", folder.path() / "m"});
  const auto rows = first_column(between(played.out, "  playmaker", "\n\n"), "  ");
  ASSERT_GE(rows.size(), 14U) << played.out;
  for (const std::string& row : rows) {
    EXPECT_THAT(explain({row}).out, HasSubstr("cls match")) << row;
  }

  const std::string stats = run({cls_binary(), "stats", folder.path() / "m"}).out;
  const auto figures = first_column(between(stats, "possession", "\n\n"), "");
  ASSERT_GE(figures.size(), 25U) << stats;
  for (const std::string& row : figures) {
    const bool has_picture = row == "formation";
    EXPECT_THAT(explain({has_picture ? "summary" : row}).out, HasSubstr("cls stats")) << row;
  }

  const std::string summary = explain({"summary"}).out;
  std::istringstream headings(between(stats, "player  ", "\n") + " " +
                              between(stats.substr(stats.rfind("player  ")), "player", "\n"));
  int columns = 0;
  for (std::string heading; headings >> heading; ++columns) {
    EXPECT_TRUE(heading == "player" || summary.find(heading) != std::string::npos) << heading;
  }
  EXPECT_GE(columns, 13);
}

TEST(ExplainCommand, ExplainsRowsBesideNames) {
  EXPECT_THAT(explain({"missed"}), Prints(0, HasSubstr("without a usable reply")));
  EXPECT_THAT(explain({"rpc p50"}), Prints(0, HasSubstr("median player")));
  const std::string both = explain({"kick"}).out;
  EXPECT_THAT(both, HasSubstr("kick (action"));
  EXPECT_THAT(both, HasSubstr("kick commands sent"));

  const auto document = base::Json::parse(explain({"kick", "missed", "--json"}).out);
  EXPECT_EQ(document["entries"].size(), 1U);
  ASSERT_EQ(document["rows"].size(), 2U);
  EXPECT_EQ(document["rows"][1]["row"], "missed (late)");
}

// Long names and types leave no room for a column of meanings.
TEST(ExplainCommand, PutsMeaningsBelowLongNames) {
  EXPECT_THAT(explain({"WorldModel"}).out,
              HasSubstr("  intercept_table, InterceptTable\n      who reaches the ball when\n"));
  EXPECT_THAT(explain({"Ball"}).out, HasSubstr("name               type "));
}

TEST(ExplainCommand, SuggestsNamesForTypos) {
  EXPECT_THAT(explain({"body_smart_kik"}),
              Exits(2, "cls: unknown name 'body_smart_kik'; did you mean 'body_smart_kick'?\n"));
  EXPECT_THAT(explain({}).err, HasSubstr("cls explain --list"));
}

TEST(ExplainCommand, WritesThePagesOfTheReference) {
  const TemporaryFolder folder;
  ASSERT_EQ(explain({"--export", folder.path()}).exit_code, 0);
  for (const char* page : {"README.md", "messages.md", "actions.md", "parameters.md", "modes.md"}) {
    EXPECT_TRUE(read_file(folder.path() / page) ==
                read_file(source_folder() / "docs/reference" / page))
        << page << ": cls explain --export docs/reference";
  }
}

TEST(ExplainCommand, NamesThePlaceInThePages) {
  std::map<std::string, std::set<std::string>> anchors;
  for (const char* page : {"messages.md", "actions.md", "parameters.md", "modes.md"}) {
    std::istringstream lines(read_file(source_folder() / "docs/reference" / page));
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("##")) continue;
      std::string heading = line.substr(line.find(' ') + 1);
      for (char& c : heading) c = c == ' ' ? '-' : static_cast<char>(std::tolower(c));
      anchors[page].insert(heading);
    }
  }

  for (const json& entry : all_entries()) {
    const auto place = entry["page"].get<std::string>();
    const std::size_t mark = place.find('#');
    ASSERT_NE(mark, std::string::npos) << place;
    EXPECT_EQ(anchors[place.substr(0, mark)].count(place.substr(mark + 1)), 1U)
        << entry["name"] << ": " << place;
  }

  EXPECT_THAT(explain({"Self.stamina"}).out, HasSubstr("docs/reference/messages.md#self"));
}

TEST(ExplainCommand, DrawsFormations) {
  const CommandResult drawn = run({cls_binary(), "explain", "formation"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_THAT(drawn.out, HasSubstr("normal-formation, ball at 0, 0"));
  for (const char* player : {"1", "9", "A", "B", "●"}) EXPECT_THAT(drawn.out, HasSubstr(player));

  TemporaryFolder folder;
  const std::string svg = folder.path() / "offense.svg";
  const CommandResult written =
      run({cls_binary(), "explain", "formation", "offense", "--ball=20,-10", "--svg", svg});
  EXPECT_EQ(written.out, svg + "\n") << written.err;
  const std::string text = read_file(svg);
  EXPECT_THAT(text, HasSubstr("offense-formation, ball at 20, -10"));
  EXPECT_THAT(text, HasSubstr(">11</text>"));

  std::ofstream(folder.path() / "own.formation") << "cls-formation 1\nball 0 0\n  1 -50 0\n";
  EXPECT_THAT(run({cls_binary(), "explain", "formation", folder.path() / "own.formation"}),
              Exits(2, HasSubstr("own.formation:")));
  EXPECT_EQ(run({cls_binary(), "explain", "formation", "--ball", "20"}).err,
            "cls: --ball '20': must be X,Y in meters, such as --ball=-20,5\n");
}

}  // namespace
}  // namespace cls::tests
