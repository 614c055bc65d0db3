// SIDE arguments: parsing, errors, and team names derived from them.
#include "match/terms/endpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "match/sides/playmaker_process.h"
#include "match/terms/server_choice.h"

namespace cls::match {
namespace {

using testing::HasSubstr;

std::string error_of(std::string_view text) {
  const auto endpoint = parse_endpoint(text);
  return endpoint ? "accepted" : endpoint.error().message;
}

TEST(Endpoint, ParsesEveryForm) {
  EXPECT_EQ(parse_endpoint("mock")->kind, Endpoint::Kind::kMock);
  EXPECT_EQ(parse_endpoint("mock:hold")->behavior, "hold");

  const auto address = parse_endpoint("localhost:50051");
  EXPECT_EQ(address->kind, Endpoint::Kind::kAddress);
  EXPECT_EQ(address->host, "localhost");
  EXPECT_EQ(address->port, 50051);
  EXPECT_FALSE(address->port_step);
  EXPECT_TRUE(parse_endpoint("10.0.0.1:5000+step")->port_step);
  EXPECT_EQ(parse_endpoint("[::1]:50051")->host, "[::1]");
  EXPECT_EQ(address->tls, nullptr);

  const auto secure = parse_endpoint("tls:brain.example:443+step");
  EXPECT_EQ(secure->kind, Endpoint::Kind::kAddress);
  EXPECT_EQ(secure->text, "tls:brain.example:443+step");
  EXPECT_EQ(secure->host, "brain.example");
  EXPECT_TRUE(secure->port_step);
  EXPECT_NE(secure->tls, nullptr);
  EXPECT_EQ(target_of(*secure).tls, secure->tls);
  EXPECT_EQ(parse_endpoint("unix:/run/brain.sock")->path, "/run/brain.sock");

  const auto run = parse_endpoint("run:./brain --port {port}");
  EXPECT_EQ(run->kind, Endpoint::Kind::kRun);
  EXPECT_EQ(run->command, "./brain --port {port}");
  EXPECT_TRUE(run->starts_programs());
  EXPECT_TRUE(run->has_playmaker());

  const auto team = parse_endpoint("team:teams/helios");
  EXPECT_EQ(team->kind, Endpoint::Kind::kTeam);
  EXPECT_EQ(team->path, "teams/helios");
  EXPECT_FALSE(team->has_playmaker());
}

TEST(Endpoint, PoliciesAreSidesOfCls) {
  const auto file = parse_endpoint("policy:team/mine.policy");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->policy_file, "team/mine.policy");
  EXPECT_TRUE(file->has_policy_file());
  EXPECT_FALSE(file->is_built_in());
  EXPECT_FALSE(file->has_one_playmaker());
  EXPECT_EQ(default_team_name(*file), "mine");

  for (const char* text : {"policy:planner", "policy:random", "mock:learned"}) {
    auto built_in = parse_endpoint(text);
    ASSERT_TRUE(built_in) << text;
    EXPECT_FALSE(built_in->has_policy_file()) << text;
    EXPECT_TRUE(built_in->is_built_in()) << text;
    const auto loaded = load_files(*built_in);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(built_in->policy != nullptr) << text;
  }
  EXPECT_EQ(default_team_name(*parse_endpoint("mock:learned")), "learned");
}

TEST(Endpoint, ReportsErrorAndAllForms) {
  EXPECT_EQ(error_of("moc"),
            "unknown side 'moc'; did you mean 'mock'? (a side is mock, mock:BEHAVIOR, "
            "mock:FILE.json, HOST:PORT, HOST:PORT+step, tls:HOST:PORT, unix:PATH, "
            "run:COMMAND, team:DIR, policy:FILE, mix:AGENTS=SIDE;..., each:run:COMMAND or "
            "planner:FILE=SIDE)");
  EXPECT_THAT(error_of("brain"), HasSubstr("unknown side 'brain' (a side is"));
  EXPECT_THAT(error_of("localhost"), HasSubstr("did you mean 'localhost:50051'?"));
  EXPECT_THAT(error_of("50052"), HasSubstr("did you mean 'localhost:50052'?"));
  EXPECT_EQ(error_of("localhost:0"), "side 'localhost:0': port 0 is not within 1 to 65535");
  EXPECT_EQ(error_of("localhost:70000"),
            "side 'localhost:70000': port 70000 is not within 1 to 65535");
  EXPECT_EQ(error_of("localhost:65530+step"),
            "side 'localhost:65530+step': port 65530 is not within 1 to 65535");
  EXPECT_EQ(error_of(":50051"), "side ':50051': no host before the port");
  EXPECT_EQ(error_of("mock:"), "side 'mock:': no behavior after the colon");
  EXPECT_EQ(error_of("team:"), "side 'team:': no folder after the colon");
  EXPECT_EQ(error_of("tls:brain"), "side 'tls:brain': must be tls:HOST:PORT");
  EXPECT_EQ(error_of("run: "), "side 'run: ': no command after 'run:'");
  EXPECT_EQ(error_of("run:./brain"),
            "side 'run:./brain': the command needs {port}, the port on which the Playmaker "
            "listens (or start it yourself and use HOST:PORT)");
  EXPECT_EQ(error_of("run:./brain {prot}"),
            "side 'run:./brain {prot}': unknown placeholder {prot}; did you mean {port}?");

  for (const char* text : {"", "localhost:", "localhost:x", "localhost:5+stop", "a:5x"}) {
    EXPECT_THAT(error_of(text), HasSubstr("unknown side")) << text;
  }
}

TEST(Endpoint, RefusesHostsThatCannotBeOne) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"http://localhost:50661", "an address has no scheme; write HOST:PORT"},
      {"https://localhost:50661", "write HOST:PORT, or tls:HOST:PORT"},
      {"http://localhost:50661/", "an address has no scheme"},
      {"tls:https://localhost:50661", "an address has no scheme"},
      {"localhost :50661", "there is whitespace in the host"},
      {" localhost:50661", "there is whitespace in the host"},
      {"local/host:50661", "no host name has the character '/'"},
      {"::1:50661", "an IPv6 address stands in brackets, as in [::1]:50051"},
      {"[::1:50661", "only an IPv6 address stands in brackets"},
      {"[localhost]:50661", "only an IPv6 address stands in brackets"},
      {"[1.2.3.4]:50661", "only an IPv6 address stands in brackets"},
  };

  for (const auto& [text, problem] : mistakes) {
    const auto endpoint = parse_endpoint(text);
    ASSERT_FALSE(endpoint) << text;
    EXPECT_THAT(endpoint.error().message, testing::HasSubstr(problem));
    EXPECT_THAT(endpoint.error().message, testing::HasSubstr(text));
  }

  for (const char* text : {"[::1]:50661", "[fe80::1%eth0]:50661", "my_host-2.example.org:50661"}) {
    EXPECT_TRUE(parse_endpoint(text)) << text;
  }
  for (const char* server : {"http://localhost:6000", "[::1:6000", "local host:6000"}) {
    EXPECT_FALSE(parse_server(server)) << server;
  }
  EXPECT_EQ(parse_server("[::1]:6000")->host, "::1");
}

TEST(Endpoint, ExpandsTheTildeInPaths) {
  ASSERT_NE(std::getenv("HOME"), nullptr);
  const std::string home = std::getenv("HOME");
  EXPECT_EQ(parse_endpoint("team:~/x")->path, home + "/x");
  EXPECT_EQ(parse_endpoint("unix:~/x.sock")->path, home + "/x.sock");
  EXPECT_EQ(parse_endpoint("mock:~/x.json")->behavior, home + "/x.json");
  EXPECT_EQ(parse_endpoint("planner:~/p.toml=mock")->planner_file, home + "/p.toml");
}

TEST(Endpoint, ParsesPartsOfMixedSide) {
  const auto mixed = parse_endpoint(
      "mix: goalie = mock:hold; 2-4,forwards=run:cd team; ./run {port}\n;others=localhost:50051");
  ASSERT_TRUE(mixed) << mixed.error().message;
  EXPECT_EQ(mixed->kind, Endpoint::Kind::kMixed);
  EXPECT_TRUE(mixed->starts_programs());
  EXPECT_FALSE(mixed->has_one_playmaker());
  ASSERT_EQ(mixed->parts.size(), 3U);
  EXPECT_EQ(mixed->parts[0].behavior, "hold");
  EXPECT_EQ(mixed->parts[0].agents, std::vector<int>({1}));
  EXPECT_EQ(mixed->parts[1].label, "2-4,forwards");
  EXPECT_EQ(mixed->parts[1].command, "cd team; ./run {port}") << "the shell's own separator";
  EXPECT_EQ(mixed->parts[1].agents, std::vector<int>({2, 3, 4, 9, 10, 11}));
  EXPECT_EQ(mixed->parts[2].port, 50051);
  EXPECT_EQ(mixed->parts[2].agents, std::vector<int>({5, 6, 7, 8, 12})) << "and the coach";
}

TEST(Endpoint, ParsesAProcessForEachAgent) {
  const auto each = parse_endpoint("each:run:cd ada && ./run --port {port}");
  ASSERT_TRUE(each) << each.error().message;
  EXPECT_EQ(each->kind, Endpoint::Kind::kMixed);
  ASSERT_EQ(each->parts.size(), 12U);
  EXPECT_EQ(each->parts[0].label, "1");
  EXPECT_EQ(each->parts[11].label, "coach");
  EXPECT_EQ(each->parts[11].agents, std::vector<int>({12}));
  EXPECT_EQ(each->parts[5].command, "cd ada && ./run --port {port}");
  EXPECT_EQ(default_team_name(*each), default_team_name(each->parts[0]));
  EXPECT_EQ(error_of("each:mock"), "side 'each:mock': must be each:run:COMMAND");
  EXPECT_THAT(error_of("each:run:x"), HasSubstr("side 'each:run:x': side 'run:x': "));
}

TEST(Endpoint, GivesCoachToFirstPart) {
  EXPECT_EQ(parse_endpoint("mix:1=mock;2-11=mock:hold")->parts[0].agents, std::vector({1, 12}));
  const auto elsewhere = parse_endpoint("mix:players=mock;coach=localhost:50051");
  EXPECT_EQ(elsewhere->parts[1].agents, std::vector({12}));
}

TEST(Endpoint, ReportsErrorsOfMixedSide) {
  EXPECT_EQ(error_of("mix:"), "side 'mix:': '' is not AGENTS=SIDE");
  EXPECT_EQ(error_of("mix:mock"), "side 'mix:mock': 'mock' is not AGENTS=SIDE");
  EXPECT_EQ(error_of("mix:1-9=mock"),
            "side 'mix:1-9=mock': player 10 has no part; add others=SIDE");
  EXPECT_EQ(error_of("mix:players=mock;7=mock"),
            "side 'mix:players=mock;7=mock': player 7 has two parts");
  EXPECT_EQ(error_of("mix:players=mock;others=mock;coach=mock"),
            "side 'mix:players=mock;others=mock;coach=mock': no player is left for 'others'");
  EXPECT_THAT(error_of("mix:golie=mock;others=mock"), HasSubstr("did you mean 'goalie'?"));
  EXPECT_THAT(error_of("mix:12=mock;others=mock"), HasSubstr("'12' is not a player"));
  EXPECT_THAT(error_of("mix:1=team:helios;others=mock"),
              HasSubstr("external teams and Playmakers do not play in one team"));
  EXPECT_THAT(error_of("mix:1=moc;others=mock"), HasSubstr("did you mean 'mock'?"));
}

TEST(Endpoint, ParsesSideWithPlannerFile) {
  const auto mock = parse_endpoint("planner:a/b.toml=mock:planner");
  EXPECT_EQ(mock->kind, Endpoint::Kind::kMock);
  EXPECT_EQ(mock->behavior, "planner");
  EXPECT_EQ(mock->planner_file, "a/b.toml");
  EXPECT_EQ(mock->text, "planner:a/b.toml=mock:planner");
  EXPECT_EQ(default_team_name(*mock), "planner");
  EXPECT_EQ(parse_endpoint("planner:x=run:A=1 ./go {port}")->command, "A=1 ./go {port}");
  EXPECT_EQ(parse_endpoint("planner:x=mix:1=mock;others=mock:hold")->parts.size(), 2U);
  EXPECT_EQ(parse_endpoint("planner:50051")->host, "planner") << "a host of this name";
  EXPECT_EQ(parse_endpoint("mock:planner")->planner_file, "");
}

TEST(Endpoint, ReportsErrorsOfSideWithPlannerFile) {
  EXPECT_EQ(error_of("planner:=mock"), "side 'planner:=mock': no file after 'planner:'");
  EXPECT_EQ(error_of("planner:x=team:helios"),
            "side 'planner:x=team:helios': an external team does not use the planner of cls");
  EXPECT_EQ(error_of("planner:x=planner:y=mock"),
            "side 'planner:x=planner:y=mock': planner:FILE= may be given once");
  EXPECT_EQ(error_of("mix:1=planner:x=mock;others=mock"),
            "side 'mix:1=planner:x=mock;others=mock': planner:FILE= applies to the whole team; "
            "write it before mix:");
  EXPECT_THAT(error_of("planner:x=moc"),
              HasSubstr("side 'planner:x=moc': unknown side 'moc'; did you"));
}

TEST(TeamNames, AreDerivedFromEndpoint) {
  const auto name = [](std::string_view text) { return default_team_name(*parse_endpoint(text)); };
  EXPECT_EQ(name("mock"), "mock");
  EXPECT_EQ(name("mock:hold"), "hold");
  EXPECT_EQ(name("mock:dir/press high.json"), "press_high");
  EXPECT_EQ(name("localhost:50051"), "localhost_50051");
  EXPECT_EQ(name("10.11.12.13:50051"), "_11_12_13_50051");
  EXPECT_EQ(name("unix:/run/brain.sock"), "brain");
  EXPECT_EQ(name("policy:policy-every-step.pol"), "every-step") << "without the rest of a word";
  EXPECT_EQ(name("policy:averyveryverylongword.pol"), "eryverylongword");
  EXPECT_EQ(name("policy:mycheckpoint_0001.pol"), "checkpoint_0001") << "too little without it";
  EXPECT_EQ(name("run:python3 -u examples/playmaker.py --port {port}"), "playmaker");
  EXPECT_EQ(name("run:cd brain && HOME=/x node server.js {port}"), "server");
  EXPECT_EQ(name("run:exec './my brain' {port}"), "my");
  EXPECT_EQ(name("run:python3 {port}"), "python3");
  EXPECT_EQ(name("run:../old/run --port {port}"), "old");
  EXPECT_EQ(name("run:cd '/tmp/ada' && ./run --port {port}"), "ada");
  EXPECT_EQ(name("run:./run --port {port}"),
            std::filesystem::current_path().filename().string().substr(0, 15));
  EXPECT_EQ(name("team:teams/helios/"), "helios");
}

TEST(TeamNames, MakesEqualNamesDistinctWithin15Characters) {
  EXPECT_EQ(distinct_names("mock", "mock").left, "mock_l");
  EXPECT_EQ(distinct_names("mock", "mock").right, "mock_r");
  EXPECT_EQ(distinct_names("a", "b").left, "a");
  EXPECT_EQ(distinct_names("localhost_50051", "localhost_50051").right, "localhost_500_r");
}

TEST(TeamNames, AreValidatedBeforeConnecting) {
  EXPECT_TRUE(check_team_name("My-Team_1"));
  EXPECT_EQ(check_team_name("two words").error().message,
            "team name 'two words': only letters, digits, '-', '+' and '_'");
  EXPECT_EQ(check_team_name("sixteen_letters_").error().message,
            "team name 'sixteen_letters_' is longer than 15 characters");
  EXPECT_FALSE(check_team_name(""));
}

}  // namespace
}  // namespace cls::match
