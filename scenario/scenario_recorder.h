// Match hooks of a scenario: set up the initial situation and record the run.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "base/io/byte_sink.h"
#include "match/hooks/match_hooks.h"
#include "scenario/run_record.h"
#include "scenario/scenario.h"

namespace cls::scenario {

/// Records the replies of one side for checks of actions and RPCs.
class ReplyRecorder : public match::SideListener {
 public:
  ReplyRecorder(const Scenario& scenario, soccer::Side side, const int& step);

  bool has_work() const { return records_replies_ || !expectations_.empty(); }
  void on_call(const proxy::RpcCall& call) override;

  /// Moves the recorded replies into the record.
  void move_to(RunRecord& record);

 private:
  soccer::Side side_;
  const int& step_;
  bool records_replies_ = false;
  std::vector<ReceivedReply> replies_;
  std::map<std::size_t, std::unique_ptr<mock_server::Expectations>> expectations_;
};

/// `text_log` is the text log of the match. All arguments must outlive the recorder.
class ScenarioRecorder : public match::MatchHooks {
 public:
  ScenarioRecorder(const Scenario& scenario, const base::StringSink& text_log, RunRecord& record);

  match::SideListener* listener(soccer::Side side) override;
  void arrange(simulator::World& world, simulator::Events& events) override;
  void before_decisions(const match::MatchView& view) override;
  bool after_cycle(const match::MatchView& view) override;

  /// Call after the match.
  void finish();

 private:
  void place_side(simulator::World& world, simulator::Events& events, soccer::Side side) const;
  void record_frame(const simulator::World& world);
  void record_touches(const simulator::World& world);
  void record_touch(int slot);
  void record_referee_messages();

  const Scenario& scenario_;
  const base::StringSink& text_log_;
  RunRecord& record_;
  int step_ = 0;
  std::array<ReplyRecorder, 2> reply_recorders_;
  std::size_t text_read_ = 0;
  int setup_messages_ = 0;  ///< messages caused by the setup, not by play
  std::array<int, soccer::kPlayersOnPitch> kicks_{};
  int touch_time_ = -1;
  int toucher_ = -1;
  int catcher_ = -1;
};

}  // namespace cls::scenario
