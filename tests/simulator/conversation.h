// Written conversations between clients and a soccer server, held against servers.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/sessions/match_server.h"

namespace cls::tests {

/// One thing that happens in a conversation, and what all clients are then told.
///
/// The text form, one line each; lines that begin with a blank or are empty are comments:
///
///     = server::coach_w_referee=on     a parameter of the match
///     @ (see_global                    messages that begin so are told too, from here on
///     > L1 (init Left (version 18))    client L1 sends this
///     + 2                              two cycles pass
///     < L1 (init l 1 before_kick_off)  a client is told this; '#' stands for any whole number,
///                                      '@' for either side's letter
///     - L1                             what this client is told does not count
///     ? L1 (sense_body 0 ...)          the last it was told that begins with this word is this
///
/// A client's first letter says where it knocks: C as an online coach, T as the trainer, others as
/// players. What one client is told is in order, but where cycles pass after what was sent; of
/// different clients it is not. `\n` is a line feed. Senses and parameters are left out unless
/// asked for.
struct Turn {
  int line = 0;
  std::string client;  ///< who sends; empty: cycles pass
  std::string sent;
  int cycles = 0;
  std::vector<std::string> shown;  ///< beginnings of messages that count from here on
  std::vector<std::pair<std::string, std::string>> latest;  ///< client and message
  std::map<std::string, std::vector<std::string>> told;     ///< by client
};

struct Conversation {
  std::vector<std::string> settings;
  std::vector<std::string> ignored;  ///< clients
  std::vector<Turn> turns;
};

/// Reads the text form; a line that cannot be read fails the test by an exception.
Conversation read_conversation(std::string_view text);

/// Where a client of that name knocks.
simulator::Door door_of(const std::string& client);

/// A server that conversations can be held with.
class Host {
 public:
  virtual ~Host() = default;
  virtual void send(const std::string& client, const std::string& datagram) = 0;
  virtual void pass_cycles(int count) = 0;
  /// What a client has been told since the last call. `expected`: as many are waited for.
  virtual std::vector<std::string> take(const std::string& client, std::size_t expected,
                                        const std::vector<std::string>& shown) = 0;
  /// The last of all that begin with that word.
  std::string latest(const std::string& client, const std::string& word) {
    return latest_[client][word];
  }
  virtual std::vector<std::string> clients() const = 0;

 protected:
  void note(const std::string& client, const std::string& message) {
    latest_[client][message.substr(0, message.find(' '))] = message;
  }

 private:
  std::map<std::string, std::map<std::string, std::string>> latest_;
};

/// True if a message is not one of those left out, or begins with one of `shown`.
bool counts(std::string_view message, const std::vector<std::string>& shown);

/// Expects the host to tell what is written.
void hold(const Conversation& conversation, Host& host);

/// The match server with clients in memory.
std::unique_ptr<Host> make_memory_host(const std::vector<std::string>& settings);

}  // namespace cls::tests
