// Parses what users write and what cls wrote earlier: scenarios, formations, cls.toml, scripts of
// the mock, planner files, recordings, saved matches, stores.
#pragma once

#include <string_view>

namespace cls::tests {

/// The first byte of `input` selects the kind of file: 's' scenario, 'f' formation, 'l' formation
/// of librcsc, 't' cls.toml, 'm' script of the mock, 'p' parameters of the planner, 'r' recorded
/// RPCs in protobuf's text format ('R': as they are, but not compressed), 'v' and 'V' the same of
/// saved matches, 'e' a line of a schedule, a row of a store or a result, 'y' a policy whose
/// weights follow a line of "--"; the rest is the file. Aborts when an accepted file is not equal
/// to itself after it was formatted and parsed again.
void check_user_file(std::string_view input);

}  // namespace cls::tests
