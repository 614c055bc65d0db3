// docs/troubleshooting.md explains every end reason, exit code and warning, each at its anchor.
#include "cli/support/troubleshooting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "cli/terminal/exit_code.h"
#include "tests/cli/doc_page.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using soccer::EndReason;

fs::path page_path() { return source_folder() / "docs/troubleshooting.md"; }

TEST(Troubleshooting, HasAnchorOfEveryEndReason) {
  const DocPage page = read_page(page_path());
  for (int i = 0; i <= static_cast<int>(EndReason::kInterrupted); ++i) {
    const auto reason = static_cast<EndReason>(i);
    EXPECT_TRUE(page.anchors.contains(std::string(name(reason)))) << name(reason);
  }
}

TEST(Troubleshooting, HintNamesEntryUnlessMatchFinished) {
  EXPECT_EQ(cli::troubleshooting_hint(EndReason::kFinished), "");
  for (int i = 1; i <= static_cast<int>(EndReason::kInterrupted); ++i) {
    const auto reason = static_cast<EndReason>(i);
    const std::string hint = cli::troubleshooting_hint(reason);
    EXPECT_EQ(hint.find("see `cls explain " + std::string(name(reason)) + "`"), 0u) << hint;
    EXPECT_LE(hint.size(), 76u) << hint;
  }
}

TEST(Troubleshooting, HintNamesDoctorWhenNothingStarted) {
  EXPECT_THAT(cli::troubleshooting_hint(EndReason::kRefused), HasSubstr("`cls doctor`"));
}

TEST(Troubleshooting, HasAnchorOfEveryExitCode) {
  const DocPage page = read_page(page_path());
  const std::string header = read_file(source_folder() / "cli/terminal/exit_code.h");
  const std::regex value(R"(  k\w+ = (\d+),)");
  int codes = 0;
  for (std::sregex_iterator at(header.begin(), header.end(), value), end; at != end; ++at) {
    ++codes;
    EXPECT_TRUE(page.anchors.contains("exit-code-" + at->str(1))) << at->str();
  }
  EXPECT_GE(codes, 14);
}

/// `text` with its whitespace reduced to single spaces.
std::string words(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(\s+)"), " ");
}

/// The longest part of a literal between placeholders; that is what the page must contain.
std::string longest_part(const std::string& literal) {
  static const std::regex placeholder(R"(\{[^}]*\}|\\n)");
  std::string longest;
  std::sregex_token_iterator part(literal.begin(), literal.end(), placeholder, -1), end;
  for (; part != end; ++part) {
    if (part->length() > static_cast<std::ptrdiff_t>(longest.size())) longest = part->str();
  }
  longest.erase(0, longest.find_first_not_of(" :;,()"));
  longest.erase(std::min(longest.size(), longest.find_last_not_of(" :;,()") + 1));
  return words(longest);
}

/// The warnings that the statements of a source file emit; only the text that is in the statement.
std::vector<std::string> warnings_of(std::string source) {
  if (source.find("warn") == std::string::npos) return {};
  source = std::regex_replace(source, std::regex(R"("\s*\n\s*")"), "");
  static const std::regex statement(
      R"rx((\bwarn\(|\bwarn_once\(|warnings_?\.push_back\(|\bwarning_ = |"cls: warning: )("(?:[^"\\]|\\.)*"|[^;"])*;)rx");
  static const std::regex literal(R"rx("((?:[^"\\]|\\.)*)")rx");
  constexpr std::size_t kMinText = 12;  // shorter ones connect the parts of a warning
  std::vector<std::string> warnings;
  for (std::sregex_iterator at(source.begin(), source.end(), statement), end; at != end; ++at) {
    const std::string text = at->str();
    for (std::sregex_iterator part(text.begin(), text.end(), literal); part != end; ++part) {
      const std::string found = longest_part(part->str(1));
      if (found.size() >= kMinText && found != "cls: warning") warnings.push_back(found);
    }
  }
  return warnings;
}

TEST(Troubleshooting, ExplainsEveryWarning) {
  const std::string page = words(read_file(page_path()));
  int count = 0;
  for (const char* folder :
       {"match", "tournament", "scenario", "checks", "cli", "proxy", "mock-server"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      for (const std::string& warning : warnings_of(read_file(entry.path()))) {
        ++count;
        EXPECT_THAT(page, HasSubstr(warning)) << entry.path() << ": " << warning;
      }
    }
  }
  EXPECT_GE(count, 20);
}

TEST(WarningsOf, FindsTextOfWarnings) {
  EXPECT_EQ(warnings_of("warn(fmt::format(\"{}: no reply \"\n  \"within the limit ({})\", a));"),
            std::vector<std::string>{"no reply within the limit"});
  EXPECT_EQ(warnings_of("warning_ = \"the Playmaker is a fake\";"),
            std::vector<std::string>{"the Playmaker is a fake"});
  EXPECT_TRUE(warnings_of("warn(line); print(\"a text that is not a warning\");").empty());
}

}  // namespace
}  // namespace cls::tests
