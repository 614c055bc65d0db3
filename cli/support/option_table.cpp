// The tables. An option has the same group and placeholder in all commands.
#include "cli/support/option_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "cli/support/value_form.h"
#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

struct OptionRow {
  std::string_view name;
  const char* group;  ///< nullptr: the default group
  const char* value;  ///< nullptr: from the type
};

constexpr const char* kTeams = "Teams";
constexpr const char* kPlaymakers = "Playmakers";
constexpr const char* kLimits = "Limits";
constexpr const char* kDebugging = "Debugging";
constexpr const char* kOutput = "Output";

constexpr OptionRow kOptions[] = {
    {"--left-name", kTeams, "NAME"},
    {"--right-name", kTeams, "NAME"},
    {"--own-names", kTeams, nullptr},
    {"--rated", kTeams, nullptr},
    {"--coach", kTeams, nullptr},
    {"--without-coach", kTeams, nullptr},
    {"--trainer", kTeams, "SIDE"},
    {"--formation", kTeams, "DIR"},
    {"--left-formation", kTeams, "DIR"},
    {"--right-formation", kTeams, "DIR"},
    {"--teamname", kTeams, "NAME"},
    {"--number", kTeams, nullptr},
    {"--unum", kTeams, nullptr},
    {"--team", kTeams, "NAME=SIDE"},
    {"--opponents", kTeams, "A,B,..."},
    {"--playmaker", kPlaymakers, "SIDE"},
    {"--rpc-host", kPlaymakers, "HOST"},
    {"--rpc-port", kPlaymakers, nullptr},
    {"--rpc-port-step", kPlaymakers, nullptr},
    {"--rpc-add-20-to-port-for-right", kPlaymakers, nullptr},
    {"--rpc-timeout", kPlaymakers, nullptr},
    {"--rpc-type", kPlaymakers, "TYPE"},
    {"--rpc-deadline", kPlaymakers, "N"},
    {"--no-deadline", kPlaymakers, nullptr},
    {"--on-late", kPlaymakers, "WHAT"},
    {"--batch", kPlaymakers, "WHEN"},
    {"--max-missed", kPlaymakers, "N"},
    {"--reconnect-within", kPlaymakers, nullptr},
    {"--tls-ca", kPlaymakers, "FILE"},
    {"--tls-cert", kPlaymakers, "FILE"},
    {"--tls-key", kPlaymakers, "FILE"},
    {"--tls-name", kPlaymakers, "NAME"},
    {"--start-timeout", kLimits, "X"},
    {"--stall-after", kLimits, "X"},
    {"--time-limit", kLimits, "X"},
    {"--sandbox", kTeams, nullptr},
    {"--max-memory", kLimits, "SIZE"},
    {"--max-cpu", kLimits, "N"},
    {"--latency-limit", kLimits, nullptr},
    {"--step", kDebugging, nullptr},
    {"--at", kDebugging, nullptr},
    {"--record-rpc", kDebugging, "FILE"},
    {"--record-world-models", kDebugging, nullptr},
    {"--world-models", kDebugging, "WHICH"},
    {"--save-at", kDebugging, "CYCLE FILE"},
    {"--resume", kDebugging, "FILE"},
    {"--replay", kDebugging, "FILE"},
    {"--player", kDebugging, "N"},
    {"--dry-run", kDebugging, nullptr},
    {"--debug-log", kDebugging, "DIR"},
    {"--monitor-port", kDebugging, nullptr},
    {"--watch", kOutput, nullptr},
    {"--open", kOutput, nullptr},
    {"--linger", kOutput, "X"},
    {"--cast", kOutput, "FILE"},
    {"--json", kOutput, nullptr},
    {"--format", kOutput, "FORMAT"},
    {"--columns", kOutput, "A,B,..."},
    {"--out", kOutput, "FILE"},
    {"--page", kOutput, "FILE"},
    {"--result", kOutput, "FILE"},
    {"--junit", kOutput, "FILE"},
    {"--github", kOutput, nullptr},
    {"--strict", kOutput, nullptr},
    {"--quiet", kOutput, nullptr},
    {"--no-color", kOutput, nullptr},
    {"--against", nullptr, "SIDE"},
    {"--config", nullptr, "FILE"},
    {"--cycles", nullptr, "N"},
    {"--dir", nullptr, "DIR"},
    {"--export", nullptr, "DIR"},
    {"--fault-cycles", nullptr, "FROM TO"},
    {"--fault-unum", nullptr, "N,N,..."},
    {"--filter", nullptr, "PATTERN"},
    {"--half-time", nullptr, "N"},
    {"--host", nullptr, "HOST"},
    {"--listen", nullptr, "ADDRESS"},
    {"--mode", nullptr, "MODE"},
    {"--seed", nullptr, "N"},
    {"--server", nullptr, "SERVER"},
    {"--players", nullptr, "L7,R1,..."},
    {"--set", nullptr, "NAME=VALUE"},
    {"--shard", nullptr, "K/N"},
    {"--side", nullptr, "SIDE"},
    {"--status", nullptr, "STATUS"},
    {"--to", nullptr, "VERSION"},
    {"--truth", nullptr, "FILE"},
    {"--view", nullptr, "WHERE"},
    {"--unimplemented", nullptr, "RPC,RPC,..."},
};

struct TextForm {
  std::string_view value;  ///< placeholder of options that accept no empty text
  const char* form;
};

constexpr TextForm kTextForms[] = {
    {"DIR", "a folder"}, {"FILE", "a file"}, {"HOST", "a host"}, {"NAME", "a name"}};

struct CommandGroup {
  std::string_view command;
  const char* group;
};

constexpr CommandGroup kCommandGroups[] = {
    {"report", "Results"},    {"match", "Play"},         {"tournament", "Play"},
    {"tune", "Play"},         {"compare", "Play"},       {"dev", "Play"},
    {"test", "Play"},         {"train", "Play"},         {"results", "Results"},
    {"stats", "Results"},     {"logs", "Results"},       {"convert", "Results"},
    {"watch", "Results"},     {"check", "Checks"},       {"doctor", "Checks"},
    {"mock", "Run one part"}, {"proxy", "Run one part"}, {"server", "Run one part"},
};

void complete_option(CLI::Option& option) {
  if (!is_flag(option)) require_strict_number(option);
  const std::string name = option.get_name();
  const auto row = std::find_if(std::begin(kOptions), std::end(kOptions),
                                [&name](const OptionRow& one) { return one.name == name; });
  if (row == std::end(kOptions) || option.get_group().empty()) return;
  if (row->group != nullptr && option.get_group() == "Options") option.group(row->group);
  if (row->value == nullptr || is_flag(option)) return;
  option.type_name(row->value);
  for (const TextForm& one : kTextForms) {
    if (one.value == row->value) require_text(option, one.form);
  }
}

// Most commands declare --quiet themselves, to describe what it leaves out.
void add_shared_flags(CLI::App& command) {
  if (command.get_option_no_throw("--quiet") == nullptr) {
    command.add_flag("--quiet", output_options().quiet, "print no progress and no notes");
  }
  command.add_flag("--no-color", output_options().no_color, "disable color");
}

}  // namespace

void complete_commands(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const auto row = std::find_if(
        std::begin(kCommandGroups), std::end(kCommandGroups),
        [command](const CommandGroup& one) { return one.command == command->get_name(); });
    if (command->get_group() == "Subcommands") {
      command->group(row == std::end(kCommandGroups) ? "Commands" : row->group);
    }
    if (command->get_subcommands([](const CLI::App*) { return true; }).empty()) {
      add_shared_flags(*command);
    }
    for (CLI::Option* option : command->get_options()) complete_option(*option);
    complete_commands(*command);
  }
}

}  // namespace cls::cli
