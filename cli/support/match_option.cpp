// Describes a row as an option of a command.
#include "cli/support/match_option.h"

#include <string>

namespace cls::cli {
namespace {

using match::MatchOption;

std::string names_of(const MatchOption& row) {
  std::string names = match::option_name(row.key);
  if (row.has_opposite) names += ",!--no-" + names.substr(2);
  return names;
}

}  // namespace

Option& add_match_option(Command& command, const MatchOption& row) {
  Option& option = command.option(names_of(row), std::string(row.help));

  // set_options() checks the range, so that all errors of a match are reported together.
  option.form = row.form;
  option.form.min.reset();
  option.form.max.reset();

  option.environment = row.environment;
  option.min_values = option.max_values = row.values;
  return option;
}

}  // namespace cls::cli
