// The online coaches and the trainer of a match: admission, commands, what they see and hear.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulator/sessions/coach_language.h"
#include "simulator/sessions/coach_session.h"
#include "simulator/sessions/tile.h"
#include "simulator/world/event.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

/// Words of a coach or trainer that come to be heard. `side` is neutral for the trainer.
struct CoachWords {
  Side side = Side::kNeutral;
  soccer::CoachSay said;  ///< a trainer's: the text alone
  int received = 0;       ///< game time at which an online coach sent them
};

/// What comes of a command beside its effect on the world, in the order in which it must be told.
struct CoachOutcome {
  std::optional<soccer::ServerReply> reply;
  std::optional<CoachWords> words;  ///< of the trainer: heard at once
  std::optional<Tile> tile;
};

/// Part of MatchServer, which passes on what is told to players and logs.
class Coaches {
 public:
  explicit Coaches(const soccer::ServerParams& params)
      : language_{CoachLanguage(params), CoachLanguage(params)} {}

  /// See MatchServer::admit.
  std::variant<Admission, soccer::ErrorCode> admit(const World& world, Door door,
                                                   std::string_view datagram);

  /// Gives the admitted client its channel and sends what follows an init, but for the players'
  /// coach language versions.
  CoachSession& connect(const World& world, const Admission& admission,
                        std::unique_ptr<soccer::Channel> channel);

  /// Null if there is none.
  CoachSession* session(ClientId client) { return slot(client).get(); }
  const CoachSession* session(ClientId client) const;

  /// What the side's online coach calls itself; empty if it does not.
  const std::string& name(Side side) const { return names_[index(side)]; }

  void disconnect_all();
  void remove_lost();

  /// Executes a command; its events lie in `events` and are to be told before the reply.
  CoachOutcome execute(World& world, CoachSession& coach, const CoachInbox::Datagram& datagram,
                       Events& events);

  /// At the beginning of a step: nobody is asked or done; appends what players hear now.
  void begin_step(const World& world, std::vector<CoachWords>& out);

  /// At the end of a step: more words after each full game time.
  void end_step(const World& world);

  // What everybody hears.
  void tell_referee(const soccer::Hear& words);
  void tell_said(const World& world, const PlayerSaid& said);
  void tell_words(const World& world, const CoachWords& words);
  void tell_type(const TypeChanged& change);
  void tell_goalie(const GoalieAppointed& change);

  /// see_global to those who have their eyes open: the trainer first.
  void send_views(const World& world);

  /// (think) to those who have their eyes open: left, right, trainer.
  void ask(std::string_view think);

 private:
  static std::size_t index(Side side) { return side == Side::kRight ? 1 : 0; }
  std::unique_ptr<CoachSession>& slot(ClientId client) {
    return sessions_[static_cast<std::size_t>(client - kLeftCoach)];
  }

  std::variant<Admission, soccer::ErrorCode> admit_coach(const World& world,
                                                         std::string_view datagram);
  std::variant<Admission, soccer::ErrorCode> admit_trainer(const World& world,
                                                           std::string_view datagram);

  struct Executor;
  std::optional<soccer::ServerReply> refuse_tile(const World& world, CoachSession& coach,
                                                 const soccer::TeamGraphic& tile,
                                                 std::optional<soccer::ErrorCode> error);
  void send_view(const World& world, CoachSession& coach, bool is_look_reply);
  void send(CoachSession& coach, const soccer::Hear& words);

  std::array<std::unique_ptr<CoachSession>, kFirstMonitor - kLeftCoach> sessions_;
  std::array<CoachLanguage, 2> language_;  ///< left, right
  std::array<std::string, 2> names_;

  // Reused, so that a cycle does not allocate.
  soccer::GlobalView view_;
  std::string text_;
  std::vector<CoachLanguage::Words> due_;
};

}  // namespace cls::simulator
