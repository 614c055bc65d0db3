// The connected players of a match: admission, messages and senses.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/index.h"
#include "simulator/senses/vision.h"
#include "simulator/sessions/coach_registry.h"
#include "simulator/sessions/session.h"
#include "simulator/world/event.h"
#include "soccer/commands/connection_request.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/hear.h"

namespace cls::simulator {

/// Part of MatchServer.
class PlayerRegistry {
 public:
  explicit PlayerRegistry(const soccer::ServerParams& params);

  // See MatchServer::admit. An accepted player joins the world.
  static AdmissionResult admit(World& world, const soccer::PlayerInit& init,
                               const ClientRights& rights);
  static AdmissionResult admit(World& world, const soccer::PlayerReconnect& request,
                               const ClientRights& rights);

  /// Creates the session of an admitted client and sends the reply and the parameters.
  PlayerSession& connect(const World& world, const Admission& admission,
                         std::unique_ptr<soccer::Channel> channel);

  /// Null if the player is not connected.
  PlayerSession* session(Slot slot) { return sessions_[base::index(slot)].get(); }
  const PlayerSession* session(Slot slot) const { return sessions_[base::index(slot)].get(); }
  int connected() const;
  void disconnect_all();
  /// Closes lost connections; their players leave the pitch.
  void remove_lost(World& world);

  void begin_step();
  void end_step();

  /// Versions of the coach language that the player has declared; zero if none.
  soccer::Clang& clang_versions(Slot slot) { return clang_versions_[base::index(slot)]; }

  void send_referee_message(const World& world, const soccer::Hear& message);
  void queue_say(const World& world, const PlayerSaid& said);
  /// A message of an online coach is sent immediately, one of the trainer after the next
  /// sense_body.
  void send_coach_message(const World& world, const CoachMessage& message);
  void send_type_change(const TypeChanged& change);
  void send_goalie_change(const GoalieAppointed& change);
  /// To those who have received their senses since the step: who has joined after them waits for
  /// the next ones.
  void send_think(const World& world);

  void send_sense_body(const World& world, PlayerSession& player);
  /// Sends sense_body, fullstate and hear messages to all players.
  void send_senses(World& world);
  /// Sends the see messages that are due until `ms` after the step, in match time.
  void send_due_sees(const World& world, int ms);

 private:
  void send_full_state(const World& world, PlayerSession& player);
  void send_heard(World& world, PlayerSession& player);
  void send_see(const World& world, PlayerSession& player);
  void run_view_round(const World& world, bool synchronous);
  void run_asynchronous_rounds(const World& world, int until_ms);

  VisionModel vision_;
  std::array<std::unique_ptr<PlayerSession>, soccer::kPlayersOnPitch> sessions_;
  std::array<soccer::Clang, soccer::kPlayersOnPitch> clang_versions_ = {};
  std::int64_t steps_ = 0;
  std::int64_t asynchronous_rounds_ = 0;
  bool synchronous_sees_sent_ = true;  ///< since the last step

  // Reused, so that a cycle does not allocate.
  std::string text_;
  soccer::See see_;
  soccer::FullState full_state_;
  std::vector<soccer::Hear> heard_;
};

}  // namespace cls::simulator
