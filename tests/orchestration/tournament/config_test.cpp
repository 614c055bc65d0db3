// cls.toml: what is read, and how mistakes are told.
#include <gtest/gtest.h>

#include <fstream>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/config/config_file.h"
#include "orchestration/tournament/config/config_keys.h"
#include "tests/support/temporary_folder.h"

namespace cls::orchestration::tournament {
namespace {

constexpr const char* kWhole = R"([tournament]
format = "gauntlet"
gauntlet = ["NEW"]
rounds = 50
seed = 9
cycles = 600
concurrency = 3
on_crash = "rerun"
time_limit = 90

[server]
kick_off_wait = 3
wind_none = true

[teams.OLD]
endpoint = "mock"

[teams.NEW]
endpoint = "localhost:50051"
)";

TEST(Config, IsReadWithTeamsInTheOrderOfTheFile) {
  const ConfigReading reading = parse_config(kWhole, "cls.toml");
  EXPECT_TRUE(reading.mistakes.empty()) << reading.mistakes.front();
  const TournamentConfig& config = reading.config;
  EXPECT_EQ(config.format, Format::kGauntlet);
  EXPECT_EQ(config.gauntlet, std::vector<std::string>{"NEW"});
  EXPECT_EQ(config.rounds, 50);
  EXPECT_EQ(config.seed, 9u);
  EXPECT_EQ(config.concurrency, 3);
  EXPECT_EQ(config.on_crash, OnCrash::kRerun);
  EXPECT_EQ(config.time_limit_s, 90.0);
  EXPECT_EQ(config.settings, (std::vector<ServerSetting>{{"server::kick_off_wait", "3"},
                                                         {"server::wind_none", "true"}}));
  EXPECT_EQ(config.teams, (std::vector<TeamEntry>{{"OLD", "mock"}, {"NEW", "localhost:50051"}}));
  EXPECT_TRUE(mistakes_in(config).empty());
}

TEST(Config, TellsEveryMistakeWithItsLine) {
  const ConfigReading reading = parse_config(R"([tournament]
ronds = 3
format = "round-robbin"
seed = -1
concurrency = "many"
tie_breakers = ["goal"]
swap_sides = 1

[server]
half_tine = 3
half_time = "x"

[teams.A]
endpint = "mock"

[teams."two words"]
endpoint = "moc"

[tournment]
)",
                                             "f.toml");
  EXPECT_EQ(reading.mistakes,
            (std::vector<std::string>{
                "f.toml:2: unknown key 'ronds'; did you mean 'rounds'?",
                "f.toml:3: format: 'round-robbin': did you mean 'round-robin'?",
                "f.toml:4: seed: must be a whole number from 0",
                "f.toml:5: concurrency: must be \"auto\" or a whole number from 1 to 4096",
                "f.toml:6: tie_breakers: 'goal': did you mean 'goals'?",
                "f.toml:7: swap_sides: must be true or false",
                "f.toml:10: unknown parameter 'half_tine'; did you mean 'half_time'?",
                "f.toml:11: parameter 'half_time': 'x' is not a whole number",
                "f.toml:14: unknown key 'endpint'; did you mean 'endpoint'?",
                "f.toml:13: team 'A' has no endpoint",
                "f.toml:16: team name 'two words': only letters, digits, '-', '+' and '_'",
                "f.toml:17: " +
                    [] {
                      const auto mistakes =
                          parse_config("[teams.A]\nendpoint = \"moc\"\n", "").mistakes;
                      return mistakes.at(0).substr(mistakes.at(0).find("unknown"));
                    }(),
                "f.toml:19: unknown table 'tournment'; did you mean 'tournament'?"}));
}

TEST(Config, ThatIsNoTomlIsToldWithItsLine) {
  const ConfigReading reading = parse_config("[tournament]\nrounds = \n", "f.toml");
  ASSERT_EQ(reading.mistakes.size(), 1u);
  EXPECT_EQ(reading.mistakes[0].rfind("f.toml:2: ", 0), 0u) << reading.mistakes[0];
}

TEST(Config, ContradictionsAreFound) {
  TournamentConfig config = parse_config(kWhole, "").config;
  config.gauntlet = {"NEWW"};
  EXPECT_EQ(mistakes_in(config),
            std::vector<std::string>{"gauntlet: there is no team 'NEWW'; did you mean 'NEW'?"});
  config = parse_config(kWhole, "").config;
  config.teams.pop_back();
  config.format = Format::kList;
  config.matches = {{"OLD", "OLD"}};
  EXPECT_EQ(mistakes_in(config).size(), 3u);  // one team, no such subject, against itself
  config = parse_config(kWhole, "").config;
  config.format = Format::kGroups;
  EXPECT_EQ(mistakes_in(config).size(), 2u);  // too few teams for two groups, and to advance
}

TEST(Config, WrittenReadsBackAsTheSame) {
  const TournamentConfig before = parse_config(kWhole, "").config;
  const std::string text = config_text(before);
  const ConfigReading again = parse_config(text, "");
  EXPECT_TRUE(again.mistakes.empty()) << again.mistakes.front();
  EXPECT_EQ(config_text(again.config), text);
  EXPECT_EQ(first_difference(again.config, before), "");
}

TEST(Config, TheFirstDifferenceOfTwoPlansIsNamed) {
  const TournamentConfig before = parse_config(kWhole, "").config;
  TournamentConfig now = before;
  now.concurrency = 7;
  now.on_crash = OnCrash::kStop;
  EXPECT_EQ(first_difference(now, before), "") << "how it is carried out is no part of the plan";
  now.rounds = 51;
  now.cycles.reset();
  EXPECT_EQ(first_difference(now, before), "rounds is 51, was 50");
  now = before;
  now.cycles.reset();
  EXPECT_EQ(first_difference(now, before), "cycles is not set, was 600");
  now = before;
  now.teams[1].endpoint = "mock:hold";
  EXPECT_EQ(first_difference(now, before),
            "[teams.\"NEW\"] endpoint is \"mock:hold\", was \"localhost:50051\"");
  now = before;
  now.teams.push_back({"THIRD", "mock"});
  EXPECT_EQ(first_difference(now, before), "[teams.\"THIRD\"] endpoint is \"mock\", was not set");
  now = before;
  std::swap(now.teams[0], now.teams[1]);
  EXPECT_EQ(first_difference(now, before), "[teams.\"NEW\"] stands in another place");
}

TEST(Config, TheCommentedFileNamesEveryKeyAndIsPlayable) {
  const std::string text = commented_config();
  for (const ConfigKey& key : tournament_keys()) {
    EXPECT_NE(text.find(std::string(key.name) + " = "), std::string::npos) << key.name;
  }
  const ConfigReading reading = parse_config(text, "cls.toml");
  EXPECT_TRUE(reading.mistakes.empty()) << reading.mistakes.front();
  EXPECT_TRUE(mistakes_in(reading.config).empty());
  // With every line that shows a default or example in force, it still reads.
  std::string all = text;
  for (const ConfigKey& key : tournament_keys()) {
    const std::string commented = "\n#" + std::string(key.name) + " = ";
    if (const std::size_t at = all.find(commented); at != std::string::npos) all.erase(at + 1, 1);
  }
  const ConfigReading everything = parse_config(all, "cls.toml");
  EXPECT_TRUE(everything.mistakes.empty()) << everything.mistakes.front();
}

TEST(Config, IsFoundUpwardAndKnowsItsFolder) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "cls.toml") << kWhole;
  std::filesystem::create_directories(folder.path() / "a" / "b");
  const auto found = find_config(folder.path() / "a" / "b");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, folder.path() / "cls.toml");
  EXPECT_EQ(read_config(*found).config.folder, folder.path());
}

TEST(Config, EndpointsOfAFileElsewhereKeepTheirMeaning) {
  EXPECT_EQ(endpoint_from("/some where", "run:./go {port}"), "run:cd '/some where' && ./go {port}");
  EXPECT_EQ(endpoint_from("/a", "team:teams/x"), "team:/a/teams/x");
  EXPECT_EQ(endpoint_from("/a", "team:/b"), "team:/b");
  EXPECT_EQ(endpoint_from("/a", "mock:x.json"), "mock:/a/x.json");
  EXPECT_EQ(endpoint_from("/a", "mock:hold"), "mock:hold");
  EXPECT_EQ(endpoint_from("/a", "host:1"), "host:1");
  EXPECT_EQ(endpoint_from(std::filesystem::current_path(), "run:./go {port}"), "run:./go {port}");
}

}  // namespace
}  // namespace cls::orchestration::tournament
