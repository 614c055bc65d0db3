// CLI11 assigns words to options; their count, form and value are checked here, so that an error
// names the option, its value and what it must be.
#include "cli/command/parse.h"

#include <fmt/format.h>

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
  CLI::Option* declared =
      is_flag(option) ? app.add_flag(option.names) : app.add_option(option.names);
  declared->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  if (is_flag(option)) return declared;

  const bool takes_many = option.max_values == kAnyNumber;
  declared->expected(option.min_values,
                     takes_many ? CLI::detail::expected_max_vector_size : option.max_values);
  if (option.min_values == 0) declared->default_str("true");  // without a value, as a flag
  return takes_many ? declared->allow_extra_args() : declared;
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

/// The mistakes that CLI11 reports.
enum class Mistake { kNone, kMissingValues, kOther };

Mistake assign(CLI::App& app, const Words& words) {
  try {
    app.parse(Words(words.rbegin(), words.rend()));  // CLI11 takes the last word first
    return Mistake::kNone;
  } catch (const CLI::ArgumentMismatch&) {
    return Mistake::kMissingValues;
  } catch (const CLI::ParseError&) {
    return Mistake::kOther;
  }
}

// The option without all of its values. It is the last of the words: others take what follows.
const Option* unfinished_option(const Command& command, const std::string& last_word) {
  const auto is_begun = [](const Option& option) {
    return !option.given.empty() && !option.from_environment &&
           std::ssize(option.given) < option.min_values;
  };
  const auto begun = std::ranges::find_if(command.options, is_begun);
  if (begun != command.options.end()) return &*begun;

  const bool is_long = last_word.starts_with("--");
  return find_option(command, is_long ? last_word.substr(0, last_word.find('='))
                                      : fmt::format("-{}", last_word.back()));
}

std::string text_of(Mistake mistake, const Command& command, const Words& unknown,
                    const Words& words) {
  if (mistake == Mistake::kNone) return "";
  if (!unknown.empty()) return unknown_word(command, unknown.front());

  const Option* option =
      mistake == Mistake::kMissingValues ? unfinished_option(command, words.back()) : nullptr;
  return option == nullptr ? wrong_arguments(command) : wrong_count(command, *option);
}

// A flag has one value at most, which CLI11 does not check.
std::string repeated_flag(const Command& command) {
  const auto is_repeated = [](const Option& option) {
    return is_flag(option) && option.given.size() > 1;
  };
  const auto found = std::ranges::find_if(command.options, is_repeated);
  return found == command.options.end() ? "" : wrong_count(command, *found);
}

}  // namespace

Parsed parse(Command& root, const Words& words) {
  CLI::App app;
  app.name(root.name);
  Declared declared;
  declare(app, root, declared);
  const Mistake mistake = assign(app, words);
  take_values(declared);

  const auto [command, place] = innermost(root, app);
  command->words = place->remaining();
  if (asks_for_help(*command)) return {command, true, ""};

  std::string error = text_of(mistake, *command, app.remaining(true), words);
  if (error.empty()) error = repeated_flag(*command);
  if (error.empty()) error = store_values(*command);
  if (error.empty() && !command->run) error = missing_command(*command);
  return {command, false, std::move(error)};
}

}  // namespace cls::cli
