// Describes a row as an option of a command.
#include "cli/support/match_option.h"

#include <string>

namespace cls::cli {
namespace {

using match::MatchOption;

const char* title(match::OptionGroup group) {
  switch (group) {
    case match::OptionGroup::kMatch:
      break;
    case match::OptionGroup::kTeams:
      return kTeamsGroup;
    case match::OptionGroup::kPlaymakers:
      return kPlaymakersGroup;
    case match::OptionGroup::kLimits:
      return kLimitsGroup;
    case match::OptionGroup::kDebugging:
      return kDebuggingGroup;
  }
  return kOptionsGroup;
}

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

  option.value = row.placeholder;
  option.group = title(row.group);
  option.environment = row.environment;
  option.min_values = option.max_values = row.values;
  return option;
}

}  // namespace cls::cli
