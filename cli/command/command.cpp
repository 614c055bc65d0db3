// Builds and searches the tree of commands.
#include "cli/command/command.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "base/text/split.h"
#include "base/text/value_text.h"

namespace cls::cli {
namespace {

using base::ValueKind;

template <class T>
struct ElementOf {
  using type = T;
};
template <class T>
struct ElementOf<std::optional<T>> {
  using type = T;
};
template <class T>
struct ElementOf<std::vector<T>> {
  using type = T;
};

template <class T>
constexpr ValueKind kind_of() {
  using Element = typename ElementOf<T>::type;
  if constexpr (std::is_same_v<Element, bool>) return ValueKind::kFlag;
  if constexpr (std::is_floating_point_v<Element>) return ValueKind::kNumber;
  if constexpr (std::is_unsigned_v<Element>) return ValueKind::kUnsigned;
  if constexpr (std::is_integral_v<Element>) return ValueKind::kWhole;
  return ValueKind::kText;
}

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;

// Takes the form of the option from the type of its target.
void describe(Option& option) {
  std::visit(
      [&option]<class Pointer>(Pointer) {
        if constexpr (std::is_pointer_v<Pointer>) {
          using Value = std::remove_pointer_t<Pointer>;
          option.form.kind = kind_of<Value>();
          if (kIsVector<Value>) option.max_values = kAnyNumber;
        }
      },
      option.target);
}

// The form of texts with this placeholder, none of which is empty; other placeholders: "".
const char* form_of_placeholder(std::string_view placeholder) {
  constexpr std::pair<std::string_view, const char*> kForms[] = {
      {"DIR", "a folder"}, {"FILE", "a file"}, {"HOST", "a host"}, {"NAME", "a name"}};
  const auto* found =
      std::ranges::find(kForms, placeholder, &std::pair<std::string_view, const char*>::first);
  return found == std::end(kForms) ? "" : found->second;
}

// Lists have no default value.
template <class T>
std::string default_of(const T& value) {
  if constexpr (kIsVector<T>) {
    return "";
  } else {
    return base::text_of(value);
  }
}

// "-p,--port" -> "-p", "--port"; the name after a `!` switches the flag off.
std::vector<std::string> split_names(std::string_view names) {
  std::vector<std::string> parts;
  for (const std::string_view name : base::split(names, ',')) {
    parts.emplace_back(name.substr(name.starts_with('!') ? 1 : 0));
  }
  return parts;
}

// nullptr if none has the name.
template <class Commands>
auto* find_in(Commands& commands, std::string_view name) {
  const auto found = std::ranges::find(commands, name, &Command::name);
  return found == commands.end() ? nullptr : &*found;
}

}  // namespace

Option& Option::shows_default() {
  std::visit(
      [this]<class Pointer>(Pointer pointer) {
        if constexpr (std::is_pointer_v<Pointer>) default_text = default_of(*pointer);
      },
      target);
  return *this;
}

Command::Command(std::string command_name, std::string text, Command* above)
    : name(std::move(command_name)), description(std::move(text)), parent(above) {
  flag("-h,--help", "print this help");
}

Command& Command::command(std::string command_name, std::string text) {
  return commands.emplace_back(std::move(command_name), std::move(text), this);
}

Option& Command::add(std::string names, Target target, std::string help) {
  Option& added = options.emplace_back();
  const std::size_t space = names.find(' ');
  if (space != std::string::npos) added.value = names.substr(space + 1);
  added.names = names.substr(0, space);
  added.form.phrase = form_of_placeholder(added.value);

  added.target = target;
  added.help = std::move(help);
  describe(added);
  return added;
}

Option& Command::flag(std::string names, std::string help) {
  Option& added = add(std::move(names), {}, std::move(help));
  added.form.kind = ValueKind::kFlag;
  return added;
}

std::string full_name(const Command& command) {
  if (command.parent == nullptr) return command.name;
  return full_name(*command.parent) + " " + command.name;
}

bool is_argument(const Option& option) { return !option.names.starts_with('-'); }

bool is_flag(const Option& option) { return option.form.kind == ValueKind::kFlag; }

std::string name_of(const Option& option) {
  const std::vector<std::string> names = split_names(option.names);
  const auto is_long = [](const std::string& name) { return name.starts_with("--"); };
  const auto found = std::ranges::find_if(names, is_long);
  return found == names.end() ? names.front() : *found;
}

std::vector<std::string> all_names(const Option& option) { return split_names(option.names); }

std::string value_name(const Option& option) {
  if (!option.value.empty()) return option.value;
  switch (option.form.kind) {
    case ValueKind::kWhole:
    case ValueKind::kUnsigned:
      return "N";
    case ValueKind::kNumber:
      return "X";
    case ValueKind::kText:
      return "VALUE";
    case ValueKind::kFlag:
      break;
  }
  return "";
}

const Option* find_option(const Command& command, std::string_view name) {
  for (const Option& option : command.options) {
    const std::vector<std::string> names = split_names(option.names);
    if (std::ranges::find(names, name) != names.end()) return &option;
  }
  return nullptr;
}

const Command* find_command(const Command& command, std::string_view name) {
  return find_in(command.commands, name);
}
Command* find_command(Command& command, std::string_view name) {
  return find_in(command.commands, name);
}

}  // namespace cls::cli
