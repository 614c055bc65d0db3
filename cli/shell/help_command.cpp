// `cls help`: pages of the manual; application.cpp handles the names of commands.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "base/text/suggestion.h"
#include "cli/shell/help_topics.h"
#include "cli/shell/man_page.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    "print help of a command or a topic\n"
    "\n"
    "  cls help tournament run    a command, as cls tournament run --help\n"
    "  cls help topics            the pages of the manual\n"
    "  cls help testing           one of them";

constexpr std::string_view kListOfTopics = "topics";

struct Arguments {
  std::string topic;
  std::string man_folder;
  bool json = false;
};

int list_topics(bool json) {
  nlohmann::ordered_json document = {{"schema", "cls.topics/1"}};
  for (const HelpTopic& topic : help_topics()) {
    if (!json) fmt::print("{:<20} {}\n", topic.name, topic.title);
    document["topics"].push_back({{"name", topic.name}, {"title", topic.title}});
  }
  if (json) fmt::print("{}", base::json_document(document));
  return kOk;
}

int print_topic(const HelpTopic& topic, bool json) {
  if (!json) {
    fmt::print("{}", page_text(topic));
    return kOk;
  }
  const nlohmann::ordered_json document = {{"schema", "cls.topic/1"},
                                           {"name", topic.name},
                                           {"title", topic.title},
                                           {"text", topic.text}};
  fmt::print("{}", base::json_document(document));
  return kOk;
}

int report_unknown_topic(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names = {std::string(kListOfTopics)};
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  for (const HelpTopic& topic : help_topics()) names.push_back(topic.name);
  const std::string near = base::did_you_mean(name, {names.begin(), names.end()});
  return print_error(kUsage, fmt::format("unknown command or topic '{}'{}", name,
                                         near.empty() ? " (see cls help topics)" : near));
}

int write_man_pages(const CLI::App& app, const fs::path& folder) {
  if (const auto created = base::create_folders(folder); !created) {
    return print_error(kCannotCreate, created.error().message);
  }
  for (const ManPage& page : man_pages(app)) {
    const auto written = base::write_file(folder / page.file, page.text);
    if (!written) return print_error(kWriteFailed, written.error().message);
  }
  return kOk;
}

int run(const CLI::App& app, const Arguments& arguments) {
  if (!arguments.man_folder.empty()) return write_man_pages(app, arguments.man_folder);
  if (arguments.topic == kListOfTopics) return list_topics(arguments.json);
  const HelpTopic* topic = find_topic(arguments.topic);
  return topic == nullptr ? report_unknown_topic(app, arguments.topic)
                          : print_topic(*topic, arguments.json);
}

}  // namespace

void add_help_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("help", kDescription);
  command->add_option("TOPIC", arguments->topic, "a command, a page of the manual, or topics");
  command->add_option("--man", arguments->man_folder, "write the manual pages of all commands")
      ->type_name("DIR");
  command->add_flag("--json", arguments->json, "print one JSON document");
  command->callback([&app, arguments, &exit_code] { exit_code = run(app, *arguments); });
}

}  // namespace cls::cli
