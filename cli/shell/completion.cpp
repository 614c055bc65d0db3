// Follows the words before the cursor through commands, options and arguments.
#include "cli/shell/completion.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <utility>

#include "cli/shell/completion_values.h"
#include "cli/support/value_form.h"

namespace cls::cli {
namespace {

using Words = std::vector<std::string>;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// Hidden ones have no group.
std::vector<const CLI::App*> visible_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : visible_commands(app)) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

/// Where the cursor is.
struct Place {
  const CLI::App* command = nullptr;
  const CLI::Option* option = nullptr;  ///< whose value the cursor is on
  Words arguments;                      ///< before the cursor, without options
  Words options;                        ///< given before the cursor: "--seed"
};

// False if a word is not a command.
bool advance(Place& place, const std::string& word) {
  if (visible_commands(*place.command).empty()) {
    place.arguments.push_back(word);
    return true;
  }
  place.command = find_command(*place.command, word);
  return place.command != nullptr;
}

// Nothing behind an unknown command can be completed.
bool find_place(Place& place, const Words& before) {
  int values = 0;  // that the option still takes
  for (const std::string& word : before) {
    if (values > 0) {
      if (--values == 0) place.option = nullptr;
      continue;
    }
    if (word.size() < 2 || word.front() != '-') {
      if (!advance(place, word)) return false;
      continue;
    }
    const std::size_t equals = word.find('=');
    place.options.push_back(word.substr(0, equals));
    const CLI::Option* option = place.command->get_option_no_throw(place.options.back());
    if (option == nullptr || is_flag(*option) || equals != std::string::npos) continue;
    place.option = option;
    values = option->get_expected_min();
  }
  return true;
}

bool may_repeat(const CLI::Option& option) {
  return option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

void add_options(const Place& place, Completion& completion) {
  for (const CLI::Option* option : place.command->get_options()) {
    if (option->get_group().empty() || !option->nonpositional()) continue;
    for (const std::string& name : option->get_lnames()) {
      const std::string text = "--" + name;
      const bool given =
          std::find(place.options.begin(), place.options.end(), text) != place.options.end();
      if (!given || may_repeat(*option)) {
        completion.candidates.push_back({text, first_line(option->get_description())});
      }
    }
  }
}

void add_commands(const CLI::App& app, Completion& completion) {
  for (const CLI::App* command : visible_commands(app)) {
    completion.candidates.push_back({command->get_name(), first_line(command->get_description())});
  }
}

// The argument at the cursor; nullptr if the command takes no more.
const CLI::Option* argument_at(const CLI::App& command, std::size_t index) {
  const CLI::Option* last = nullptr;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    if (index-- == 0) return option;
    last = option;
  }
  const bool takes_rest =
      last != nullptr && last->get_expected_max() == CLI::detail::expected_max_vector_size;
  return takes_rest ? last : nullptr;
}

// "cls help tournament run": the words are commands.
void add_topics(const CLI::App& app, const Words& arguments, Completion& completion) {
  const CLI::App* place = &app;
  for (const std::string& word : arguments) {
    place = find_command(*place, word);
    if (place == nullptr) return;
  }
  add_commands(*place, completion);
  if (arguments.empty()) add_topic_names(completion);
}

void keep_matching(std::string_view word, Completion& completion) {
  std::erase_if(completion.candidates, [word](const Candidate& candidate) {
    return !std::string_view(candidate.text).starts_with(word);
  });
}

// "--mode=lock": candidates are whole words.
Completion complete_attached(const Place& place, const std::string& word) {
  Completion completion;
  const std::size_t equals = word.find('=');
  const CLI::Option* option = place.command->get_option_no_throw(word.substr(0, equals));
  if (option == nullptr || is_flag(*option)) return completion;
  completion = values_of(*option, {place.options, word.substr(equals + 1)});
  const std::string head = word.substr(0, equals + 1);
  for (Candidate& candidate : completion.candidates) candidate.text.insert(0, head);
  completion.path_prefix.insert(0, head);
  return completion;
}

}  // namespace

Completion complete(const CLI::App& app, const Words& words) {
  Completion completion;
  if (words.empty()) return completion;
  const std::string& word = words.back();
  Place place{&app, nullptr, {}, {}};
  if (!find_place(place, {words.begin(), words.end() - 1})) return completion;
  if (place.option != nullptr) {
    completion = values_of(*place.option, {place.options, word});
  } else if (word.starts_with("--") && word.find('=') != std::string::npos) {
    completion = complete_attached(place, word);
  } else if (word.starts_with('-')) {
    add_options(place, completion);
  } else if (!visible_commands(*place.command).empty()) {
    add_commands(*place.command, completion);
  } else if (place.command->get_name() == "help") {
    add_topics(app, place.arguments, completion);
  } else if (place.command->get_allow_extras()) {
    add_parameters(completion, word);  // of cls server
  } else if (const CLI::Option* argument = argument_at(*place.command, place.arguments.size())) {
    completion = values_of(*argument, {place.options, word});
  }
  keep_matching(word, completion);
  return completion;
}

}  // namespace cls::cli
