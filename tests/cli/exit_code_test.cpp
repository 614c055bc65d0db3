// Exit codes: the table of docs/cli.md, and commands that end with each of them.
#include "cli/terminal/exit_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using namespace cls::cli;

// The two groups of `row`: code and meaning.
std::map<int, std::string> table_in(const std::string& text, const std::regex& row) {
  std::map<int, std::string> table;
  const std::sregex_iterator end;
  for (std::sregex_iterator at(text.begin(), text.end(), row); at != end; ++at) {
    table[std::stoi((*at)[1].str())] = (*at)[2].str();
  }
  return table;
}

TEST(ExitCode, ManualHasTheTableOfTheHeader) {
  const auto source = source_folder();
  const auto header = cls::base::read_file(source / "cli" / "terminal" / "exit_code.h");
  const auto manual = cls::base::read_file(source / "docs" / "cli.md");
  ASSERT_TRUE(header && manual);
  const auto codes = table_in(*header, std::regex("k\\w+ = (\\d+), +///< ([^;\n]+)"));
  const auto documented = table_in(*manual, std::regex("\\n\\| (\\d+) \\| ([^|]+) \\|"));
  EXPECT_EQ(codes.size(), 15u);
  EXPECT_EQ(documented.size(), codes.size());
  for (const auto& [code, meaning] : codes) {
    ASSERT_TRUE(documented.contains(code)) << code;
    EXPECT_TRUE(documented.at(code).starts_with(meaning)) << code << ": " << documented.at(code);
  }
}

class ExitCodes : public testing::Test, public ClsFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    const auto path = folder_.path() / name;
    std::ofstream(path) << text;
    return path.string();
  }
  int code(std::vector<std::string> arguments) const { return run(std::move(arguments)).exit_code; }
};

TEST_F(ExitCodes, OfUsageAndFiles) {
  EXPECT_EQ(code({"version"}), kOk);
  EXPECT_EQ(code({"match", "mock", "mock", "--cycles", "many"}), kUsage);
  EXPECT_EQ(code({"results", file("noise.rcg", "\x1f\x8b noise")}), kBadData);
  EXPECT_EQ(code({"results", "missing.rcg"}), kNoInput);
  EXPECT_EQ(code({"init", file("plain", "") + "/cup"}), kCannotCreate);
  EXPECT_EQ(code({"tournament", "plan", "cup", "--config", file("cls.toml", "[tournment]\n")}),
            kBadConfig);
}

TEST_F(ExitCodes, OfPlaymakersAndPorts) {
  EXPECT_EQ(code({"check", "playmaker", "127.0.0.1:1", "--start-timeout", "0.3"}), kUnavailable);
  Command mock({cls_binary(), "mock"});
  ASSERT_TRUE(mock.wait_for_output("\n"));
  const std::string line = mock.out();
  const std::string port = line.substr(line.rfind(':') + 1, line.find('\n') - line.rfind(':') - 1);
  EXPECT_EQ(code({"mock", "--port", port}), kTryAgain);
  mock.send_signal(SIGINT);
  EXPECT_EQ(mock.finish().exit_code, kInterrupted);
}

TEST_F(ExitCodes, OfMatches) {
  EXPECT_EQ(code({"match", "mock:hold", "mock:hold", "--time-limit", "0.01"}), kTimedOut);
  EXPECT_EQ(code({"compare", "mock:hold", "mock:hold", "--cycles", "5", "--max-pairs", "1"}),
            kUndecided);
}

TEST_F(ExitCodes, StrictFailsOnWarningsOnly) {
  const std::vector<std::string> clean = {"match",    "mock:hold", "mock:hold",
                                          "--cycles", "20",        "--strict"};
  EXPECT_EQ(code(clean), kOk);
  const std::string unmet = file("unmet.json", R"({"otherwise": "hold",
    "expect": [{"rpc": "GetTrainerActions", "count": {">=": 1}}]})");
  std::vector<std::string> warned = {"match", "mock:hold", "mock:" + unmet, "--cycles", "20"};
  EXPECT_EQ(code(warned), kOk);
  warned.emplace_back("--strict");
  const CommandResult strict = run(warned);
  EXPECT_EQ(strict.exit_code, kFailed);
  EXPECT_THAT(strict.err, HasSubstr("cls: 1 warning (--strict)\n"));
}

}  // namespace
}  // namespace cls::tests
