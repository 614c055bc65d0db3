// The page for spectators: what it shows, what it does not show, and which folders it reads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "league/schedule/schedule.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/site/replay_shelf.h"
#include "tournament/site/spectator_page.h"
#include "tournament/site/spectator_view.h"
#include "tournament/site/tournament_site.h"
#include "tournament/store/pauses_file.h"
#include "tournament/store/store.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr std::chrono::seconds kEnough{60};

std::string whole(const viewer::LiveFeed& feed) {
  std::string bytes;
  while (feed.wait(bytes.size(), kEnough)) {
    const auto piece = feed.read(bytes.size(), std::size_t{1} << 20);
    bytes += piece.bytes;
    if (piece.ended) return bytes;
  }
  ADD_FAILURE() << "the feed has no end";
  return bytes;
}

TournamentState played(Format format, int teams, const Referee& referee = better_wins) {
  TournamentState state;
  state.config = config_of(format, teams);
  state.matches = play_all(state.config.competition, referee);
  return state;
}

TEST(SpectatorView, ShowsScheduleResultsAndTables) {
  TournamentState state = played(Format::kRoundRobin, 4);
  const std::size_t count = state.matches.size();
  for (std::size_t i = 2; i < count; ++i) state.matches[i].outcome.reset();
  state.running = {3};
  const SpectatorPage page = spectator_view(state, "cups/spring");

  EXPECT_EQ(page.title, "spring");
  EXPECT_EQ(page.status, "2 of 12 matches played");
  EXPECT_FALSE(page.over);
  ASSERT_EQ(page.running.size(), 1U);
  EXPECT_EQ(page.running[0].index, 3);
  ASSERT_EQ(page.next.size(), 8U);
  EXPECT_EQ(page.next[0].index, 4);
  EXPECT_EQ(page.further, 1);
  ASSERT_FALSE(page.results.empty());
  EXPECT_EQ(page.results[0].content[0].index, 2) << "the latest first";
  EXPECT_EQ(page.tables.size(), 1U);
  EXPECT_EQ(page.statistics.size(), 2U);
}

TEST(SpectatorView, TellsWhenTheNextMatchesStart) {
  TournamentState state = played(Format::kRoundRobin, 2);
  for (ScheduledMatch& match : state.matches) match.outcome.reset();
  EXPECT_EQ(spectator_view(state, "cup").next[0].start, "") << "without start_times";

  state.config.execution.concurrency = 1;
  state.config.report.slot_minutes = 20;
  state.config.report.start_times = {"2037-07-15 09:00"};
  const SpectatorPage page = spectator_view(state, "cup");
  EXPECT_EQ(page.next[0].start, "2037-07-15 09:00");
  EXPECT_THAT(spectator_page(page, "x"), HasSubstr(">2037-07-15 09:20 · round 1<"));
}

TEST(SpectatorView, TellsOfATechnicalTimeOut) {
  TournamentState state = played(Format::kRoundRobin, 2);
  state.matches.back().outcome.reset();
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(begin_pause(folder.path(), "SECRET-reason"));
  const std::string now = spectator_now(spectator_view(state, folder.path()), "x");
  EXPECT_THAT(now, HasSubstr("Technical time-out since 20"));
  EXPECT_THAT(now, Not(HasSubstr("SECRET"))) << "written for the organizers";

  ASSERT_TRUE(end_pause(folder.path()));
  EXPECT_EQ(spectator_view(state, folder.path()).pause, "");
}

// Ranks over all groups of a stage that is being played say nothing yet.
TEST(SpectatorView, ShowsTheTablesOfTheStageThatIsPlayed) {
  TournamentState state;
  state.config = config_of(Format::kStages, 4);
  Stage first;
  first.name = "first round";
  first.groups = 2;
  Stage last;
  last.name = "finals";
  state.config.competition.stages = {first, last};
  for (const Fixture& fixture : next_fixtures(state.config.competition, {})) {
    state.matches.push_back(planned(fixture));
  }
  state.matches[0].outcome = better_wins(state.matches[0].fixture);

  const SpectatorPage page = spectator_view(state, "cup");
  ASSERT_EQ(page.tables.size(), 2U);
  EXPECT_THAT(page.tables[0], HasSubstr("group A"));
  for (const std::string& table : page.tables) EXPECT_THAT(table, Not(HasSubstr("so far")));
}

TEST(SpectatorView, NamesAWinnerWhereOneTeamIsFirst) {
  EXPECT_NE(spectator_view(played(Format::kRoundRobin, 3), "cup").winner, "");
  const auto drawn = [](const Fixture&) { return score(0, 0); };
  EXPECT_EQ(spectator_view(played(Format::kRoundRobin, 3, drawn), "cup").winner, "");
}

TEST(SpectatorView, ShowsTheBracketOfAKnockout) {
  const SpectatorPage page = spectator_view(played(Format::kKnockout, 4), "cup");
  EXPECT_TRUE(page.over);
  EXPECT_THAT(page.bracket, HasSubstr("class=\"won\""));
}

// Deciding matches of a final and of the third place are played in turn.
TEST(SpectatorView, ListsTheResultsOfAStageUnderOneHeading) {
  const auto drawn = [](const Fixture&) { return score(1, 1); };
  const SpectatorPage page = spectator_view(played(Format::kKnockout, 4, drawn), "cup");
  std::set<std::string> titles;
  for (const auto& group : page.results) {
    EXPECT_TRUE(titles.insert(group.title).second) << group.title;
  }
  EXPECT_GE(titles.size(), 3U);
}

TEST(SpectatorPage, ShowsPlayersWithTheirNumbers) {
  SpectatorPage page = spectator_view(played(Format::kRoundRobin, 2), "cup");
  SpectatorMatch match;
  match.left = "A";
  match.right = "B";
  match.glance.emplace().left_players = {{9, {-10.0, 3.0}}};
  page.winner.clear();
  page.running = {match};
  EXPECT_THAT(spectator_now(page, "x"),
              HasSubstr("<g class=\"l\" transform=\"translate(-10.0 3.0)\"><circle r=\"2\"/>"
                        "<text y=\"0.85\">9</text></g>"));
}

TEST(SpectatorView, ShowsNoEndpointsMessagesOrHosts) {
  TournamentState state = played(Format::kRoundRobin, 3, [](const Fixture& fixture) {
    Outcome outcome = better_wins(fixture);
    outcome.message = "SECRET-message";
    outcome.warnings = {"SECRET-warning"};
    outcome.host = "SECRET-host";
    outcome.version = outcome.server = "SECRET-version";
    return outcome;
  });

  for (TeamEntry& team : state.config.competition.teams) team.endpoint = "team:/SECRET/endpoint";
  Outcome crash = fault(soccer::EndReason::kCrashed);
  crash.message = "SECRET-crash";
  state.matches[1].outcome = crash;
  state.matches[2].decision = MatchDecision{};
  state.matches[2].decision->reason = "SECRET-reason";
  const SpectatorPage page = spectator_view(state, "cup");

  EXPECT_THAT(spectator_page(page, "x"), Not(HasSubstr("SECRET")));
  EXPECT_THAT(spectator_now(page, "x"), Not(HasSubstr("SECRET")));
  EXPECT_THAT(spectator_page(page, "x"), HasSubstr("no result"));
}

TEST(SpectatorPage, ShowsNamesAsText) {
  TournamentState state = played(Format::kRoundRobin, 3);
  state.config.report.name = "<i>cup</i>";
  state.config.competition.teams[0].name = "<b>\"&東京";
  state.matches.back().outcome.reset();
  state.running = {state.matches.back().fixture.index};
  const SpectatorPage page = spectator_view(state, "cup");
  for (const std::string& text : {spectator_page(page, "x"), spectator_now(page, "x")}) {
    EXPECT_THAT(text, Not(HasSubstr("<b>")));
    EXPECT_THAT(text, Not(HasSubstr("<i>")));
  }

  EXPECT_THAT(spectator_page(page, "x"), HasSubstr("&lt;b&gt;&quot;&amp;東京"));
}

TEST(SpectatorPage, HasRelativeAddressesOnly) {
  SpectatorPage page;
  page.running = {{1, "", "A", "B", "", "", true}};
  page.results = {{"final", {{2, "final", "A", "B", "", "1:0", true}}}};
  const std::string html = spectator_page(page, "x");
  EXPECT_THAT(html, HasSubstr("href=\"match/1/\""));
  EXPECT_THAT(html, HasSubstr("href=\"match/2/\""));
  for (const char* absolute : {"href=\"/", "src=\"/", "http://", "https://"}) {
    EXPECT_THAT(html, Not(HasSubstr(absolute)));
  }
}

// A folder with two matches that have results, and one that has none.
class TournamentSiteTest : public testing::Test {
 protected:
  void play(const std::string& first_folder) {
    const TournamentConfig config = config_of(Format::kRoundRobin, 3);
    ASSERT_TRUE(prepare_folder(folder_.path(), config));
    auto store = Store::open(folder_.path() / kStoreFile);
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->add(next_fixtures(config.competition, {})));
    ASSERT_TRUE(store->begin_attempts(std::vector<int>{1, 2}));
    Outcome outcome = score(2, 1);
    outcome.folder = first_folder;
    ASSERT_TRUE(store->finish(1, outcome));
    outcome.folder = "matches/none";
    ASSERT_TRUE(store->finish(2, outcome));
  }

  void add_log(const fs::path& match) const {
    fs::create_directories(match);
    fs::copy_file(tests::fixture("gamelog/match-start.rcg.gz"), match / "match.rcg.gz");
  }

  tests::TemporaryFolder folder_;
};

TEST_F(TournamentSiteTest, ServesItsPagesAndNothingElse) {
  play("matches/one");
  add_log(folder_.path() / "matches/one");
  const auto site = TournamentSite::open(folder_.path());
  ASSERT_TRUE(site) << site.error().message;

  const auto page = (*site)->reply("", "");
  ASSERT_EQ(page.status, 200);
  EXPECT_THAT(page.document->text, HasSubstr("href=\"match/1/\""));
  EXPECT_THAT(page.document->text, Not(HasSubstr("match/2/"))) << "no log";
  EXPECT_EQ((*site)->reply("now", "").status, 200);
  EXPECT_EQ((*site)->reply("match/1", "").location, "1/");

  const auto replay = (*site)->reply("match/1/", "");
  ASSERT_EQ(replay.status, 200);
  EXPECT_THAT(whole(*replay.feed), HasSubstr("application/cls-view;base64"));

  for (const char* path : {"cls.toml", "plan.toml", "tournament.db", "matches/one/match.rcg.gz",
                           "match/1/match.rcg.gz", "match/1/live", "match/1/drawings-left",
                           "match/2/", "match/3/", "match/0/", "match/-1/", "match/../plan.toml",
                           "match/1/../../plan.toml", "match//", "match/", "now/", "../"}) {
    EXPECT_EQ((*site)->reply(path, "").status, 404) << path;
  }
}

TEST_F(TournamentSiteTest, ReadsNoFolderOutside) {
  const tests::TemporaryFolder outside;
  add_log(outside.path() / "other");
  for (const std::string& named :
       {(outside.path() / "other").string(),
        "matches/../../" + outside.path().filename().string() + "/other"}) {
    fs::remove_all(folder_.path());
    fs::create_directories(folder_.path());
    play(named);
    const auto site = TournamentSite::open(folder_.path());
    ASSERT_TRUE(site) << site.error().message;
    EXPECT_EQ((*site)->reply("match/1/", "").status, 404) << named;
  }

  fs::remove_all(folder_.path());
  fs::create_directories(folder_.path() / "matches");
  play("matches/link");
  fs::create_directory_symlink(outside.path() / "other", folder_.path() / "matches/link");
  const auto site = TournamentSite::open(folder_.path());

  ASSERT_TRUE(site) << site.error().message;
  EXPECT_EQ((*site)->reply("match/1/", "").status, 404) << "a link";
}

TEST_F(TournamentSiteTest, WritesNothingIntoTheFolder) {
  play("matches/one");
  const auto names = [this] {
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      all.push_back(entry.path().string());
    }
    return all;
  };
  const auto before = names();
  const std::string store = tests::read_file(folder_.path() / kStoreFile);
  const auto site = TournamentSite::open(folder_.path());
  for (const char* path : {"", "now", "match/1/", "match/2/"}) (*site)->reply(path, "");

  EXPECT_EQ(names(), before);
  EXPECT_EQ(tests::read_file(folder_.path() / kStoreFile), store);
}

TEST_F(TournamentSiteTest, ShowsOrganizersAllMatches) {
  play("matches/one");
  add_log(folder_.path() / "matches/one");
  const auto site = TournamentSite::open(folder_.path(), {.reader = Reader::kOrganizer});
  ASSERT_TRUE(site) << site.error().message;

  EXPECT_THAT((*site)->reply("", "").body, HasSubstr("href=\"match/1/\""));
  EXPECT_THAT((*site)->reply("match/1/", "").body, HasSubstr("application/cls-view;base64"));
  EXPECT_EQ((*site)->reply("match/2/", "").body, "the match has no log\n");
  EXPECT_EQ((*site)->reply("match/3/live", "").body, "the match is not played now\n");

  for (const char* path : {"now", "match/1", "match/9/", "plan.toml", "match/1/plan.toml"}) {
    EXPECT_EQ((*site)->reply(path, "").status, 404) << path;
  }
}

TEST_F(TournamentSiteTest, MakesItsViewAnewAfterAChangeOnly) {
  play("matches/one");
  const auto site = TournamentSite::open(folder_.path(), {.reader = Reader::kOrganizer});
  ASSERT_TRUE(site) << site.error().message;

  const std::string before = (*site)->reply("", "").body;
  const int views = (*site)->views();
  for (int i = 0; i < 10; ++i) EXPECT_EQ((*site)->reply("", "").body, before);
  EXPECT_LE((*site)->views(), views + 2) << "its own close of the store, and a new minute";

  auto store = Store::open(folder_.path() / kStoreFile);

  ASSERT_TRUE(store);
  ASSERT_TRUE(store->finish(3, score(5, 0)));
  EXPECT_THAT((*site)->reply("", "").body, HasSubstr("5 : 0"));
}

TEST(TournamentSite, SaysThatThereIsNoTournament) {
  const tests::TemporaryFolder folder;
  const auto site = TournamentSite::open(folder.path());
  ASSERT_FALSE(site);
  EXPECT_THAT(site.error().message, HasSubstr("holds no tournament"));
}

TEST(ReplayShelf, ForgetsThePagesThatWereNotAskedForLongest) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"a.rcg.gz", "b.rcg.gz", "c.rcg.gz"}) {
    fs::copy_file(tests::fixture("gamelog/match-start.rcg.gz"), folder.path() / name);
  }
  std::size_t size = 0;
  {
    ReplayShelf one(1);
    size = whole(*one.page(folder.path() / "a.rcg.gz", "")).size();
  }
  ReplayShelf shelf(2 * size + size / 2);
  const auto first = shelf.page(folder.path() / "a.rcg.gz", "");

  EXPECT_EQ(shelf.page(folder.path() / "a.rcg.gz", ""), first) << "made once";

  whole(*first);
  whole(*shelf.page(folder.path() / "b.rcg.gz", ""));
  whole(*shelf.page(folder.path() / "c.rcg.gz", ""));
  EXPECT_NE(shelf.page(folder.path() / "a.rcg.gz", ""), first) << "forgotten";
  EXPECT_LE(shelf.bytes(), 2 * size + size / 2);
}

TEST(ReplayShelf, MakesAnotherPageOfALogThatWasWrittenAgain) {
  const tests::TemporaryFolder folder;
  const fs::path log = folder.path() / "match.rcg.gz";
  fs::copy_file(tests::fixture("gamelog/match-start.rcg.gz"), log);
  ReplayShelf shelf(std::size_t{1} << 30);
  const auto before = shelf.page(log, "");
  EXPECT_EQ(shelf.page(log, ""), before);
  fs::last_write_time(log, fs::last_write_time(log) + std::chrono::seconds(5));
  EXPECT_NE(shelf.page(log, ""), before);
}

TEST(ReplayShelf, SaysThatThereIsNoLog) {
  ReplayShelf shelf(1000);
  EXPECT_THAT(whole(*shelf.page("/nowhere/match.rcg", "")), HasSubstr("no log"));
}

}  // namespace
}  // namespace cls::tournament
