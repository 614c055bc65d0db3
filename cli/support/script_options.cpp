// Accepted, told, ignored: existing start scripts work as they are.
#include "cli/support/script_options.h"

#include <CLI/CLI.hpp>

namespace cls::cli {
namespace {

constexpr const char* kGroup = "Accepted because start scripts say them; they do nothing";

// Of the start.sh of the Cross Language Soccer framework's proxy.
constexpr const char* kFlags =
    "--offline-logging,--offline-client-mode,--debug,--debug-server-connect,"
    "--debug-server-logging";
constexpr const char* kWithValue[] = {
    "--team-graphic",      "--debug-start-time", "--debug-end-time", "--debug-server-host",
    "--debug-server-port", "--log-dir",          "--debug-log-ext"};

}  // namespace

void add_script_options(CLI::App& command) {
  for (const std::string& flag : CLI::detail::split(kFlags, ',')) {
    command.add_flag(flag)->group(kGroup);
  }
  for (const char* option : kWithValue) {
    command.add_option(option)->expected(1)->group(kGroup);
  }
}

std::vector<std::string> given_script_options(const CLI::App& command) {
  std::vector<std::string> given;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() == kGroup && option->count() > 0) given.push_back(option->get_name());
  }
  return given;
}

}  // namespace cls::cli
