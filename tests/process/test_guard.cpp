// Starts the guard before the first test, while the program has one thread.
#include "tests/process/test_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <thread>

#include "process/guard.h"
#include "tests/support/built.h"
#include "tests/support/marked_processes.h"

namespace cls::process {
namespace {

class GuardEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    auto guard = Guard::start(0, nullptr);
    if (!guard) throw std::runtime_error(guard.error().message);
    guard_.emplace(*std::move(guard));
  }
  void TearDown() override { guard_.reset(); }

 private:
  std::optional<Guard> guard_;
};

[[maybe_unused]] const testing::Environment* const environment =
    testing::AddGlobalTestEnvironment(new GuardEnvironment);

ProcessHost new_host() {
  auto host = ProcessHost::create();
  if (!host) throw std::runtime_error(host.error().message);
  return *std::move(host);
}

}  // namespace

CommandPlan fake(std::vector<std::string> actions) {
  CommandPlan plan;
  plan.name = "the fake";
  plan.argv = std::move(actions);
  plan.argv.insert(plan.argv.begin(), tests::built("cls_fake_process"));
  return plan;
}

MarkedHost::MarkedHost() : host(new_host()), mark(tests::new_mark()) {}

std::shared_ptr<Child> MarkedHost::start(CommandPlan plan, ProcessHost::OnLine on_line) {
  plan.environment.push_back({tests::kMarkVariable, mark});
  auto child = host.start(plan, std::move(on_line));
  if (!child) throw std::runtime_error(child.error().message);
  return *child;
}

std::shared_ptr<Child> MarkedHost::start_fake(std::vector<std::string> actions) {
  return start(fake(std::move(actions)));
}

bool MarkedHost::nothing_left(std::chrono::milliseconds limit) const {
  return tests::all_marked_gone(mark, limit);
}

bool saw_line(const Child& child, const std::string& line) {
  const std::atomic<int> never{0};
  const auto there = [&] {
    const std::vector<std::string> lines = child.last_lines();
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  };
  return wait_until_ready(child, there, std::chrono::seconds(10), never) == Readiness::kReady;
}

}  // namespace cls::process
