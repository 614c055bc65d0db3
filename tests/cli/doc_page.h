// Pages of the documentation: code blocks, anchors and links.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace cls::tests {

/// A fenced code block.
struct CodeBlock {
  std::string language;            ///< first word behind the fence: "console", "sh", "python"
  std::string file;                ///< `<!-- file: NAME -->` above it: a file to save
  std::string not_run;             ///< `<!-- not run: REASON -->` above it
  std::string needs;               ///< `<!-- needs: LANGUAGE -->` above it: tools and packages
  std::vector<std::string> lines;  ///< without the indentation of the fence
  int line = 0;                    ///< of the fence
};

/// `$ COMMAND` in a console block, with the output lines below it.
struct ConsoleCommand {
  std::string command;
  std::vector<std::string> output;
};

struct DocPage {
  std::filesystem::path path;
  std::vector<CodeBlock> blocks;
  std::string files_of;            ///< `<!-- files of: PAGE -->`: whose files its commands use
  std::set<std::string> anchors;   ///< of its headings, as GitHub forms them
  std::vector<std::string> links;  ///< targets inside the repository: "matches.md#sides"
};

DocPage read_page(const std::filesystem::path& path);

/// README.md, all of docs/, and python/README.md.
std::vector<std::filesystem::path> doc_pages();

/// Joins lines that end in a backslash.
std::vector<ConsoleCommand> console_commands(const CodeBlock& block);

/// True if `output` is what `expected` shows. A line `...` stands for any lines. Times of day and
/// verdicts on speed are equal, and so are all numbers of lines with latencies, speeds or CPU
/// times.
bool shows_output(const std::vector<std::string>& expected, const std::vector<std::string>& output);

}  // namespace cls::tests
