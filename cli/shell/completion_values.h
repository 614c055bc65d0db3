// Values of options and arguments, by the placeholder that help shows.
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"
#include "cli/shell/completion.h"

namespace cls::cli {

/// The words that a value may depend on.
struct ValueContext {
  std::vector<std::string> options;  ///< given before the cursor
  std::string word;                  ///< the value so far
};

/// All values that are known, whether they begin with the word or not, and the kind of paths.
Completion values_of(const Option& option, const ValueContext& context);

/// "server::half_time=", ...; "server::coach=true" for a `word` that has a name already.
void add_parameters(Completion& completion, const std::string& word);

/// The pages that `cls help` prints.
void add_topic_names(Completion& completion);

}  // namespace cls::cli
