// Sections from the help of a command: what it is for, examples, arguments, options by group.
#include "cli/shell/man_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "base/system/version.h"
#include "cli/support/command_help.h"
#include "cli/support/usage_errors.h"

namespace cls::cli {
namespace {

// Text without meaning for man(7).
std::string plain(std::string_view text) {
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
  std::replace(text.begin(), text.end(), '\n', ' ');
  return plain(text);
}

// "cls-tournament-run".
std::string page_name(const CLI::App& command) {
  std::string name = full_name(command);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

/// The parts of a description: a line, sentences, indented examples.
struct Description {
  std::string purpose;
  std::string sentences;
  std::string examples;
};

Description description_of(const CLI::App& command) {
  Description parts;
  for (const std::string& line : CLI::detail::split(command.get_description(), '\n')) {
    if (parts.purpose.empty()) {
      parts.purpose = line;
    } else if (line.starts_with("  ")) {
      parts.examples += plain(line) + "\n";
    } else if (!line.empty()) {
      parts.sentences += plain(line) + "\n";
    }
  }
  return parts;
}

// "[OPTIONS] LEFT RIGHT".
std::string arguments_of(const CLI::App& command) {
  constexpr std::string_view kLabel = "Usage:";
  const std::string usage = CommandHelp().make_usage(&command, "");
  return on_one_line(CLI::detail::trim_copy(usage.substr(usage.find(kLabel) + kLabel.size())));
}

std::string option_entry(const CLI::Option& option) {
  const CommandHelp help;
  const bool is_argument = option.get_positional();
  std::string names = help.make_option_name(&option, is_argument);
  names += help.make_option_opts(&option);
  return fmt::format(".TP\n.B {}\n{}\n", plain(names), on_one_line(help.make_option_desc(&option)));
}

std::string argument_section(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) text += option_entry(*option);
  }
  return text.empty() ? "" : ".SH ARGUMENTS\n" + text;
}

std::string option_section(const CLI::App& command) {
  std::string text;
  for (const std::string& group : command.get_groups()) {
    std::string entries;
    for (const CLI::Option* option : command.get_options()) {
      if (option->nonpositional() && option->get_group() == group) entries += option_entry(*option);
    }
    if (group.empty() || entries.empty()) continue;
    if (group != "Options") text += fmt::format(".SS {}\n", plain(group));
    text += entries;
  }
  return text.empty() ? "" : ".SH OPTIONS\n" + text;
}

std::string command_section(const CLI::App& command) {
  std::string text;
  for (const CLI::App* below : command.get_subcommands({})) {
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", plain(page_name(*below)),
                        plain(description_of(*below).purpose));
  }
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string closing_sections(const CLI::App& command) {
  std::string text =
      ".SH EXIT STATUS\n0: success. 1: a test or check failed, or the match is invalid. "
      "2: wrong usage.\n.B cls help cli\nlists all exit codes.\n.SH SEE ALSO\n";
  if (command.get_parent() != nullptr) {
    text += fmt::format(".BR {} (1)\n.PP\n", plain(page_name(*command.get_parent())));
  }
  return text + ".B cls help topics\nlists the pages of the manual.\n";
}

std::string page_of(const CLI::App& command) {
  const std::string name = page_name(command);
  const Description description = description_of(command);
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text =
      fmt::format(".TH {} 1 \"\" \"cls {}\" \"cls manual\"\n", plain(title), base::kVersion);
  text += fmt::format(".SH NAME\n{} \\- {}\n", plain(name), plain(description.purpose));
  text +=
      fmt::format(".SH SYNOPSIS\n.B {}\n{}\n", plain(full_name(command)), arguments_of(command));
  if (!description.sentences.empty()) text += ".SH DESCRIPTION\n" + description.sentences;
  if (!description.examples.empty()) {
    text += fmt::format(".SH EXAMPLES\n.nf\n{}.fi\n", description.examples);
  }
  return text + argument_section(command) + option_section(command) + command_section(command) +
         closing_sections(command);
}

void add_pages(const CLI::App& command, std::vector<ManPage>& pages) {
  pages.push_back({page_name(command) + ".1", page_of(command)});
  for (const CLI::App* below : command.get_subcommands({})) add_pages(*below, pages);
}

}  // namespace

std::vector<ManPage> man_pages(const CLI::App& app) {
  std::vector<ManPage> pages;
  add_pages(app, pages);
  return pages;
}

}  // namespace cls::cli
