// What must hold for any bytes that are taken for a log; shared by fuzzers and a test of the
// corpus.
#pragma once

#include <string_view>

namespace cls::tests {

/// Reads the bytes as a game log of whatever version, packed or not; writes the record in every
/// version and reads that again, which must give the same text; reckons results and statistics.
/// Aborts where a promise is broken.
void check_game_log(std::string_view bytes);

/// The same for a text log: every datagram is cut into commands, results are told, and the players'
/// answers are reckoned against a small made-up match.
void check_text_log(std::string_view bytes);

}  // namespace cls::tests
