// Sessions of connected players and coaches, and their inboxes of received commands.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/senses/hearing.h"
#include "simulator/sessions/connection.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/player_command.h"

namespace cls::simulator {

/// Datagrams of a player since its commands were last executed. They are parsed on arrival, so that
/// (done) is known immediately. Memory is reused.
class PlayerInbox {
 public:
  /// One datagram; its commands are the range [first, last) of commands().
  struct Datagram {
    std::string text;
    std::size_t first = 0;
    std::size_t last = 0;
    bool complete = true;         ///< no syntax error
    bool null_terminated = true;  ///< as required on a network
    bool answered = false;        ///< on receipt; only the logs lack it
  };

  PlayerInbox() {
    datagrams_.reserve(kDatagramCapacity);
    commands_.reserve(kCommandCapacity);
  }

  /// Returns true if the commands include (done) or (bye): the server need not wait any longer.
  bool add(std::string_view text, bool null_terminated);

  std::size_t size() const { return count_; }
  const Datagram& operator[](std::size_t i) const { return datagrams_[i]; }

  /// The newest datagram if all before it are answered and it asks for nothing that needs an order
  /// among the clients: no action of a player. Null otherwise.
  Datagram* answerable();
  const std::vector<soccer::PlayerCommand>& commands() const { return commands_; }
  void clear();

 private:
  // Initial capacity, enough for the usual commands of a cycle.
  static constexpr std::size_t kTextCapacity = 512;  ///< of a datagram, in bytes
  static constexpr std::size_t kDatagramCapacity = 8;
  static constexpr std::size_t kCommandCapacity = 32;

  std::vector<Datagram> datagrams_;
  std::size_t count_ = 0;
  std::vector<soccer::PlayerCommand> commands_;
};

struct PlayerSession : Connection {
  Slot slot() const { return client; }

  PlayerInbox inbox;
  int view_rounds = 0;  ///< since the last see message
  PendingMessages pending;
};

/// Datagrams of a coach or trainer since its commands were last executed: one command per datagram,
/// parsed on arrival.
class CoachInbox {
 public:
  struct Datagram {
    std::string text;
    soccer::CoachCommand command;
    std::optional<soccer::ErrorCode> error;  ///< `command` is then a TeamGraphic or unset
    bool null_terminated = true;
    bool answered = false;  ///< on receipt; only the logs lack it
  };

  /// Returns true if the command is (done) or (bye).
  bool add(std::string_view text, bool null_terminated, soccer::CoachRole role);

  const std::vector<Datagram>& datagrams() const { return datagrams_; }

  /// As PlayerInbox::answerable: a question, a setting of the coach's own messages or a mistake.
  Datagram* answerable();
  void clear() { datagrams_.clear(); }

 private:
  std::vector<Datagram> datagrams_;
};

struct CoachSession : Connection {
  CoachSession() : Connection(ReceiveQuota::kMaxCoachBytes) {}

  bool is_trainer() const { return client == kTrainer; }
  soccer::CoachRole role() const {
    return is_trainer() ? soccer::CoachRole::kTrainer : soccer::CoachRole::kOnlineCoach;
  }
  /// Neutral for the trainer.
  Side side() const {
    if (is_trainer()) return Side::kNeutral;
    return client == kLeftCoach ? Side::kLeft : Side::kRight;
  }
  /// Form of its hear messages.
  soccer::Recipient recipient() const {
    return is_trainer() ? soccer::Recipient::kTrainer : soccer::Recipient::kOnlineCoach;
  }

  bool eye = false;  ///< receives see_global in every cycle
  bool ear = false;  ///< the trainer receives hear messages; online coaches always do
  CoachInbox inbox;

  bool hears() const { return !is_trainer() || ear; }
};

}  // namespace cls::simulator
