// Turns of a cls team in lockstep.
#include "match/sides/lockstep_agents.h"

namespace cls::match {
namespace {

using base::Result;

// A side that does not end its turn in this time when the match ends has to be cancelled.
constexpr std::chrono::milliseconds kLeaveWait{20};

}  // namespace

std::optional<MatchEnd> LockstepAgents::join(const ServerStatus& /*server*/,
                                             const std::vector<std::string>& /*others*/) {
  joined_ = true;
  const Result<void> connected = connect();
  if (connected) return std::nullopt;
  return MatchEnd{.reason = EndReason::kServerFailed, .message = connected.error().message};
}

Result<void> LockstepAgents::connect() {
  simulator::LockstepServer& simulator = server_.simulator();
  const auto serve = [&simulator] {
    simulator.accept_clients();
    return true;
  };

  simulator::ClientRights rights;
  if (!is_trainer()) {
    rights.left = identity().side == soccer::Side::kLeft;
    rights.right = !rights.left;
  }
  const auto open = [&simulator, rights](simulator::ListeningPort door) {
    return [&simulator, rights, door] { return simulator.connect(door, rights); };
  };

  if (is_trainer()) {
    return team().connect_coach(soccer::CoachRole::kTrainer,
                                open(simulator::ListeningPort::kTrainers), serve);
  }
  TRY(team().connect(open(simulator::ListeningPort::kPlayers), serve));
  if (!options().coach) return {};
  return team().connect_coach(soccer::CoachRole::kOnlineCoach,
                              open(simulator::ListeningPort::kOnlineCoaches), serve);
}

void LockstepAgents::begin_handshake() {
  busy_ = true;
  worker().start([this] { failed_handshake_ = shake_hands(); });
}

void LockstepAgents::begin_turn(int cycle) {
  begin_listening(cycle);
  busy_ = true;
  if (!on_match_thread_) worker().start([this] { team().run_cycle(); });
}

void LockstepAgents::take_turn() {
  if (!on_match_thread_) return;
  worker().run([this] { team().run_cycle(); });
  busy_ = false;
}

bool LockstepAgents::wait_work(std::chrono::milliseconds limit) {
  if (!busy_) return true;
  if (limit == kNoLimit) {
    worker().wait();
    busy_ = false;
  } else {
    busy_ = !worker().wait_for(limit);
  }
  return !busy_;
}

void LockstepAgents::end_turn() {
  end_listening();
  turn_over_ = true;
}

std::optional<MatchEnd> LockstepAgents::agent_failure(const MatchMoment& moment) {
  if (busy_) return std::nullopt;
  if (failed_handshake_) return std::exchange(failed_handshake_, std::nullopt);
  if (!std::exchange(turn_over_, false)) return std::nullopt;

  const proxy::MissedDecisions missed = team().missed_decisions();
  if (missed.consecutive == 1 && missed.last.outcome == proxy::RpcOutcome::kUnavailable) {
    for (const PlaymakerProcess* started : playmaker_processes()) {
      started->child().wait_exit(kProgramExitDelay);
    }
  }
  return end_by_missed_decisions(missed, who(), moment.cycle, options());
}

void LockstepAgents::leave() {
  if (!wait_work(kLeaveWait)) {
    cancel();
    wait_work(kNoLimit);
  }
  busy_ = true;
  worker().start([this] { team().leave(); });
}

void LockstepAgents::terminate() {
  wait_work(kNoLimit);
  for (const auto* started : playmaker_processes()) started->child().end(kTerminateGrace);
}

}  // namespace cls::match
