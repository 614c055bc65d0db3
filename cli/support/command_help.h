// The layout of help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cls::cli {

/// Help that starts with purpose and examples of the description, then lists options in groups.
/// Fits 80 columns. The list of commands shows the first line of each description.
class CommandHelp : public CLI::Formatter {
 public:
  CommandHelp();
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace cls::cli
