// The tree of commands and how a mistake on the command line is reported.
#include "cli/application.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "base/text/suggestion.h"
#include "base/text/wrapped_text.h"
#include "cli/check/check_command.h"
#include "cli/check/doctor_command.h"
#include "cli/logs/convert_command.h"
#include "cli/logs/results_command.h"
#include "cli/logs/stats_command.h"
#include "cli/match/match_command.h"
#include "cli/match/mock_command.h"
#include "cli/match/proxy_command.h"
#include "cli/match/server_command.h"
#include "cli/match/test_command.h"
#include "cli/support/exit_code.h"
#include "cli/tournament/compare_command.h"
#include "cli/tournament/init_command.h"
#include "cli/tournament/tournament_command.h"
#include "cli/version_command.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "cls plays, evaluates and tests RoboCup 2D soccer matches of gRPC Playmakers.\n"
    "\n"
    "  cls match mock mock                    the bundled team against itself\n"
    "  cls match mock localhost:50051         against your Playmaker\n"
    "  cls match --help                       all about matches";

constexpr std::size_t kWidth = 80;
constexpr std::size_t kCommandColumn = 16;

// Help that starts with the examples of the description and fits a terminal; of commands, the list
// shows the first line.
class Help : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    return "\n" + CLI::Formatter::make_usage(app, name);
  }
  std::string make_subcommand(const CLI::App* command) const override {
    const std::string description = command->get_description();
    std::stringstream out;
    CLI::detail::format_help(
        out, command->get_name(),
        base::wrapped(description.substr(0, description.find('\n')), kWidth - kCommandColumn),
        kCommandColumn);
    return out.str();
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    return base::wrapped(CLI::Formatter::make_option_desc(option), kWidth - get_column_width());
  }
};

// The options and commands that `word` may be a slip of.
std::vector<std::string_view> known_words(const CLI::App& app, std::vector<std::string>& storage) {
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_lnames().empty()) storage.push_back("--" + option->get_lnames().front());
  }
  for (const CLI::App* command : app.get_subcommands({})) storage.push_back(command->get_name());
  return {storage.begin(), storage.end()};
}

// What the words up to the mistake have chosen.
const CLI::App& innermost_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost_command(*chosen.front());
}

// "cls check perception".
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

int report_mistake(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& place = innermost_command(app);
  const std::string help = full_name(place) + " --help";
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) {
    fmt::print(stderr, "cls: {} (see {})\n", error.what(), help);
    return kUsage;
  }
  const std::string& word = unknown.front();
  std::vector<std::string> storage;
  const std::string_view near = base::nearest_name(word, known_words(place, storage));
  const bool has_commands = !place.get_subcommands({}).empty();
  const char* kind = word.starts_with("-") ? "option" : has_commands ? "command" : "argument";
  fmt::print(stderr, "cls: unknown {} '{}'", kind, word);
  if (near.empty()) {
    fmt::print(stderr, " (see {})\n", help);
  } else {
    fmt::print(stderr, "; did you mean '{}'?\n", near);
  }
  return kUsage;
}

}  // namespace

int run_application(int argc, const char* const* argv) {
  CLI::App app{kDescription};
  app.name("cls");
  app.formatter(std::make_shared<Help>());
  app.require_subcommand(1);
  int exit_code = kDone;
  add_match_command(app, exit_code);
  add_tournament_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_init_command(app, exit_code);
  add_results_command(app, exit_code);
  add_stats_command(app, exit_code);
  add_convert_command(app, exit_code);
  add_check_command(app, exit_code);
  add_doctor_command(app, exit_code);
  add_mock_command(app, exit_code);
  add_proxy_command(app, exit_code);
  add_server_command(app, exit_code);
  add_test_command(app, exit_code);
  add_version_command(app, exit_code);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    return report_mistake(app, error);
  }
  return exit_code;
}

}  // namespace cls::cli
