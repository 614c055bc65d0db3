// The Python package cls_gym: conventions, determinism, faults, and the official checkers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// The first Python that imports `modules`: of the environment that python/tests/environment makes,
/// the system's, or the first one on PATH. Empty: there is none.
std::string python_with(const std::string& modules) {
  const std::string own = fs::path(CLS_BUILD_DIR) / "python-environment/bin/python";
  for (const std::string& python : {own, std::string("/usr/bin/python3"), std::string("python3")}) {
    if (fs::path(python).is_absolute() && !fs::exists(python)) continue;
    if (run({python, "-c", "import " + modules}).exit_code == 0) return python;
  }
  return "";
}

const std::string kPythonPath = "PYTHONPATH=" + (fs::path(CLS_BUILD_DIR) / "python").string();
const std::string kNoBytecode = "PYTHONDONTWRITEBYTECODE=1";

CommandResult run_python(const std::string& python, const std::string& test,
                         std::vector<std::string> environment = {}) {
  environment.insert(environment.end(), {kPythonPath, kNoBytecode});
  Command tested({python, source_folder() / "python/tests" / test}, environment);
  return tested.finish(std::chrono::seconds(3000));
}

constexpr const char* kNoNumpy = "no Python with numpy: install python3-numpy";
constexpr const char* kNoGrpc = "no Python with numpy and grpc: install python3-grpcio";

/// A script of python/tests, and what it needs.
struct Script {
  std::string name;
  std::string modules;
  std::string why_skipped;
  std::string file;
  std::vector<std::string> environment = {};
};

class PythonGymScript : public testing::TestWithParam<Script> {};

TEST_P(PythonGymScript, Passes) {
  const std::string python = python_with(GetParam().modules);
  if (python.empty()) GTEST_SKIP() << GetParam().why_skipped;

  const auto tested = run_python(python, GetParam().file, GetParam().environment);
  EXPECT_EQ(tested.exit_code, 0) << tested.err;
}

INSTANTIATE_TEST_SUITE_P(
    PythonGym, PythonGymScript,
    testing::Values(
        Script{"KeepsConventionsWithNumpyAlone",
               "numpy",
               kNoNumpy,
               "gym_worlds_test.py",
               {"CLS_TEST_WITHOUT_GYMNASIUM=1"}},
        Script{"KeepsConventionsWithGymnasium", "numpy, gymnasium",
               "no gymnasium: run python/tests/environment", "gym_worlds_test.py"},
        Script{"KeepsContractWithNumpyAlone",
               "numpy",
               kNoNumpy,
               "gym_contract_test.py",
               {"CLS_TEST_WITHOUT_GYMNASIUM=1"}},
        Script{"KeepsContractWithGymnasium", "numpy, gymnasium, pettingzoo",
               "no gymnasium and pettingzoo: run python/tests/environment", "gym_contract_test.py"},
        Script{"FillsArraysWithNumpyAlone",
               "numpy",
               kNoNumpy,
               "gym_arrays_test.py",
               {"CLS_TEST_WITHOUT_GYMNASIUM=1"}},
        Script{"FillsArraysWithGymnasium", "numpy, gymnasium",
               "no gymnasium: run python/tests/environment", "gym_arrays_test.py"},
        Script{"StartsWhereToldWithNumpyAlone",
               "numpy",
               kNoNumpy,
               "gym_start_test.py",
               {"CLS_TEST_WITHOUT_GYMNASIUM=1"}},
        Script{"StartsWhereToldWithGymnasium", "numpy, gymnasium",
               "no gymnasium: run python/tests/environment", "gym_start_test.py"},
        Script{"ChoosesSensesWithNumpyAlone",
               "numpy",
               kNoNumpy,
               "gym_senses_test.py",
               {"CLS_TEST_WITHOUT_GYMNASIUM=1"}},
        Script{"ChoosesSensesWithGymnasium", "numpy, gymnasium, pettingzoo",
               "no gymnasium and pettingzoo: run python/tests/environment", "gym_senses_test.py"},
        Script{"HasTypes", "numpy, mypy", "no mypy: run python/tests/environment", "types_test.py"},
        Script{"ServesFrameworks", "numpy, gymnasium", "no gymnasium: run python/tests/environment",
               "gym_adapters_test.py"},
        Script{"ServesFrameworksOfSeveralAgents", "numpy, gymnasium",
               "no gymnasium: run python/tests/environment", "gym_multiagent_test.py"},
        Script{"RecordsEpisodes", "numpy, gymnasium, pyarrow",
               "no pyarrow: run python/tests/environment", "gym_data_test.py"},
        Script{"RunsExamplesOfDocumentation",
               "numpy, grpc",
               kNoGrpc,
               "gym_docs_test.py",
               {"CLS_BINARY=" + cls_binary().string()}},
        Script{"PassesOfficialCheckers", "numpy, gymnasium, pettingzoo",
               "no gymnasium and pettingzoo: run python/tests/environment", "gym_checkers_test.py"},
        Script{"GivesSocceractionItsTable",
               "socceraction.vaep.features",
               "no socceraction: pip install socceraction 'multimethod<2'",
               "socceraction_test.py",
               {"CLS_BINARY=" + cls_binary().string()}},
        Script{"GivesKloppyItsMatches",
               "numpy, kloppy.domain",
               "no kloppy: pip install kloppy",
               "kloppy_test.py",
               {"CLS_BINARY=" + cls_binary().string()}},
        Script{"PlaysHalfFieldOffenseByItsRules", "numpy", kNoNumpy, "gym_hfo_test.py"},
        Script{"ChoosesAmongOptions", "numpy", kNoNumpy, "gym_options_test.py"},
        Script{"ComputesPoliciesAsTheEngine", "numpy", kNoNumpy, "gym_network_test.py"},
        Script{"ReadsOnnxFiles", "numpy", kNoNumpy, "gym_onnx_test.py"},
        Script{"LearnsATeam",
               "numpy",
               kNoNumpy,
               "gym_learn_team_test.py",
               {"CLS_BINARY=" + cls_binary().string()}},
        Script{"KeepsLeagues", "numpy", kNoNumpy, "gym_league_test.py"},
        Script{"ServesPolicies", "numpy, grpc", kNoGrpc, "gym_play_test.py"},
        Script{"PlaysWholeMatchesAsAnEnvironment",
               "numpy, grpc",
               kNoGrpc,
               "gym_match_test.py",
               {"CLS_BINARY=" + cls_binary().string()}}),
    [](const auto& each) { return each.param.name; });

TEST(PythonGym, ExampleShowsTimeLeftAndSavesWhatItLearnedWhenInterrupted) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << kNoNumpy;
  const TemporaryFolder folder;
  Command learning({python, source_folder() / "examples/training/learn_numpy.py", "--out", "p.npz"},
                   {kPythonPath, kNoBytecode}, folder.path());
  ASSERT_TRUE(learning.wait_for_output(" left\n", std::chrono::seconds(120))) << learning.out();

  std::ifstream status("/proc/" + std::to_string(learning.pid()) + "/status");
  const std::string threads((std::istreambuf_iterator<char>(status)), {});
  EXPECT_THAT(threads, HasSubstr("Threads:\t1\n")) << "small matrices are slower with threads";

  learning.send_signal(SIGINT);
  const auto ended = learning.finish(std::chrono::seconds(60));
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(ended.out,
              testing::ContainsRegex("interrupted after [0-9]+ of 2000000 steps; what was "
                                     "learned is in p.npz"));
  EXPECT_TRUE(fs::exists(folder.path() / "p.npz"));
}

/// A match of an untrained policy. `options` are those of `cls match`.
CommandResult play_policy(const std::string& python, const fs::path& folder, const char* obs,
                          std::vector<std::string> options) {
  constexpr const char* kSave =
      "import sys; sys.path.insert(0, sys.argv[1]); from gym_play_test import policy; "
      "policy(obs=sys.argv[2]).save('policy.npz')";
  const std::vector<std::string> environment = {kPythonPath, kNoBytecode};
  const auto saved =
      Command({python, "-c", kSave, source_folder() / "python/tests", obs}, environment, folder)
          .finish();
  EXPECT_EQ(saved.exit_code, 0) << saved.err;

  std::vector<std::string> match = {
      cls_binary(), "match", "run:" + python + " -m cls_gym.play policy.npz --port {port}",
      "mock:hold",  "--dir", "match",
      "--cycles",   "40",    "--quiet",
      "--seed",     "1"};
  match.insert(match.end(), options.begin(), options.end());
  return Command(std::move(match), environment, folder).finish(std::chrono::seconds(300));
}

TEST(PythonGym, PolicyPlaysAMatchOnTheNumbersItObserves) {
  const std::string python = python_with("numpy, grpc");
  if (python.empty()) GTEST_SKIP() << kNoGrpc;
  const TemporaryFolder folder;
  const auto played = play_policy(python, folder.path(), "world_model", {"--rated", "--strict"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  // Actions that the skills of the other players never request.
  const std::string result = read_file(folder.path() / "match/result.json");
  const auto has = [&](const char* action) { return result.find(action) != std::string::npos; };
  EXPECT_TRUE(has("\"dash\": {") || has("\"turn\": {") || has("\"kick\": {"));
}

TEST(PythonGym, RatedMatchRefusesAPolicyOfTheFullState) {
  const std::string python = python_with("numpy, grpc");
  if (python.empty()) GTEST_SKIP() << kNoGrpc;
  const TemporaryFolder folder;
  const auto refused = play_policy(python, folder.path(), "full_state", {"--rated"});
  EXPECT_EQ(refused.exit_code, 69) << refused.err;
  EXPECT_THAT(refused.err + refused.out, HasSubstr("was trained with obs='full_state'"));
}

TEST(PythonGym, SaysHowToGetItsEngine) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << kNoNumpy;
  const auto imported = run({python, "-c", "import cls_gym; cls_gym.ids()"},
                            {"PYTHONPATH=" + (source_folder() / "python").string(),
                             "CLS_TRAINING_LIBRARY=/no/such/library.so"});
  EXPECT_EQ(imported.exit_code, 1);
  EXPECT_THAT(imported.err, HasSubstr("cls_gym: cannot load /no/such/library.so"));
}

}  // namespace
}  // namespace cls::tests
