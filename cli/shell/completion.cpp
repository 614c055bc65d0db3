// Follows the words before the cursor through commands, options and arguments.
#include "cli/shell/completion.h"

#include <algorithm>
#include <string_view>

#include "cli/command/help.h"
#include "cli/shell/completion_values.h"

namespace cls::cli {
namespace {

using Words = std::vector<std::string>;

bool is_visible(const Command& command) { return command.group != kHidden; }

bool has_visible_commands(const Command& command) {
  return std::ranges::any_of(command.commands, is_visible);
}

const Command* find_visible(const Command& command, const std::string& name) {
  const Command* found = find_command(command, name);
  return found != nullptr && is_visible(*found) ? found : nullptr;
}

/// Where the cursor is.
struct Place {
  const Command* command = nullptr;
  const Option* option = nullptr;  ///< whose value the cursor is on
  Words arguments;                 ///< before the cursor, without options
  Words options;                   ///< given before the cursor: "--seed"
};

// False if a word is not a command.
bool advance(Place& place, const std::string& word) {
  if (!has_visible_commands(*place.command)) {
    place.arguments.push_back(word);
    return true;
  }
  place.command = find_visible(*place.command, word);
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
    const Option* option = find_option(*place.command, place.options.back());
    if (option == nullptr || is_flag(*option) || equals != std::string::npos) continue;

    place.option = option;
    values = option->min_values;
  }
  return true;
}

void add_options(const Place& place, Completion& completion) {
  for (const Option& option : place.command->options) {
    if (option.group == kHidden || is_argument(option)) continue;
    for (const std::string& name : all_names(option)) {
      const bool given = std::ranges::find(place.options, name) != place.options.end();
      if (!name.starts_with("--") || (given && !option.is_repeatable)) continue;
      completion.candidates.push_back({name, first_line(option.help)});
    }
  }
}

void add_commands(const Command& command, Completion& completion) {
  for (const Command& below : command.commands) {
    if (!is_visible(below)) continue;
    completion.candidates.push_back({below.name, first_line(below.description)});
  }
}

// The argument at the cursor; nullptr if the command takes no more.
const Option* argument_at(const Command& command, std::size_t index) {
  const Option* last = nullptr;
  for (const Option& option : command.options) {
    if (!is_argument(option)) continue;
    if (index-- == 0) return &option;
    last = &option;
  }
  return last != nullptr && last->max_values == kAnyNumber ? last : nullptr;
}

// "cls help tournament run": the words are commands.
void add_topics(const Command& root, const Words& arguments, Completion& completion) {
  const Command* place = &root;
  for (const std::string& word : arguments) {
    place = find_visible(*place, word);
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
  const Option* option = find_option(*place.command, word.substr(0, equals));
  if (option == nullptr || is_flag(*option)) return completion;

  completion = values_of(*option, {place.options, word.substr(equals + 1)});

  const std::string head = word.substr(0, equals + 1);
  for (Candidate& candidate : completion.candidates) candidate.text.insert(0, head);
  completion.path_prefix.insert(0, head);
  return completion;
}

}  // namespace

Completion complete(const Command& root, const Words& words) {
  Completion completion;

  if (words.empty()) return completion;
  const std::string& word = words.back();
  Place place{&root, nullptr, {}, {}};
  if (!find_place(place, {words.begin(), words.end() - 1})) return completion;

  if (place.option != nullptr) {
    completion = values_of(*place.option, {place.options, word});
  } else if (word.starts_with("--") && word.find('=') != std::string::npos) {
    completion = complete_attached(place, word);
  } else if (word.starts_with('-')) {
    add_options(place, completion);
  } else if (has_visible_commands(*place.command)) {
    add_commands(*place.command, completion);
  } else if (place.command->name == "help") {
    add_topics(root, place.arguments, completion);
  } else if (place.command->takes_any_words) {
    add_parameters(completion, word);  // of cls server
  } else if (const Option* argument = argument_at(*place.command, place.arguments.size())) {
    completion = values_of(*argument, {place.options, word});
  }

  keep_matching(word, completion);
  return completion;
}

}  // namespace cls::cli
