// Folders of tournaments that were changed or cut: every command refuses them with one line.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/installed.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

class CorruptTournament : public testing::Test {
 protected:
  // A complete tournament of six short matches.
  void SetUp() override {
    std::ofstream(cup() / "cls.toml") << "[tournament]\ncycles = 10\n"
                                         "[server]\nkick_off_wait = 2\n"
                                         "[teams.RED]\nendpoint = \"mock\"\n"
                                         "[teams.BLUE]\nendpoint = \"mock\"\n"
                                         "[teams.HOLD]\nendpoint = \"mock:hold\"\n";
    ASSERT_EQ(tournament({"run", cup(), "--quiet"}).exit_code, 0);
  }

  static CommandResult tournament(const Arguments& arguments) {
    return run(joined({cls_binary(), "tournament"}, arguments));
  }
  fs::path cup() const { return folder_.path(); }

  // A report without the line of its times: when a match ended is in the store alone.
  static std::string without_times(const std::string& report) {
    const std::size_t times = report.find("\nPlayed from ");
    EXPECT_NE(times, std::string::npos) << report;
    return std::string(report).erase(times, report.find('\n', times + 1) - times);
  }

  void sql(const std::string& statement) const {
    SQLite::Database(cup() / "tournament.db", SQLite::OPEN_READWRITE).exec(statement);
  }

  void expect_corrupt(const Arguments& arguments, const std::string& reason) const {
    const CommandResult refused = tournament(arguments);
    EXPECT_EQ(refused.exit_code, 65) << arguments[0] << ": " << refused.out << refused.err;
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(reason));
  }
  void expect_corrupt_everywhere(const std::string& reason) const {
    for (const char* command : {"status", "report", "run"}) {
      expect_corrupt({command, cup()}, reason);
    }
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(CorruptTournament, RejectsTeamsOutOfRange) {
  sql("UPDATE match SET left_team = 99 WHERE number = 3");
  expect_corrupt_everywhere("tournament.db: match 3: there is no team 99");
  sql("UPDATE match SET left_team = -1 WHERE number = 3");
  expect_corrupt_everywhere("tournament.db: match 3: there is no team -1");
}

TEST_F(CorruptTournament, RejectsMissingAndRenumberedMatches) {
  sql("UPDATE match SET number = -5 WHERE number = 1");
  expect_corrupt_everywhere("match number -5 is out of place");
  sql("UPDATE match SET number = 1 WHERE number = -5");
  sql("DELETE FROM match WHERE number = 2");
  expect_corrupt_everywhere("match 2 is missing");
}

// Without the store the results are in the folders of the matches: nothing is played again.
TEST_F(CorruptTournament, ReadsResultsOfALostStoreFromTheFolders) {
  const std::string table = without_times(tournament({"report", cup()}).out);
  std::map<fs::path, fs::file_time_type> logs;
  for (const auto& entry : fs::recursive_directory_iterator(cup() / "matches")) {
    if (entry.is_regular_file()) logs[entry.path()] = entry.last_write_time();
  }
  ASSERT_GT(logs.size(), 6U);

  for (const bool empty : {false, true}) {
    for (const char* ending : {"", "-wal", "-shm"}) {
      fs::remove(cup() / (std::string("tournament.db") + ending));
    }
    if (empty) std::ofstream(cup() / "tournament.db");
    for (const char* command : {"status", "report", "decide", "archive"}) {
      EXPECT_THAT(tournament({command, cup()}),
                  Exits(65, HasSubstr("tournament.db is missing or empty, but matches were played: "
                                      "`cls tournament run " +
                                      cup().string() + "` reads their results again\n")))
          << command;
    }
    EXPECT_THAT(tournament({"run", cup()}),
                Exits(0, HasSubstr("was missing or empty: 6 results were read from matches/")));
    for (const auto& [file, time] : logs) EXPECT_EQ(fs::last_write_time(file), time) << file;
    EXPECT_EQ(without_times(tournament({"report", cup()}).out), table);
  }
}

TEST_F(CorruptTournament, RefusesToPlayAgainWhatItCannotRead) {
  fs::remove(cup() / "tournament.db");
  for (const auto& entry : fs::directory_iterator(cup() / "matches")) {
    if (entry.path().filename().string().starts_with("000003-")) fs::remove_all(entry.path());
  }
  const CommandResult refused = tournament({"run", cup()});
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.err, HasSubstr("match 3 was played, but matches/ has no result of it: "
                                     "restore tournament.db from a copy, or --force"));
  EXPECT_THAT(tournament({"status", cup()}), Exits(65));
}

// The logs that a protest is about remain, are archived, and the report names them.
TEST_F(CorruptTournament, KeepsTheLogsOfAMatchThatIsPlayedAgain) {
  const auto folders = [&] {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(cup() / "matches")) {
      if (entry.path().filename().string().starts_with("000001-")) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    return found;
  };
  const fs::path first = folders().at(0);
  ASSERT_THAT(tournament({"decide", cup(), "--match", "1", "--annul", "--reason", "a protest"}),
              Exits(0));
  ASSERT_THAT(tournament({"decide", cup(), "--match", "1", "--replay", "--reason", "a power cut"}),
              Exits(0));
  ASSERT_THAT(tournament({"run", cup(), "--quiet"}), Exits(0));
  ASSERT_EQ(folders().size(), 2U);
  EXPECT_TRUE(fs::exists(first / "result.json"));

  const std::string decisions = tournament({"decide", cup()}).out;
  EXPECT_THAT(decisions, HasSubstr("a protest"));
  EXPECT_THAT(decisions, HasSubstr("a power cut"));
  EXPECT_THAT(tournament({"report", cup(), "--format", "md"}).out,
              HasSubstr("matches/" + first.filename().string()));

  ASSERT_THAT(tournament({"archive", cup()}), Exits(0));
  int annulled = 0;
  for (const auto& entry : fs::recursive_directory_iterator(cup() / "archive/annulled")) {
    annulled += entry.path().string().ends_with(".rcg.gz");
  }
  EXPECT_EQ(annulled, 1);
}

// A log of a stranger's tournament may be a link to any file.
TEST_F(CorruptTournament, ArchivesNoLinksThatLeadOutOfIt) {
  const TemporaryFolder elsewhere;
  for (const auto& entry : fs::directory_iterator(cup() / "matches")) {
    if (!entry.path().filename().string().starts_with("000001-")) continue;
    for (const auto& log : fs::directory_iterator(entry.path())) {
      if (!log.path().string().ends_with(".rcg.gz")) continue;
      fs::rename(log.path(), elsewhere.path() / "x.rcg.gz");
      fs::create_symlink(elsewhere.path() / "x.rcg.gz", log.path());
      break;
    }
  }
  EXPECT_THAT(tournament({"archive", cup()}),
              Exits(1, HasSubstr("a link that leads out of the tournament")));
}

// NFS without locks and file systems of some virtual machines refuse them.
TEST_F(CorruptTournament, SaysThatTheFileSystemHasNoLocks) {
  if (!is_installed("cc")) GTEST_SKIP() << "no cc on PATH";
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "locks.c")
      << "#include <errno.h>\nint flock(int f, int o) { errno = ENOLCK; return -1; }\n";
  const std::string library = (folder.path() / "locks.so").string();
  ASSERT_THAT(run({"cc", "-shared", "-fPIC", "-o", library, folder.path() / "locks.c"}), Exits(0));
  const CommandResult refused =
      run({cls_binary(), "tournament", "run", cup()}, {"LD_PRELOAD=" + library});
  EXPECT_NE(refused.exit_code, 75);
  EXPECT_THAT(refused.err, HasSubstr("/lock: No locks available; use a folder on a file system "
                                     "with locks"));
}

TEST_F(CorruptTournament, CountsLastMatchesThatAreMissing) {
  sql("DELETE FROM match WHERE number > 4");
  EXPECT_THAT(tournament({"status", cup()}).out, HasSubstr("4 of 6 matches done"));
  expect_corrupt({"run", cup()}, "match 5 is missing");
}

TEST_F(CorruptTournament, RejectsMatchesOfAnotherPlan) {
  sql("UPDATE match SET seed = seed + 1 WHERE number = 4");
  expect_corrupt_everywhere("match 4 is not that of schedule.jsonl");
  fs::remove(cup() / "schedule.jsonl");
  expect_corrupt({"run", cup()}, "match 4 is not the one that the plan schedules");
}

TEST_F(CorruptTournament, RejectsEmptyPlan) {
  std::ofstream(cup() / "plan.toml", std::ios::trunc).close();
  for (const char* command : {"status", "report"}) {
    expect_corrupt({command, cup()}, "plan.toml: not the plan of a tournament");
  }
  EXPECT_THAT(tournament({"run", cup()}), Exits(78));
}

TEST_F(CorruptTournament, WorkRejectsTeamsOutOfRange) {
  std::ofstream(cup() / "schedule.jsonl")
      << R"({"index":7,"round":1,"stage":"","pairing":0,"left":0,"right":9,"seed":1,"decides":false})"
      << "\n";
  EXPECT_THAT(tournament({"work", cup(), "--index", "7"}),
              Exits(65, HasSubstr("match 7: there is no team 9")));
}

// An archive: no file can be created in the folder, and a reader needs none.
TEST_F(CorruptTournament, IsReadInAReadOnlyFolder) {
  using fs::perms;
  fs::permissions(cup(), perms::owner_read | perms::owner_exec | perms::others_read |
                             perms::others_exec | perms::group_read | perms::group_exec);
  Arguments command;
  if (::geteuid() == 0) command = {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
  for (const char* name : {"status", "report"}) {
    Arguments arguments = command;
    arguments.insert(arguments.end(), {cls_binary(), "tournament", name, cup()});
    EXPECT_THAT(run(arguments), Prints(0, HasSubstr("6 of 6 matches done")));
  }
  fs::permissions(cup(), perms::owner_all);
}

}  // namespace
}  // namespace cls::tests
