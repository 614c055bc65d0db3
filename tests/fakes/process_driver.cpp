// Stands for cls where a test wants to kill it: a guard and children, one for each argument.
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "orchestration/process/guard.h"
#include "orchestration/process/process_host.h"

// Starts every argument as a shell command, prints "ready" and the pids, and waits for ever. The
// argument "return" makes it end in order instead, once all others are started.
int main(int argc, char** argv) {
  using namespace cls::orchestration::process;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  auto guard = Guard::start(argc, argv);
  if (!guard) {
    std::fprintf(stderr, "%s\n", guard.error().message.c_str());
    return 1;
  }
  auto host = ProcessHost::create();
  if (!host) return 1;
  std::vector<std::shared_ptr<Child>> children;
  bool stay = true;
  for (const std::string& argument : arguments) {
    if (argument == "return") {
      stay = false;
      continue;
    }
    auto child = host->start(shell_command("child", argument));
    if (!child) {
      std::fprintf(stderr, "%s\n", child.error().message.c_str());
      return 1;
    }
    children.push_back(*child);
  }
  std::printf("guard %d\nready\n", guard->pid());
  std::fflush(stdout);
  while (stay) ::pause();
  return 0;
}
