// The Python package cls_gym: conventions, determinism, faults, and the official checkers.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

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

CommandResult run_python(const std::string& python, const std::string& test,
                         std::vector<std::string> environment = {}) {
  const fs::path build = CLS_BUILD_DIR;
  environment.push_back("PYTHONPATH=" + (build / "python").string());
  environment.push_back("PYTHONDONTWRITEBYTECODE=1");
  Command tested({python, source_folder() / "python/tests" / test}, environment);
  return tested.finish(std::chrono::seconds(3000));
}

constexpr const char* kNoNumpy = "no Python with numpy: install python3-numpy";

TEST(PythonGym, KeepsConventionsWithNumpyAlone) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << kNoNumpy;
  const auto tested = run_python(python, "gym_worlds_test.py", {"CLS_TEST_WITHOUT_GYMNASIUM=1"});
  EXPECT_EQ(tested.exit_code, 0) << tested.err;
}

TEST(PythonGym, KeepsConventionsWithGymnasium) {
  const std::string python = python_with("numpy, gymnasium");
  if (python.empty()) GTEST_SKIP() << "no gymnasium: run python/tests/environment";
  const auto tested = run_python(python, "gym_worlds_test.py");
  EXPECT_EQ(tested.exit_code, 0) << tested.err;
}

TEST(PythonGym, PassesOfficialCheckers) {
  const std::string python = python_with("numpy, gymnasium, pettingzoo");
  if (python.empty()) GTEST_SKIP() << "no gymnasium and pettingzoo: run python/tests/environment";
  const auto tested = run_python(python, "gym_checkers_test.py");
  EXPECT_EQ(tested.exit_code, 0) << tested.err;
}

TEST(PythonGym, PlaysHalfFieldOffenseByItsRules) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << kNoNumpy;
  const auto tested = run_python(python, "gym_hfo_test.py");
  EXPECT_EQ(tested.exit_code, 0) << tested.err;
}

TEST(PythonGym, SaysHowToGetItsEngine) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << kNoNumpy;
  const auto imported =
      run({python, "-c", "import cls_gym"}, {"PYTHONPATH=" + (source_folder() / "python").string(),
                                             "CLS_TRAINING_LIBRARY=/no/such/library.so"});
  EXPECT_EQ(imported.exit_code, 1);
  EXPECT_NE(imported.err.find("cls_gym: cannot load /no/such/library.so"), std::string::npos)
      << imported.err;
}

}  // namespace
}  // namespace cls::tests
