// CLI11 assigns words to options; their count, form and value are checked here, so that an error
// names the option, its value and what it must be.
#include "cli/command/parse.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <utility>

#include "base/text/split.h"
#include "base/text/value_text.h"
#include "cli/command/usage_errors.h"

namespace cls::cli {
namespace {

using Words = std::vector<std::string>;
using Declared = std::map<const CLI::Option*, Option*>;

CLI::Option* declare(CLI::App& app, const Option& option) {
  if (is_flag(option)) return app.add_flag(option.names);

  CLI::Option* declared = app.add_option(option.names);
  if (option.max_values == kAnyNumber) {
    declared->expected(option.min_values, CLI::detail::expected_max_vector_size);
    declared->allow_extra_args();
  } else {
    declared->expected(option.min_values, option.max_values);
  }

  declared->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return declared;
}

void declare(CLI::App& app, Command& command, Declared& declared) {
  app.set_help_flag();  // an option like others
  app.allow_extras(command.takes_any_words);
  app.require_subcommand(0, 1);  // a side may be called as a command: cls match mock mock

  for (Option& option : command.options) declared[declare(app, option)] = &option;
  for (Command& below : command.commands) declare(*app.add_subcommand(below.name), below, declared);
}

// The command that the words before an error chose, and its twin in CLI11.
std::pair<Command*, const CLI::App*> innermost(Command& command, const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  if (chosen.empty()) return {&command, &app};
  return innermost(*find_command(command, chosen.front()->get_name()), *chosen.front());
}

void take_values(const Declared& declared) {
  for (const auto& [from, option] : declared) {
    option->given = from->results();
    option->from_environment = false;
    if (!option->given.empty() || option->environment.empty()) continue;

    const char* value = std::getenv(option->environment.c_str());
    if (value == nullptr || *value == '\0') continue;
    option->given = {value};
    option->from_environment = true;
  }
}

/// Stores texts that have the form of the option. False if the type cannot hold a number.
struct Store {
  const Words& texts;

  bool operator()(std::monostate) const { return true; }

  template <class T>
  bool operator()(T* target) const {
    return store(texts.back(), *target);
  }
  template <class T>
  bool operator()(std::optional<T>* target) const {
    return store(texts.back(), target->emplace());
  }
  template <class T>
  bool operator()(std::vector<T>* target) const {
    target->clear();
    for (const std::string& text : texts) {
      if (!store(text, target->emplace_back())) return false;
    }
    return true;
  }

  template <class T>
  static bool store(const std::string& text, T& value) {
    auto read = base::value_of<T>(text);
    if (!read) return false;

    value = *std::move(read);
    return true;
  }
};

Words split(const Words& values, char separator) {
  if (separator == '\0') return values;
  Words parts;
  for (const std::string& value : values) {
    for (const std::string_view part : base::split(value, separator)) {
      if (!part.empty()) parts.emplace_back(part);
    }
  }
  return parts;
}

// Empty: stored.
std::string store(const Command& command, Option& option) {
  if (option.given.empty()) return "";
  if (!is_flag(option) && std::ssize(option.given) < option.min_values) {
    return wrong_count(command, option);
  }

  const bool once = option.max_values == 1 && !option.is_repeatable;
  if (once && !is_flag(option) && option.given.size() > 1) return given_too_often(option);

  const Words texts = split(option.given, option.separator);
  for (const std::string& text : texts) {
    if (!base::fits(option.form, text)) return invalid_value(command, option, text);
  }

  if (texts.empty() || std::visit(Store{texts}, option.target)) return "";
  return invalid_value(command, option, texts.front());
}

bool asks_for_help(const Command& command) {
  return !command.options.front().given.empty() ||
         (command.parent != nullptr && asks_for_help(*command.parent));
}

// The values of the command and of those above it.
std::string store_values(Command& command) {
  if (command.parent != nullptr) {
    if (std::string error = store_values(*command.parent); !error.empty()) return error;
  }

  for (Option& option : command.options) {
    if (std::string error = store(command, option); !error.empty()) return error;
  }
  return missing_options(command);
}

// CLI11 names the option of an error in its text only.
std::string translated(const Command& command, const CLI::App& app, const CLI::ParseError& error) {
  if (const Words unknown = app.remaining(true); !unknown.empty()) {
    return unknown_word(command, unknown.front());
  }
  if (const Option* option = option_in(command, error.what())) {
    return wrong_count(command, *option);
  }
  return wrong_arguments(command);
}

}  // namespace

Parsed parse(Command& root, Words words) {
  CLI::App app;
  app.name(root.name);
  Declared declared;
  declare(app, root, declared);

  std::string error;
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& problem) {
    error = translated(*innermost(root, app).first, app, problem);
  }
  take_values(declared);

  const auto [command, place] = innermost(root, app);
  command->words = place->remaining();
  if (asks_for_help(*command)) return {command, true, ""};
  if (error.empty()) error = store_values(*command);
  if (error.empty() && !command->run) error = missing_command(*command);
  return {command, false, std::move(error)};
}

}  // namespace cls::cli
