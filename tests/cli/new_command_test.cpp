// `cls new`: the files of a project and what it refuses. tests/matches plays with projects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/python.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
constexpr const char* kLanguages[] = {"python", "javascript", "typescript", "go",
                                      "java",   "rust",       "csharp"};

class NewCommand : public testing::Test, public cls::tests::ClsFolder {
 protected:
  CommandResult run_new(std::vector<std::string> words) const {
    words.insert(words.begin(), "new");
    return run(std::move(words));
  }
};

TEST_F(NewCommand, WritesProjectOfEachLanguage) {
  for (const std::string language : kLanguages) {
    const CommandResult result = run_new({language, "ada", "--dir", language, "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto document = base::Json::parse(result.out);
    EXPECT_EQ(document["schema"], "cls.new/1");
    const fs::path project = folder_.path() / language;
    for (const auto& file : document["files"].get<std::vector<std::string>>()) {
      const std::string text = read_file(project / file);
      EXPECT_FALSE(text.empty()) << language << " " << file;
      EXPECT_THAT(text, Not(HasSubstr("@NAME@"))) << file;
      EXPECT_THAT(file, Not(HasSubstr("vectors")));
    }
    EXPECT_EQ(access((project / "run").c_str(), X_OK), 0);
    EXPECT_THAT(read_file(project / "cls.toml"), HasSubstr("[teams.ada]"));
    for (const char* file :
         {"README.md", ".gitignore", ".editorconfig", ".vscode/tasks.json", ".vscode/launch.json",
          ".github/workflows/test.yml", "tests/scores.json", "proto/playmaker.proto",
          "proto/team_playmaker.proto"}) {
      EXPECT_TRUE(fs::exists(project / file)) << language << " " << file;
    }
  }
}

TEST_F(NewCommand, NextStepsHoldForAnyFolder) {
  const CommandResult result = run_new({"python", "ada", "--dir", "my team"});
  EXPECT_THAT(result.out, HasSubstr("\n  cd 'my team'\n"));
}

// A new project has scenarios, and no program of tests yet.
TEST_F(NewCommand, RunTestNamesTheScenariosWhereThereAreNoTests) {
  const std::string python = python_with_grpc();
  if (python.empty()) GTEST_SKIP() << "no Python with grpc";
  ASSERT_EQ(run_new({"python", "ada"}).exit_code, 0);
  Command command({folder_.path() / "ada/run", "test"}, {}, folder_.path());
  EXPECT_THAT(command.finish(std::chrono::seconds(120)),
              Exits(2, HasSubstr("cls test tests/ plays the scenarios")));
}

TEST_F(NewCommand, CommentsOfTheReadmeShareAColumnForEveryName) {
  for (const std::string name : {"a", "golden", "fifteen_letters"}) {
    ASSERT_EQ(run_new({"python", name}).exit_code, 0);
    std::istringstream readme(read_file(folder_.path() / name / "README.md"));
    std::set<std::size_t> columns;
    for (std::string line; std::getline(readme, line);) {
      if (const std::size_t comment = line.find("  # "); comment != std::string::npos) {
        columns.insert(comment);
      }
    }
    EXPECT_EQ(columns.size(), 1u) << name;
  }
}

TEST_F(NewCommand, MinimalTemplateReplacesDecisionsOnly) {
  ASSERT_EQ(run_new({"java", "ada", "--dir", "team"}).exit_code, 0);
  ASSERT_EQ(run_new({"java", "ada", "--dir", "minimal", "--template", "minimal"}).exit_code, 0);
  const fs::path source = "src/main/java/team";
  const auto text = [&](const char* project, const char* file) {
    return read_file(folder_.path() / project / source / file);
  };
  EXPECT_LT(text("minimal", "Decide.java").size(), text("team", "Decide.java").size() / 2);
  EXPECT_EQ(text("minimal", "Game.java"), text("team", "Game.java"));
}

TEST_F(NewCommand, TemplatesAddFilesOfTheirOwn) {
  for (const std::string language : kLanguages) {
    for (const std::string name : {"high-level", "rl"}) {
      const std::string dir = language + "-" + name;
      const CommandResult result =
          run_new({language, "ada", "--dir", dir, "--template", name, "--json"});
      ASSERT_EQ(result.exit_code, 0) << result.err;
      int decisions = 0;
      const auto document = base::Json::parse(result.out);
      for (const auto& file : document["files"].get<std::vector<std::string>>()) {
        const std::string stem = fs::path(file).stem();
        if (stem == "decide" || stem == "Decide") ++decisions;
      }
      EXPECT_EQ(decisions, 1) << dir;
      EXPECT_EQ(fs::exists(folder_.path() / dir / "policy.txt"), name == "rl") << dir;
    }
  }

  const std::string readme = read_file(folder_.path() / "go-rl/README.md");
  EXPECT_THAT(readme, HasSubstr("\n\n## Train it\n"));
  EXPECT_THAT(readme, HasSubstr("\npython3 train.py --rounds 20\n```\n\n"));
  EXPECT_THAT(read_file(folder_.path() / "go-high-level/README.md"), Not(HasSubstr("rain")));

  const std::string train = read_file(folder_.path() / "go-rl/train.py");
  EXPECT_THAT(train, HasSubstr("\"cls\", \"match\", \"ada\""));
}

// What the debugger of each language starts is a file of the project, or its build makes it.
TEST_F(NewCommand, DebuggerStartsTheProgramOfTheProject) {
  const std::map<std::string, std::pair<std::string, std::string>> kStarted = {
      {"python", {"program", "playmaker.py"}},
      {"javascript", {"program", "src/main.js"}},
      {"typescript", {"outFiles", ""}},
      {"go", {"mode", ""}},
      {"java", {"mainClass", ""}},
      {"rust", {"cargo", ""}},
      {"csharp", {"projectPath", "Team.csproj"}}};

  for (const std::string language : kLanguages) {
    run_new({language, "ada", "--dir", language});
    const fs::path project = folder_.path() / language;
    const auto launch = base::Json::parse(read_file(project / ".vscode/launch.json"));
    const auto& configuration = launch["configurations"][0];
    const auto& [key, file] = kStarted.at(language);
    EXPECT_TRUE(configuration.contains(key)) << language;
    if (!file.empty()) {
      EXPECT_EQ(configuration[key], "${workspaceFolder}/" + file);
      EXPECT_TRUE(fs::exists(project / file)) << language;
    }
    const auto tasks = base::Json::parse(read_file(project / ".vscode/tasks.json"));
    EXPECT_EQ(tasks["tasks"][0]["label"], configuration["preLaunchTask"]);
  }
}

// Debian 12 lacks .NET, and has no Go, Node.js and Rust as recent as the projects need.
TEST_F(NewCommand, WorkflowInstallsToolsOfTheLanguage) {
  const auto workflow = [&](const std::string& language) {
    run_new({language, "ada", "--dir", language});
    return read_file(folder_.path() / language / ".github/workflows/test.yml");
  };
  EXPECT_THAT(workflow("go"), HasSubstr("setup-go@v5\n        with: {go-version: '1.26'"));
  EXPECT_THAT(workflow("javascript"), HasSubstr("node-version: 20}"));
  EXPECT_THAT(workflow("typescript"), HasSubstr("node-version: 20}"));
  EXPECT_THAT(workflow("rust"), HasSubstr("toolchain: '1.88'}"));
  EXPECT_THAT(workflow("csharp"), HasSubstr("dotnet-version: 8.0.x}"));
  const std::string python = workflow("python");
  EXPECT_THAT(python, HasSubstr("python3-grpcio"));
  EXPECT_EQ(python.find('@' + std::string("SETUP")), std::string::npos);
}

TEST_F(NewCommand, RefusesUnknownWordsAndExistingFiles) {
  EXPECT_EQ(
      run_new({"rusty", "ada"}).err,
      "cls: unknown language 'rusty': python, javascript, typescript, go, java, rust, csharp; "
      "did you mean 'rust'?\n");
  EXPECT_EQ(run_new({"go", "ada", "--template", "teem"}).err,
            "cls: unknown template 'teem': team, minimal, high-level, rl; did you mean 'team'?\n");
  EXPECT_EQ(run_new({"go", "a b"}).exit_code, 2);
  ASSERT_EQ(run_new({"go", "ada"}).exit_code, 0);
  EXPECT_THAT(run_new({"go", "ada"}),
              Exits(73, HasSubstr("it stays as it is, and --dir selects another folder")));
}

}  // namespace
}  // namespace cls::tests
