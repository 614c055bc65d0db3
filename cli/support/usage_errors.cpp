// Translates the errors of CLI11. It names the option in its text only; everything else is read
// from the option itself.
#include "cli/support/usage_errors.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/text/suggestion.h"
#include "cli/support/value_form.h"

namespace cls::cli {
namespace {

std::string see_help(const CLI::App& command) {
  return fmt::format(" (see {} --help)", full_name(command));
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // former names
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// "; did you mean 'x'?", else where the names are listed.
std::string suggestion(const std::string& word, const std::vector<std::string>& names,
                       const CLI::App& command) {
  std::string near = base::did_you_mean(word, {names.begin(), names.end()});
  return near.empty() ? see_help(command) : near;
}

// The sub-command that the arguments before the error selected.
const CLI::App& innermost_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost_command(*chosen.front());
}

// "A, B and C".
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

// The option that the text of the error names.
const CLI::Option* option_of(const CLI::App& command, std::string_view text) {
  const CLI::Option* best = nullptr;
  const auto is_end = [](char c) { return c == ' ' || c == ':' || c == ','; };
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const std::size_t at = text.find(name);
    if (at == std::string_view::npos || (at > 0 && text[at - 1] != ' ')) continue;
    const std::size_t end = at + name.size();
    if (end < text.size() && !is_end(text[end])) continue;
    // The first name in the text; a value behind it may look like another.
    if (best == nullptr || at < text.find(best->get_name())) best = option;
  }
  return best;
}

// The first value that the error is about.
std::string bad_value(const CLI::Option& option, std::string_view text) {
  const std::vector<std::string>& values = option.results();
  for (const std::string& value : values) {
    if (!value.empty() && text.find(value) != std::string_view::npos) return value;
  }
  return values.empty() ? "" : values.front();
}

// A valid decimal number that the type cannot hold.
bool is_too_large(const std::string& value, const std::string& form) {
  return form.starts_with("a whole number") && form.find(" to ") == std::string::npos &&
         value.size() > 9 && value.find_first_not_of("0123456789") == std::string::npos;
}

std::string invalid_value(const CLI::App& command, const CLI::Option& option,
                          std::string_view text) {
  const std::string name = option.get_name();
  if (is_flag(option)) return fmt::format("{} takes no value{}", name, see_help(command));
  const std::string value = bad_value(option, text);
  const std::string form = value_form(option);
  if (is_too_large(value, form)) return fmt::format("{} '{}': too large", name, value);
  if (form.empty()) return fmt::format("{} '{}': invalid{}", name, value, see_help(command));
  const std::vector<std::string> words = choices(option);
  return fmt::format("{} '{}': must be {}{}", name, value, form,
                     base::did_you_mean(value, {words.begin(), words.end()}));
}

std::string wrong_count(const CLI::App& command, const CLI::Option& option, bool too_many) {
  const std::string name = option.get_name();
  if (is_flag(option)) return fmt::format("{} takes no value{}", name, see_help(command));
  if (too_many && option.get_expected_max() == 1) {
    return fmt::format("{} is given {} times; only once is possible", name,
                       option.results().size());
  }
  const std::string form = value_form(option);
  if (option.get_expected_min() > 1) {
    return fmt::format("{} requires {} values: {}", name, option.get_expected_min(),
                       value_name(option));
  }
  return fmt::format("{} requires a value: {}", name, form.empty() ? value_name(option) : form);
}

std::string missing(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_required() && option->count() == 0) names.push_back(option->get_name());
  }
  if (!names.empty()) {
    return fmt::format("{} {} required{}", listed(names), names.size() == 1 ? "is" : "are",
                       see_help(command));
  }
  if (command.get_parent() == nullptr) {
    return "no command; see cls --help, or begin with: cls match mock mock";
  }
  return fmt::format("{} requires a command: {}", command.get_name(),
                     fmt::join(command_names(command), ", "));
}

}  // namespace

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + " " + command.get_name();
}

std::optional<std::string> unknown_command(const CLI::App& app,
                                           const std::vector<std::string>& arguments) {
  const CLI::App* place = &app;
  for (const std::string& argument : arguments) {
    if (argument.starts_with('-')) continue;
    const std::vector<const CLI::App*> commands = place->get_subcommands({});
    if (commands.empty()) return std::nullopt;
    const auto chosen = std::find_if(
        commands.begin(), commands.end(),
        [&argument](const CLI::App* command) { return command->get_name() == argument; });
    if (chosen == commands.end()) {
      return fmt::format("unknown command '{}'{}", argument,
                         suggestion(argument, command_names(*place), *place));
    }
    place = *chosen;
  }
  return std::nullopt;
}

std::string unknown_option(const CLI::App& command, const std::string& option) {
  const std::string name = option.substr(0, option.find('='));
  return fmt::format("unknown option '{}'{}", name,
                     suggestion(name, option_names(command), command));
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& place = innermost_command(app);
  if (const std::vector<std::string> unknown = app.remaining(true); !unknown.empty()) {
    const std::string& argument = unknown.front();
    if (argument.starts_with('-')) return unknown_option(place, argument);
    return fmt::format("unknown argument '{}'{}", argument, see_help(place));
  }
  const std::string text = error.what();
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing(place);
  const CLI::Option* option = option_of(place, text);
  if (option == nullptr) return fmt::format("wrong arguments{}", see_help(place));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return wrong_count(place, *option, text.find("At Most") != std::string::npos);
  }
  return invalid_value(place, *option, text);
}

}  // namespace cls::cli
