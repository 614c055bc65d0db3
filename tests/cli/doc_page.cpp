// Pages of the documentation: code blocks, anchors and links.
#include "tests/cli/doc_page.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

// "## The `late` end" -> "the-late-end".
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(letter) != 0 || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(letter));
    }
  }
  return anchor;
}

// The text of `<!-- KEY: TEXT -->`, or nothing.
std::string note(const std::string& line, const std::string& key) {
  const std::string start = "<!-- " + key + ": ";
  const std::size_t at = line.find(start);
  const std::size_t end = line.rfind(" -->");
  if (at == std::string::npos || end == std::string::npos) return {};
  return line.substr(at + start.size(), end - at - start.size());
}

void add_links(const std::string& line, std::vector<std::string>& links) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  for (std::sregex_iterator at(line.begin(), line.end(), link), end; at != end; ++at) {
    const std::string target = (*at)[1];
    if (target.find("://") == std::string::npos) links.push_back(target);
  }
}

CodeBlock open_block(const std::string& fence, const std::string& line_above, int line) {
  CodeBlock block;
  block.language = fence.substr(3);
  block.file = note(line_above, "file");
  block.not_run = note(line_above, "not run");
  block.needs = note(line_above, "needs");
  block.line = line;
  return block;
}

// What differs from run to run, in one form.
std::string without_measurements(std::string line) {
  static const std::regex time(R"(\d{8}T\d{6}Z|\d{4}-\d\d-\d\d \d\d:\d\d:\d\d,\d{3})");
  static const std::regex measured(R"(\d (us|ms|cycles/s|MB)\b|cpu seconds|\d s\b)");
  static const std::regex number(R"(\d+(\.\d+)?)");
  static const std::regex spaces(R"( +)");
  static const std::regex verdict(R"(limited by .*)");
  line = std::regex_replace(line, time, "TIME");
  line = std::regex_replace(line, verdict, "limited by the host");
  if (!std::regex_search(line, measured)) return line;
  return std::regex_replace(std::regex_replace(line, number, "N"), spaces, " ");
}

}  // namespace

DocPage read_page(const fs::path& path) {
  DocPage page;
  page.path = path;
  const std::vector<std::string> lines = split_lines(read_file(path));
  std::string above;

  std::size_t indent = 0;
  bool open = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    if (line.compare(start, 3, "```") == 0) {
      if (!open) {
        page.blocks.push_back(open_block(line.substr(start), above, static_cast<int>(i) + 1));
      }
      indent = start;
      open = !open;
    } else if (open) {
      page.blocks.back().lines.push_back(line.substr(std::min({indent, start, line.size()})));
    } else {
      if (line.starts_with("#")) page.anchors.insert(anchor_of(line.substr(line.find(' ') + 1)));
      if (page.files_of.empty()) page.files_of = note(line, "files of");
      add_links(line, page.links);
    }
    above = line;
  }

  return page;
}

std::vector<fs::path> doc_pages() {
  std::vector<fs::path> pages = {source_folder() / "README.md",
                                 source_folder() / "python/README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::ranges::sort(pages);
  return pages;
}

std::vector<ConsoleCommand> console_commands(const CodeBlock& block) {
  std::vector<ConsoleCommand> commands;
  bool continued = false;

  for (std::string line : block.lines) {
    const bool begins = line.starts_with("$ ");
    if (begins) commands.push_back({});
    if (commands.empty()) continue;
    if (!begins && !continued) {
      commands.back().output.push_back(line);
      continue;
    }
    if (begins) line.erase(0, 2);
    continued = line.ends_with("\\");
    if (continued) line.pop_back();
    commands.back().command += line;
  }

  return commands;
}

bool shows_output(const std::vector<std::string>& expected,
                  const std::vector<std::string>& output) {
  // matches[j]: the expected lines so far show exactly the first j lines of the output.
  std::vector<bool> matches(output.size() + 1, false);
  matches[0] = true;

  for (const std::string& line : expected) {
    std::vector<bool> next(output.size() + 1, false);
    for (std::size_t j = 0; j <= output.size(); ++j) {
      if (line == "...") {
        next[j] = matches[j] || (j > 0 && next[j - 1]);
      } else {
        next[j] = j > 0 && matches[j - 1] &&
                  without_measurements(line) == without_measurements(output[j - 1]);
      }
    }
    matches = std::move(next);
  }

  return matches.back();
}

}  // namespace cls::tests
