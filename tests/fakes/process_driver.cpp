// Stand-in for cls that tests can kill: a guard and one child per argument.
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "process/guard.h"
#include "process/process_host.h"
#include "process/scratch_folder.h"

// Starts each argument as a shell command, prints the guard's pid and "ready", and waits forever.
// With the argument "return" it exits cleanly after starting the others; with "scratch" it also has
// a temporary folder, whose path it prints.
int main(int argc, char** argv) {
  using namespace cls::process;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  auto guard = Guard::start(argc, argv);

  if (!guard) {
    std::fprintf(stderr, "%s\n", guard.error().message.c_str());
    return 1;
  }

  auto host = ProcessHost::create();
  if (!host) return 1;
  std::vector<std::shared_ptr<Child>> children;
  std::optional<ScratchFolder> scratch;
  bool stay = true;

  for (const std::string& argument : arguments) {
    if (argument == "return") {
      stay = false;
      continue;
    }
    if (argument == "scratch") {
      scratch.emplace(*ScratchFolder::create());
      continue;
    }
    auto child = host->start(shell_command("child", argument));
    if (!child) {
      std::fprintf(stderr, "%s\n", child.error().message.c_str());
      return 1;
    }
    children.push_back(*child);
  }
  std::printf("guard %d\n", guard->pid());
  if (scratch) std::printf("%s\n", scratch->path().c_str());
  std::printf("ready\n");
  std::fflush(stdout);
  while (stay) ::pause();
  return 0;
}
