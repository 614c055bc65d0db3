// Sets up a scenario's situation and writes down what comes of it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "base/io/byte_sink.h"
#include "orchestration/match/hooks/match_director.h"
#include "orchestration/scenario/run_record.h"
#include "orchestration/scenario/scenario.h"

namespace cls::orchestration::scenario {

/// Hears one side for the checks about actions and rpcs.
class SideEar : public proxy::RpcListener {
 public:
  SideEar(const Scenario& scenario, soccer::Side side, const int& step);

  bool has_work() const { return keeps_replies_ || !expectations_.empty(); }
  void on_call(const proxy::RpcCall& call) override;

  /// Moves what was heard into the record.
  void tell(RunRecord& record);

 private:
  soccer::Side side_;
  const int& step_;
  bool keeps_replies_ = false;
  std::vector<ReceivedReply> replies_;
  std::map<std::size_t, std::unique_ptr<mock_server::Expectations>> expectations_;
};

/// `text_log` is what the match writes into; all must outlive the director.
class ScenarioDirector : public match::MatchDirector {
 public:
  ScenarioDirector(const Scenario& scenario, const base::StringSink& text_log, RunRecord& record);

  proxy::RpcListener* listener(soccer::Side side) override;
  void arrange(simulator::World& world, simulator::Events& events) override;
  void before_decisions(const simulator::World& world) override;
  bool after_cycle(const simulator::World& world) override;

  /// After the match.
  void finish();

 private:
  void place_side(simulator::World& world, simulator::Events& events, soccer::Side side) const;
  void note_frame(const simulator::World& world);
  void note_touches(const simulator::World& world);
  void note_touch(int slot);
  void note_words();

  const Scenario& scenario_;
  const base::StringSink& text_log_;
  RunRecord& record_;
  int step_ = 0;
  std::array<SideEar, 2> ears_;
  std::size_t text_read_ = 0;
  int words_of_arrangement_ = 0;  ///< said by the arrangement itself, not by the referee
  std::array<int, soccer::kPlayersOnPitch> kicks_{};
  int touch_time_ = -1;
  int toucher_ = -1;
  int catcher_ = -1;
};

}  // namespace cls::orchestration::scenario
