// A simple player for server tests: runs to the ball and kicks it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/channel.h"
#include "soccer/geometry.h"
#include "soccer/messages/see.h"

namespace cls::tests {

/// Deterministic: the same messages lead to the same commands.
class ScriptedPlayer {
 public:
  ScriptedPlayer(std::unique_ptr<soccer::Channel> channel, std::string team, int version = 18);

  /// Sends (init ...).
  void join(bool goalie = false);

  /// Reads all received messages. After (think), sends the commands of this cycle and (done), and
  /// returns true.
  bool act();

  /// Sends a text unchanged.
  void send(std::string_view text) { channel_->send(text); }

  /// Its position before kick-off, in coordinates of its team.
  void stand_at(soccer::Vec2 place) { place_ = place; }

  /// Stores each message for messages().
  void keep_messages() { keep_ = true; }
  std::vector<std::string> messages() const { return messages_; }
  int count(std::string_view beginning) const;

  bool heard_time_over() const { return time_over_; }
  int unum() const { return unum_; }
  bool is_left() const { return is_left_; }

 private:
  void read(std::string_view message);
  void think();
  void chase();

  std::unique_ptr<soccer::Channel> channel_;
  std::string team_;
  int version_;
  soccer::Vec2 place_;
  int unum_ = 0;
  bool is_left_ = true;
  bool waiting_ = true;  ///< for a kick-off
  bool time_over_ = false;
  bool asked_ = false;
  bool keep_ = false;
  soccer::See see_;
  bool seen_ = false;  ///< since the last commands
  int cycles_ = 0;
  std::string in_;
  std::string out_;
  std::vector<std::string> messages_;
};

/// Positions of a team of 11 before kick-off, goalie first; `attacking`: the last player is at the
/// ball.
std::vector<soccer::Vec2> formation(bool attacking);

}  // namespace cls::tests
