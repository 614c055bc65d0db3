// The tree of commands, and the arguments before parsing.
#include "cli/application.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/shell/completion_command.h"
#include "cli/support/command_help.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/option_table.h"
#include "cli/support/print_error.h"
#include "cli/support/usage_errors.h"
#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "play, evaluate and test RoboCup 2D soccer matches of gRPC Playmakers\n"
    "\n"
    "  cls match mock mock                    the bundled team against itself\n"
    "  cls match mock localhost:50051         against your Playmaker\n"
    "  cls help match                         options of matches";

// What completion scripts call. No command of the tree, because it takes any words.
constexpr std::string_view kCompleteCommand = "complete";

using Words = std::vector<std::string>;

bool is_shared_flag(const std::string& word) {
  return word == "--json" || word == "--quiet" || word == "--no-color";
}

// nullptr if there is none.
const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  const auto found =
      app.get_subcommands([&name](const CLI::App* command) { return command->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

// Moves the shared flags from the front to the command: "--json match a b" -> "match --json a b".
Words with_flags_behind_command(const CLI::App& app, Words words) {
  const auto command = std::find_if_not(words.begin(), words.end(), is_shared_flag);
  const CLI::App* place = &app;
  auto end = command;
  while (end != words.end() && !place->get_subcommands({}).empty()) {
    place = find_command(*place, *end);
    if (place == nullptr) return words;
    ++end;
  }
  std::rotate(words.begin(), command, end);
  return words;
}

// "help" and a command, or nothing; the command `help` itself handles topics.
bool asks_for_help(const CLI::App& app, const Words& words) {
  if (words.empty() || words.front() != "help") return false;
  return words.size() == 1 || find_command(app, words[1]) != nullptr;
}

// "help tournament run" -> "tournament run --help"; "--version" -> "version".
Words canonical(const CLI::App& app, Words words) {
  if (asks_for_help(app, words)) {
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
  }
  words = with_flags_behind_command(app, std::move(words));
  const auto first = std::find_if_not(words.begin(), words.end(), is_shared_flag);
  if (first != words.end() && (*first == "--version" || *first == "-V")) {
    words.erase(first);
    words.insert(words.begin(), "version");
  }
  return words;
}

void add_commands(CLI::App& app, int& exit_code) {
  add_match_command(app, exit_code);
  add_tournament_command(app, exit_code);
  add_tune_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_test_command(app, exit_code);
  add_dev_command(app, exit_code);
  add_results_command(app, exit_code);
  add_stats_command(app, exit_code);
  add_logs_command(app, exit_code);
  add_convert_command(app, exit_code);
  add_watch_command(app, exit_code);
  add_report_command(app, exit_code);
  add_check_command(app, exit_code);
  add_doctor_command(app, exit_code);
  add_mock_command(app, exit_code);
  add_proxy_command(app, exit_code);
  add_server_command(app, exit_code);
  add_explain_command(app, exit_code);
  add_config_command(app, exit_code);
  add_init_command(app, exit_code);
  add_new_command(app, exit_code);
  add_package_team_command(app, exit_code);
  add_completion_command(app, exit_code);
  add_train_command(app, exit_code);
  add_version_command(app, exit_code);
  add_help_command(app, exit_code);
}

// canonical() replaces these; they are here for help and suggestions.
void add_root_options(CLI::App& app) {
  app.add_flag("-V,--version")->description("print the version, as cls version");
  app.add_flag("--json")->description("of every command: print one JSON document on stdout");
  app.add_flag("--quiet")->description("of every command: print no progress and no notes");
  app.add_flag("--no-color")->description("of every command: disable color");
}

}  // namespace

int run_application(int argc, const char* const* argv) {
  output_options() = {};
  CLI::App app{kDescription};
  app.name("cls");
  app.formatter(std::make_shared<CommandHelp>());
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  int exit_code = kOk;
  add_commands(app, exit_code);
  complete_commands(app);
  add_root_options(app);

  if (argc > 1 && argv[1] == kCompleteCommand) {
    return print_completion(app, Words(argv + 2, argv + argc));
  }
  Words words = canonical(app, Words(argv + 1, argv + argc));
  if (const auto error = unknown_command(app, words)) return print_error(kUsage, *error);
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    return print_error(kUsage, usage_error(app, error));
  }
  return exit_code;
}

}  // namespace cls::cli
