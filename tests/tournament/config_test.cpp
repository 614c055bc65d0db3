// cls.toml: parsing, validation, error messages and plan differences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "match/terms/match_options.h"
#include "tests/support/temporary_folder.h"
#include "tournament/config/config.h"
#include "tournament/config/config_file.h"
#include "tournament/config/config_keys.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kWhole = R"([tournament]
format = "gauntlet"
gauntlet = ["NEW"]
rounds = 50
seed = 9
cycles = 600
concurrency = 3
on_crash = "rerun"
time_limit = 90
max_memory = "2G"
max_cpu = 600

[server]
kick_off_wait = 3
wind_none = true

[teams.OLD]
endpoint = "mock"

[teams.NEW]
endpoint = "localhost:50051"
)";

TEST(Config, ReadsTeamsInFileOrder) {
  const ParsedConfig parsed = parse_config(kWhole, "cls.toml");
  EXPECT_TRUE(parsed.errors.empty()) << parsed.errors.front();

  const TournamentConfig& config = parsed.config;
  EXPECT_EQ(config.competition.format, Format::kGauntlet);
  EXPECT_EQ(config.competition.gauntlet, std::vector<std::string>{"NEW"});
  EXPECT_EQ(config.competition.rounds, 50);
  EXPECT_EQ(config.competition.seed, 9u);
  EXPECT_EQ(config.execution.concurrency, 3);
  EXPECT_EQ(config.execution.on_crash, OnCrash::kRerun);

  const match::MatchOptions options = match_options(config.conditions);
  EXPECT_EQ(options.time_limit_s, 90.0);
  EXPECT_EQ(options.limits.memory, 2ULL << 30);
  EXPECT_EQ(options.limits.cpu_seconds, 600);
  EXPECT_EQ(
      config.conditions.settings,
      (std::vector<ServerSetting>{{"server::kick_off_wait", "3"}, {"server::wind_none", "true"}}));
  EXPECT_EQ(config.competition.teams,
            (std::vector<TeamEntry>{{"OLD", "mock"}, {"NEW", "localhost:50051"}}));
  EXPECT_TRUE(validate(config).empty());
}

TEST(Config, ReportsEveryErrorWithItsLine) {
  const ParsedConfig parsed = parse_config(R"([tournament]
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

  EXPECT_EQ(parsed.errors,
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
                      const auto errors =
                          parse_config("[teams.A]\nendpoint = \"moc\"\n", "").errors;
                      return errors.at(0).substr(errors.at(0).find("unknown"));
                    }(),
                "f.toml:19: unknown table 'tournment'; did you mean 'tournament'?"}));
}

TEST(Config, ReportsTomlSyntaxErrorsWithTheirLine) {
  const ParsedConfig parsed = parse_config("[tournament]\nrounds = \n", "f.toml");
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_EQ(parsed.errors[0].rfind("f.toml:2: ", 0), 0u) << parsed.errors[0];
}

TEST(Config, SuggestsTablesOfTeams) {
  const ParsedConfig parsed = parse_config("[teams]\nRED = \"mock\"\n", "cls.toml");
  ASSERT_EQ(parsed.errors.size(), 1u);
  EXPECT_EQ(parsed.errors[0], "cls.toml:2: 'RED' must be a table, [teams.RED] with an endpoint");
}

// toml++ recurses into the parts of a key.
TEST(Config, RejectsKeysOfTooManyParts) {
  std::string key = "a";
  for (int i = 0; i < 50'000; ++i) key += ".a";
  for (const std::string& text : {"\n" + key + " = 1\n", "\n[" + key + "]\n"}) {
    const ParsedConfig parsed = parse_config(text, "cls.toml");
    ASSERT_EQ(parsed.errors.size(), 1u);
    EXPECT_EQ(parsed.errors[0], "cls.toml:2: a key of more than 1000 parts");
  }
}

TEST(Config, RejectsSchedulesThatFillTheMemory) {
  TournamentConfig config;
  for (int i = 0; i < 1001; ++i)
    config.competition.teams.push_back({"T" + std::to_string(i), "mock"});
  EXPECT_EQ(validate(config).at(0), "a tournament has at most 1000 teams, there are 1001");
  config.competition.teams.resize(1000);
  EXPECT_TRUE(validate(config).empty());
  config.competition.rounds = 1'000'000;
  EXPECT_THAT(validate(config).at(0), HasSubstr("at most 1000000 are possible"));
}

TEST(Config, RejectsContradictions) {
  TournamentConfig config = parse_config(kWhole, "").config;
  config.competition.gauntlet = {"NEWW"};
  EXPECT_EQ(validate(config),
            std::vector<std::string>{"gauntlet: unknown team 'NEWW'; did you mean 'NEW'?"});

  config = parse_config(kWhole, "").config;
  config.competition.teams.pop_back();
  config.competition.format = Format::kList;
  config.competition.matches = {{"OLD", "OLD"}};

  EXPECT_EQ(validate(config).size(), 3u);  // one team, no such subject, against itself
  config = parse_config(kWhole, "").config;

  config.competition.format = Format::kGroups;
  EXPECT_EQ(validate(config).size(), 2u);  // too few teams for two groups, and to advance
  config = parse_config(kWhole, "").config;

  config.conditions.options["mode"] = "lokstep";
  EXPECT_EQ(validate(config),
            std::vector<std::string>{"--mode 'lokstep': did you mean 'lockstep'?"});

  config.conditions.options.clear();
  config.conditions.options["server"] = "rcsserver";
  EXPECT_EQ(validate(config).size(), 1u);
}

TEST(Config, FormattedTextParsesToTheSameConfig) {
  const TournamentConfig before = parse_config(kWhole, "").config;
  const std::string text = format_config(before);
  const ParsedConfig reparsed = parse_config(text, "");
  EXPECT_TRUE(reparsed.errors.empty()) << reparsed.errors.front();
  EXPECT_EQ(format_config(reparsed.config), text);
  EXPECT_EQ(first_difference(reparsed.config, before), "");
}

// The text of the command line, as TOML in the configuration; else the error.
std::string value_of(std::string_view key, std::string_view text) {
  TournamentConfig config;
  const ConfigKey& row = *find_key(key);
  const auto parsed = row.parse(config, row.read(text));
  return parsed ? row.format(config) : parsed.error().message;
}

TEST(Config, TextsOfTheCommandLineMayLookLikeNumbers) {
  for (const char* key : {"name", "folder", "remote_shell", "remote_folder", "on_event",
                          "on_match_finish", "on_finish"}) {
    for (const std::string text : {"2026", "true", "2026.5", "-1", "1e3"}) {
      EXPECT_EQ(value_of(key, text), "\"" + text + "\"") << key;
    }
  }
  for (const ConfigKey& key : tournament_keys()) {
    EXPECT_THAT(value_of(key.name, "2026"), Not(HasSubstr("must be a string"))) << key.name;
    EXPECT_THAT(value_of(key.name, "2026"), Not(HasSubstr("must be a list"))) << key.name;
  }
}

TEST(Config, EachRowReadsTheTextsOfItsType) {
  EXPECT_EQ(value_of("rounds", "2026"), "2026");
  EXPECT_EQ(value_of("rounds", "2026.5"), "must be a whole number from 1 to 1000000");
  EXPECT_EQ(value_of("slot_minutes", "20"), "20");
  EXPECT_EQ(value_of("slot_minutes", "12.5"), "12.5");
  EXPECT_EQ(value_of("pin", "true"), "true");
  EXPECT_EQ(value_of("pin", "1"), "must be true or false");
  EXPECT_EQ(value_of("concurrency", "auto"), "\"auto\"");
  EXPECT_EQ(value_of("concurrency", "4"), "4");
  EXPECT_EQ(value_of("gauntlet", "2026,true"), "[\"2026\", \"true\"]");
  EXPECT_EQ(value_of("matches", "A:B,C:D"), "[[\"A\", \"B\"], [\"C\", \"D\"]]");
  EXPECT_EQ(value_of("cycles", "600"), "600");
}

// The plan of a tournament is read again by each of its matches.
TEST(Config, FlagsMayHaveWords) {
  EXPECT_EQ(value_of("sandbox", "false"), "false");
  EXPECT_EQ(value_of("sandbox", "namespaces"), "\"namespaces\"");
  EXPECT_EQ(value_of("sandbox", "network"), "must be true, false, files or namespaces");

  const ParsedConfig parsed = parse_config("[tournament]\nsandbox = \"files\"\n", "");
  EXPECT_TRUE(parsed.errors.empty());
  const ParsedConfig again = parse_config(format_config(parsed.config), "");
  EXPECT_TRUE(again.errors.empty());
  EXPECT_EQ(match_options(again.config.conditions).sandbox, match::Sandbox::kFiles);
}

TEST(Config, OptionsForSlurmAreWordsOfAShell) {
  EXPECT_EQ(value_of("slurm_options", "--a=b  --c "), "[\"--a=b\", \"--c\"]");
  EXPECT_EQ(value_of("slurm_options", "--comment='two  words' -x"),
            "[\"--comment=two  words\", \"-x\"]");
  EXPECT_EQ(value_of("slurm_options", "'--a=b c' --d=\"e f\" --g=h\\ i"),
            "[\"--a=b c\", \"--d=e f\", \"--g=h i\"]");
  EXPECT_EQ(value_of("slurm_options", "--a='b"),
            "must be a list of options, [\"--partition=short\", ...]");
  EXPECT_EQ(value_of("slurm_options", "short"),
            "'short': sbatch options must have the form --name=value");
}

TEST(Config, NamesFirstDifferenceOfTwoPlans) {
  const TournamentConfig before = parse_config(kWhole, "").config;
  TournamentConfig now = before;
  now.execution.concurrency = 7;
  now.execution.on_crash = OnCrash::kStop;

  EXPECT_EQ(first_difference(now, before), "") << "execution is not part of the plan";

  now.competition.rounds = 51;
  now.conditions.options.erase("cycles");
  EXPECT_EQ(first_difference(now, before), "rounds is 51, was 50");

  now = before;
  now.conditions.options.erase("cycles");
  EXPECT_EQ(first_difference(now, before), "cycles is not set, was 600");

  now = before;
  now.competition.teams[1].endpoint = "mock:hold";
  EXPECT_EQ(first_difference(now, before),
            "[teams.\"NEW\"] endpoint is \"mock:hold\", was \"localhost:50051\"");

  now = before;
  now.competition.teams.push_back({"THIRD", "mock"});
  EXPECT_EQ(first_difference(now, before), "[teams.\"THIRD\"] endpoint is \"mock\", was not set");

  now = before;
  std::swap(now.competition.teams[0], now.competition.teams[1]);
  EXPECT_EQ(first_difference(now, before), "[teams.\"NEW\"] is at another position");
}

TEST(Config, CommentedFileHasEveryKeyAndIsValid) {
  const std::string text = commented_config();
  for (const ConfigKey& key : tournament_keys()) {
    EXPECT_THAT(text, HasSubstr(std::string(key.name) + " = ")) << key.name;
  }
  const ParsedConfig parsed = parse_config(text, "cls.toml");

  EXPECT_TRUE(parsed.errors.empty()) << parsed.errors.front();
  EXPECT_TRUE(validate(parsed.config).empty());

  // It still parses with all commented defaults and examples enabled.
  std::string all = text;
  for (const ConfigKey& key : tournament_keys()) {
    const std::string commented = "\n#" + std::string(key.name) + " = ";
    if (const std::size_t at = all.find(commented); at != std::string::npos) all.erase(at + 1, 1);
  }
  const ParsedConfig everything = parse_config(all, "cls.toml");

  EXPECT_TRUE(everything.errors.empty()) << everything.errors.front();
}

TEST(Config, IsFoundInParentFolderAndStoresItsFolder) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "cls.toml") << kWhole;
  std::filesystem::create_directories(folder.path() / "a" / "b");
  const auto found = find_config(folder.path() / "a" / "b");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, folder.path() / "cls.toml");
  EXPECT_EQ(read_config(*found).config.execution.folder, folder.path());
}

TEST(Config, ResolvesEndpointsRelativeToItsFolder) {
  EXPECT_EQ(endpoint_from("/some where", "run:./go {port}"), "run:cd '/some where' && ./go {port}");
  EXPECT_EQ(endpoint_from("/some where", "each:run:./go {port}"),
            "each:run:cd '/some where' && ./go {port}");
  EXPECT_EQ(endpoint_from("/a", "team:teams/x"), "team:/a/teams/x");
  EXPECT_EQ(endpoint_from("/a", "team:/b"), "team:/b");
  EXPECT_EQ(endpoint_from("/a", "mock:x.json"), "mock:/a/x.json");
  EXPECT_EQ(endpoint_from("/a", "mock:hold"), "mock:hold");
  EXPECT_EQ(endpoint_from("/a", "host:1"), "host:1");
  EXPECT_EQ(endpoint_from("/a", "planner:p.toml=mock:x.json"), "planner:/a/p.toml=mock:/a/x.json");
  EXPECT_EQ(endpoint_from("/a", "planner:/b/p.toml=mock"), "planner:/b/p.toml=mock");
  EXPECT_EQ(endpoint_from(std::filesystem::current_path(), "run:./go {port}"), "run:./go {port}");
}

}  // namespace
}  // namespace cls::tournament
