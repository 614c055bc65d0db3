// Messages as values, for a server and an agent in one process. Their text stays the truth: values
// are what a reader of the text gets.
#pragma once

#include <string>
#include <string_view>

#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::soccer {

/// Makes of a message what parse() makes of the text that format() writes: rounds its numbers and
/// clears what the text does not have. False, with a message that still has the same text, if that
/// text has another form or does not parse; such a message is sent as text.
bool make_as_sent(See& see);
/// As received by a client of `version`; false before version 14, whose text has fewer groups.
bool make_as_sent(SenseBody& sense, int version);

/// Appends a message to `out` as bytes that begin with those of its text, for a Channel whose peer
/// reads values (Channel::peer_reads_values).
void write_values(const See& see, std::string& out);
void write_values(const SenseBody& sense, std::string& out);

/// Reads what write_values() wrote in this process. False, with `out` unchanged, if the message is
/// text. Messages from elsewhere must not get here: their bytes are not checked.
bool read_values(std::string_view message, See& out);
bool read_values(std::string_view message, SenseBody& out);

}  // namespace cls::soccer
