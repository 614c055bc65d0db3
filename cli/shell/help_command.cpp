// `cls help`: pages of the manual and a search; application.cpp handles the names of commands.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/suggestion.h"
#include "base/text/table.h"
#include "cli/shell/help_search.h"
#include "cli/shell/help_topics.h"
#include "cli/shell/man_page.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHelpDescription =
    "print help of a command or a topic, or search it\n"
    "\n"
    "  cls help tournament run    a command, as cls tournament run --help\n"
    "  cls help topics            the pages of the manual\n"
    "  cls help testing           one of them\n"
    "  cls help offside line      all commands, options, pages, fields, actions and\n"
    "                             end reasons that have these words";

constexpr std::string_view kListOfTopics = "topics";

struct HelpArguments {
  std::vector<std::string> words;
  std::string man_folder;
  bool json = false;
};

int list_topics(bool json) {
  base::Json document = {{"schema", "cls.topics/1"}};
  for (const HelpTopic& topic : help_topics()) {
    if (!json) fmt::print("{:<20} {}\n", topic.name, topic.title);
    document["topics"].push_back({{"name", topic.name}, {"title", topic.title}});
  }
  if (json) return print_json(document);
  return kOk;
}

int print_topic(const HelpTopic& topic, bool json) {
  if (!json) {
    fmt::print("{}", page_text(topic));
    return kOk;
  }
  return print_json({{"schema", "cls.topic/1"},
                     {"name", topic.name},
                     {"title", topic.title},
                     {"text", topic.text}});
}

int report_unknown_topic(const Command& root, const std::string& name) {
  std::vector<std::string> names = {std::string(kListOfTopics)};
  for (const Command& command : root.commands) names.push_back(command.name);
  for (const HelpTopic& topic : help_topics()) names.push_back(topic.name);

  const std::string near = base::did_you_mean(name, {names.begin(), names.end()});
  return print_error(kUsage, "unknown command or topic '{}'{}", name,
                     near.empty() ? " (see cls help topics)" : near);
}

int print_matches(const std::vector<HelpMatch>& found, bool json) {
  base::Json document = {{"schema", "cls.help_search/1"}};
  base::Table table;
  table.add_columns({"kind", "name", "text"});
  for (const HelpMatch& one : found) {
    table.add_row({one.kind, one.name, one.text});
    document["found"].push_back(
        {{"kind", one.kind}, {"name", one.name}, {"text", one.text}, {"read", one.read}});
  }

  if (json) {
    return print_json(document);
  }

  table.allow_folds(2);
  fmt::print("{}\ncls help PAGE, cls COMMAND --help and cls explain NAME print the rest\n",
             table.format_text({0, stdout_width(), 1}));
  return kOk;
}

int write_man_pages(const Command& root, const fs::path& folder) {
  TRY_OR(kCannotCreate, base::create_folders(folder));

  for (const ManPage& page : man_pages(root)) {
    TRY_OR(kWriteFailed, base::write_file(folder / page.file, page.text));
  }
  return kOk;
}

int run_help(const Command& command, const HelpArguments& arguments) {
  const Command& root = *command.parent;
  if (!arguments.man_folder.empty()) return write_man_pages(root, arguments.man_folder);

  const std::string first = arguments.words.empty() ? "" : arguments.words.front();
  if (arguments.words.size() == 1) {
    if (first == kListOfTopics) return list_topics(arguments.json);
    if (const HelpTopic* topic = find_topic(first)) return print_topic(*topic, arguments.json);
  }

  const std::vector<HelpMatch> found = search_help(root, arguments.words);
  if (found.empty() && arguments.words.size() == 1) return report_unknown_topic(root, first);
  if (found.empty()) {
    return print_error(kUsage, "nothing has the words '{}' (see cls help topics)",
                       fmt::join(arguments.words, " "));
  }
  return print_matches(found, arguments.json);
}

}  // namespace

void add_help_command(Command& app) {
  auto [command, arguments] = app.command("help", kHelpDescription, run_help);

  command.option("WORDS", arguments.words,
                 "a command, a page of the manual, topics, or what to search for");
  command.option("--man", arguments.man_folder, "write the manual pages of all commands")
      .placeholder("DIR");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
