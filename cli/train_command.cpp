// `cls train spec`: what can be trained.
#include <fmt/format.h>

#include <regex>
#include <string>
#include <vector>

#include "base/text/json.h"
#include "base/text/suggestion.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "training/pool/spec_tables.h"
#include "training/pool/specification.h"

namespace cls::cli {
namespace {

constexpr const char* kTrainDescription =
    "describe what cls_gym trains\n"
    "\n"
    "  cls train spec     tasks, observations, actions and rewards\n"
    "\n"
    "docs/training.md leads from an environment to a policy that plays a match.";

constexpr const char* kSpecDescription =
    "print tasks, feature sets, action sets and reward terms\n"
    "\n"
    "  cls train spec                       all, one line each\n"
    "  cls train spec HalfFieldOffense      options of a task\n"
    "  cls train spec ego --offense 2       numbers of an observation\n"
    "  cls train spec hfo                   ids and values of an action set\n"
    "  cls train spec --json                for programs\n"
    "\n"
    "NAME is a task, a feature set or an action set. In Python: cls_gym.catalog().";

struct TrainArguments {
  std::string name;
  std::string format = "text";
  bool json = false;
  int offense = 2;
  int defense = 1;
};

struct Description {
  std::vector<training::SpecTable> tables;
  base::Json document;
};

// "cls/HFO-2v1-v0" and "HFO-2v1" are names of cls_gym for a task with these options.
std::string task_of_short_name(const std::string& name) {
  static const std::regex pattern("(cls/)?HFO-[0-9]+v[0-9]+(-v[0-9]+)?");
  std::smatch parts;
  if (!std::regex_match(name, parts, pattern)) return name;
  return parts[1].str() + "HalfFieldOffense" + parts[2].str();
}

// A task by its id, with or without "cls/" and "-v0".
const training::Task* find_task(const std::string& given) {
  const std::string name = task_of_short_name(given);
  for (const training::Task& task : training::tasks()) {
    if (name == task.id || name == training::full_id(task)) return &task;
  }
  return nullptr;
}

base::Result<Description> describe(const TrainArguments& arguments) {
  const std::string& name = arguments.name;
  if (name.empty()) return Description{training::overview_tables(), training::catalog()};

  if (const training::Task* task = find_task(name)) {
    return Description{tables_of(*task), document_of(*task)};
  }
  if (const training::FeatureSet* set = training::find_feature_set(name)) {
    const int teammates = arguments.offense - 1;
    return Description{tables_of(*set, teammates, arguments.defense),
                       document_of(*set, teammates, arguments.defense)};
  }

  if (const training::ActionSet* set = training::find_action_set(name)) {
    return Description{tables_of(*set), document_of(*set)};
  }

  return base::Error{fmt::format("unknown task, feature set or action set '{}'{}", name,
                                 base::did_you_mean(name, training::spec_names()))};
}

int run_train_spec(const TrainArguments& arguments) {
  const std::string format = arguments.json ? "json" : arguments.format;
  if (format != "text" && format != "json" && format != "markdown") {
    return print_error(kUsage, "--format '{}': must be text, json or markdown", arguments.format);
  }

  base::Result<Description> description = describe(arguments);
  if (!description) return print_error(kUsage, description.error().message);

  if (format == "json") {
    base::Json document = {{"schema", training::kCatalogSchema}};
    document.update(description->document);
    print_json(document);
  } else if (format == "markdown") {
    fmt::print("{}", training::format_markdown(description->tables));
  } else {
    // Cut on a terminal only: in a pipe or file the whole line is wanted.
    const std::size_t width = stdout_is_terminal() ? stdout_width() : 0;
    fmt::print("{}", training::format_text(description->tables, width));
  }

  return kOk;
}

}  // namespace

void add_train_command(Command& app) {
  Command& train = app.command("train", kTrainDescription);

  train.group = kPlayCommands;
  auto [command, arguments] = train.command("spec", kSpecDescription, run_train_spec);

  command.option("NAME", arguments.name, "task, feature set or action set (default: all)");
  command
      .setting("--offense", arguments.offense,
               "players of the own team in a feature set, with the agent")
      .range(1, 11);
  command.setting("--defense", arguments.defense, "players of the other team").range(0, 11);

  command.setting("--format FORMAT", arguments.format, "text, json or markdown")
      .of_group(kOutputGroup);
  command.flag("--json", arguments.json, "the same as --format json").of_group(kOutputGroup);
}

}  // namespace cls::cli
