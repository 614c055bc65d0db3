// Names and messages of strangers do nothing to terminals, spreadsheets and pages.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/text/printable.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

// Clears the screen, sets the title, rings; CSI of C1; right-to-left override; not UTF-8.
const std::string kHostile =
    "\x1b[2J\x1b]0;pwn\a\xc2\x9b"
    "31m\xe2\x80\xae\xff<script>";

bool is_safe(const std::string& text) { return cls::base::printable_lines(text) == text; }

class HostileText : public testing::Test {
 protected:
  CommandResult run(Arguments arguments) const {
    arguments.insert(arguments.begin(), cls_binary());
    return tests::run(arguments);
  }
  void expect_safe(const Arguments& arguments) const {
    const CommandResult result = run(arguments);
    const auto named = [&] { return arguments[0] + " " + arguments.back(); };
    EXPECT_TRUE(is_safe(result.out)) << named() << ": " << result.out;
    EXPECT_TRUE(is_safe(result.err)) << named() << ": " << result.err;
    EXPECT_FALSE((result.out + result.err).empty()) << named();
  }
  std::string path(const std::string& name) const { return folder_.path() / name; }

  /// A game log of a match whose left team has this name.
  std::string log_of(const std::string& name) const {
    std::string log = read_file(fixture("gamelog/rcg-v6-excerpt.rcg.gz"));
    const std::size_t team = log.find("(team ");
    const std::size_t begin = log.find(' ', team + 6) + 1;
    const std::string old = log.substr(begin, log.find(' ', begin) - begin);
    for (std::size_t at = log.find(" " + old + " "); at != std::string::npos;
         at = log.find(" " + old + " ", at + name.size())) {
      log.replace(at + 1, old.size(), name);
    }
    std::ofstream(path("game.rcg")) << log;
    return path("game.rcg");
  }

  TemporaryFolder folder_;
};

TEST_F(HostileText, OfGameLogsIsNotPrinted) {
  const std::string log = log_of(kHostile);
  for (const char* format : {"text", "md", "csv", "json"}) {
    expect_safe({"results", log, "--format", format});
  }
  for (const char* format : {"text", "csv", "csv-players", "json"}) {
    expect_safe({"stats", log, "--format", format});
  }
  expect_safe({"watch", log, log});
  expect_safe({"results", log_of("a\nb")});
}

TEST_F(HostileText, OfGameLogsIsNoFormulaInCsv) {
  const std::string log = log_of("=cmd|'/C_calc'!A0");
  const std::string results = run({"results", log, "--format", "csv"}).out;
  EXPECT_THAT(results, HasSubstr("'=cmd|"));
  for (const char* format : {"csv", "csv-players"}) {
    const std::string stats = run({"stats", log, "--format", format}).out;
    EXPECT_THAT(stats, Not(HasSubstr(",=cmd")));
    EXPECT_THAT(stats, Not(HasSubstr("\n=cmd")));
    EXPECT_THAT(stats, HasSubstr("'=cmd|"));
  }
}

TEST_F(HostileText, OfConfigurationsIsNotPrinted) {
  std::ofstream(path("cls.toml")) << "[tournament]\nformat = \"x\\u001B[2Jy\\u202E\"\n"
                                     "[teams.RED]\nendpoint = \"mock\"\n";
  expect_safe({"tournament", "plan", folder_.path()});
  expect_safe({"match", "a\x1b[2Jb", "mock"});
  expect_safe({"stats", path("no\x1b[2Jfile")});
}

TEST_F(HostileText, OfTournamentFoldersIsNotPrinted) {
  std::ofstream(path("cls.toml")) << "[tournament]\ncycles = 5\nname = \""
                                  << "<script>"
                                  << "\"\n"
                                     "[server]\nkick_off_wait = 2\n"
                                     "[teams.\"+1+1\"]\nendpoint = \"mock\"\n"
                                     "[teams.BLUE]\nendpoint = \"mock\"\n";
  const std::string cup = folder_.path();
  ASSERT_EQ(run({"tournament", "run", cup, "--quiet"}).exit_code, 0);

  {
    SQLite::Database store(cup + "/tournament.db", SQLite::OPEN_READWRITE);
    const base::Json text = kHostile.substr(0, kHostile.find('\xff')) + "<script>\n```\n";
    store.exec("UPDATE match SET outcome = json_set(outcome, '$.message', json('" + text.dump() +
               "'), '$.warnings', json_array(json('" + text.dump() +
               "')), '$.end_reason', 'crashed', '$.host', json('" + text.dump() + "'))");
  }

  expect_safe({"tournament", "status", cup});
  for (const char* format : {"text", "md", "csv", "json", "html", "junit"}) {
    expect_safe({"tournament", "report", cup, "--format", format});
  }

  const std::string markdown = run({"tournament", "report", cup, "--format", "md"}).out;
  std::istringstream lines(markdown);
  bool code = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) code = !code;
    if (code) continue;
    const std::size_t at = line.find("<script>");
    EXPECT_TRUE(at == std::string::npos || line[at - 1] == '\\') << line;
  }

  const std::string csv = run({"tournament", "report", cup, "--format", "csv"}).out;
  EXPECT_THAT(csv, Not(HasSubstr(",+1+1")));
}

class FullOutput : public HostileText {
 protected:
  CommandResult run_into_full_disk(const std::string& arguments) const {
    return tests::run({"/bin/sh", "-c", cls_binary().string() + " " + arguments + " >/dev/full"});
  }
};

TEST_F(FullOutput, IsAnErrorOfEveryCommand) {
  const std::string log = log_of("A");
  for (const std::string& arguments :
       {"results " + log, "stats " + log, std::string("version"), std::string("help match"),
        "match mock mock --cycles 2 --dir " + path("m")}) {
    EXPECT_THAT(
        run_into_full_disk(arguments),
        Exits(74, HasSubstr("cls: cannot write standard output: No space left on device\n")));
  }
}

}  // namespace
}  // namespace cls::tests
