// A whole team of players in one process, asking one Playmaker.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "proxy/agent/player_agent.h"
#include "proxy/coach/coach_agent.h"
#include "proxy/playmaker/correspondence.h"
#include "proxy/playmaker/playmaker.h"
#include "soccer/channel.h"
#include "soccer/side.h"

namespace cls::proxy {

struct TeamOptions {
  soccer::TeamName name;
  int players = soccer::kPlayersPerTeam;
  int protocol = soccer::kDefaultProtocolVersion;
  OnLate on_late = OnLate::kHold;
  RpcTimeout decision_timeout{10'000};  ///< kNoTimeout: wait for ever
  RpcTimeout start_timeout{20'000};     ///< for the Playmaker to come up and answer Register
  RpcTimeout reconnect_within{3'000};   ///< for it to come back in mid-match: see AskingTime
  bool one_playmaker = true;            ///< for all agents; else (ports that step) one for each
  int first_unum = 1;                   ///< of those to take over with `reconnect`
  bool reconnect = false;               ///< take over players who lost their connection
  bool goalie = true;                   ///< the first one is the goalie
  std::shared_ptr<const FormationSet> formations;  ///< null: the built-in ones
  std::string debug_log;  ///< folder for what the Playmaker logs; empty: nowhere
};

/// Where a team's time went, summed over all cycles.
struct TeamTimes {
  std::chrono::nanoseconds perceive{0};  ///< parsing and world model
  std::chrono::nanoseconds state{0};     ///< completing the world and filling the State
  std::chrono::nanoseconds begin{0};     ///< serialising and handing over to gRPC
  std::chrono::nanoseconds wait{0};      ///< for answers, and parsing them
  std::chrono::nanoseconds act{0};       ///< skills and commands
};

/// The agent that has now gone longest without a usable answer.
struct MissingAnswers {
  int unum = 0;  ///< 0: nobody lacks one; kCoachNumber, kTrainerNumber
  int in_a_row = 0;
  RpcStatus last;  ///< why the latest one is missing
};

/// One thread uses a team (Playmaker::cancel() apart). What players do does not depend on the order
/// in which answers come.
class Team {
 public:
  /// `playmaker` must outlive the team.
  Team(TeamOptions options, Playmaker& playmaker);

  /// Asks this Playmaker from now on; before introduce() only.
  void set_playmaker(Playmaker& playmaker) { playmaker_ = &playmaker; }

  /// Opens a new connection to the server.
  using OpenChannel = std::function<std::unique_ptr<soccer::Channel>()>;

  /// Connects the players one after the other, goalie first, each until it has its number, the
  /// parameters and all player types.
  base::Result<void> connect(const OpenChannel& open, const Serve& serve);

  /// The same for the team's coach, once its players are connected, or for a trainer, with a team
  /// of its own without players. `open` opens a connection to the server's door for them.
  base::Result<void> connect_coach(soccer::CoachRole role, const OpenChannel& open,
                                   const Serve& serve);

  /// Introduces the players to the Playmaker one after the other: Register, parameters, player
  /// types, init message. A Playmaker without Register (of the first interface) is served all the
  /// same. Not ok when it cannot be reached or does not speak the interface; the message names the
  /// player and the call.
  RpcStatus introduce();

  /// One cycle. Takes in what the server sent and asks the Playmaker for everybody whose decision
  /// is due; returns how many.
  int begin_cycle();
  /// Waits for the answers, carries each out as it comes, sends commands and (done).
  void finish_cycle();
  int run_cycle();

  // The same in smaller steps, for servers that do not take turns with us: ask() as often as
  // messages come or next_due() is reached, take_reply() while answers are outstanding.

  /// begin_cycle() at this moment; more calls may follow before the answers are there.
  int ask(Instant now);
  /// Carries out one answer; false when none is there within `longest`.
  bool take_reply(std::chrono::microseconds longest);
  int outstanding() const { return outstanding_; }
  /// When the clock alone makes a decision due; the far future when only a message can.
  Instant next_due() const;

  /// Says goodbye to Playmaker and server. A Playmaker that does not react is waited for once, for
  /// a second.
  void leave();

  const std::string& name() const { return name_; }
  soccer::Side side() const;
  const std::vector<std::unique_ptr<PlayerAgent>>& players() const { return players_; }
  /// What its first player believes, or, without players, its coach or trainer. Once connected.
  const WorldModel& world() const;
  /// The server waits for everybody, by what it told.
  bool synchronous() const { return world().server().synch_mode; }
  /// The coach, or the trainer; null when there is none.
  const CoachAgent* coach() const { return coach_.get(); }
  const TeamTimes& times() const { return times_; }
  MissingAnswers missing_answers() const;
  /// Adds a line to those that take_warnings() gives, unless it was there before.
  void warn_once(const std::string& line);
  /// Lines worth a user's notice that came up since the last call, each cause once per team.
  std::vector<std::string> take_warnings();

 private:
  base::Result<void> connect_one(const OpenChannel& open, const Serve& serve, bool goalie);
  void warn_of_shared_identity();
  Correspondence& correspondence(int unum);
  AskingTime asking_time(const PlayerAgent& agent, Instant now) const;
  RpcStatus introduce_coach();
  int ask_coach(Instant now);
  RpcTimeout coach_timeout(Instant now) const;
  void carry_out_coach(Reply reply);
  RpcTimeout decision_timeout(const PlayerAgent& agent, Instant now) const;
  PlayerAgent& agent(int unum);
  void carry_out(Reply reply);
  void note(PlayerAgent& asker, const Correspondence& calls, const Reply& reply);
  void carry_out_choice(PlayerAgent& asker, const Reply& reply);
  void ask_for_choice(PlayerAgent& asker);
  void warn_of_unimplemented(const PlayerAgent& agent);
  void warn_of_server(const ServerTrouble& trouble);

  TeamOptions options_;
  std::string name_;
  Playmaker* playmaker_;
  std::vector<std::unique_ptr<PlayerAgent>> players_;
  std::array<std::optional<Correspondence>, kAgentNumbers> correspondence_;  // by agent number
  std::unique_ptr<CoachAgent> coach_;
  int outstanding_ = 0;
  TeamTimes times_;
  std::array<bool, kActionKinds> told_actions_{};
  std::array<bool, kSayKinds> told_say_{};
  std::vector<std::string> warnings_;
  std::size_t warnings_taken_ = 0;
};

}  // namespace cls::proxy
