// The seam between a team and a soccer server: datagrams one way and the other.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace cls::soccer {

/// One end of a connection that carries whole messages, as UDP does. Messages are the text of the
/// protocol without the closing NUL: the UDP implementation adds and strips it. An agent sees
/// nothing else of the server, so it plays the same over memory and over a network.
class Channel {
 public:
  virtual ~Channel() = default;

  /// Queues one message to the other side. False when the connection is known to be gone.
  virtual bool send(std::string_view message) = 0;

  /// Takes the oldest waiting message into `message` (its capacity is reused). False, leaving
  /// `message` alone, when none waits. Never blocks.
  virtual bool receive(std::string& message) = 0;

  /// True if messages can be compressed on the way, as over a network.
  virtual bool can_compress() const { return false; }

  /// Compresses what is sent, and expects the same of what is received, from now on (zlib, level 0
  /// to 9); a negative level ends it. Only where can_compress().
  virtual void compress(int /*level*/) {}

  /// When the message taken last reached this process; the clock's epoch where nobody notes it, as
  /// in memory.
  virtual std::chrono::steady_clock::time_point arrived() const { return {}; }
};

}  // namespace cls::soccer
