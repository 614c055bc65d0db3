// Topics of `cls help`, and manual pages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/installed.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

TEST(HelpCommand, PrintsPagesWithoutLinkTargets) {
  const CommandResult page = run({cls_binary(), "help", "testing"});
  EXPECT_EQ(page.exit_code, 0);
  const std::string source = read_file(source_folder() / "docs/testing.md");
  EXPECT_EQ(page.out.substr(0, page.out.find('\n')), source.substr(0, source.find('\n')));
  EXPECT_THAT(source, HasSubstr("]("));
  EXPECT_THAT(page.out, Not(HasSubstr("](")));
}

TEST(HelpCommand, ListsTopics) {
  const CommandResult topics = run({cls_binary(), "help", "topics"});
  EXPECT_THAT(topics.out, HasSubstr("formats/rcg "));
  const auto printed = base::Json::parse(run({cls_binary(), "help", "topics", "--json"}).out);
  ASSERT_GE(printed["topics"].size(), 20u);
  for (const auto& topic : printed["topics"]) {
    const auto name = topic["name"].get<std::string>();
    EXPECT_EQ(run({cls_binary(), "help", name}).exit_code, 0) << name;
    EXPECT_TRUE(fs::exists(source_folder() / "docs" / (name + ".md"))) << name;
  }
}

TEST(HelpCommand, SuggestsCommandsAndTopics) {
  EXPECT_EQ(run({cls_binary(), "help", "mtch"}).err,
            "cls: unknown command or topic 'mtch'; did you mean 'match'?\n");
  EXPECT_EQ(run({cls_binary(), "help", "troubleshoting"}).err,
            "cls: unknown command or topic 'troubleshoting'; did you mean 'troubleshooting'?\n");
}

TEST(HelpCommand, SearchesCommandsPagesAndNames) {
  const CommandResult found = run({cls_binary(), "help", "offside", "line", "--json"});
  ASSERT_EQ(found.exit_code, 0) << found.err;
  const auto document = base::Json::parse(found.out);
  EXPECT_EQ(document["schema"], "cls.help_search/1");
  std::map<std::string, int> kinds;
  for (const auto& one : document["found"]) ++kinds[one["kind"].get<std::string>()];
  EXPECT_GE(kinds["page"], 1) << found.out;
  EXPECT_GE(kinds["field"], 1) << found.out;

  const CommandResult option = run({cls_binary(), "help", "no-deadline"});
  EXPECT_THAT(option.out, HasSubstr("--no-deadline of cls match"));
  const CommandResult scattered = run({cls_binary(), "help", "linger", "watch"});
  EXPECT_THAT(scattered.out, HasSubstr("--linger of cls watch"));

  // In one section of a page, in none of its lines.
  const CommandResult section = run({cls_binary(), "help", "8000", "comes", "home"});
  EXPECT_THAT(section.out, HasSubstr("Save stamina: ")) << section.err;
  EXPECT_THAT(run({cls_binary(), "help", "zebra", "crossing"}),
              Exits(2, "cls: nothing has the words 'zebra crossing' (see cls help topics)\n"));
}

TEST(ManPages, DescribeAllCommandsAndOptions) {
  TemporaryFolder folder;
  ASSERT_EQ(run({cls_binary(), "help", "--man", folder.path()}).exit_code, 0);
  for (const char* page : {"cls.1", "cls-match.1", "cls-tournament-run.1", "cls-check-server.1"}) {
    EXPECT_TRUE(fs::exists(folder.path() / page)) << page;
  }
  const std::string match = read_file(folder.path() / "cls-match.1");
  for (const char* text :
       {".SH NAME\ncls\\-match \\- play one match", ".SH SYNOPSIS\n.B cls match\n",
        "\n  cls match mock mock", "\n.B \\-\\-seed N\n", "\n.SS Playmakers\n"}) {
    EXPECT_THAT(match, HasSubstr(text)) << text;
  }
  for (const char* page : {"match", "tournament", "help"}) {
    EXPECT_THAT(read_file(folder.path() / "cls.1"), HasSubstr(".BR cls\\-" + std::string(page)));
  }
}

TEST(ManPages, HaveExamplesOnlyUnderExamples) {
  TemporaryFolder folder;
  ASSERT_EQ(run({cls_binary(), "help", "--man", folder.path()}).exit_code, 0);
  const std::string match = read_file(folder.path() / "cls-match.1");
  const std::size_t examples = match.find(".SH EXAMPLES");
  const std::size_t sides = match.find("\n  HOST:PORT ");
  ASSERT_NE(sides, std::string::npos) << match;
  EXPECT_LT(match.find(".SH DESCRIPTION"), sides);
  EXPECT_LT(sides, examples);
}

TEST(ManPages, AreWellFormed) {
  if (!is_installed("mandoc")) GTEST_SKIP() << "no mandoc";
  TemporaryFolder folder;
  ASSERT_EQ(run({cls_binary(), "help", "--man", folder.path()}).exit_code, 0);
  for (const auto& page : fs::directory_iterator(folder.path())) {
    const CommandResult lint = run({"mandoc", "-T", "lint", "-W", "warning", page.path()});
    std::istringstream warnings(lint.out + lint.err);
    for (std::string line; std::getline(warnings, line);) {
      // The same binary writes the same pages on any day.
      EXPECT_THAT(line, HasSubstr("missing date"));
    }
  }
}

}  // namespace
}  // namespace cls::tests
