// The pages of docs/ as topics of `cls help`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::cli {

/// A page of docs/, embedded at build time.
struct DocFile {
  std::string_view name;  ///< "matches.md", "formats/rcg.md"
  std::string_view text;
};
const std::vector<DocFile>& doc_files();

struct HelpTopic {
  std::string name;   ///< "matches", "formats/rcg"
  std::string title;  ///< the heading of the page
  std::string_view text;
};

/// All topics, by name.
const std::vector<HelpTopic>& help_topics();

/// nullptr if there is no such page.
const HelpTopic* find_topic(std::string_view name);

/// The page for a terminal: links without targets, no comments and no pictures.
std::string page_text(const HelpTopic& topic);

}  // namespace cls::cli
