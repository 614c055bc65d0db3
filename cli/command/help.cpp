// Lays out the help in 80 columns.
#include "cli/command/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text/wrap_text.h"

namespace cls::cli {
namespace {

constexpr std::size_t kHelpWidth = 80;
constexpr std::size_t kOptionColumn = 30;
constexpr std::size_t kCommandColumn = 16;

void add_once(std::vector<std::string>& list, const std::string& item) {
  if (std::ranges::find(list, item) == list.end()) list.push_back(item);
}

// "  NAME      text"; a name that reaches the column has a line of its own.
std::string entry(const std::string& name, const std::string& text, std::size_t column) {
  std::string lines = fmt::format("{:<{}}", "  " + name, column);
  const std::string margin = "\n" + std::string(column, ' ');
  if (name.size() + 2 >= column && !text.empty()) lines += margin;

  for (const char c : base::wrap_text(text, kHelpWidth - column)) {
    if (c == '\n') {
      lines += margin;
    } else {
      lines += c;
    }
  }
  return lines + "\n";
}

std::string without_spaces_at_line_ends(std::string text) {
  for (auto at = text.find(" \n"); at != std::string::npos; at = text.find(" \n")) {
    text.erase(at, 1);
  }
  return text;
}

bool takes_many(const Option& option) { return option.max_values == kAnyNumber; }

// A title and the options that belong below it; empty without any.
template <class Belongs>
std::string section(const Command& command, const std::string& title, const Belongs& belongs) {
  std::string lines;
  for (const Option& option : command.options) {
    if (!belongs(option)) continue;
    lines += entry(signature_of(option), description_of(option), kOptionColumn);
  }
  return lines.empty() ? "" : fmt::format("\n{}:\n{}", title, lines);
}

std::string command_sections(const Command& command) {
  std::vector<std::string> groups;
  for (const Command& below : command.commands) {
    if (below.group != kHidden) add_once(groups, below.group);
  }

  std::string text;
  for (const std::string& group : groups) {
    text += fmt::format("\n{}:\n", group);
    for (const Command& below : command.commands) {
      if (below.group != group) continue;
      text += entry(below.name, first_line(below.description), kCommandColumn);
    }
  }
  return text;
}

}  // namespace

std::string help_text(const Command& command) {
  std::string text = fmt::format("{}\n\nUsage: {} {}\n", command.description, full_name(command),
                                 usage_of(command));

  text += section(command, "Arguments", is_argument);
  for (const std::string& group : option_groups(command)) {
    text += section(command, group, [&group](const Option& option) {
      return !is_argument(option) && option.group == group;
    });
  }

  text += command_sections(command);
  return without_spaces_at_line_ends(std::move(text));
}

std::string first_line(std::string_view text) {
  return std::string(text.substr(0, text.find('\n')));
}

std::string usage_of(const Command& command) {
  std::string usage = "[OPTIONS]";
  for (const Option& option : command.options) {
    if (!is_argument(option)) continue;
    const std::string name = option.names + (takes_many(option) ? "..." : "");
    usage += option.is_required ? " " + name : " [" + name + "]";
  }

  if (!command.commands.empty()) usage += " COMMAND";
  return usage;
}

std::string signature_of(const Option& option) {
  if (is_argument(option)) return option.names + (takes_many(option) ? " ..." : "");
  std::string text = fmt::format("{}", fmt::join(all_names(option), ","));
  if (!is_flag(option)) text += " " + value_name(option);
  return text;
}

std::string description_of(const Option& option) {
  std::string text = option.help;
  // The width of the help folds it; only lines that are indented stay lines.
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] != ' ') text[at] = ' ';
  }
  if (!option.environment.empty()) text += fmt::format(" (environment: {})", option.environment);
  if (!option.default_text.empty()) text += fmt::format(" (default: {})", option.default_text);
  return text;
}

std::vector<std::string> option_groups(const Command& command) {
  std::vector<std::string> groups;
  for (const Option& option : command.options) {
    if (option.group != kHidden) add_once(groups, option.group);
  }

  std::stable_partition(groups.begin(), groups.end(),
                        [](const std::string& group) { return group != kOutputGroup; });
  return groups;
}

}  // namespace cls::cli
