// Scripted conversations between clients and a soccer server, replayed against servers.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/sessions/match_server.h"

namespace cls::tests {

/// One datagram of a client, or a pause, and the messages that all clients receive after it.
///
/// The text form has one entry per line; empty lines and lines that begin with a space are
/// comments:
///
///     = server::coach_w_referee=on     a parameter of the match
///     @ (see_global                    from here on, include messages that begin so
///     > L1 (init Left (version 18))    client L1 sends a datagram
///     + 2                              two cycles pass
///     < L1 (init l 1 before_kick_off)  client L1 receives a message; '#' matches any integer, '@'
///                                      the letter of a side
///     - L1                             ignore the messages that this client receives
///     ? L1 (sense_body 0 ...)          the latest message to L1 that begins with this word
///
/// The first letter of a client selects its port: C online coaches, T trainers, others players.
/// Messages to one client are in order, unless cycles pass after the datagram; messages to
/// different clients are not. `\n` is a line feed. Senses and parameters are ignored unless
/// included by '@'.
struct Turn {
  int line = 0;
  std::string client;  ///< sender; empty if cycles pass
  std::string sent;
  int cycles = 0;
  std::vector<std::string> included;  ///< prefixes of messages to include from here on
  std::vector<std::pair<std::string, std::string>> latest;   ///< client and message
  std::map<std::string, std::vector<std::string>> received;  ///< by client
};

struct Conversation {
  std::vector<std::string> settings;
  std::vector<std::string> ignored;  ///< clients
  std::vector<Turn> turns;
};

/// Parses the text form; throws on an invalid line.
Conversation parse_conversation(std::string_view text);

/// The port that a client of that name connects to.
simulator::ListeningPort port_of(const std::string& client);

/// A server that a conversation can be replayed against.
class Host {
 public:
  virtual ~Host() = default;
  virtual void send(const std::string& client, const std::string& datagram) = 0;
  virtual void pass_cycles(int count) = 0;
  /// Returns the relevant messages to a client since the last call; waits for `expected` messages.
  virtual std::vector<std::string> receive(const std::string& client, std::size_t expected,
                                           const std::vector<std::string>& included) = 0;
  /// The latest message to the client that begins with that word.
  std::string latest(const std::string& client, const std::string& word) {
    return latest_[client][word];
  }
  virtual std::vector<std::string> clients() const = 0;

 protected:
  void record(const std::string& client, const std::string& message) {
    latest_[client][message.substr(0, message.find(' '))] = message;
  }

 private:
  std::map<std::string, std::map<std::string, std::string>> latest_;
};

/// True unless the message is a sense or parameter that is not in `included`.
bool is_relevant(std::string_view message, const std::vector<std::string>& included);

/// Sends the datagrams of the conversation and expects the messages.
void replay_conversation(const Conversation& conversation, Host& host);

/// A match server with clients in memory.
std::unique_ptr<Host> make_memory_host(const std::vector<std::string>& settings);

}  // namespace cls::tests
