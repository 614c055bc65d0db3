// The table of all options of a match. A row is all there is to an option: `cls match` and its
// help, cls.toml, `cls config`, the matches of a tournament, scenarios, the manifest, completion
// and manual pages follow from it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text/value_form.h"
#include "match/terms/match_options.h"
#include "match/terms/option_texts.h"

namespace cls::match {

/// The paragraph of the help.
enum class OptionGroup { kMatch, kTeams, kPlaymakers, kLimits, kDebugging };

/// The places besides `cls match` where an option may be set.
enum class OptionUse {
  kOneMatch,    ///< nowhere
  kConditions,  ///< in cls.toml; part of the plan of a tournament
  kExecution,   ///< in cls.toml; may change from run to run
};

struct MatchOption {
  std::string_view key;          ///< in cls.toml and `cls config`: "rpc_deadline"
  std::string_view placeholder;  ///< of the value in help; empty: a flag
  std::string_view help;         ///< ends with the default value in parentheses
  base::ValueForm form;
  /// Stores a text of that form. The error is a line that names the option.
  std::function<base::Result<void>(MatchOptions&, const std::string&)> set;
  /// The value in effect; empty: none.
  std::function<std::string(const MatchOptions&)> shown;

  OptionGroup group = OptionGroup::kMatch;
  OptionUse use = OptionUse::kOneMatch;
  std::string_view example = {};       ///< for the commented cls.toml
  std::string_view environment = {};   ///< a variable that gives the value
  std::string_view scenario_key = {};  ///< in scenarios; empty: not there
  std::string_view shown_as = {};      ///< row of `cls config` that shows the value; empty: `key`
  int values = 1;                      ///< words on the command line; a space joins them
  bool has_opposite = false;           ///< --no-NAME
  bool is_side = false;                ///< the text may be the name of a team
};

/// In the order of help and `cls config`.
const std::vector<MatchOption>& match_options();

/// nullptr if there is none.
const MatchOption* find_match_option(std::string_view key);

/// "--rpc-deadline" of "rpc_deadline".
std::string option_name(std::string_view key);

/// Sets all of them, in the order of the table; returns a line for each that is wrong.
std::vector<std::string> set_options(MatchOptions& options, const OptionTexts& texts);

/// The words that give `cls match` these options.
std::vector<std::string> option_words(const OptionTexts& texts);

}  // namespace cls::match
