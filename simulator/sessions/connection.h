// What every client of a match has in common: who it is, its channel, and what it owes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "simulator/sessions/allowance.h"
#include "simulator/world/world.h"
#include "soccer/channel.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/reply_code.h"

namespace cls::simulator {

/// Index of a client of the match: players by their slots, then coaches and trainer, monitors.
using ClientId = int;
constexpr ClientId kLeftCoach = soccer::kPlayersOnPitch;
constexpr ClientId kRightCoach = kLeftCoach + 1;
constexpr ClientId kTrainer = kLeftCoach + 2;
constexpr ClientId kFirstMonitor = kTrainer + 1;

constexpr bool is_monitor(ClientId client) { return client >= kFirstMonitor; }
constexpr bool is_player(ClientId client) { return client < soccer::kPlayersOnPitch; }

/// Where clients ask to be let in: each is a port of its own on a network (protocol 1.1).
enum class Door : std::uint8_t {
  kGame,          ///< players and monitors
  kOfflineCoach,  ///< the trainer
  kOnlineCoach,
  kMonitors,  ///< monitors only
};

/// A client that was let in. It hears nothing before MatchServer::greet.
struct Admission {
  ClientId client = kNobody;
  int version = 0;
  bool reconnected = false;
  bool binary = false;  ///< its messages have no closing NUL on a network
};

struct Connection {
  explicit Connection(std::size_t bytes_a_step = Allowance::kPlayerBytes)
      : allowance(bytes_a_step) {
    text_.reserve(kUsualReply);
  }

  ClientId client = kNobody;
  int version = 0;
  std::unique_ptr<soccer::Channel> channel;

  bool asked = false;  ///< to think, since the last step
  bool done = false;   ///< since the last step
  bool lost = false;   ///< the connection is gone; the client leaves after the commands
  Allowance allowance;

  void begin_step() {
    asked = done = false;
    allowance.renew();
  }

  /// True if the client was asked to think and has not sent (done).
  bool is_awaited() const { return asked && !done && !lost; }

  /// Sends one message; a failure marks the connection as lost.
  void send(std::string_view message) {
    if (!lost && !channel->send(message)) lost = true;
  }

  /// Higher levels than this there are not.
  static constexpr int kMostCompression = 9;

  /// Answers (compression LEVEL) and obeys it, if the channel can; a negative level ends it.
  void compress(int level) {
    if (!channel->can_compress()) return reply(soccer::WarningCode::kCompressionUnsupported);
    reply(soccer::OkCompression{level});
    channel->compress(level);
  }

  void reply(const soccer::ServerReply& answer) { send_formatted(answer); }
  void reply(soccer::ErrorCode code) { send_formatted(code); }
  void reply(soccer::WarningCode code) { send_formatted(code); }

 private:
  template <typename Message>
  void send_formatted(const Message& message) {
    text_.clear();
    soccer::format(message, text_);
    send(text_);
  }

  static constexpr std::size_t kUsualReply = 128;  ///< bytes

  std::string text_;  ///< reused
};

}  // namespace cls::simulator
