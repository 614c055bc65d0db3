// Sections from the help of a command: what it is for, examples, arguments, options by group.
#include "cli/shell/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/system/version.h"
#include "base/text/lines.h"
#include "cli/command/help.h"

namespace cls::cli {
namespace {

// Text without meaning for man(7).
std::string escaped(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out += "\\&";

  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return escaped(text);
}

// "cls-tournament-run".
std::string page_name(const Command& command) {
  std::string name = full_name(command);
  std::ranges::replace(name, ' ', '-');
  return name;
}

/// The parts of a description: a line, sentences, indented examples.
struct DescriptionParts {
  std::string purpose;
  std::string sentences;
  std::string examples;
};

// A list, such as that of sides, belongs to the sentences before it.
std::string list_of(const std::string& lines) { return ".nf\n" + lines + ".fi\n"; }

DescriptionParts parts_of(const Command& command) {
  DescriptionParts parts;
  std::string block;  // indented lines
  const auto end_block = [&] {
    if (block.empty()) return;
    const bool is_example = block.starts_with("  cls ") || block.starts_with("  [cls ");
    (is_example ? parts.examples : parts.sentences) += is_example ? block : list_of(block);
    block.clear();
  };

  for (const std::string_view line : base::lines_of(command.description)) {
    if (parts.purpose.empty()) {
      parts.purpose = line;
    } else if (line.starts_with("  ")) {
      block += escaped(line) + "\n";
    } else {
      end_block();
      if (!line.empty()) parts.sentences += escaped(line) + "\n";
    }
  }

  end_block();
  return parts;
}

std::string option_entry(const Option& option) {
  return fmt::format(".TP\n.B {}\n{}\n", escaped(signature_of(option)),
                     on_one_line(description_of(option)));
}

std::string argument_section(const Command& command) {
  std::string text;
  for (const Option& option : command.options) {
    if (is_argument(option)) text += option_entry(option);
  }
  return text.empty() ? "" : ".SH ARGUMENTS\n" + text;
}

std::string option_section(const Command& command) {
  std::string text;
  for (const std::string& group : option_groups(command)) {
    std::string entries;
    for (const Option& option : command.options) {
      if (!is_argument(option) && option.group == group) entries += option_entry(option);
    }
    if (entries.empty()) continue;
    if (group != kOptionsGroup) text += fmt::format(".SS {}\n", escaped(group));
    text += entries;
  }
  return text.empty() ? "" : ".SH OPTIONS\n" + text;
}

std::string command_section(const Command& command) {
  std::string text;
  for (const Command& below : command.commands) {
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", escaped(page_name(below)),
                        escaped(parts_of(below).purpose));
  }
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string closing_sections(const Command& command) {
  std::string text =
      ".SH EXIT STATUS\n0: success. 1: a test or check failed, or the match is invalid. "
      "2: wrong usage.\n.B cls help cli\nlists all exit codes.\n.SH SEE ALSO\n";

  if (command.parent != nullptr) {
    text += fmt::format(".BR {} (1)\n.PP\n", escaped(page_name(*command.parent)));
  }
  return text + ".B cls help topics\nlists the pages of the manual.\n";
}

std::string page_of(const Command& command) {
  const std::string name = page_name(command);
  const DescriptionParts description = parts_of(command);

  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });

  std::string text =
      fmt::format(".TH {} 1 \"\" \"cls {}\" \"cls manual\"\n", escaped(title), base::kVersion);
  text += fmt::format(".SH NAME\n{} \\- {}\n", escaped(name), escaped(description.purpose));
  text += fmt::format(".SH SYNOPSIS\n.B {}\n{}\n", escaped(full_name(command)),
                      escaped(usage_of(command)));

  if (!description.sentences.empty()) text += ".SH DESCRIPTION\n" + description.sentences;
  if (!description.examples.empty()) {
    text += fmt::format(".SH EXAMPLES\n.nf\n{}.fi\n", description.examples);
  }
  return text + argument_section(command) + option_section(command) + command_section(command) +
         closing_sections(command);
}

void add_pages(const Command& command, std::vector<ManPage>& pages) {
  pages.push_back({page_name(command) + ".1", page_of(command)});
  for (const Command& below : command.commands) add_pages(below, pages);
}

}  // namespace

std::vector<ManPage> man_pages(const Command& root) {
  std::vector<ManPage> pages;
  add_pages(root, pages);
  return pages;
}

}  // namespace cls::cli
