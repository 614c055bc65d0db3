// Lockstep matches are a function of their seed, independent of load and CPU features.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

struct Logs {
  std::string rcg;
  std::string rcl;
  std::string events;
};

Logs play(const std::string& seed, std::vector<std::string> environment = {}) {
  TemporaryFolder folder;
  EXPECT_THAT(run({cls_binary(), "match", "mock", "mock", "--seed", seed, "--half-time", "20",
                   "--set", "server::kick_off_wait=3", "--dir", folder.path()},
                  std::move(environment)),
              Exits(0));
  const auto read = [&](const char* name) { return read_file(folder.path() / name); };
  return {read("match.rcg"), read("match.rcl"), read("events.jsonl")};
}

// Not EXPECT_EQ: it would print megabytes.
void expect_same(const Logs& a, const Logs& b) {
  EXPECT_GT(a.rcg.size(), 100000u);
  EXPECT_TRUE(a.rcg == b.rcg) << "rcg differs";
  EXPECT_TRUE(a.rcl == b.rcl) << "rcl differs";
  EXPECT_TRUE(a.events == b.events) << "events differ";
}

TEST(Determinism, SameSeedGivesSameBytes) { expect_same(play("7"), play("7")); }

TEST(Determinism, DifferentSeedGivesDifferentMatch) {
  EXPECT_FALSE(play("7").rcg == play("8").rcg);
}

TEST(Determinism, ResultIsIndependentOfLoad) {
  const Logs idle = play("7");
  std::vector<std::unique_ptr<Command>> load;
  for (int i = 0; i < 4; ++i) {
    load.push_back(
        std::make_unique<Command>(std::vector<std::string>{"sh", "-c", "while :; do :; done"}));
  }
  expect_same(idle, play("7"));
}

TEST(Determinism, ResultIsIndependentOfCpuFeatures) {
  expect_same(play("7"), play("7", {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2"}));
}

}  // namespace
}  // namespace cls::tests
