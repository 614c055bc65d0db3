// `cls completion`, and what its scripts call.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/json.h"
#include "base/text/printable.h"
#include "base/text/suggestion.h"
#include "cli/shell/completion.h"
#include "cli/shell/shells.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"

namespace cls::cli {
namespace {

constexpr const char* kCompletionDescription =
    "print the completion script of a shell\n"
    "Packages of cls install the scripts.\n"
    "\n"
    "  cls completion bash > ~/.local/share/bash-completion/completions/cls\n"
    "  cls completion zsh > ~/.zfunc/_cls      with fpath+=~/.zfunc before compinit\n"
    "  cls completion fish > ~/.config/fish/completions/cls.fish";

struct CompletionArguments {
  std::string shell;
  bool json = false;
};

int run_completion(const CompletionArguments& arguments) {
  const ShellScript* script = find_shell(arguments.shell);
  if (script == nullptr) {
    return print_error(kUsage, "unknown shell '{}': {}{}", arguments.shell,
                       fmt::join(shell_names(), ", "),
                       base::did_you_mean(arguments.shell, shell_names()));
  }

  if (arguments.json)
    return print_json(
        {{"schema", "cls.completion/1"}, {"shell", arguments.shell}, {"script", script->text}});

  fmt::print("{}", script->text);

  return kOk;
}

}  // namespace

int print_completion(const Command& root, std::vector<std::string> words) {
  if (!words.empty() && words.front() == "--") words.erase(words.begin());
  const Completion completion = complete(root, words);
  for (const Candidate& candidate : completion.candidates) {
    fmt::print("{}\t{}\n", candidate.text, base::printable(candidate.note));
  }

  if (completion.paths != PathKind::kNone) {
    fmt::print("{}\t{}\n", completion.paths == PathKind::kFiles ? ":files" : ":folders",
               completion.path_prefix);
  }
  return kOk;
}

void add_completion_command(Command& app) {
  auto [command, arguments] = app.command("completion", kCompletionDescription, run_completion);

  command.option("SHELL", arguments.shell, fmt::format("{}", fmt::join(shell_names(), ", ")))
      .required();
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
