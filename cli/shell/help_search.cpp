// Searches commands, options, pages and names of the interface.
#include "cli/shell/help_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/text/find_ignoring_case.h"
#include "base/text/split.h"
#include "cli/command/help.h"
#include "cli/explain/reference.h"
#include "cli/shell/help_topics.h"

namespace cls::cli {
namespace {

using Words = std::vector<std::string>;

bool has_all(std::string_view text, const Words& words) {
  return std::ranges::all_of(words, [text](const std::string& word) {
    return base::find_ignoring_case(text, word) != std::string_view::npos;
  });
}

// The words may name the command, too, but not it alone.
bool is_about(const Option& option, const std::string& command, const Words& words) {
  const std::string own = option.names + " " + option.help;
  const auto has = [&own](const std::string& word) {
    return base::find_ignoring_case(own, word) != std::string::npos;
  };
  return has_all(command + " " + own, words) && std::ranges::any_of(words, has);
}

void add_found_commands(const Command& command, const Words& words, std::vector<HelpMatch>& found) {
  const std::string name = full_name(command);
  const std::string read = name + " --help";
  if (has_all(name + " " + command.description, words)) {
    found.push_back({"command", name, first_line(command.description), read});
  }

  for (const Option& option : command.options) {
    if (option.group == kHidden || !is_about(option, name, words)) continue;
    found.push_back({"option", fmt::format("{} of {}", name_of(option), name), option.help, read});
  }

  for (const Command& below : command.commands) {
    if (below.group != kHidden) add_found_commands(below, words, found);
  }
}

// A line from a few words before the first of the words.
std::string excerpt(std::string_view line, const Words& words) {
  constexpr std::size_t kBefore = 30;
  constexpr std::size_t kLength = 110;
  const std::size_t at = base::find_ignoring_case(line, words.front());
  if (at > kBefore && at != line.npos) line.remove_prefix(line.find(' ', at - kBefore) + 1);
  line.remove_prefix(std::min(line.find_first_not_of("# |-"), line.size()));
  if (line.size() > kLength) line = line.substr(0, line.rfind(' ', kLength));
  return std::string(line);
}

// The first line that has all the words; empty if they are in several lines.
std::string line_with(std::string_view page, const Words& words) {
  for (const std::string_view line : base::split(page, '\n')) {
    if (has_all(line, words)) return excerpt(line, words);
  }
  return "";
}

// The first section that has all the words: its heading, and its first line with one of them.
std::string section_with(std::string_view page, const Words& words) {
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t end = std::min(page.find("\n#", at), page.size());
    const std::string_view section = page.substr(at, end - at);
    at = end + 1;
    if (!has_all(section, words)) continue;

    const std::string heading = excerpt(section.substr(0, section.find('\n')), words);
    for (const std::string& word : words) {
      const std::string line = line_with(section.substr(section.find('\n') + 1), {word});
      if (!line.empty()) return heading + ": " + line;
    }
    return heading;
  }
  return "";
}

void add_found_pages(const Words& words, std::vector<HelpMatch>& found) {
  for (const HelpTopic& topic : help_topics()) {
    if (!has_all(topic.text, words)) continue;
    const std::string text = page_text(topic);
    std::string place = line_with(text, words);
    if (place.empty()) place = section_with(text, words);
    if (place.empty()) continue;
    found.push_back({"page", topic.name, std::move(place), "cls help " + topic.name});
  }
}

void add_entries(const Words& words, std::vector<HelpMatch>& found) {
  for (const ReferenceEntry* entry : entries_with(words.front())) {
    std::string all = entry->name + " " + entry->text;
    for (const auto& [label, value] : entry->facts) all += " " + value;
    if (!has_all(all, words)) continue;

    found.push_back({std::string(name(entry->kind)), entry->name, first_line(meaning(*entry)),
                     "cls explain " + entry->name});
  }
}

}  // namespace

std::vector<HelpMatch> search_help(const Command& root, const std::vector<std::string>& words) {
  std::vector<HelpMatch> found;
  if (words.empty()) return found;

  add_found_commands(root, words, found);
  add_found_pages(words, found);
  add_entries(words, found);
  return found;
}

}  // namespace cls::cli
