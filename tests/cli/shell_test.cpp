// Completion with the tabulator key of bash, fish and zsh.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/installed.h"
#include "tests/support/pseudo_terminal.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

/// How a test starts a shell. The function `cls` prints its arguments, so that a completed line
/// shows what the shell made of it; completion scripts call the program itself.
struct Shell {
  std::string name;
  std::vector<std::string> command;
  std::string setup;  ///< reads the script cls.NAME
};

void PrintTo(const Shell& shell, std::ostream* out) { *out << shell.name; }

const Shell kShells[] = {
    {"bash", {"bash", "--norc", "--noprofile", "-i"}, "cls() { echo \"ran:$*:\"; }; . ./cls.bash"},
    {"zsh",
     {"zsh", "-f", "-i"},
     "unsetopt prompt_sp; autoload -Uz compinit; compinit -D -u; "
     "cls() { echo \"ran:$*:\"; }; . ./cls.zsh"},
};

/// A folder with scripts, a configuration, and `cls` on PATH.
class ShellCompletion : public testing::TestWithParam<Shell> {
 protected:
  void SetUp() override {
    if (!is_installed(GetParam().name)) GTEST_SKIP() << "no " << GetParam().name;
    prepare(GetParam().name);
  }

  void prepare(const std::string& shell) {
    fs::create_directories(folder_.path() / "bin");
    fs::create_directories(folder_.path() / "helios/sub");
    fs::create_symlink(cls_binary(), folder_.path() / "bin/cls");
    std::ofstream(folder_.path() / "cls.toml") << "[teams.gracehopper]\nendpoint = \"mock\"\n";
    std::ofstream(folder_.path() / "script with spaces.json") << "{}\n";
    std::ofstream(folder_.path() / ("cls." + shell))
        << run({cls_binary(), "completion", shell}).out;
  }

  std::vector<std::string> environment() const {
    return {"PATH=" + (folder_.path() / "bin").string() + ":" + std::getenv("PATH"),
            "HOME=" + folder_.path().string(), "PS1=ready> ", "TERM=dumb", "LC_ALL=C.UTF-8"};
  }

  TemporaryFolder folder_;
};

struct Line {
  const char* typed;
  const char* ran;
};

TEST_P(ShellCompletion, CompletesWithTheTabulatorKey) {
  const std::vector<Line> lines = {
      {"cls mat\t", "ran:match:"},
      {"cls tournament sto\t", "ran:tournament stop:"},
      {"cls match gra\tmock", "ran:match gracehopper mock:"},
      {"cls match mock:ho\t", "ran:match mock:hold:"},
      {"cls match mock team:hel\tsu\t", "ran:match mock team:helios/sub"},
      {"cls match --mod\tr\t", "ran:match --mode realtime:"},
      {"cls match --mode=lo\t", "ran:match --mode=lockstep:"},
      {"cls match --set server::half_ti\t5", "ran:match --set server::half_time=5:"},
      {"cls test referee_offs\t", "ran:test referee_offside:"},
      {"cls mock scr\t", "ran:mock script with spaces.json:"},
  };

  PseudoTerminal terminal(GetParam().command, environment(), folder_.path());
  terminal.type(GetParam().setup + "; echo set''up\n");
  ASSERT_TRUE(terminal.wait_for("setup")) << terminal.shown();

  for (const Line& line : lines) {
    terminal.type(line.typed);
    terminal.type("\n");
    ASSERT_TRUE(terminal.wait_for(line.ran)) << line.typed << "\n" << terminal.shown();
  }
}

INSTANTIATE_TEST_SUITE_P(Shells, ShellCompletion, testing::ValuesIn(kShells),
                         [](const auto& shell) { return shell.param.name; });

// fish prints its completions of a line.
class FishCompletion : public ShellCompletion {};

TEST_P(FishCompletion, PrintsCandidatesOfALine) {
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"cls mat", "match\tplay one match and print its result\n"},
      {"cls match gra", "gracehopper\tmock\n"},
      {"cls match mock:ho", "mock:hold\ta behavior of the mock\n"},
      {"cls match mock team:hel", "team:helios/"},
      {"cls match --mode=lo", "--mode=lockstep\n"},
      {"cls test referee_offs", "referee_offside\t"},
      {"cls mock scr", "script with spaces.json\n"},
  };
  for (const auto& [line, candidate] : lines) {
    const CommandResult result =
        Command({"fish", "--no-config", "-c", "source cls.fish; complete -C '" + line + "'"},
                environment(), folder_.path())
            .finish();
    EXPECT_EQ(result.out.find(candidate), 0u) << line << "\n" << result.out << result.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Shells, FishCompletion, testing::Values(Shell{"fish", {}, ""}),
                         [](const auto& shell) { return shell.param.name; });

// bash-completion loads the script by the name of the program.
TEST(ShellScripts, AreValid) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    if (!is_installed(shell)) continue;
    TemporaryFolder folder;
    const fs::path script = folder.path() / "script";
    std::ofstream(script) << run({cls_binary(), "completion", shell}).out;
    EXPECT_THAT(run({shell, "-n", script}), Exits(0));
  }
}

}  // namespace
}  // namespace cls::tests
