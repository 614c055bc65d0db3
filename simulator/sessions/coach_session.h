// One connected online coach or trainer as the server keeps it beside the world.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/sessions/session.h"
#include "soccer/commands/coach_command.h"

namespace cls::simulator {

/// What a coach or trainer has sent since its commands were last executed: one command per
/// datagram, parsed on arrival.
class CoachInbox {
 public:
  struct Datagram {
    std::string text;
    soccer::CoachCommand command;
    std::optional<soccer::ErrorCode> error;  ///< instead of a command; a TeamGraphic says where
    bool null_terminated = true;
  };

  /// True if the command is (done) or (bye).
  bool add(std::string_view text, bool null_terminated, soccer::CoachRole role);

  const std::vector<Datagram>& datagrams() const { return datagrams_; }
  void clear() { datagrams_.clear(); }

 private:
  std::vector<Datagram> datagrams_;
};

struct CoachSession : Connection {
  CoachSession() : Connection(Allowance::kCoachBytes) {}

  bool is_trainer() const { return client == kTrainer; }
  soccer::CoachRole role() const {
    return is_trainer() ? soccer::CoachRole::kTrainer : soccer::CoachRole::kOnlineCoach;
  }
  /// Neutral for the trainer.
  Side side() const {
    if (is_trainer()) return Side::kNeutral;
    return client == kLeftCoach ? Side::kLeft : Side::kRight;
  }
  /// In which form it hears.
  soccer::Listener listener() const {
    return is_trainer() ? soccer::Listener::kTrainer : soccer::Listener::kOnlineCoach;
  }

  bool eye = false;  ///< gets see_global in every cycle
  bool ear = false;  ///< a trainer hears; an online coach always does
  CoachInbox inbox;
};

}  // namespace cls::simulator
