// Parsing of the command line, help and usage errors.
#include "cli/application.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "cli/support/exit_code.h"

namespace {

struct Answer {
  int exit_code;
  std::string out;
  std::string err;
};

Answer run(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "cls");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code =
      cls::cli::run_application(static_cast<int>(arguments.size()), arguments.data());
  std::fflush(stdout);
  std::fflush(stderr);
  std::string out = testing::internal::GetCapturedStdout();
  return {exit_code, out, testing::internal::GetCapturedStderr()};
}

TEST(Application, PrintsVersionOnStdout) {
  const Answer answer = run({"version"});
  EXPECT_EQ(answer.exit_code, cls::cli::kOk);
  EXPECT_EQ(answer.out.substr(0, 6), "cls 0.");
  EXPECT_EQ(answer.err, "");
}

TEST(Application, PrintsHelpOnStdoutWithExamplesFirst) {
  const Answer answer = run({"--help"});
  EXPECT_EQ(answer.exit_code, cls::cli::kOk);
  EXPECT_NE(answer.out.find("  match         play one match and print its result\n"),
            std::string::npos)
      << answer.out;
  EXPECT_LT(answer.out.find("cls match mock mock"), answer.out.find("Usage: cls"))
      << "examples come first";
}

TEST(Application, HelpFitsATerminal) {
  for (const char* command : {"match", "compare", "tournament", "proxy", "test"}) {
    std::istringstream help(run({command, "--help"}).out);
    for (std::string line; std::getline(help, line);) {
      EXPECT_LE(line.size(), 100u) << line;
    }
  }
  std::istringstream help(run({"--help"}).out);
  for (std::string line; std::getline(help, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST(Application, ReportsUnknownCommandInOneLine) {
  const Answer answer = run({"mtach"});
  EXPECT_EQ(answer.exit_code, cls::cli::kUsage);
  EXPECT_EQ(answer.out, "");
  EXPECT_NE(answer.err.find("mtach"), std::string::npos) << answer.err;
  EXPECT_EQ(answer.err.find('\n'), answer.err.size() - 1) << answer.err;
}

TEST(Application, ReportsUsageErrorWithoutCommand) {
  EXPECT_EQ(run({}).exit_code, cls::cli::kUsage);
}

}  // namespace
