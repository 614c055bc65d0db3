// The form TENSOR of the calls of a team: rows of numbers instead of States and action lists.
#pragma once

#include <memory>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proto/team_playmaker.pb.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/playmaker/tensor_codec.h"

namespace cls::proxy {

class TensorCalls {
 public:
  /// Adds what the team offers to its registration.
  static void offer(const TeamRegistration& team, playmaker::v1::RegisterTeamRequest& request);

  /// Selects what the Playmaker chose; the error says what it may not choose. Other encodings turn
  /// the form off.
  base::Result<void> choose(const TeamRegistration& team,
                            const playmaker::v1::RegisterTeamResponse& response);
  bool active() const { return codec_ != nullptr; }

  /// Adds the row of a player to the request of the cycle; the first one begins the rows.
  void add_player(const player::WorldModel& world, bool first,
                  playmaker::v1::GetTeamActionsRequest& request);

  /// Reads the rows of the players `due`, in the order of the request. The error concerns them all.
  base::Result<void> read(const playmaker::v1::GetTeamActionsResponse& response,
                          std::size_t players);
  /// True if the response had rows.
  bool has_rows() const { return !actions_.empty(); }
  /// The action list of row `row`; null for an action that does not exist. Valid until the next
  /// call.
  const protos::PlayerActions* actions(std::size_t row, const player::WorldModel& world);

 private:
  std::shared_ptr<TensorCodec> codec_;  // null: another encoding
  TensorSizes sizes_;
  std::vector<float> features_;
  std::vector<std::uint8_t> masks_;
  std::vector<float> actions_;
  protos::PlayerActions list_;
};

}  // namespace cls::proxy
