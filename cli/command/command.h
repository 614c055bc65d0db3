// The tree of commands as plain data: what each is called, takes, says and does. Parsing, help,
// manual pages and completion read it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/text/value_form.h"

namespace cls::cli {

/// Where parsing stores the value of an option. A vector gets all values; nothing: the texts stay
/// in the option.
using Target =
    std::variant<std::monostate, bool*, int*, std::uint64_t*, double*, std::string*,
                 std::filesystem::path*, std::optional<int>*, std::optional<std::uint64_t>*,
                 std::optional<double>*, std::vector<int>*, std::vector<std::string>*>;

/// The `max_values` of an option that takes all values up to the next option.
inline constexpr int kAnyNumber = 1 << 20;

/// Titles of groups of options in help and manual pages.
inline constexpr const char* kOptionsGroup = "Options";
inline constexpr const char* kTeamsGroup = "Teams";
inline constexpr const char* kPlaymakersGroup = "Playmakers";
inline constexpr const char* kLimitsGroup = "Limits";
inline constexpr const char* kDebuggingGroup = "Debugging";
inline constexpr const char* kOutputGroup = "Output";
inline constexpr const char* kHidden = "";  ///< not listed anywhere

/// An option, a flag or an argument.
struct Option {
  /// "--seed", "-p,--port", "--coach,!--no-coach"; an argument: "LEFT". Commands declare them with
  /// the placeholder of the value: "--out FILE"; a FILE, DIR, HOST or NAME is then not empty.
  std::string names;
  Target target;
  std::string help;
  base::ValueForm form;
  std::string value;  ///< placeholder of the value: "FILE"; empty: value_name() decides
  std::string group = kOptionsGroup;
  std::string default_text;  ///< shown behind the help
  std::string environment;   ///< variable that gives the value if the command line does not
  int min_values = 1;
  int max_values = 1;
  bool is_required = false;
  bool is_repeatable = false;
  char separator = '\0';  ///< splits a value into several: ','

  // Set by parse().
  std::vector<std::string> given;  ///< the values as written; of a flag "true" or "false"
  bool from_environment = false;

  Option& required() { return with(is_required, true); }
  Option& shows_default();  ///< the current value of the target
  Option& from(double min) { return with(form.min, min); }
  Option& above(double min) { return from(min).with(form.above_min, true); }
  Option& range(double min, double max) { return from(min).with(form.max, max); }
  Option& one_of(std::vector<std::string> words) { return with(form.words, std::move(words)); }
  /// Of a value that may be empty.
  Option& placeholder(std::string text) { return with(value, std::move(text)); }
  Option& of_group(std::string title) { return with(group, std::move(title)); }
  /// Each time with one value.
  Option& repeatable() { return with(is_repeatable, true).with(max_values, 1); }
  /// Exactly so many values.
  Option& takes(int count) { return with(min_values, count).with(max_values, count); }
  Option& split_at(char between) { return with(separator, between); }

 private:
  template <class Member, class Value>
  Option& with(Member& member, Value now) {
    member = std::move(now);
    return *this;
  }
};

/// A command, and the targets of its options, which live as long as it.
template <class Arguments>
struct AddedCommand;

struct Command {
  std::string name;
  std::string description;         ///< one line, then sentences and indented examples
  std::string group = "Commands";  ///< title in the help of its parent
  bool starts_programs = false;    ///< needs a guard that ends them, before anything else runs
  bool takes_any_words = false;    ///< unknown words go to `words` in order
  Command* parent = nullptr;
  std::deque<Option> options;  ///< the first is --help
  std::deque<Command> commands;
  std::function<int()> run;  ///< returns the exit code

  std::vector<std::string> words;  ///< set by parse()

  Command() = default;
  Command(std::string name, std::string description, Command* parent);

  /// Adds a command below this one.
  Command& command(std::string name, std::string description);

  /// Adds a command that calls `run` with its arguments; those of the second form with itself, too.
  template <class Arguments>
  auto command(std::string below, std::string text, int (*run_command)(Arguments&)) {
    auto added = with_arguments<Arguments>(std::move(below), std::move(text));
    added.command.run = [run_command, added] { return run_command(added.arguments); };
    return added;
  }
  template <class Arguments>
  auto command(std::string below, std::string text,
               int (*run_command)(const Command&, Arguments&)) {
    auto added = with_arguments<Arguments>(std::move(below), std::move(text));
    added.command.run = [run_command, added] {
      return run_command(added.command, added.arguments);
    };
    return added;
  }

  /// Adds an option whose value goes to `target`, or an argument.
  template <class T>
  Option& option(std::string names, T& target, std::string help) {
    return add(std::move(names), &target, std::move(help));
  }
  /// The same; the help shows the value that `target` has now as its default.
  template <class T>
  Option& setting(std::string names, T& target, std::string help) {
    return option(std::move(names), target, std::move(help)).shows_default();
  }
  /// Adds an option whose values stay in Option::given.
  Option& option(std::string names, std::string help) {
    return add(std::move(names), {}, std::move(help));
  }
  Option& flag(std::string names, bool& target, std::string help) {
    return add(std::move(names), &target, std::move(help));
  }
  /// A flag that stays in Option::given.
  Option& flag(std::string names, std::string help);

 private:
  template <class Arguments>
  auto with_arguments(std::string below, std::string text) {
    using Stored = std::remove_const_t<Arguments>;
    const auto stored = std::make_shared<Stored>();
    Command& added = command(std::move(below), std::move(text));
    added.arguments_ = stored;
    return AddedCommand<Stored>{added, *stored};
  }
  Option& add(std::string names, Target target, std::string help);

  std::shared_ptr<void> arguments_;
};

template <class Arguments>
struct AddedCommand {
  Command& command;
  Arguments& arguments;
};

/// Groups of commands in the help of `cls`.
inline constexpr const char* kPlayCommands = "Play";
inline constexpr const char* kResultCommands = "Results";
inline constexpr const char* kCheckCommands = "Checks";
inline constexpr const char* kPartCommands = "Run one part";

/// "cls tournament run".
std::string full_name(const Command& command);

bool is_argument(const Option& option);
bool is_flag(const Option& option);

/// "--port" of "-p,--port"; an argument's own name.
std::string name_of(const Option& option);

/// All names, as typed: "-p", "--port".
std::vector<std::string> all_names(const Option& option);

/// The placeholder of the value in help: "FILE", "N", "X".
std::string value_name(const Option& option);

/// nullptr if there is none. `name` as typed, "--port" or "-p".
const Option* find_option(const Command& command, std::string_view name);
const Command* find_command(const Command& command, std::string_view name);
Command* find_command(Command& command, std::string_view name);

}  // namespace cls::cli
