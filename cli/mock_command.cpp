// `cls mock`: serves until a signal comes.
#include "cli/mock_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "mock-server/server.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "Runs the mock Playmaker alone, for agents that ask over the network.\n"
    "\n"
    "  cls mock                     on a free port, which is printed\n"
    "  cls mock hold --port 50051   the behaviour that only watches";

struct Arguments {
  std::string behaviour = "simple";
  std::string host = "127.0.0.1";
  int port = 0;
};

int run_mock(const Arguments& arguments) {
  auto behaviour = mock_server::make_behaviour(arguments.behaviour);
  if (!behaviour) {
    fmt::print(stderr, "cls: {}\n", behaviour.error().message);
    return kUsage;
  }
  const std::atomic<int>& signal = watch_interrupts();
  auto server = mock_server::Server::start(std::move(*behaviour), arguments.host, arguments.port);
  if (!server) {
    fmt::print(stderr, "cls: {}\n", server.error().message);
    return kTryAgain;
  }
  fmt::print("listening on {}:{}\n", arguments.host, (*server)->port());
  std::fflush(stdout);
  while (signal.load() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return signal.load() == SIGTERM ? kTerminated : kInterrupted;
}

}  // namespace

void add_mock_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("mock", kDescription);
  command->add_option("BEHAVIOUR", arguments->behaviour, "simple or hold (simple)");
  command->add_option("--port", arguments->port, "0: a free one (0)")->check(CLI::Range(0, 65535));
  command->add_option("--host", arguments->host, "address to listen on (127.0.0.1)");
  command->callback([arguments, &exit_code] { exit_code = run_mock(*arguments); });
}

}  // namespace cls::cli
