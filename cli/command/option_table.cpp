// The tables. An option has the same group and placeholder in all commands.
#include "cli/command/option_table.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "cli/terminal/terminal.h"
#include "match/terms/option_table.h"

namespace cls::cli {
namespace {

using namespace match;

struct OptionRow {
  std::string_view name;
  const char* group;
  std::string_view value;  ///< empty: from the type
};

constexpr OptionRow kOptions[] = {
    {"--without-coach", kTeamsGroup, ""},
    {"--teamname", kTeamsGroup, "NAME"},
    {"--number", kTeamsGroup, ""},
    {"--unum", kTeamsGroup, ""},
    {"--team", kTeamsGroup, "NAME=SIDE"},
    {"--opponents", kTeamsGroup, "A,B,..."},
    {"--playmaker", kPlaymakersGroup, "SIDE"},
    {"--rpc-host", kPlaymakersGroup, "HOST"},
    {"--rpc-port", kPlaymakersGroup, ""},
    {"--rpc-port-step", kPlaymakersGroup, ""},
    {"--rpc-add-20-to-port-for-right", kPlaymakersGroup, ""},
    {"--rpc-timeout", kPlaymakersGroup, ""},
    {"--rpc-type", kPlaymakersGroup, "TYPE"},
    {"--latency-limit", kLimitsGroup, ""},
    {"--step", kDebuggingGroup, ""},
    {"--at", kDebuggingGroup, ""},
    {"--world-models", kDebuggingGroup, "WHICH"},
    {"--replay", kDebuggingGroup, "FILE"},
    {"--player", kDebuggingGroup, "N"},
    {"--dry-run", kDebuggingGroup, ""},
    {"--watch", kOutputGroup, ""},
    {"--open", kOutputGroup, ""},
    {"--linger", kOutputGroup, "X"},
    {"--on-event", kOutputGroup, "COMMAND"},
    {"--hook-limit", kOutputGroup, "X"},
    {"--cast", kOutputGroup, "FILE"},
    {"--json", kOutputGroup, ""},
    {"--format", kOutputGroup, "FORMAT"},
    {"--columns", kOutputGroup, "A,B,..."},
    {"--out", kOutputGroup, "FILE"},
    {"--page", kOutputGroup, "FILE"},
    {"--result", kOutputGroup, "FILE"},
    {"--junit", kOutputGroup, "FILE"},
    {"--github", kOutputGroup, ""},
    {"--strict", kOutputGroup, ""},
    {"--quiet", kOutputGroup, ""},
    {"--no-color", kOutputGroup, ""},
    {"--against", kOptionsGroup, "SIDE"},
    {"--config", kOptionsGroup, "FILE"},
    {"--export", kOptionsGroup, "DIR"},
    {"--fault-cycles", kOptionsGroup, "FROM TO"},
    {"--fault-unum", kOptionsGroup, "N,N,..."},
    {"--filter", kOptionsGroup, "PATTERN"},
    {"--host", kOptionsGroup, "HOST"},
    {"--listen", kOptionsGroup, "ADDRESS"},
    {"--players", kOptionsGroup, "L7,R1,..."},
    {"--set", kOptionsGroup, "NAME=VALUE"},
    {"--shard", kOptionsGroup, "K/N"},
    {"--side", kOptionsGroup, "SIDE"},
    {"--status", kOptionsGroup, "STATUS"},
    {"--cdf", kOptionsGroup, "DIR"},
    {"--tables", kOptionsGroup, "DIR"},
    {"--to", kOptionsGroup, "VERSION"},
    {"--truth", kOptionsGroup, "FILE"},
    {"--view", kOptionsGroup, "WHERE"},
    {"--unimplemented", kOptionsGroup, "RPC,RPC,..."},
};

struct TextForm {
  std::string_view value;  ///< placeholder of options that accept no empty text
  const char* form;
};

constexpr TextForm kTextForms[] = {
    {"DIR", "a folder"}, {"FILE", "a file"}, {"HOST", "a host"}, {"NAME", "a name"}};

const char* title(OptionGroup group) {
  switch (group) {
    case OptionGroup::kMatch:
      break;
    case OptionGroup::kTeams:
      return kTeamsGroup;
    case OptionGroup::kPlaymakers:
      return kPlaymakersGroup;
    case OptionGroup::kLimits:
      return kLimitsGroup;
    case OptionGroup::kDebugging:
      return kDebuggingGroup;
  }
  return kOptionsGroup;
}

// The row of `name`: of an option of matches, or one of the table above.
std::optional<OptionRow> find_row(const std::string& name) {
  for (const MatchOption& option : match_options()) {
    if (option_name(option.key) == name)
      return OptionRow{name, title(option.group), option.placeholder};
  }

  const auto row = std::find_if(std::begin(kOptions), std::end(kOptions),
                                [&name](const OptionRow& one) { return one.name == name; });
  return row == std::end(kOptions) ? std::nullopt : std::optional(*row);
}

void complete_option(Option& option) {
  const std::string name = name_of(option);
  const auto row = find_row(name);
  if (!row || option.group == kHidden) return;

  if (option.group == kOptionsGroup) option.group = row->group;
  if (row->value.empty() || is_flag(option)) return;
  option.value = row->value;
  for (const TextForm& one : kTextForms) {
    if (one.value == row->value) option.form.phrase = one.form;
  }
}

// Most commands declare --quiet themselves, to describe what it leaves out.
void add_shared_flags(Command& command) {
  if (find_option(command, "--quiet") == nullptr) {
    command.flag("--quiet", output_options().quiet, "print no progress and no notes");
  }
  command.flag("--no-color", output_options().no_color, "disable color");
}

}  // namespace

void complete_commands(Command& root) {
  for (Command& command : root.commands) {
    if (command.commands.empty()) add_shared_flags(command);
    for (Option& option : command.options) complete_option(option);
    complete_commands(command);
  }
}

}  // namespace cls::cli
