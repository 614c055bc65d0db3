// The tournament store: members, schema versions, migration and the lock of its folder.
#include "tournament/store/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/text/json.h"
#include "league/schedule/schedule.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/report/report_document.h"
#include "tournament/report/report_model.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using soccer::EndReason;
using ordered_json = base::Json;

TEST(Store, SaysThatItsFileIsGone) {
  const tests::TemporaryFolder folder;
  auto store = Store::open(folder.path() / "db");
  ASSERT_TRUE(store);
  ASSERT_TRUE(store->add(next_fixtures(config_of(Format::kKnockout, 2).competition, {})).ok());

  fs::rename(folder.path() / "db", folder.path() / "moved");
  for (const char* what : {"removed", "replaced"}) {
    const auto stored = store->finish(1, fault(EndReason::kLate));
    ASSERT_FALSE(stored) << what;
    EXPECT_THAT(stored.error().message, HasSubstr("db: was removed or replaced"));
    fs::copy_file(folder.path() / "moved", folder.path() / "db", fs::copy_options::skip_existing);
  }
}

TEST(Store, RoundTripsEveryMember) {
  const tests::TemporaryFolder folder;
  Outcome outcome = fault(EndReason::kLate);
  outcome.left_score = 1;
  outcome.left_penalties = 3;
  outcome.right_penalties = 0;
  outcome.cycles = 77;
  outcome.wall_seconds = 1.5;
  outcome.run_seconds = 1.75;
  outcome.cycles_per_second = 51.25;
  outcome.deterministic = false;
  outcome.mode = "lockstep";
  outcome.started = "2026-01-01T00:00:00Z";
  outcome.ended = "2026-01-01T00:00:02Z";
  outcome.host = "here";
  outcome.load = 0.5;
  outcome.version = "1";
  outcome.server = "embedded 1";
  outcome.folder = "matches/1";
  outcome.left = {10, 2, 3, 4.5, 9.5, 0.25};
  outcome.right = {11, 0, 1, 5.5, 8.5, 0.75};
  const auto fixtures = next_fixtures(config_of(Format::kKnockout, 2).competition, {});
  {
    auto store = Store::open(folder.path() / "db");
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->add(fixtures).ok());
    EXPECT_EQ(*store->begin_attempts(std::vector{1}), std::vector{1});
    EXPECT_EQ(*store->running(), std::vector{1});
    ASSERT_TRUE(store->finish(1, outcome).ok());
  }
  const auto store = Store::open_to_read(folder.path() / "db");

  ASSERT_TRUE(store);

  const auto matches = store->matches();
  ASSERT_TRUE(matches);
  EXPECT_EQ((*matches)[0].fixture, fixtures[0]);

  const auto config = config_of(Format::kKnockout, 2);
  ScheduledMatch before = planned(fixtures[0]);
  before.outcome = outcome;
  EXPECT_EQ(json_of(config, (*matches)[0]), json_of(config, before));
  EXPECT_FALSE((*matches)[1].outcome);

  const auto again = parse_work_result(format_work_result(fixtures[0], outcome));
  ASSERT_TRUE(again);

  before.outcome = again->outcome;
  EXPECT_EQ(json_of(config, (*matches)[0]), json_of(config, before));
}

TEST(Store, RefusesSeedsThatAreNoUnsignedIntegers) {
  const auto with_seed = [](const std::string& seed) {
    return parse_fixture(
        R"({"index":1,"round":1,"stage":"","pairing":1,"left":0,"right":1,"seed":)" + seed +
        R"(,"decides":false})");
  };
  const auto largest = with_seed("18446744073709549568.0");  // the largest double below 2^64
  ASSERT_TRUE(largest) << largest.error().message;
  EXPECT_EQ(largest->seed, 18446744073709549568U);
  EXPECT_FALSE(with_seed("-1e9"));
  EXPECT_FALSE(with_seed("18446744073709551616.0"));
}

TEST(FolderLock, IsExclusive) {
  const tests::TemporaryFolder folder;
  const auto first = FolderLock::try_lock(folder.path());
  ASSERT_TRUE(first && *first);
  const auto second = FolderLock::try_lock(folder.path());
  ASSERT_TRUE(second.ok());
  EXPECT_FALSE(second->has_value());
}

// A copy of fixtures/tournament/store-v1: a tournament of schema version 1 with forfeits,
// penalties, a failed match and one that was not played. matches.json is the report that wrote it.
class OldStore : public testing::Test {
 protected:
  OldStore() {
    for (const char* name : {kPlanFile, kStoreFile}) {
      fs::copy_file(tests::fixture("tournament/store-v1") / name, folder_.path() / name);
    }
  }

  fs::path file() const { return folder_.path() / kStoreFile; }

  int schema_version() const {
    return SQLite::Database(file().string()).execAndGet("PRAGMA user_version").getInt();
  }

  // The matches of the report, as version 1 reported them.
  static ordered_json expected() {
    const auto text = tests::read_file(tests::fixture("tournament/store-v1/matches.json"));
    return ordered_json::parse(text)["matches"];
  }

  ordered_json matches() const {
    const auto state = read_tournament(folder_.path());
    if (!state) throw std::runtime_error(state.error().message);
    ordered_json all = ordered_json::array();
    for (const ScheduledMatch& match : state->matches) all.push_back(json_of(state->config, match));
    return all;
  }

  // Rows of a query, cells separated by '|'; NULL is "-".
  std::vector<std::string> query(const std::string& sql) const {
    const SQLite::Database database(file().string());
    SQLite::Statement row(database, sql);
    std::vector<std::string> rows;
    while (row.executeStep()) {
      rows.emplace_back();
      for (int i = 0; i < row.getColumnCount(); ++i) {
        const SQLite::Column cell = row.getColumn(i);
        rows.back() += (i > 0 ? "|" : "") + (cell.isNull() ? "-" : cell.getString());
      }
    }
    return rows;
  }

  tests::TemporaryFolder folder_;
};

TEST_F(OldStore, IsReadWithoutMigration) {
  EXPECT_EQ(matches().dump(2), expected().dump(2));
  EXPECT_EQ(schema_version(), 1);
  const auto state = read_tournament(folder_.path());
  const Report report = make_report(state->config, state->matches, folder_.path());
  EXPECT_EQ(report.counts.finished, 2);
  EXPECT_EQ(report.counts.forfeits, 2);
  EXPECT_EQ(report.counts.invalid, 1);
  EXPECT_EQ(report.counts.open, 1);
  EXPECT_THAT(report_csv(report), HasSubstr("\n3,1,,2,A,B,305414156,finished,0,0,0,3,0,"));
}

TEST_F(OldStore, IsMigratedWhenOpenedForWriting) {
  const auto before = query("SELECT number, state, attempts, settled FROM match ORDER BY number");
  ASSERT_TRUE(Store::open(file()).ok());
  EXPECT_EQ(schema_version(), 2);
  EXPECT_EQ(matches().dump(2), expected().dump(2));
  EXPECT_EQ(query("SELECT number, state, attempts, settled FROM match ORDER BY number"), before);
  EXPECT_TRUE(query("SELECT name FROM sqlite_master WHERE name = 'match_1'").empty());
}

TEST_F(OldStore, AnswersTheSameQueriesAfterMigration) {
  // All columns of version 1 but the JSON column of version 2, which docs/tournaments.md names.
  std::string columns;
  for (const std::string& name : query("SELECT name FROM pragma_table_info('match')")) {
    columns += (columns.empty() ? "" : ", ") + name;
  }

  ASSERT_EQ(std::count(columns.begin(), columns.end(), ','), 43);

  const std::string sql = "SELECT " + columns + " FROM match ORDER BY number";
  const std::string documented =
      "SELECT host, count(*), sum(left_missed + right_missed) FROM match GROUP BY host";
  const auto rows = query(sql);
  const auto groups = query(documented);

  ASSERT_TRUE(Store::open(file()).ok());
  EXPECT_EQ(query(sql), rows);
  EXPECT_EQ(query(documented), groups);
}

TEST_F(OldStore, IsResumedAfterMigration) {
  auto store = Store::open(file());
  ASSERT_TRUE(store);
  ASSERT_TRUE(store->requeue(true).ok());
  EXPECT_EQ(*store->begin_attempts(std::vector{5, 6}), (std::vector{2, 1}));

  Outcome outcome = score(2, 1);
  outcome.attempts = 2;
  ASSERT_TRUE(store->finish(5, outcome).ok());

  const auto all = *store->matches();
  EXPECT_TRUE(all[4].outcome->played());
  EXPECT_EQ(all[4].settled, 2);
  EXPECT_FALSE(all[5].outcome);
}

TEST_F(OldStore, RejectsNewerSchemaVersion) {
  SQLite::Database(file().string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 3");
  const std::string message = file().string() +
                              ": schema version 3 is newer than this cls supports (2); use the cls "
                              "that wrote it";
  EXPECT_EQ(Store::open(file()).error().message, message);
  EXPECT_EQ(Store::open_to_read(file()).error().message, message);
  EXPECT_EQ(read_tournament(folder_.path()).error().message, message);
}

}  // namespace
}  // namespace cls::tournament
