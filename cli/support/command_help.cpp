// Overrides of CLI11's formatter.
#include "cli/support/command_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "base/text/wrap_text.h"
#include "cli/support/value_form.h"

namespace cls::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kCommandColumn = 16;

void cut(std::string& text, std::string_view part) {
  if (const auto at = text.find(part); at != std::string::npos) text.erase(at, part.size());
}

std::string without_spaces_at_line_ends(std::string text) {
  for (auto at = text.find(" \n"); at != std::string::npos; at = text.find(" \n")) {
    text.erase(at, 1);
  }
  return text;
}

}  // namespace

CommandHelp::CommandHelp() {
  label("Positionals", "Arguments");
  label("SUBCOMMAND", "COMMAND");
}

std::string CommandHelp::make_usage(const CLI::App* app, std::string name) const {
  return "\n" + CLI::Formatter::make_usage(app, name);
}

std::string CommandHelp::make_help(const CLI::App* app, std::string name,
                                   CLI::AppFormatMode /*mode*/) const {
  std::string text = make_description(app) + make_usage(app, std::move(name));
  text += make_positionals(app);
  std::vector<std::string> groups = app->get_groups();
  std::stable_partition(groups.begin(), groups.end(),
                        [](const std::string& group) { return group != "Output"; });
  for (const std::string& group : groups) {
    const auto options = app->get_options([&group](const CLI::Option* option) {
      return option->get_group() == group && option->nonpositional();
    });
    if (!group.empty() && !options.empty()) text += make_group(group, false, options);
  }
  text += make_subcommands(app, CLI::AppFormatMode::Normal);
  return without_spaces_at_line_ends(std::move(text));
}

std::string CommandHelp::make_subcommand(const CLI::App* command) const {
  const std::string description = command->get_description();
  std::stringstream out;
  CLI::detail::format_help(
      out, command->get_name(),
      base::wrap_text(description.substr(0, description.find('\n')), kWidth - kCommandColumn),
      kCommandColumn);
  return out.str();
}

std::string CommandHelp::make_option_name(const CLI::Option* option, bool is_positional) const {
  std::string name = CLI::Formatter::make_option_name(option, is_positional);
  cut(name, "{false}");
  return name;
}

// Arguments need no type; the default value and the environment follow the description.
std::string CommandHelp::make_option_opts(const CLI::Option* option) const {
  if (option->get_positional()) {
    return option->get_expected_max() == CLI::detail::expected_max_vector_size ? " ..." : "";
  }
  return is_flag(*option) || value_name(*option).empty() ? "" : " " + value_name(*option);
}

std::string CommandHelp::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (!option->get_envname().empty()) {
    text += fmt::format(" (environment: {})", option->get_envname());
  }
  const std::string value = option->get_default_str();
  if (!value.empty()) text += fmt::format(" (default: {})", value);
  return base::wrap_text(text, kWidth - get_column_width());
}

}  // namespace cls::cli
