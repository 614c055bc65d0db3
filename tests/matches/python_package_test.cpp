// The Python package cls-playmaker: what its server reports, and that it installs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/python.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

std::string python_path(const fs::path& folder) { return "PYTHONPATH=" + folder.string(); }

// A copy of what an installation reads, so that no test writes into the source tree.
fs::path copy_package(const fs::path& folder) {
  fs::create_directories(folder / "proto");
  fs::create_directories(folder / "python");
  for (const char* name : {"playmaker.proto", "team_playmaker.proto"}) {
    fs::copy_file(source_folder() / "proto" / name, folder / "proto" / name);
  }
  for (const char* name : {"pyproject.toml", "setup.py", "README.md"}) {
    fs::copy_file(source_folder() / "python" / name, folder / "python" / name);
  }
  const fs::path package = folder / "python/cls_playmaker";
  fs::create_directories(package);
  for (const auto& entry : fs::directory_iterator(source_folder() / "python/cls_playmaker")) {
    if (entry.is_regular_file()) fs::copy_file(entry.path(), package / entry.path().filename());
  }
  return folder / "python";
}

void expect_success(const char* test) {
  const std::string python = python_with_grpc();
  if (python.empty()) GTEST_SKIP() << kNoPython;
  const auto tested =
      run({python, source_folder() / "python/tests" / test},
          {python_path(fs::path(CLS_BUILD_DIR) / "python"), "PYTHONDONTWRITEBYTECODE=1"});
  EXPECT_EQ(tested.exit_code, 0) << tested.err;
}

TEST(PythonPackage, ReportsErrorsAndStopsGracefully) { expect_success("serving_test.py"); }

TEST(PythonPackage, DecidesForTeamInOneCall) { expect_success("team_test.py"); }

TEST(PythonPackage, BuildsWithProtoc) {
  const std::string python = python_with_grpc();
  if (python.empty()) GTEST_SKIP() << kNoPython;
  if (run({python, "-c", "import setuptools"}).exit_code != 0) {
    GTEST_SKIP() << "no setuptools: install python3-setuptools";
  }
  TemporaryFolder folder;
  Command build({python, "setup.py", "-q", "build_py", "--build-lib", "out"}, {},
                copy_package(folder.path()));
  const auto built = build.finish();

  ASSERT_EQ(built.exit_code, 0) << built.err;

  const auto imported = run({python, "-c",
                             "from cls_playmaker import proto, Playmaker, serve, start\n"
                             "print(proto.State.DESCRIPTOR.full_name, proto.PlayOn)"},
                            {python_path(folder.path() / "python/out")});
  EXPECT_EQ(imported.out, "protos.State 2\n") << imported.err;
}

// One command, from what is built and installed: wire, engine and environments.
TEST(PythonPackage, MakesAnEnvironmentWithoutANetwork) {
  const std::string python = python_with_grpc();
  if (python.empty()) GTEST_SKIP() << kNoPython;
  TemporaryFolder folder;
  if (run({python, "-m", "venv", folder.path() / "try"}).exit_code != 0) {
    GTEST_SKIP() << "no virtual environments: install python3-venv";
  }
  if (run({python, "-c", "import numpy"}).exit_code != 0) GTEST_SKIP() << "no python3-numpy";

  const std::string environment = folder.path() / "env";
  const std::vector<std::string> offline = {"PYTHON=" + python, "PIP_NO_INDEX=1",
                                            "PYTHONPATH=", "CLS_TRAINING_LIBRARY="};
  for (const char* round : {"new", "again"}) {
    const auto made =
        Command({source_folder() / "python/environment", CLS_BUILD_DIR, environment}, offline)
            .finish(std::chrono::seconds(400));
    ASSERT_EQ(made.exit_code, 0) << round << made.err;
    EXPECT_EQ(made.out, ". " + environment + "/bin/activate\n");
    EXPECT_THAT(made.err, testing::ContainsRegex("after [0-9]+ s; use it in this shell by"));
  }

  const auto used = run({environment + "/bin/python", "-c",
                         "import cls_gym, cls_playmaker\n"
                         "from cls_gym._engine import library_path\n"
                         "env = cls_gym.Env('cls/HFO-1v0-v0', features='ego')\n"
                         "env.reset(seed=1)\n"
                         "print(library_path().parent.parent.name)"},
                        offline);
  EXPECT_EQ(used.out, "site-packages\n") << used.err;

  const auto unbuilt =
      run({source_folder() / "python/environment", folder.path(), environment}, offline);
  EXPECT_EQ(unbuilt.exit_code, 1);
  EXPECT_EQ(unbuilt.err, "python: " + folder.path().string() +
                             " has no engine or no modules of the wire; ./bootstrap python builds "
                             "them\n");
}

// A newcomer's way: a virtual environment, the package, a copy of the example somewhere else.
TEST(PythonPackage, InstallsIntoVirtualEnvironmentAndPlays) {
  TemporaryFolder folder;
  const std::string environment = folder.path() / "environment";
  if (run({"python3", "-m", "venv", environment}).exit_code != 0) {
    GTEST_SKIP() << "no virtual environments: install python3-venv";
  }
  const fs::path package = copy_package(folder.path() / "checkout");
  Command install({environment + "/bin/pip", "install", "--timeout", "10", "--retries", "0",
                   "--disable-pip-version-check", package.string()});
  const auto installed = install.finish(std::chrono::seconds(300));
  const std::string said = installed.out + installed.err;
  if (said.find("Could not find a version") != std::string::npos) {
    GTEST_SKIP() << "pip reaches no package index with grpcio";
  }
  ASSERT_EQ(installed.exit_code, 0) << said;

  for (const char* name : {"actions.py", "decide.py", "playmaker.py", "situation.py"}) {
    fs::copy_file(source_folder() / "examples/python" / name, folder.path() / name);
  }
  Command match(
      {cls_binary(), "match", "run:" + environment + "/bin/python playmaker.py --port {port}",
       "mock", "--cycles", "50", "--dir", "match", "--json"},
      {}, folder.path());
  const auto played = match.finish(std::chrono::seconds(120));
  ASSERT_EQ(played.exit_code, 0) << played.err;

  const auto result = base::Json::parse(played.out);
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["warnings"], base::Json::array());

  for (const auto& player : result["left"]["players"]) EXPECT_EQ(player["missed"], 0) << player;
}

}  // namespace
}  // namespace cls::tests
