// The tree of commands, the layout of help and the report of usage errors.
#include "cli/application.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "base/text/suggestion.h"
#include "base/text/wrap_text.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "play, evaluate and test RoboCup 2D soccer matches of gRPC Playmakers\n"
    "\n"
    "  cls match mock mock                    the bundled team against itself\n"
    "  cls match mock localhost:50051         against your Playmaker\n"
    "  cls match --help                       options of matches";

constexpr std::size_t kWidth = 80;
constexpr std::size_t kCommandColumn = 16;

// Help that starts with the examples of the description and fits a terminal. The list of commands
// shows the first line of each description.
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
        base::wrap_text(description.substr(0, description.find('\n')), kWidth - kCommandColumn),
        kCommandColumn);
    return out.str();
  }
  // The default value is shown behind the description instead.
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    const std::string value = "=" + option->get_default_str();
    if (const auto at = text.find(value); value != "=" && at != std::string::npos) {
      text.erase(at, value.size());
    }
    return text;
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_desc(option);
    const std::string value = option->get_default_str();
    if (!value.empty()) text += fmt::format(" (default: {})", value);
    return base::wrap_text(text, kWidth - get_column_width());
  }
};

// The options and commands of `app`, as candidates for "did you mean".
std::vector<std::string_view> known_names(const CLI::App& app, std::vector<std::string>& storage) {
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_lnames().empty()) storage.push_back("--" + option->get_lnames().front());
  }
  for (const CLI::App* command : app.get_subcommands({})) storage.push_back(command->get_name());
  return {storage.begin(), storage.end()};
}

// The sub-command that the arguments before the error selected.
const CLI::App& innermost_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost_command(*chosen.front());
}

// "cls check perception".
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

int report_usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& place = innermost_command(app);
  const std::string help = full_name(place) + " --help";
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) {
    fmt::print(stderr, "cls: {} (see {})\n", error.what(), help);
    return kUsage;
  }
  const std::string& argument = unknown.front();
  std::vector<std::string> storage;
  const std::string_view near = base::nearest_name(argument, known_names(place, storage));
  const bool has_commands = !place.get_subcommands({}).empty();
  const char* kind = argument.starts_with("-") ? "option" : has_commands ? "command" : "argument";
  fmt::print(stderr, "cls: unknown {} '{}'", kind, argument);
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
  int exit_code = kOk;
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
    return report_usage_error(app, error);
  }
  return exit_code;
}

}  // namespace cls::cli
