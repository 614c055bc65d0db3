// Settings of matches: cls.toml, options, where each comes from, and what takes effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using json = base::Json;
using Arguments = std::vector<std::string>;

constexpr const char* kConfig =
    "[tournament]\n"
    "cycles = 8\n"
    "seed = 5\n"
    "half_time = 4\n"
    "[server]\n"
    "kick_off_wait = 3\n"
    "[teams.RED]\n"
    "endpoint = \"mock:hold\"\n"
    "[teams.BLUE]\n"
    "endpoint = \"mock:hold\"\n";

class Settings : public testing::Test, public ClsFolder {
 protected:
  Settings() { write("cls.toml", kConfig); }

  // A match of a few cycles into the folder `name`.
  CommandResult play(const std::string& name, const Arguments& settings) {
    Arguments all = {"match",  "mock:hold", "mock:hold",
                     "--seed", "7",         "--cycles",
                     "20",     "--set",     "server::kick_off_wait=3",
                     "--dir",  name};
    for (const std::string& setting : settings) {
      all.push_back("--set");
      all.push_back(setting);
    }
    return run(all);
  }
  json document(const std::string& file) const { return json::parse(read_file(path(file))); }
  json config(Arguments arguments) {
    arguments.insert(arguments.begin(), "config");
    arguments.push_back("--json");
    const CommandResult printed = run(arguments);
    EXPECT_EQ(printed.exit_code, 0) << printed.err;
    json rows;
    const json settings = json::parse(printed.out)["settings"];
    for (const json& row : settings) rows[row["name"].get<std::string>()] = row;
    return rows;
  }
};

TEST_F(Settings, MissingFileIsError) {
  for (const char* command : {"match", "config"}) {
    EXPECT_THAT(run({command, "mock", "mock", "--config", "nope.toml"}),
                Exits(66, "cls: --config nope.toml: no such file\n"));
  }
}

TEST_F(Settings, NamesBringSettingsOfTheirFile) {
  ASSERT_EQ(run({"match", "RED", "BLUE", "--dir", "x"}).exit_code, 0);
  const json result = document("x/result.json");
  EXPECT_EQ(result["cycles"], 8);
  EXPECT_EQ(result["seed"], 5);
  const json settings = document("x/manifest.json")["settings"];
  EXPECT_EQ(settings["server::half_time"], 4);
  EXPECT_EQ(settings["server::kick_off_wait"], 3);
}

TEST_F(Settings, OptionsOverrideFile) {
  ASSERT_THAT(run({"match", "RED", "BLUE", "--cycles", "5", "--half-time", "9", "--set",
                   "server::kick_off_wait=4", "--dir", "x"}),
              Exits(0));
  EXPECT_EQ(document("x/result.json")["cycles"], 5);
  const json settings = document("x/manifest.json")["settings"];
  EXPECT_EQ(settings["server::half_time"], 9);
  EXPECT_EQ(settings["server::kick_off_wait"], 4);
}

TEST_F(Settings, FileCountsOnlyIfNamed) {
  EXPECT_EQ(config({"mock", "mock"})["cycles"]["origin"], "default");
  const json named = config({"mock", "mock", "--config", "cls.toml"});
  EXPECT_EQ(named["cycles"]["value"], "8");
  EXPECT_EQ(named["cycles"]["origin"], "cls.toml:2");
}

TEST_F(Settings, ConfigNamesOriginOfEachValue) {
  const json rows = config({"RED", "BLUE", "--seed", "7", "--rpc-deadline", "500"});
  EXPECT_EQ(rows["left"]["value"], "mock:hold");
  EXPECT_EQ(rows["left"]["origin"], "argument LEFT");
  EXPECT_EQ(rows["seed"]["value"], "7");
  EXPECT_EQ(rows["seed"]["origin"], "option --seed");
  EXPECT_EQ(rows["rpc_deadline"]["origin"], "option --rpc-deadline");
  EXPECT_EQ(rows["server::half_time"]["origin"], "cls.toml:4");
  EXPECT_EQ(rows["server::kick_off_wait"]["value"], "3");
  EXPECT_EQ(rows["server::kick_off_wait"]["origin"], "cls.toml:6");
  EXPECT_EQ(rows["server::ball_decay"]["origin"], "default");
  EXPECT_EQ(rows["time_limit"]["value"], nullptr);
}

TEST_F(Settings, ConfigHasRowsOfOptionsThatTheFileLacks) {
  const json rows = config({"--rated", "--pin", "--save-at", "30", "saved", "--tls-name", "host"});
  EXPECT_EQ(rows["rated"]["value"], "true");
  EXPECT_EQ(rows["rated"]["origin"], "option --rated");
  EXPECT_EQ(rows["own_names"]["value"], "false");
  EXPECT_EQ(rows["own_names"]["origin"], "default");
  EXPECT_EQ(rows["save_at"]["value"], "30 saved");
  EXPECT_EQ(rows["tls_name"]["origin"], "option --tls-name");
  EXPECT_TRUE(rows["resume"]["value"].is_null());
  EXPECT_EQ(config({"RED", "BLUE"})["own_names"]["origin"], "team of cls.toml");
}

TEST_F(Settings, NoDeadlineLeavesNoDeadline) {
  const json rows = config({"--no-deadline"});
  EXPECT_EQ(rows["no_deadline"]["origin"], "option --no-deadline");
  EXPECT_TRUE(rows["rpc_deadline"]["value"].is_null());
  EXPECT_EQ(rows["rpc_deadline"]["origin"], "option --no-deadline");
}

TEST_F(Settings, LimitsOfProcessesAreReadFromFileAndOptions) {
  write("limits.toml", "[tournament]\nmax_memory = \"2G\"\nmax_cpu = 600\n");
  const json rows = config({"mock", "mock", "--config", "limits.toml", "--max-cpu", "5"});
  EXPECT_EQ(rows["max_memory"]["value"], "2G");
  EXPECT_EQ(rows["max_memory"]["origin"], "limits.toml:2");
  EXPECT_EQ(rows["max_cpu"]["value"], "5");
  EXPECT_EQ(rows["max_cpu"]["origin"], "option --max-cpu");
  EXPECT_EQ(run({"match", "mock", "mock", "--max-memory", "2000"}).err,
            "cls: --max-memory '2000': must be a size such as 512M or 2G\n");
}

TEST_F(Settings, DryRunShowsOrigins) {
  EXPECT_THAT(run({"match", "RED", "BLUE", "--dry-run", "--seed", "7"}),
              Prints(0, testing::AllOf(HasSubstr("# cycles = 8 (cls.toml:2)\n"),
                                       HasSubstr("# seed = 7 (option --seed)\n"))));
}

TEST_F(Settings, RefusesParametersThatTheMatchDecides) {
  EXPECT_THAT(play("x", {"server::port=7000"}),
              Exits(2,
                    "cls: --set: server::port has no effect in a match: cls chooses the ports; "
                    "--monitor-port N sets that of monitors\n"));
  write("bad.toml", "[server]\ngame_log_dir = \"logs\"\n");
  EXPECT_THAT(
      run({"match", "mock", "mock", "--config", "bad.toml"}),
      Exits(78,
            "cls: bad.toml:2: server::game_log_dir has no effect in a match: logs go to the match "
            "folder; use --dir\n"));
}

TEST_F(Settings, WarnsOfParametersWithoutEffect) {
  ASSERT_EQ(play("x", {"server::profile=on", "server::recv_step=20"}).exit_code, 0);
  EXPECT_EQ(document("x/result.json")["warnings"],
            json({"server::profile has no effect on the embedded server",
                  "server::recv_step has no effect on the embedded server in lockstep"}));
}

TEST_F(Settings, InvalidSeedsAreErrors) {
  for (const char* seed : {"-1", "99999999999999999999999", "1.5"}) {
    EXPECT_EQ(run({"match", "mock", "mock", "--seed", seed}).exit_code, 2) << seed;
    write("seed.toml", std::string("[tournament]\nseed = ") + seed + "\n");
    EXPECT_EQ(run({"match", "mock", "mock", "--config", "seed.toml"}).exit_code, 78) << seed;
  }
}

TEST_F(Settings, CompressedLogsHoldBytesOfPlainOnes) {
  ASSERT_EQ(play("plain", {}).exit_code, 0);
  ASSERT_THAT(play("packed", {"server::game_log_compression=6", "server::text_log_compression=1"}),
              Exits(0));
  EXPECT_EQ(document("packed/result.json")["log_files"],
            json({{"rcg", "match.rcg.gz"}, {"rcl", "match.rcl.gz"}}));
  EXPECT_FALSE(fs::exists(path("packed/match.rcg")));
  EXPECT_LT(fs::file_size(path("packed/match.rcg.gz")), fs::file_size(path("plain/match.rcg")));
  EXPECT_EQ(read_file(path("packed/match.rcg.gz")), read_file(path("plain/match.rcg")));
  EXPECT_EQ(read_file(path("packed/match.rcl.gz")), read_file(path("plain/match.rcl")));
  const CommandResult results = run({"results", "packed", "--json"});
  EXPECT_EQ(results.exit_code, 0) << results.err;
  EXPECT_EQ(json::parse(results.out)["matches"][0]["end_reason"], "finished");
}

TEST_F(Settings, GameLogHasRequestedVersion) {
  for (const auto& [version, begin] : {std::pair("4", "ULG4"), std::pair("5", "ULG5"),
                                       std::pair("3", "ULG\3"), std::pair("-1", "[")}) {
    const std::string name = std::string("v") + version;
    ASSERT_EQ(play(name, {std::string("server::game_log_version=") + version}).exit_code, 0);
    EXPECT_TRUE(read_file(path(name + "/match.rcg")).starts_with(begin)) << version;
    EXPECT_EQ(run({"results", name}).exit_code, 0) << version;
  }
  EXPECT_THAT(play("v7", {"server::game_log_version=7"}),
              Exits(2, "cls: server::game_log_version=7: must be 1 to 6, or -1 (JSON)\n"));
}

TEST_F(Settings, LogsOfServersOverUdpAreConverted) {
  ASSERT_THAT(
      run({"match", "mock:hold", "mock:hold", "--mode", "synch", "--cycles", "10", "--set",
           "server::game_log_version=5", "--set", "server::game_log_compression=9", "--dir", "x"}),
      Exits(0));
  EXPECT_EQ(document("x/result.json")["log_files"],
            json({{"rcg", "match.rcg.gz"}, {"rcl", "match.rcl"}}));
  EXPECT_TRUE(read_file(path("x/match.rcg.gz")).starts_with("ULG5"));
  EXPECT_FALSE(fs::exists(path("x/match.rcg")));
}

TEST_F(Settings, SwitchedOffLogsAreNotWritten) {
  ASSERT_EQ(play("x", {"server::text_logging=off"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("x/match.rcl")));
  EXPECT_EQ(document("x/result.json")["log_files"]["rcl"], nullptr);
  EXPECT_EQ(document("x/result.json")["log_files"]["rcg"], "match.rcg");
}

TEST_F(Settings, ManifestSaysHowWhereAndWithWhat) {
  ASSERT_EQ(run({"match", "RED", "BLUE", "--dir", "x"}).exit_code, 0);
  const json manifest = document("x/manifest.json");
  EXPECT_EQ(manifest["command"],
            json({cls_binary().string(), "match", "RED", "BLUE", "--dir", "x"}));
  for (const char* part : {"cls", "wire", "protobuf", "grpc", "compiler", "server"}) {
    EXPECT_FALSE(manifest["versions"][part].get<std::string>().empty()) << part;
  }
  EXPECT_GT(manifest["machine"]["cores"], 0);
  EXPECT_GT(manifest["machine"]["memory_bytes"], 1'000'000);
  EXPECT_TRUE(manifest["machine"]["kernel"].get<std::string>().starts_with("Linux "));
  EXPECT_TRUE(manifest["environment"].is_object());
  EXPECT_GE(manifest["ended"].get<std::string>(), manifest["started"].get<std::string>());
}

TEST_F(Settings, ResultsKnowWhenTheMatchBegan) {
  ASSERT_EQ(run({"match", "RED", "BLUE", "--dir", "x"}).exit_code, 0);
  const json listed = json::parse(run({"results", "x", "--json"}).out);
  const auto date = listed["matches"][0]["date"].get<std::string>();
  EXPECT_EQ(date.size(), 12u);
  EXPECT_GT(date, "2020");
}

}  // namespace
}  // namespace cls::tests
