// The tree of commands, and the arguments before parsing.
#include "cli/application.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/io/home_path.h"
#include "cli/command/help.h"
#include "cli/command/parse.h"
#include "cli/command/usage_errors.h"
#include "cli/shell/completion.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

constexpr const char* kRootDescription =
    "play, evaluate and test RoboCup 2D soccer matches of gRPC Playmakers\n"
    "\n"
    "  cls match mock mock                    the bundled team against itself\n"
    "  cls match mock localhost:50051         against your Playmaker\n"
    "  cls help match                         options of matches";

// The entry of completion scripts. It takes any words, so it is not a command of the tree.
constexpr std::string_view kCompleteCommand = "complete";

using Words = std::vector<std::string>;

bool is_shared_flag(const std::string& word) {
  return word == "--json" || word == "--quiet" || word == "--no-color";
}

// Moves the shared flags from the front to the command: "--json match a b" -> "match --json a b".
Words with_flags_behind_command(const Command& root, Words words) {
  const auto command = std::ranges::find_if_not(words, is_shared_flag);
  const Command* place = &root;

  auto end = command;
  while (end != words.end() && !place->commands.empty()) {
    place = find_command(*place, *end);
    if (place == nullptr) return words;
    ++end;
  }

  std::rotate(words.begin(), command, end);
  return words;
}

// "help" and a command, or nothing; the command `help` itself handles topics.
bool asks_for_help(const Command& root, const Words& words) {
  if (words.empty() || words.front() != "help") return false;
  return words.size() == 1 || find_command(root, words[1]) != nullptr;
}

// "help tournament run" -> "tournament run --help"; "--version" -> "version".
Words canonical(const Command& root, Words words) {
  if (asks_for_help(root, words)) {
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
  }

  words = with_flags_behind_command(root, std::move(words));
  const auto first = std::ranges::find_if_not(words, is_shared_flag);
  if (first != words.end() && (*first == "--version" || *first == "-V")) {
    words.erase(first);
    words.insert(words.begin(), "version");
  }
  return words;
}

// "--dir=~/x" -> "--dir=/home/ada/x": shells expand the tilde in "--dir ~/x" only.
Words with_home(Words words) {
  for (std::string& word : words) {
    const std::size_t equals = word.find("=~");
    if (!word.starts_with("--") || equals == std::string::npos || word.find('=') != equals)
      continue;

    word = word.substr(0, equals + 1) + base::expand_home(word.substr(equals + 1));
  }
  return words;
}

void add_commands(Command& parent) { CLS_COMMANDS(CLS_ADD_COMMAND) }

// canonical() replaces these; they are here for help and suggestions.
// Most commands declare --quiet themselves, to describe what it leaves out.
void add_shared_flags(Command& command) {
  for (Command& below : command.commands) add_shared_flags(below);
  if (!command.commands.empty()) return;

  if (find_option(command, "--quiet") == nullptr) {
    command.flag("--quiet", output_options().quiet, "print no progress and no notes")
        .of_group(kOutputGroup);
  }
  command.flag("--no-color", output_options().no_color, "disable color").of_group(kOutputGroup);
}

void add_root_options(Command& root) {
  root.flag("-V,--version", "print the version, as cls version");
  root.flag("--json", "of every command: print one JSON document on stdout");
  root.flag("--quiet", "of every command: print no progress and no notes");
  root.flag("--no-color", "of every command: disable color");
}

}  // namespace

std::unique_ptr<Command> command_tree() {
  auto root = std::make_unique<Command>("cls", kRootDescription, nullptr);
  add_commands(*root);
  add_shared_flags(*root);
  add_root_options(*root);
  return root;
}

bool may_start_programs(const Command& root, int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]).starts_with("-")) continue;
    const Command* command = find_command(root, argv[i]);
    return command != nullptr && command->starts_programs;
  }
  return false;
}

int run_application(Command& root, int argc, const char* const* argv) {
  output_options() = {};
  if (argc > 1 && argv[1] == kCompleteCommand) {
    return print_completion(root, Words(argv + 2, argv + argc));
  }

  const Words words = canonical(root, with_home(Words(argv + 1, argv + argc)));
  const std::string unknown = unknown_command(root, words);
  if (!unknown.empty()) return print_error(kUsage, unknown);

  const Parsed parsed = parse(root, words);
  if (parsed.asks_for_help) {
    fmt::print("{}", help_text(*parsed.command));
    return kOk;
  }
  if (!parsed.error.empty()) return print_error(kUsage, parsed.error);
  return parsed.command->run();
}

}  // namespace cls::cli
