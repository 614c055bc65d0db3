// The online coaches and the trainer of a match: admission, commands, messages.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.h"
#include "simulator/sessions/coach_language.h"
#include "simulator/sessions/session.h"
#include "simulator/sessions/team_graphic.h"
#include "simulator/world/event.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

/// A message of a coach or trainer that is due. `side` is neutral for the trainer.
struct CoachMessage {
  Side side = Side::kNeutral;
  soccer::CoachSay say;  ///< of a trainer: only the text
  int received = 0;      ///< game time at which an online coach sent it
};

/// Results of a command besides its effect on the world, in the order in which they are sent.
struct CoachCommandResult {
  std::optional<soccer::ServerReply> reply;
  std::optional<CoachMessage> message;  ///< of the trainer; sent immediately
  std::optional<TeamGraphicTile> tile;
};

/// Part of MatchServer, which forwards messages to players and logs.
class CoachRegistry {
 public:
  explicit CoachRegistry(const soccer::ServerParams& params)
      : language_{CoachLanguage(params), CoachLanguage(params)} {}

  /// See MatchServer::admit.
  AdmissionResult admit(const World& world, ListeningPort port, std::string_view datagram,
                        const ClientRights& rights);

  /// Creates the session of an admitted client and sends the reply and the parameters, but not the
  /// coach language versions of the players.
  CoachSession& connect(const World& world, const Admission& admission,
                        std::unique_ptr<soccer::Channel> channel);

  /// Null if the client is not connected.
  CoachSession* session(ClientId client) { return slot(client).get(); }
  const CoachSession* session(ClientId client) const;

  /// Name that the online coach of the side sent in its init; may be empty.
  const std::string& name(Side side) const { return names_[index(side)]; }

  void disconnect_all();
  void remove_lost();

  /// Executes a command. The caller dispatches `events` before it sends the result.
  CoachCommandResult execute(World& world, CoachSession& coach,
                             const CoachInbox::Datagram& datagram, Events& events);

  /// Resets think/done states and appends the coach messages that are due now.
  void begin_step(const World& world, std::vector<CoachMessage>& out);

  /// Extends the freeform quota after each full game time.
  void end_step(const World& world);

  void send_referee_message(const soccer::Hear& message);
  void send_say(const World& world, const PlayerSaid& said);
  void send_coach_message(const World& world, const CoachMessage& message);
  void send_type_change(const TypeChanged& change);
  void send_goalie_change(const GoalieAppointed& change);

  /// Sends see_global to coaches with eye on, the trainer first.
  void send_views(const World& world);

  /// Sends (think) to coaches with eye on: left, right, trainer.
  void send_think();

 private:
  static std::size_t index(Side side) { return side == Side::kRight ? 1 : 0; }
  std::unique_ptr<CoachSession>& slot(ClientId client) {
    return sessions_[base::index(client - kLeftCoach)];
  }

  AdmissionResult admit_coach(const World& world, std::string_view datagram,
                              const ClientRights& rights);
  AdmissionResult admit_trainer(const World& world, std::string_view datagram);

  struct Executor;
  std::optional<soccer::ServerReply> reject_tile(const World& world, CoachSession& coach,
                                                 const soccer::TeamGraphic& tile,
                                                 std::optional<soccer::ErrorCode> error);
  void send_view(const World& world, CoachSession& coach, bool is_look_reply);
  void send(CoachSession& coach, const soccer::Hear& message);

  std::array<std::unique_ptr<CoachSession>, kFirstMonitor - kLeftCoach> sessions_;
  std::array<CoachLanguage, 2> language_;  ///< left, right
  std::array<std::string, 2> names_;

  // Reused, so that a cycle does not allocate.
  soccer::GlobalView view_;
  std::string text_;
  std::vector<CoachLanguage::Message> due_;
};

}  // namespace cls::simulator
