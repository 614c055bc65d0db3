// Texts of match options as users write them, before they become MatchOptions.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace cls::match {

/// By the key of the option: "rpc_deadline". option_table.h sets MatchOptions from them.
using OptionTexts = std::map<std::string, std::string, std::less<>>;

}  // namespace cls::match
