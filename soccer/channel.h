// The interface between agents and a soccer server: messages in both directions.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace cls::soccer {

/// One end of a connection that carries whole messages, like UDP. Messages are protocol text
/// without the closing NUL, which the UDP implementation adds and removes. Agents have no other
/// connection to the server, so they play the same in memory and over a network.
class Channel {
 public:
  virtual ~Channel() = default;

  /// Queues one message to the peer. False if the connection is known to be closed.
  virtual bool send(std::string_view message) = 0;

  /// Receives the oldest waiting message into `message`, reusing its capacity. False, with
  /// `message` unchanged, if there is none. Never blocks.
  virtual bool receive(std::string& message) = 0;

  /// True if messages can be compressed, as over a network.
  virtual bool can_compress() const { return false; }

  /// From now on compresses sent messages and expects compressed ones (zlib level 0 to 9); a
  /// negative level stops compression. Requires can_compress().
  virtual void compress(int /*level*/) {}

  /// Asks the peer to send values in place of text (soccer/messages/values.h) where it can. False
  /// over a network, which carries text only, and nothing changes.
  virtual bool ask_for_values() { return false; }

  /// True if the peer has asked for values.
  virtual bool peer_reads_values() const { return false; }

  /// Arrival time of the last received message; the epoch of the clock for channels in memory.
  virtual std::chrono::steady_clock::time_point received_at() const { return {}; }
};

}  // namespace cls::soccer
