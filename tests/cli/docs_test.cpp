// The documentation is true: its examples run, its commands and options exist, its links resolve.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/doc_page.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/language.h"
#include "tests/support/python.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

#if defined(__OPTIMIZE__) && !CLS_SANITIZED
constexpr bool kPlaysWholeMatches = true;
#else
constexpr bool kPlaysWholeMatches = false;  // minutes each
#endif

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A folder in which the examples of a page run: `cls` and a Python with gRPC on PATH, and what a
/// built checkout has.
class ExampleFolder {
 public:
  ExampleFolder() : python_(python_with_grpc()) {
    fs::create_directory(folder_.path() / "bin");
    fs::create_symlink(cls_binary(), folder_.path() / "bin/cls");
    if (!python_.empty()) {
      std::ofstream(folder_.path() / "bin/python3") << "#!/bin/sh\nexec " << python_ << " \"$@\"\n";
      fs::permissions(folder_.path() / "bin/python3", fs::perms::owner_all);
    }
    for (const char* name : {"examples", "proto", "python"}) {
      fs::create_symlink(source_folder() / name, folder_.path() / name);
    }
    fs::create_symlink(CLS_BUILD_DIR, folder_.path() / "build");
  }

  bool has_python() const { return !python_.empty(); }

  void save(const CodeBlock& block) const {
    const fs::path file = folder_.path() / block.file;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << joined(block.lines);
  }
  void save_files_of(const fs::path& page) const {
    for (const CodeBlock& block : read_page(page).blocks) {
      if (!block.file.empty()) save(block);
    }
  }

  /// What a terminal would show.
  CommandResult run(const std::string& command) const {
    const std::string path = (folder_.path() / "bin").string() + ":" + std::getenv("PATH");
    Command shell({"/bin/sh", "-c", "{ " + command + "\n} 2>&1"},
                  {"PATH=" + path, std::string("PYTHONPATH=") + CLS_BUILD_DIR + "/python"},
                  folder_.path());
    return shell.finish(std::chrono::seconds(300));
  }

 private:
  TemporaryFolder folder_;
  std::string python_;
};

// A notice that no page shows.
bool says_that_host_is_slow(const std::string& line) {
  return line.find(" will take about ") != std::string::npos;
}

bool is_whole_match(const std::string& command) {
  return command.starts_with("cls match") && command.find("--cycles") == std::string::npos &&
         command.find("--half-time") == std::string::npos;
}

class DocExamples : public testing::TestWithParam<std::string> {
 protected:
  // Why the commands of a block cannot run here; empty: they can.
  std::string why_skipped(const CodeBlock& block) const {
    if (block.needs.empty()) return {};
    const auto unreachable = no_registry_.find(block.needs);
    return unreachable != no_registry_.end() ? unreachable->second : why_missing(block.needs);
  }

  void run_examples(const ExampleFolder& folder, const CodeBlock& block) {
    for (const ConsoleCommand& example : console_commands(block)) {
      if (example.command.find("python3") != std::string::npos && !folder.has_python()) {
        skip("no Python with grpc", example.command);
      } else if (is_whole_match(example.command) && !kPlaysWholeMatches) {
        skip("a whole match in a slow build", example.command);
      } else if (const std::string why = why_skipped(block); !why.empty()) {
        skip(why, example.command);
      } else {
        run_example(folder, block, example);
      }
    }
  }

  std::string skipped_;

 private:
  void skip(const std::string& why, const std::string& command) {
    skipped_ += "\n  " + why + ": " + command;
  }

  void run_example(const ExampleFolder& folder, const CodeBlock& block,
                   const ConsoleCommand& example) {
    const CommandResult shown = folder.run(example.command);
    if (!block.needs.empty() && shown.exit_code != 0 && is_about_network(shown.out)) {
      no_registry_[block.needs] = block.needs + ": cannot reach the registry of its packages";
      return skip(no_registry_[block.needs], example.command);
    }
    std::vector<std::string> lines = lines_of(shown.out);
    std::erase_if(lines, says_that_host_is_slow);
    EXPECT_TRUE(shows_output(example.output, lines))
        << GetParam() << ":" << block.line << ": " << example.command << "\nthe page shows\n"
        << joined(example.output) << "the program prints\n"
        << shown.out;
  }

  std::map<std::string, std::string> no_registry_;  ///< by language
};

std::vector<std::string> pages_with_examples() {
  std::vector<std::string> pages;
  for (const fs::path& path : doc_pages()) {
    for (const CodeBlock& block : read_page(path).blocks) {
      if (block.language != "console") continue;
      pages.push_back(fs::relative(path, source_folder()).generic_string());
      break;
    }
  }
  return pages;
}

TEST_P(DocExamples, PrintWhatThePageShows) {
  const ExampleFolder folder;
  const DocPage page = read_page(source_folder() / GetParam());
  if (!page.files_of.empty()) folder.save_files_of(page.path.parent_path() / page.files_of);
  for (const CodeBlock& block : page.blocks) {
    if (!block.file.empty()) folder.save(block);
    if (block.language == "console" && block.not_run.empty()) run_examples(folder, block);
  }
  if (!skipped_.empty()) GTEST_SKIP() << skipped_;
}

INSTANTIATE_TEST_SUITE_P(Pages, DocExamples, testing::ValuesIn(pages_with_examples()),
                         [](const auto& page) {
                           return std::regex_replace(page.param, std::regex("[^A-Za-z0-9]"), "_");
                         });

/// The words of a `cls` command on a page, up to a comment, pipe or redirection; quoted arguments
/// are one word.
std::vector<std::string> words_of(const std::string& line) {
  static const std::regex word(R"('[^']*'|"[^"]*"|[^\s'"]+)");
  std::vector<std::string> words;
  for (std::sregex_iterator at(line.begin(), line.end(), word), end; at != end; ++at) {
    const std::string text = at->str();
    if (text[0] == '#' || text[0] == '|' || text[0] == '>' || text[0] == '&') break;
    words.push_back(text);
  }
  if (!words.empty() && words[0] == "$") words.erase(words.begin());
  return words;
}

/// Help of `cls COMMAND` or `cls COMMAND SUBCOMMAND`; empty if there is no such command.
std::string help_of(const std::vector<std::string>& words) {
  static std::map<std::string, std::string> known;
  std::vector<std::string> command = {cls_binary(), words[1]};
  const bool nested = words[1] == "check" || words[1] == "tournament" || words[1] == "tune" ||
                      words[1] == "dataset" || words[1] == "book";
  if (nested && words.size() > 2) command.push_back(words[2]);
  command.push_back("--help");
  const std::string key = joined(command);
  if (!known.contains(key)) {
    const CommandResult help = run(command);
    known[key] = help.exit_code == 0 ? help.out : "";
  }
  return known[key];
}

void check_command(const fs::path& page, const std::string& line) {
  const std::vector<std::string> words = words_of(line);
  if (words.size() < 2 || (words[0] != "cls" && words[0] != "build/bin/cls")) return;
  if (words[1][0] < 'a' || words[1][0] > 'z') return;  // an option, or a drawing
  const std::string help = help_of(words);
  EXPECT_FALSE(help.empty()) << page << ": no command: " << line;
  for (const std::string& word : words) {
    if (!word.starts_with("--") || word.size() < 3) continue;
    const std::string option = word.substr(0, word.find('='));
    EXPECT_TRUE(std::regex_search(help, std::regex(option + "[^a-z-]")))
        << page << ": no option " << option << ": " << line;
  }
}

TEST(Docs, CommandsAndOptionsExist) {
  int checked = 0;
  for (const fs::path& path : doc_pages()) {
    for (const CodeBlock& block : read_page(path).blocks) {
      if (block.language != "sh" && block.language != "console" && !block.language.empty())
        continue;
      for (const std::string& line : block.lines) {
        checked += line.find("cls ") != std::string::npos ? 1 : 0;
        check_command(path, line);
      }
    }
  }
  EXPECT_GE(checked, 50);
}

TEST(Docs, LinksResolve) {
  for (const fs::path& path : doc_pages()) {
    const DocPage page = read_page(path);
    for (const std::string& link : page.links) {
      const std::size_t hash = std::min(link.find('#'), link.size());
      const fs::path target = hash == 0 ? path : path.parent_path() / link.substr(0, hash);
      ASSERT_TRUE(fs::exists(target)) << path << ": " << link;
      if (hash == link.size()) continue;
      EXPECT_TRUE(read_page(target).anchors.contains(link.substr(hash + 1)))
          << path << ": " << link;
    }
  }
}

TEST(ShowsOutput, ComparesTextAndIgnoresMeasurements) {
  EXPECT_TRUE(shows_output({"a 2 : 1 b"}, {"a 2 : 1 b"}));
  EXPECT_FALSE(shows_output({"a 2 : 1 b"}, {"a 2 : 2 b"}));
  EXPECT_TRUE(shows_output({"  rpc p50    654 / 928 us"}, {"  rpc p50  1 / 2 us"}));
  EXPECT_TRUE(shows_output({"runs/20260101T000000Z-a/"}, {"runs/20271231T101010Z-a/"}));
  EXPECT_FALSE(shows_output({"a"}, {"a", "b"}));
}

TEST(ShowsOutput, TakesDotsForAnyLines) {
  EXPECT_TRUE(shows_output({"a", "...", "d"}, {"a", "b", "c", "d"}));
  EXPECT_TRUE(shows_output({"..."}, {}));
  EXPECT_FALSE(shows_output({"a", "...", "d"}, {"a", "b"}));
}

TEST(ConsoleCommands, JoinContinuedLinesAndCollectOutput) {
  const CodeBlock block{"console", "", "", "", {"$ cls match \\", "    mock mock", "out", "$ ls"},
                        1};
  const auto commands = console_commands(block);
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].command, "cls match     mock mock");
  EXPECT_EQ(commands[0].output, std::vector<std::string>{"out"});
}

}  // namespace
}  // namespace cls::tests
