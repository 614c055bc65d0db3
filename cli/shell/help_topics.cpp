// Reads the embedded pages.
#include "cli/shell/help_topics.h"

#include <algorithm>
#include <regex>

namespace cls::cli {
namespace {

std::string heading_of(std::string_view page) {
  std::string line(page.substr(0, page.find('\n')));
  line.erase(0, line.find_first_not_of("# "));
  std::erase(line, '`');
  return line;
}

}  // namespace

const std::vector<HelpTopic>& help_topics() {
  static const std::vector<HelpTopic> topics = [] {
    std::vector<HelpTopic> all;
    for (const DocFile& file : doc_files()) {
      all.push_back({std::string(file.name.substr(0, file.name.rfind('.'))), heading_of(file.text),
                     file.text});
    }
    return all;
  }();
  return topics;
}

const HelpTopic* find_topic(std::string_view name) {
  const auto& topics = help_topics();
  const auto found = std::ranges::find(topics, name, &HelpTopic::name);
  return found == topics.end() ? nullptr : &*found;
}

std::string page_text(const HelpTopic& topic) {
  static const std::regex comment("<!--[^>]*-->\n?");
  static const std::regex picture(R"(!\[[^\]]*\]\([^)]*\)\n?)");
  static const std::regex link(R"(\[([^\]]+)\]\([^)\n]*\))");

  std::string text = std::regex_replace(std::string(topic.text), comment, "");
  text = std::regex_replace(text, picture, "");
  return std::regex_replace(text, link, "$1");
}

}  // namespace cls::cli
