// Words the errors, with suggestions for mistyped names.
#include "cli/command/usage_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/suggestion.h"

namespace cls::cli {
namespace {

std::string see_help(const Command& command) {
  return fmt::format(" (see {} --help)", full_name(command));
}

std::vector<std::string> command_names(const Command& command) {
  std::vector<std::string> names;
  for (const Command& below : command.commands) names.push_back(below.name);
  return names;
}

std::vector<std::string> long_names(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options) {
    if (option.group == kHidden) continue;  // former names
    for (std::string& name : all_names(option)) {
      if (name.starts_with("--")) names.push_back(std::move(name));
    }
  }
  return names;
}

// "; did you mean 'x'?", else where the names are listed.
std::string suggestion(const std::string& word, const std::vector<std::string>& names,
                       const Command& command) {
  std::string near = base::did_you_mean(word, {names.begin(), names.end()});
  return near.empty() ? see_help(command) : near;
}

// "A, B and C".
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

// A valid decimal number that the type cannot hold.
bool is_too_large(const std::string& value, const base::ValueForm& form) {
  const bool whole =
      form.kind == base::ValueKind::kWhole || form.kind == base::ValueKind::kUnsigned;
  return whole && !form.max && value.size() > 9 &&
         value.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::string invalid_value(const Command& command, const Option& option, const std::string& value) {
  const std::string name = name_of(option);
  if (is_flag(option) && option.form.words.empty()) return wrong_count(command, option);
  if (is_too_large(value, option.form)) return fmt::format("{} '{}': too large", name, value);
  const std::string form = base::phrase_of(option.form);
  if (form.empty()) return fmt::format("{} '{}': invalid{}", name, value, see_help(command));

  const std::vector<std::string>& words = option.form.words;
  return fmt::format("{} '{}': must be {}{}", name, value, form,
                     base::did_you_mean(value, {words.begin(), words.end()}));
}

std::string given_too_often(const Option& option) {
  return fmt::format("{} is given {} times; only once is possible", name_of(option),
                     option.given.size());
}

std::string wrong_count(const Command& command, const Option& option) {
  const std::string name = name_of(option);
  if (is_flag(option)) return fmt::format("{} takes no value{}", name, see_help(command));

  if (option.min_values > 1) {
    return fmt::format("{} requires {} values: {}", name, option.min_values, value_name(option));
  }

  const std::string form = base::phrase_of(option.form);
  return fmt::format("{} requires a value: {}", name, form.empty() ? value_name(option) : form);
}

std::string missing_options(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options) {
    if (option.is_required && option.given.empty()) names.push_back(name_of(option));
  }

  if (names.empty()) return "";
  return fmt::format("{} {} required{}", listed(names), names.size() == 1 ? "is" : "are",
                     see_help(command));
}

std::string missing_command(const Command& command) {
  if (command.parent == nullptr) {
    return "no command; see cls --help, or begin with: cls match mock mock";
  }
  return fmt::format("{} requires a command: {}", command.name,
                     fmt::join(command_names(command), ", "));
}

std::string unknown_word(const Command& command, const std::string& word) {
  if (word.starts_with('-')) return unknown_option(command, word);
  return fmt::format("unknown argument '{}'{}", word, see_help(command));
}

std::string wrong_arguments(const Command& command) {
  return fmt::format("wrong arguments{}", see_help(command));
}

std::string unknown_option(const Command& command, const std::string& option) {
  const std::string name = option.substr(0, option.find('='));
  return fmt::format("unknown option '{}'{}", name, suggestion(name, long_names(command), command));
}

std::string unknown_command(const Command& root, const std::vector<std::string>& words) {
  const Command* place = &root;
  for (const std::string& word : words) {
    if (word.starts_with('-')) continue;
    if (place->commands.empty()) return "";

    const Command* chosen = find_command(*place, word);
    if (chosen == nullptr) {
      return fmt::format("unknown command '{}'{}", word,
                         suggestion(word, command_names(*place), *place));
    }
    place = chosen;
  }
  return "";
}

}  // namespace cls::cli
