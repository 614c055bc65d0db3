// Reports of made-up tournaments in every format.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/text/json.h"
#include "base/text/replace_all.h"
#include "base/text/xml.h"
#include "league/schedule/schedule.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/config/config_file.h"
#include "tournament/report/comparison.h"
#include "tournament/report/report_bracket.h"
#include "tournament/report/report_document.h"
#include "tournament/report/report_html.h"
#include "tournament/report/report_model.h"
#include "tournament/report/report_tables.h"
#include "tournament/report/report_text.h"
#include "tournament/report/standings_columns.h"

namespace cls::tournament {
namespace {

using soccer::EndReason;
using json = base::Json;
using testing::HasSubstr;
using testing::Not;

Outcome shoot_out(int goals, int left, int right) {
  Outcome outcome = score(goals, goals);
  outcome.left_penalties = left;
  outcome.right_penalties = right;
  return outcome;
}

Outcome forfeit_by_left() {
  Outcome outcome = fault(EndReason::kCrashed);
  outcome.forfeit = true;
  outcome.right_score = 3;
  return outcome;
}

ScheduledMatch with(Outcome outcome) {
  ScheduledMatch match = planned({});
  match.outcome = std::move(outcome);
  return match;
}

// A tournament that was played, and its report.
struct Played {
  Played(TournamentConfig chosen, const Referee& referee)
      : config(std::move(chosen)),
        matches(play_all(config.competition, referee)),
        report(make_report(config, matches, "cups/spring")) {}
  Played(const Played&) = delete;
  Played& operator=(const Played&) = delete;

  TournamentConfig config;
  std::vector<ScheduledMatch> matches;
  Report report;
};

// The better team wins. With all that a match of a real tournament has.
Outcome complete_outcome(const Fixture& fixture) {
  Outcome outcome = better_wins(fixture);
  outcome.cycles = 6000;
  outcome.host = fixture.index % 2 == 0 ? "even" : "odd";
  outcome.started = "2026-11-22T10:35:12Z";
  outcome.ended = "2026-11-22T10:36:00Z";
  outcome.version = "1.2.3";
  outcome.server = "embedded 1.2.3";
  outcome.folder = "matches/00000" + std::to_string(fixture.index);
  outcome.left = {1000, 1, 2, 800.0, 1500.0, 2500.0, 9000.0, 1.0};
  outcome.right = outcome.left;
  return outcome;
}

std::size_t longest_line(const std::string& text, std::string* line = nullptr) {
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string one; std::getline(lines, one);) {
    if (one.size() > longest && line != nullptr) *line = one;
    longest = std::max(longest, one.size());
  }
  return longest;
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_THAT(text, HasSubstr(part));
}

TEST(Report, CountsForfeitsAndInvalidMatchesAsPartOfThoseDone) {
  std::vector<ScheduledMatch> matches = {with(score(1, 0)), planned({})};
  EXPECT_EQ(counts_text(count(matches)), "1 of 2 matches done");
  matches.push_back(with(fault(EndReason::kCrashed)));
  EXPECT_EQ(counts_text(count(matches)), "2 of 3 matches done, of these 1 INVALID");
  matches.push_back(with(forfeit_by_left()));
  EXPECT_EQ(counts_text(count(matches)), "3 of 4 matches done, of these 1 forfeited, 1 INVALID");
}

TEST(Report, ShowsShootOutsAndForfeitsInScores) {
  EXPECT_EQ(score_text(with(score(2, 1))), "2:1");
  EXPECT_EQ(score_text(with(shoot_out(2, 4, 3))), "2:2 (4:3 pen)");
  EXPECT_EQ(score_text(with(shoot_out(2, 4, 3)), true), "2:2 (3:4 pen)");
  EXPECT_EQ(score_text(with(forfeit_by_left())), "0:3 (forfeit)");
  EXPECT_EQ(score_text(with(fault(EndReason::kStalled))), "stalled");
  EXPECT_EQ(score_text(planned({})), "-");
}

TEST(Report, PrintsNoNegativeZero) {
  EXPECT_EQ(difference_text(-0.4), "+0");
  EXPECT_EQ(difference_text(0.0), "+0");
  EXPECT_EQ(difference_text(-0.6), "-1");
  EXPECT_EQ(difference_text(12.34, 1), "+12.3");
  const Played drawn(config_of(Format::kRoundRobin, 3), [](const Fixture&) { return score(1, 1); });
  for (const std::string& text : {report_text(drawn.report), report_html(drawn.report)}) {
    for (const char* zero : {" -0 ", ">-0<", " -0.", ">-0.", "..-0"}) {
      EXPECT_THAT(text, Not(HasSubstr(zero)));
    }
  }
}

TEST(Report, OfAComparisonWithoutAValidPairHasNoFigures) {
  Comparison comparison;
  comparison.config = config_of(Format::kRoundRobin, 2);
  const std::string text = comparison_text(comparison, {}, 80);
  EXPECT_THAT(text, HasSubstr("verdict: undecided\n0 pairs"));
  EXPECT_THAT(text, Not(HasSubstr("Elo")));
}

TEST(Report, GivesOneIntervalForOneScore) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.competition.rounds = 8;
  // A wins each first match of a pair, draws or loses some of the others.
  const Played played(config, [](const Fixture& fixture) {
    const bool first = fixture.index % 2 == 1;
    return first                    ? better_wins(fixture)
           : fixture.index % 3 == 0 ? score(1, 1)
                                    : better_wins(fixture);
  });
  const json document = json::parse(report_json(played.report));
  const json& standing = document["standings"][0];
  const json& crosstable = document["crosstable"][0];

  EXPECT_EQ(standing["team"], crosstable["team"]);
  EXPECT_EQ(standing["score_interval"], crosstable["score_interval"]);

  Comparison comparison;
  comparison.config = played.config;
  comparison.test.kind = TestKind::kSprt;
  const json compared = json::parse(comparison_json(comparison, played.matches));

  ASSERT_EQ(compared["verdict"], "undecided") << "all eight pairs count";
  EXPECT_EQ(compared["score_interval"], standing["score_interval"]);
  EXPECT_EQ(compared["score"], standing["score_rate"]);
}

TEST(Report, ListsMatchesWithCommandsInEveryFormat) {
  Played played(config_of(Format::kRoundRobin, 3), complete_outcome);
  TextOptions all;
  all.all_matches = true;
  const std::string text = report_text(played.report, all);
  const std::string md = report_markdown(played.report);
  const std::string html = report_html(played.report);
  for (const std::string& report : {text, md, html}) {
    EXPECT_EQ(occurrences(report, "cls match mock"), 6) << report;
    for (const char* part : {"2026-11-22 10:35:12", "6000", "finished", "even", "odd", "1:0"}) {
      expect_part(report, part);
    }
    for (const ScheduledMatch& match : played.matches) {
      expect_part(report, std::to_string(match.fixture.seed));
    }
  }

  expect_part(text, "logs: cups/spring/matches/000003/");
  expect_part(md, "[logs](cups/spring/matches/000003/)");
  expect_part(html, "<a href=\"cups/spring/matches/000003/\">logs</a>");
  EXPECT_THAT(html, Not(HasSubstr("match.html")));

  played.report.replays = {3};
  expect_part(report_html(played.report),
              "<a href=\"cups/spring/matches/000003/match.html\">watch</a>");
  expect_part(report_markdown(played.report), "[watch](cups/spring/matches/000003/match.html)");

  const json document = json::parse(report_json(played.report));
  expect_part(document["matches"][2]["command"].get<std::string>(), "cls match mock mock");
  EXPECT_EQ(document["matches"][2]["folder"], "matches/000003");

  const std::string csv = report_csv(played.report);
  EXPECT_EQ(occurrences(csv, "cls match mock"), 6);
  expect_part(csv, ",warnings,command\n");
}

TEST(Report, EndsWithStandingsAndWinnerWhereTheEndStaysInView) {
  const Played won(config_of(Format::kRoundRobin, 3), better_wins);
  TextOptions options;
  options.standings_last = true;
  const std::string text = report_text(won.report, options);

  EXPECT_GT(text.find("\nstandings\n"), text.find("\nmatches\n")) << text;
  EXPECT_TRUE(text.ends_with("\n\nwinner: A, 12 points, goals 4:0\n")) << text;
  EXPECT_EQ(occurrences(text, "\nstandings\n"), 1);

  const Played drawn(config_of(Format::kRoundRobin, 2), [](const Fixture&) { return score(1, 1); });

  EXPECT_EQ(winner_text(drawn.report), "level: A and B, 2 points, goals 2:2\n");

  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  EXPECT_EQ(winner_text(make_report(config, {}, "cup")), "");
}

TEST(Report, ListsMatchesOfShortTournamentsOnly) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const Played few(config, better_wins);
  expect_part(report_text(few.report), "\n      1  round 1  A       1:0  B\n");
  config.competition.rounds = 30;
  const Played many(config, better_wins);
  expect_part(report_text(many.report), "60 matches (--matches lists them)");
}

TEST(Report, LinksFoldersRelativeToTheDocument) {
  Played played(config_of(Format::kRoundRobin, 2), [](const Fixture& fixture) {
    Outcome outcome = complete_outcome(fixture);
    outcome.folder = "matches/a (b)";
    return outcome;
  });
  played.report.link_base = "../my cups";
  expect_part(report_markdown(played.report), "[logs](../my%20cups/matches/a%20%28b%29/)");
  played.report.link_base = ".";
  expect_part(report_html(played.report), "href=\"matches/a%20%28b%29/\"");
}

TEST(Report, HeadsWithNameTimesHostsAndVersions) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const Played unnamed(config, complete_outcome);
  EXPECT_EQ(unnamed.report.name, "spring") << "the folder";

  config.report.name = "Spring <cup>";
  const Played played(config, complete_outcome);
  const std::string html = report_html(played.report);
  expect_part(html, "<title>Spring &lt;cup&gt;</title>");
  expect_part(html, "<h1>Spring &lt;cup&gt;</h1>");

  for (const std::string& report : {report_text(played.report), html}) {
    expect_part(report, "Played from 2026-11-22 10:35:12 to 2026-11-22 10:36:00 UTC.");
    expect_part(report, "Hosts: even (1 match), odd (1 match).");
    expect_part(report, "Versions: cls 1.2.3, server embedded 1.2.3.");
  }
  const json document = json::parse(report_json(played.report));

  EXPECT_EQ(document["name"], "Spring <cup>");
  EXPECT_EQ(document["started"], "2026-11-22T10:35:12Z");
}

TEST(Report, ShowsEndpointsAndLatenciesOfPlaymakers) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.competition.teams[1].endpoint = "run:python3 b.py --port {port}";
  const Played played(config, complete_outcome);
  const std::string text = report_text(played.report);

  expect_part(text, "team  decisions  p50 ms  p95 ms  p99 ms  max ms  late  missed\n");
  expect_part(text, "A          2000     0.8     1.5     2.5     9.0     2       4\n");
  expect_part(text, "B: run:python3 b.py --port {port}\n");
  expect_part(report_html(played.report), "run:python3 b.py --port {port}");

  const json team = json::parse(report_json(played.report))["teams"][0];
  EXPECT_EQ(team["rpc_us"]["max"], 9000.0);
  EXPECT_EQ(team["missed"], 4);
}

TEST(Report, CountsAndListsWarningsOfMatches) {
  const Played played(config_of(Format::kRoundRobin, 2), [](const Fixture& fixture) {
    Outcome outcome = better_wins(fixture);
    if (fixture.index == 2) outcome.warnings = {"right: <odd> reply", "slow"};
    return outcome;
  });
  const std::string text = report_text(played.report);
  expect_part(text, "\n2 warnings\n  match 2, B 0:1 A: right: <odd> reply\n");
  expect_part(report_html(played.report), "<li>match 2, B 0:1 A: right: &lt;odd&gt; reply</li>");
  expect_part(report_markdown(played.report), "## 2 warnings");
  EXPECT_EQ(json::parse(report_json(played.report))["matches"][1]["warnings"].size(), 2u);
}

TEST(Report, MarksHostsThatMissFarMoreDecisions) {
  const auto on_host = [](const char* host, std::int64_t missed) {
    ScheduledMatch match = with(score(0, 0));
    match.outcome->host = host;
    match.outcome->left.decisions = 10'000;
    match.outcome->left.missed = missed;
    return match;
  };

  const auto outliers = [](const std::vector<ScheduledMatch>& matches) {
    std::string names;
    for (const HostFigures& host : host_figures(matches)) names += host.outlier ? host.host : "-";
    return names;
  };

  EXPECT_EQ(outliers({on_host("a", 10), on_host("b", 12), on_host("c", 100)}), "--c");
  EXPECT_EQ(outliers({on_host("a", 10), on_host("b", 15)}), "--") << "less than twice";
  EXPECT_EQ(outliers({on_host("a", 1), on_host("b", 3)}), "--") << "chance";
  EXPECT_EQ(outliers({on_host("a", 100)}), "-") << "nothing to compare with";
  EXPECT_EQ(outliers({on_host("a", 0), on_host("b", 0)}), "--");
}

TEST(Report, ShowsForfeitsInCrosstableAndStandings) {
  const Played played(config_of(Format::kRoundRobin, 3), [](const Fixture& fixture) {
    if (fixture.left == 0 && fixture.right == 1) return forfeit_by_left();
    if (fixture.left == 2 || fixture.right == 2) {
      Outcome outcome = fault(EndReason::kCrashed);
      outcome.forfeit = true;
      (fixture.left == 2 ? outcome.right_score : outcome.left_score) = 3;
      return outcome;
    }
    return better_wins(fixture);
  });
  const json document = json::parse(report_json(played.report));
  const std::string text = report_text(played.report);

  expect_part(text, "1-0-0 f-1");
  expect_part(text, "f+2");
  expect_part(text, "f+1: one win by forfeit, f-2: two losses by forfeit.");
  expect_part(text, "forf");

  for (const json& row : document["standings"]) {
    const json forfeits = row["forfeits"];
    const std::string expected = row["team"] == "A" ? "2-1" : row["team"] == "B" ? "3-0" : "0-4";
    EXPECT_EQ(forfeits["won"].dump() + "-" + forfeits["lost"].dump(), expected);
  }
}

TEST(Report, DrawsBracketOfKnockout) {
  TournamentConfig config = config_of(Format::kKnockout, 5);
  config.competition.swap_sides = false;
  const Played played(config, [](const Fixture& fixture) {
    return fixture.stage == "final" ? shoot_out(2, 4, 3) : better_wins(fixture);
  });

  EXPECT_EQ(bracket_text(played.report, 80),
            "final: A beats B 2:2 (4:3 pen)\n"
            "|- semi-final 1: A beats D 1:0\n"
            "|  |- quarter-final 2: D beats E 1:0\n"
            "|- semi-final 2: B beats C 1:0\n"
            "third place: C beats D 1:0\n");

  const std::string text = report_text(played.report);
  expect_part(text, "\nbracket\n  final: A beats B 2:2 (4:3 pen)\n  |- semi-final 1");
  expect_part(text, "Shoot-outs won-lost count as won and lost");
  expect_part(report_markdown(played.report), "```text\nfinal: A beats B");

  const std::string html = report_html(played.report);
  expect_part(html, "<h3>quarter-finals</h3>");
  expect_part(html, "<div class=\"won\"><span>A</span><span> 2 (4 pen)</span></div>");

  const json document = json::parse(report_json(played.report));
  EXPECT_EQ(document["bracket"].back()["stage"], "final");
  EXPECT_EQ(document["bracket"].back()["winner"], "A");
  EXPECT_EQ(document["bracket"].back()["entrants"][1]["from"]["stage"], "semi-final 2");
  EXPECT_EQ(document["standings"][0]["shoot_outs"]["won"], 1);
}

TEST(Report, NamesUnknownEntrantsOfTheBracket) {
  const TournamentConfig config = config_of(Format::kKnockout, 4);
  std::vector<ScheduledMatch> matches;
  for (const Fixture& fixture : next_fixtures(config.competition, {})) {
    matches.push_back(planned(fixture));
    if (fixture.stage == "semi-final 1") matches.back().outcome = better_wins(fixture);
  }

  EXPECT_EQ(bracket_text(make_report(config, matches, "cup"), 80),
            "final: A - winner of semi-final 2\n"
            "|- semi-final 1: A beats D 1:0, 1:0\n"
            "|- semi-final 2: B - C\n"
            "third place: D - loser of semi-final 2\n");
}

TEST(Report, DrawsBracketsOfDoubleElimination) {
  const Played played(config_of(Format::kDoubleElimination, 6), better_wins);
  const std::string tree = bracket_text(played.report, 80);
  EXPECT_EQ(tree.rfind("grand final: A beats B 1:0, 1:0\n", 0), 0u) << tree;
  for (const ScheduledMatch& match : played.matches) {
    EXPECT_EQ(occurrences(tree, match.fixture.stage + ":"), 1) << tree;
  }
  const std::string html = report_html(played.report);
  for (const char* title : {"winners' round 1", "losers' round 2", "grand final"}) {
    expect_part(html, "<h3>" + base::escape_xml(title) + "</h3>");
  }
}

TEST(Report, ShowsRoundsAndByesOfSwiss) {
  const Played played(config_of(Format::kSwiss, 5), better_wins);
  const std::string text = report_text(played.report);
  expect_part(text, "Byes: round 1 ");
  expect_part(text, "round 3");
  expect_part(text, "buch");
  const json document = json::parse(report_json(played.report));
  EXPECT_EQ(document["byes"].size(), base::index(rounds_of(played.config.competition)));
  EXPECT_EQ(document["byes"][0]["round"], 1);
}

TEST(Report, ShowsTablesOfGroupsAndTheirBracket) {
  TournamentConfig config = config_of(Format::kGroups, 6);
  const Played played(config, better_wins);
  const std::string html = report_html(played.report);
  for (const char* part : {"group A", "group B", "knock-out", "semi-final 1"}) {
    expect_part(html, part);
  }
  expect_part(bracket_text(played.report, 80), "|- semi-final 2:");

  for (const std::string& text :
       {html, report_markdown(played.report), report_text(played.report, {})}) {
    EXPECT_LT(text.find("knock-out"), text.find("group A")) << "the end comes first";
  }
  Report unfinished = played.report;
  unfinished.complete = false;
  const std::string text = report_text(unfinished, {});
  EXPECT_GT(text.find("knock-out"), text.find("group A"));
}

// The winner of a group has no other matches in the table of its group than those of its group.
TEST(Report, CountsMatchesOfTheGroupInTheTableOfAGroup) {
  TournamentConfig config = config_of(Format::kGroups, 4);
  config.competition.advance = 1;
  // A wins its group and loses the final.
  const Played played(config, [](const Fixture& fixture) {
    return fixture.stage == "final" ? score(fixture.left == 0 ? 0 : 1, fixture.left == 0 ? 1 : 0)
                                    : better_wins(fixture);
  });
  const RankedTable& group = played.report.tables.front();

  ASSERT_EQ(group.title, "group A");

  const Standing& winner = group.standings.front();
  EXPECT_EQ(winner.record.games.games(), winner.played);
  EXPECT_EQ(winner.record.strength().score, 1.0);

  const RankedTable& last = played.report.tables.back();
  ASSERT_EQ(last.title, "knock-out");

  for (const Standing& row : last.standings) {
    EXPECT_EQ(row.played, 2) << "the final; the matches of the groups are in their tables";
    EXPECT_EQ(row.record.games.games(), row.played);
  }
  EXPECT_LT(last.standings[1].record.strength().score, 1.0);
}

TEST(Report, ShowsChosenColumnsOfStandings) {
  TournamentConfig config = config_of(Format::kRoundRobin, 3);
  config.report.columns = {"team", "points", "elo"};
  const Played played(config, better_wins);
  EXPECT_EQ(standings_text(played.report).rfind("standings\n  team  pts   Elo\n  A      12  +", 0),
            0u)
      << standings_text(played.report);

  for (const std::string_view column : kStandingsColumns) {
    TournamentConfig one = config_of(Format::kSwiss, 3);
    one.report.columns = {std::string(column)};
    const Played with_column(one, better_wins);
    const auto chosen = chosen_columns(with_column.report, with_column.report.tables.front());
    ASSERT_EQ(chosen.size(), 1u);
    EXPECT_EQ(chosen[0]->name, column);
  }
}

TEST(Report, ReadsNameAndColumnsFromTheConfiguration) {
  const auto parse = [](const std::string& keys) {
    return parse_config("[tournament]\n" + keys + "\n[teams.A]\nendpoint = \"mock\"\n", "cls.toml");
  };
  const ParsedConfig good = parse("name = \"Cup\"\ncolumns = [\"team\", \"points\"]");

  ASSERT_TRUE(good.errors.empty()) << good.errors.front();
  EXPECT_EQ(good.config.report.name, "Cup");
  EXPECT_EQ(good.config.report.columns, (std::vector<std::string>{"team", "points"}));
  EXPECT_EQ(first_difference(good.config, parse("").config), "") << "not part of the plan";

  const ParsedConfig bad = parse("columns = [\"point\"]");
  ASSERT_EQ(bad.errors.size(), 1u);
  expect_part(bad.errors[0], "'point': did you mean 'points'?");
}

// Twelve teams with the longest names, in every format, with warnings, forfeits and shoot-outs.
TEST(Report, FitsTextIntoEightyColumns) {
  for (const Format format : {Format::kRoundRobin, Format::kSwiss, Format::kKnockout,
                              Format::kDoubleElimination, Format::kGroups}) {
    TournamentConfig config = config_of(format, 12);
    config.competition.groups = 3;
    for (TeamEntry& team : config.competition.teams) team.name = "FIFTEEN_CHARS_" + team.name;
    const Played played(config, [](const Fixture& fixture) {
      Outcome outcome = complete_outcome(fixture);
      if (fixture.index % 5 == 0) {
        outcome.warnings = {
            "left: the Playmaker replied after the deadline in 12 of 6000 cycles; "
            "see left-playmaker.log"};
      }
      if (fixture.index % 7 == 0) {
        outcome.forfeit = true;
        outcome.end_reason = EndReason::kCrashed;
        outcome.message = "left Playmaker exited in cycle 30 with exit code 139 (128 + SIGSEGV)";
      }
      if (fixture.decides) outcome.left_penalties = outcome.right_penalties = 3;
      return outcome;
    });

    for (const bool all : {false, true}) {
      TextOptions options;
      options.all_matches = all;
      std::string line;
      EXPECT_LE(longest_line(report_text(played.report, options), &line), 80u) << line;
      options.width = 60;
      EXPECT_LE(longest_line(report_text(played.report, options), &line), 60u) << line;
    }
    EXPECT_LE(longest_line(standings_text(played.report)), 80u);
  }
}

TEST(Report, FitsScheduledMatchesIntoEightyColumns) {
  TournamentConfig config = config_of(Format::kDoubleElimination, 12);
  for (TeamEntry& team : config.competition.teams) team.name = "FIFTEEN_CHARS_" + team.name;
  for (const ScheduledMatch& match : play_all(config.competition, better_wins)) {
    const std::string line = schedule_text(config, match.fixture);
    EXPECT_LE(line.size(), 80u) << line;
    expect_part(line, match.fixture.stage + "  ");
  }
  const Fixture first = next_fixtures(config_of(Format::kRoundRobin, 2).competition, {}).front();
  EXPECT_EQ(schedule_text(config_of(Format::kRoundRobin, 2), first),
            "  1  round 1      A - B     seed " + std::to_string(first.seed));
}

TEST(Report, IsOneAccessiblePageWithoutScripts) {
  TournamentConfig config = config_of(Format::kGroups, 6);
  config.competition.teams[0].endpoint = "run:<script>alert(1)</script>";
  const Played played(config, complete_outcome);
  std::string html = report_html(played.report);
  base::replace_all(html, "xmlns=\"http://www.w3.org/2000/svg\"", "");  // a name: loads nothing
  EXPECT_EQ(html.rfind("<!DOCTYPE html>\n<html lang=\"en\">", 0), 0u);

  EXPECT_EQ(occurrences(html, "<h1>"), 1);
  EXPECT_EQ(occurrences(html, "<table>"), occurrences(html, "<caption>"));
  EXPECT_GT(occurrences(html, "scope=\"col\""), 20);
  EXPECT_EQ(occurrences(html, "<svg"), 1) << "no pair met five times";
  EXPECT_EQ(occurrences(html, "aria-label=\"Ratings"), 1);

  for (const char* part : {"prefers-color-scheme:dark", "@media print", "&lt;script&gt;"}) {
    expect_part(html, part);
  }
  for (const char* foreign : {"<script", "http://", "https://", "src=", "@import", "url("}) {
    EXPECT_THAT(html, Not(HasSubstr(foreign))) << foreign;
  }
}

TEST(Report, ChartsTheGoalDifferencesOfPairsThatMetOften) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.competition.rounds = 6;
  const std::string html = report_html(Played(config, better_wins).report);
  EXPECT_EQ(occurrences(html, "aria-label=\"Goals of A minus those of B\""), 1);
  expect_part(html, "<h2>goal differences</h2>");
  config.competition.rounds = 1;
  const std::string once = report_html(Played(config, better_wins).report);
  EXPECT_THAT(once, Not(HasSubstr("goal differences")));
}

}  // namespace
}  // namespace cls::tournament
