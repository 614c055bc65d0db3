// `make wheel`: what the wheels hold and need, and what their engine plays and says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A user's program of numbers that depend on every step of three tasks.
constexpr const char* kHash = R"(import hashlib, numpy as np, cls_gym
digest = hashlib.sha256()
for task, config in (("cls/HFO-2v2-v0", {}), ("cls/Academy-Corner-v0", {}),
                     ("cls/HFO-2v1-v0", {"obs": "world_model", "opponent": "planner"})):
    envs = cls_gym.VectorEnv(task, 3, features="ego", actions="low_discrete", **config)
    digest.update(envs.reset(seed=3)[0].tobytes())
    for step in range(90):
        ids = np.resize(np.arange(step, step + 50) % 81, envs.action_space.shape)
        seen, rewards, *_ = envs.step(ids)
        digest.update(seen.tobytes() + rewards.tobytes() + envs.state().tobytes())
print(digest.hexdigest())
)";

/// A user's program whose types a checker follows.
constexpr const char* kTyped = R"(import numpy as np
import numpy.typing as npt
import cls_gym

def policy(seen: npt.NDArray[np.float32], legal: npt.NDArray[np.int8]) -> npt.NDArray[np.int64]:
    return np.asarray(np.argmax(legal, axis=-1), np.int64)

def play(task: str, worlds: int = 4) -> float:
    with cls_gym.VectorEnv(task, worlds, actions="low_discrete") as envs:
        seen, infos = envs.reset(seed=1)
        total = 0.0
        for _ in range(10):
            seen, rewards, ended, cut, infos = envs.step(policy(seen, infos["action_mask"]))
            total += float(rewards.sum())
        snapshot: cls_gym.Snapshot = envs.snapshot(0)
        envs.restore(0, snapshot)
        names: tuple[str, ...] = envs.spec_of_task.agents
        assert names and cls_gym.ids()
        return total

print(play("cls/HFO-1v0-v0"))
)";

std::string python_with(const std::string& modules) {
  const std::string own = fs::path(CLS_BUILD_DIR) / "python-environment/bin/python";
  for (const std::string& python : {own, std::string("/usr/bin/python3"), std::string("python3")}) {
    if (fs::path(python).is_absolute() && !fs::exists(python)) continue;
    if (run({python, "-c", "import " + modules}).exit_code == 0) return python;
  }
  return "";
}

/// The wheels of this build, and what they install.
class Wheel : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (CLS_SANITIZED) return;
    folder_ = new TemporaryFolder;
    const CommandResult built = run_there({"python3", source_folder() / "packaging/build.py",
                                           CLS_BUILD_DIR, "--wheels", "--out", "wheels"});
    ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
    const CommandResult unpacked =
        run_there({"python3", "-m", "zipfile", "-e", wheel("cls_gym"), "gym"});
    ASSERT_EQ(unpacked.exit_code, 0) << unpacked.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override {
    if (folder_ == nullptr) GTEST_SKIP() << "Python does not load a library with sanitizers";
    python_ = python_with("numpy");
    if (python_.empty()) GTEST_SKIP() << "no Python with numpy: install python3-numpy";
  }

  static fs::path path(const std::string& name) { return folder_->path() / name; }

  static fs::path wheel(const std::string& package) {
    for (const auto& entry : fs::directory_iterator(path("wheels"))) {
      if (entry.path().filename().string().starts_with(package)) return entry.path();
    }
    ADD_FAILURE() << "no wheel of " << package;
    return {};
  }

  static CommandResult run_there(const Words& words, const Words& environment = {}) {
    Words clean = {"PYTHONDONTWRITEBYTECODE=1", "CLS_TRAINING_LIBRARY="};
    clean.insert(clean.end(), environment.begin(), environment.end());
    return Command(words, clean, folder_->path()).finish(std::chrono::seconds(300));
  }

  /// What a program prints with the packages of `folder`.
  CommandResult run_python(const std::string& program, const fs::path& folder) const {
    return run_there({python_, "-c", program}, {"PYTHONPATH=" + folder.string()});
  }

  static inline TemporaryFolder* folder_ = nullptr;
  std::string python_;
};

TEST_F(Wheel, OneHasTheEngineTheOtherTheWire) {
  const std::string gym = run_there({"python3", "-m", "zipfile", "-l", wheel("cls_gym")}).out;
  EXPECT_THAT(gym, HasSubstr("cls_gym/libcls_training.so "));
  EXPECT_THAT(gym, HasSubstr("cls_gym/py.typed "));
  EXPECT_THAT(gym, Not(HasSubstr("playmaker")));
  std::string needs;
  for (const auto& entry : fs::directory_iterator(path("gym"))) {
    const fs::path metadata = entry.path() / "METADATA";
    if (fs::exists(metadata)) needs = read_file(metadata);
  }
  EXPECT_THAT(needs, HasSubstr("\nRequires-Dist: numpy>="));
  EXPECT_THAT(needs, Not(ContainsRegex("\nRequires-Dist: [^;\n]*(grpc|gymnasium)[^;\n]*\n")));
  const std::string wire =
      run_there({"python3", "-m", "zipfile", "-l", wheel("cls_playmaker")}).out;
  EXPECT_THAT(wire, HasSubstr("cls_playmaker/playmaker_pb2.py "));
  EXPECT_THAT(wire, Not(HasSubstr("cls_gym")));
}

TEST_F(Wheel, NeedsTheCLibraryOfItsTag) {
  EXPECT_THAT(wheel("cls_gym").filename().string(),
              HasSubstr("-py3-none-manylinux_2_28_x86_64.whl"));
  const std::string needs =
      run_there({"readelf", "-W", "-d", "-V", path("gym") / "cls_gym/libcls_training.so"}).out;
  const std::regex version(R"(GLIBC_2\.(\d+))");
  int seen = 0;
  for (std::sregex_iterator at(needs.begin(), needs.end(), version), end; at != end; ++at) {
    EXPECT_LE(std::stoi((*at)[1]), 28);
    ++seen;
  }
  EXPECT_GT(seen, 3);
  EXPECT_THAT(needs, Not(ContainsRegex("NEEDED.*(fmt|sleef|stdc)")));

  const std::string python = python_with("auditwheel");
  if (python.empty()) GTEST_SKIP() << "no auditwheel: run python/tests/environment";
  const CommandResult audit = run_there({python, "-m", "auditwheel", "show", wheel("cls_gym")});
  EXPECT_EQ(audit.exit_code, 0) << audit.err;
  // An older system serves, too.
  EXPECT_THAT(audit.out, ContainsRegex("consistent with\\s+the following platform tag:\\s+"
                                       "\"manylinux_2_(27|28)_x86_64\""));
}

TEST_F(Wheel, IsTheSameBytesAgain) {
  const CommandResult again = run_there({"python3", source_folder() / "packaging/build.py",
                                         CLS_BUILD_DIR, "--wheels", "--out", "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  for (const char* package : {"cls_gym", "cls_playmaker"}) {
    const fs::path one = wheel(package);
    EXPECT_TRUE(read_file(one) == read_file(path("again") / one.filename())) << package;
  }
}

TEST_F(Wheel, InstallsWithoutAnIndexAndPlaysTheBytesOfTheBuild) {
  if (run_there({python_, "-m", "venv", "--system-site-packages", "env"}).exit_code != 0) {
    GTEST_SKIP() << "no virtual environments: install python3-venv";
  }
  const std::string python = path("env") / "bin/python";
  const CommandResult installed = run_there(
      {python, "-m", "pip", "install", "--no-index", "--no-deps", "-q", wheel("cls_gym")});
  ASSERT_EQ(installed.exit_code, 0) << installed.err;
  const std::string where = "from cls_gym._engine import library_path as path; print(path())";
  if (run_there({python, "-c", "import numpy"}).exit_code != 0) GTEST_SKIP() << "no numpy there";
  EXPECT_THAT(run_there({python, "-c", where}).out, HasSubstr("/site-packages/cls_gym/"));

  const CommandResult here = run_there({python, "-c", kHash});
  const CommandResult built = run_python(kHash, fs::path(CLS_BUILD_DIR) / "python");
  EXPECT_EQ(here.exit_code, 0) << here.err;
  EXPECT_THAT(here.out, ContainsRegex("^[0-9a-f]{64}\n$"));
  EXPECT_EQ(here.out, built.out) << built.err;
}

TEST_F(Wheel, BrokenMathLibraryIsAnImportErrorAndTheProcessGoesOn) {
  constexpr const char* kProgram =
      "try:\n  import cls_gym\n  cls_gym.Env()\n"
      "except ImportError as error:\n  print('alive:', error)\n";
  fs::copy(path("gym"), path("broken"), fs::copy_options::recursive);
  const fs::path engine = path("broken") / "cls_gym/libcls_training.so";
  std::string bytes = read_file(engine);
  const CommandResult packed =
      run_there({"python3", "-c",
                 "import zlib, sys; sys.stdout.write(zlib.compress(open('/usr/lib/x86_64-linux-gnu/"
                 "libsleef.so.3', 'rb').read(), 9)[:24].hex())"});
  std::string start;
  for (std::size_t at = 0; at + 1 < packed.out.size(); at += 2) {
    start += static_cast<char>(std::stoi(packed.out.substr(at, 2), nullptr, 16));
  }
  const std::size_t place = bytes.find(start);
  ASSERT_NE(place, std::string::npos);
  bytes[place + 1000] = static_cast<char>(bytes[place + 1000] ^ 1);
  std::ofstream(engine, std::ios::binary) << bytes;

  const CommandResult broken = run_python(kProgram, path("broken"));
  EXPECT_EQ(broken.exit_code, 0) << broken.err;
  EXPECT_THAT(broken.out, ContainsRegex("^alive: cls_gym: cannot use .*libcls_training.so: the "
                                        "embedded libsleef cannot be loaded: it is corrupt; "));
  fs::remove(engine);
  const CommandResult missing = run_python(kProgram, path("broken"));
  EXPECT_EQ(missing.exit_code, 0) << missing.err;
  EXPECT_THAT(missing.out, HasSubstr("alive: cls_gym: no libcls_training.so"));
}

TEST_F(Wheel, TypesOfAUsersProgramAreClean) {
  const std::string python = python_with("mypy, numpy, gymnasium");
  if (python.empty()) GTEST_SKIP() << "no mypy: run python/tests/environment";
  std::ofstream(path("program.py")) << kTyped;
  const CommandResult checked =
      run_there({python, "-m", "mypy", "--strict", "program.py"},
                {"MYPYPATH=" + path("gym").string(), "PYTHONPATH=" + path("gym").string()});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
  EXPECT_EQ(run_python(kTyped, path("gym")).exit_code, 0);
}

}  // namespace
}  // namespace cls::tests
