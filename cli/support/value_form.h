// The accepted form of an option's value: strict numbers, and the form as a phrase.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class Option;
}

namespace cls::cli {

/// True when the option takes no value.
bool is_flag(const CLI::Option& option);

/// Makes an option with a numeric value refuse anything but a decimal number within the range of
/// its type: no signs of unsigned numbers, no overflow, no "0x10", "nan" or "inf".
void require_strict_number(CLI::Option& option);

/// Makes an option refuse an empty value; `form` is the accepted one, such as "a folder".
void require_text(CLI::Option& option, std::string_view form);

/// "a whole number from 0 to 65535", "hold, last or default"; empty if any text is accepted.
std::string value_form(const CLI::Option& option);

/// The accepted words; empty if the option accepts others.
std::vector<std::string> choices(const CLI::Option& option);

/// "N", "X", "FILE": the placeholder of the value in help.
std::string value_name(const CLI::Option& option);

}  // namespace cls::cli
