// The CI templates for users: their commands run in a repository as they stand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/installed.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

struct Template {
  const char* name;
  const char* file;
  const char* commands;  ///< Python expression of a list of shell texts, from the document `d`
};

void PrintTo(const Template& one, std::ostream* out) { *out << one.name; }

// Not the steps that download cls and install packages.
const Template kTemplates[] = {
    {"github", ".github/workflows/playmaker.yml",
     "[s['run'] for s in d['jobs']['playmaker']['steps'] if s.get('name') in "
     "('build', 'test', 'compare')]"},
    {"gitlab", "packaging/ci/gitlab.yml", "d['playmaker']['script'][2:]"},
};

constexpr const char* kPlaymaker =
    "#!/bin/sh\n[ \"$1\" = build ] && exit 0\nexec cls mock \"$@\" --quiet\n";
constexpr const char* kScenario =
    R"({"mode": "play_on", "ball": {"at": [0, 0]}, "steps": 3, "under_test": "left",
  "left": {"players": {"2": {"at": [-30, 0]}}},
  "right": {"playmaker": "mock:hold", "players": {"2": {"at": [30, 0]}}},
  "expect": [{"player": "left 2", "is": {"x": {"<": 0}}, "at": "end"}]})";

class CiTemplate : public testing::TestWithParam<Template> {
 protected:
  void SetUp() override {
    if (tests::run({"python3", "-c", "import yaml"}).exit_code != 0) {
      GTEST_SKIP() << "no Python with yaml";
    }
    fs::create_directories(folder_.path() / "bin");
    fs::create_symlink(cls_binary(), folder_.path() / "bin/cls");
    fs::create_directories(folder_.path() / "origin/tests");
    std::ofstream(folder_.path() / "origin/run") << kPlaymaker;
    fs::permissions(folder_.path() / "origin/run", fs::perms(0755));
    std::ofstream(folder_.path() / "origin/tests/stays.json") << kScenario;
    const CommandResult made = shell(
        "cd origin && git init -q -b main && git add . && "
        "git -c user.name=a -c user.email=a@b commit -q -m first && git clone -q . ../work");
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }

  CommandResult shell(const std::string& text) const {
    const std::string path = (folder_.path() / "bin").string() + ":" + std::getenv("PATH");
    Command command({"sh", "-e", "-c", text},
                    {"PATH=" + path, "SETUP=true", "BUILD=./run build", "START=./run --port {port}",
                     "TESTS=tests", "BASE=main", "CYCLES=10", "PAIRS=1",
                     "GITHUB_STEP_SUMMARY=" + (folder_.path() / "summary.md").string()},
                    folder_.path());
    return command.finish(std::chrono::seconds(300));
  }

  TemporaryFolder folder_;
};

TEST_P(CiTemplate, TestsAndComparesAPlaymaker) {
  const std::string program = "import yaml; d = yaml.safe_load(open('" +
                              (source_folder() / GetParam().file).string() +
                              "')); print('\\n'.join(" + GetParam().commands + "))";
  const CommandResult commands = tests::run({"python3", "-c", program});
  ASSERT_EQ(commands.exit_code, 0) << commands.err;
  const CommandResult ran = shell("cd work\n" + commands.out);
  EXPECT_EQ(ran.exit_code, 0) << commands.out << ran.out << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("1 passed")) << ran.out;
  const std::string table = read_file(folder_.path() / "work/runs/compare.txt");
  EXPECT_THAT(table, HasSubstr("base")) << table;
  EXPECT_TRUE(fs::exists(folder_.path() / "work/junit.xml"));
  if (std::string(GetParam().name) == "github") {
    EXPECT_THAT(read_file(folder_.path() / "summary.md"), HasSubstr(table));
  }
}

// The services' own checkers, where they are installed.
TEST(CiTemplates, AreValid) {
  const std::string github = source_folder() / kTemplates[0].file;
  const std::string gitlab = source_folder() / kTemplates[1].file;
  const std::vector<std::vector<std::string>> checks = {
      {"actionlint", github},
      {"check-jsonschema", "--builtin-schema", "vendor.github-workflows", github},
      {"check-jsonschema", "--builtin-schema", "vendor.gitlab-ci", "--data-transform", "gitlab-ci",
       gitlab}};
  int checked = 0;
  for (const std::vector<std::string>& check : checks) {
    if (!is_installed(check[0])) continue;
    const CommandResult result = tests::run(check);
    EXPECT_EQ(result.exit_code, 0) << check[0] << "\n" << result.out << result.err;
    ++checked;
  }
  if (checked == 0) GTEST_SKIP() << "neither actionlint nor check-jsonschema";
}

INSTANTIATE_TEST_SUITE_P(Ci, CiTemplate, testing::ValuesIn(kTemplates),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace cls::tests
