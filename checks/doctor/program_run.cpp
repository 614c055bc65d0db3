// Runs programs and collects their first output lines.
#include "checks/doctor/program_run.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "base/text/printable.h"

namespace cls::checks {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::size_t kLines = 20;
constexpr milliseconds kGrace{100};
constexpr milliseconds kUntilKilled{2000};

/// The first output lines of a program; filled on another thread.
class FirstLines {
 public:
  void add(std::string_view line) {
    const std::lock_guard lock(mutex_);
    if (lines_.size() < kLines && !line.empty()) lines_.push_back(base::printable(line));
  }
  std::vector<std::string> take_lines() {
    const std::lock_guard lock(mutex_);
    return std::move(lines_);
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> lines_;
};

struct Asked {
  ProgramOutput answer;
  std::shared_ptr<process::Child> child;
  std::shared_ptr<FirstLines> lines = std::make_shared<FirstLines>();
};

Asked start(process::ProcessHost& host, const ProgramRun& question) {
  Asked asked;
  const auto path = process::find_program(question.program);
  if (!path) {
    asked.answer.absence = path.error().message;
    return asked;
  }
  asked.answer.path = *path;

  process::CommandPlan plan;
  plan.name = question.program;
  plan.argv = {path->string()};
  plan.argv.insert(plan.argv.end(), question.arguments.begin(), question.arguments.end());
  plan.folder = question.folder;
  plan.environment = question.environment;

  auto child = host.start(plan, [lines = asked.lines](std::string_view line) { lines->add(line); });
  if (!child) {
    asked.answer.absence = child.error().message;
  } else {
    asked.child = *std::move(child);
  }
  return asked;
}

}  // namespace

std::vector<ProgramOutput> run_programs(process::ProcessHost& host,
                                        const std::vector<ProgramRun>& questions,
                                        milliseconds limit, const std::atomic<int>& stop) {
  std::vector<Asked> all;
  for (const ProgramRun& question : questions) all.push_back(start(host, question));

  const auto end = steady_clock::now() + limit;
  const auto nothing = [] { return false; };
  for (const Asked& asked : all) {
    if (asked.child == nullptr) continue;
    const auto left = std::chrono::duration_cast<milliseconds>(end - steady_clock::now());
    process::wait_until_ready(*asked.child, nothing, std::max(left, milliseconds(0)), stop);
    asked.child->end(kGrace);  // terminates hanging programs and their orphans
  }

  std::vector<ProgramOutput> answers;
  for (Asked& asked : all) {
    if (asked.child != nullptr) {
      asked.child->wait_gone(kUntilKilled);
      const process::Child::Status status = asked.child->status();
      if (!status.asked_to_end) asked.answer.exit = status.exit;
      asked.answer.lines = asked.lines->take_lines();
    }
    answers.push_back(std::move(asked.answer));
  }
  return answers;
}

}  // namespace cls::checks
