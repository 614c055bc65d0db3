// Evaluates checks on the record of a run.
#include "scenario/check.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.h"
#include "base/text/fnv1a.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "scenario/scenario.h"
#include "soccer/areas.h"
#include "soccer/side.h"

namespace cls::scenario {
namespace {

using mock_server::Value;
using soccer::Side;

const ObjectFrame& object_in(const StepFrame& frame, int object) {
  return object == kBallObject ? frame.ball : frame.players[base::index(object)];
}

std::string object_name(int object) {
  if (object == kBallObject) return "the ball";
  return fmt::format("{} {}", side_name(soccer::side_of_slot(object)),
                     soccer::unum_of_slot(object));
}

Value value_of(const ObjectFrame& object, ObjectTest::Quantity::What what) {
  using What = ObjectTest::Quantity::What;
  switch (what) {
    case What::kX:
      return object.position.x;
    case What::kY:
      return object.position.y;
    case What::kSpeed:
      return object.velocity.length();
    case What::kBody:
      return object.body;
    case What::kStamina:
      return object.stamina;
    case What::kCards:
      return static_cast<double>(object.cards);
    case What::kOnPitch:
      break;
  }

  return object.on_pitch;
}

bool is_at(const CheckTiming& timing, const StepFrame& frame) {
  return frame.step >= timing.from && frame.step <= timing.to;
}

std::string when(const StepFrame& frame) {
  return fmt::format("step {} (cycle {})", frame.step, frame.cycle);
}

std::string describe(const StepTest& test, const StepFrame& frame) {
  if (test.object) return test.object->describe(frame);
  if (!test.modes.empty()) return fmt::format("the mode is {}", name(frame.mode));
  return fmt::format("the score is {} : {}", frame.score[0], frame.score[1]);
}

std::string describe_expected(const StepTest& test) {
  std::vector<std::string> parts;
  if (test.object) {
    for (const auto& [what, expected] : test.object->quantities) {
      parts.push_back(
          fmt::format("{} {}", ObjectTest::Quantity::kNames.name(what), expected.text()));
    }
    if (!test.object->areas.empty()) {
      parts.push_back(fmt::format("in {}", fmt::join(test.object->areas, " or ")));
    }
    if (test.object->near) {
      const auto& near = *test.object->near;
      parts.push_back(fmt::format("within {} m of {}", near.within,
                                  near.object
                                      ? object_name(*near.object)
                                      : fmt::format("({}, {})", near.point.x, near.point.y)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  for (const soccer::PlayMode mode : test.modes) parts.emplace_back(name(mode));
  if (test.goals) parts.push_back(fmt::format("{} goals", *test.goals));
  if (test.touch_by) parts.emplace_back("a touch");

  return fmt::format("{}", fmt::join(parts, " or "));
}

std::string failure(const StepCheck& check, const RunRecord& record) {
  using How = CheckTiming::How;
  const CheckTiming& timing = check.timing;
  const StepFrame& last = record.frames.back();
  if (timing.how == How::kEnd) {
    if (check.test.holds(last, record)) return {};
    return fmt::format("at the end, {}: {}, not {}", when(last), describe(check.test, last),
                       describe_expected(check.test));
  }

  if (timing.how == How::kAt && last.step < timing.from) {
    return fmt::format("step {} not reached: the run ended at {}", timing.from, when(last));
  }

  const StepFrame* seen = nullptr;
  for (const StepFrame& frame : record.frames) {
    if (!is_at(timing, frame)) continue;
    seen = &frame;
    const bool holds = check.test.holds(frame, record);
    if (timing.how == How::kSometime && holds) return {};
    if (timing.how == How::kNever && holds) {
      return fmt::format("at {}: {}", when(frame), describe(check.test, frame));
    }
    if ((timing.how == How::kAlways || timing.how == How::kAt) && !holds) {
      return fmt::format("at {}: {}, not {}", when(frame), describe(check.test, frame),
                         describe_expected(check.test));
    }
  }

  if (seen == nullptr) {
    return fmt::format("no step at or after {}: the run ended at {}", timing.from, when(last));
  }
  if (timing.how != How::kSometime) return {};

  return fmt::format("never {}; at {}: {}", describe_expected(check.test), when(*seen),
                     describe(check.test, *seen));
}

std::string failure(const ScoreCheck& check, const RunRecord& record) {
  const std::array<int, 2>& score = record.frames.back().score;
  for (std::size_t side = 0; side < 2; ++side) {
    if (!check.goals[side] || check.goals[side]->holds(static_cast<double>(score[side]))) continue;
    return fmt::format("the score is {} : {}, not {} for the {}", score[0], score[1],
                       check.goals[side]->text(), side == 0 ? "left" : "right");
  }
  return {};
}

std::string failure(const RefereeCheck& check, const RunRecord& record) {
  std::vector<std::string> messages;
  double count = 0;
  for (const RefereeMessage& each : record.referee_messages) {
    if (each.message == check.message) ++count;
    messages.push_back(fmt::format("{} {}", each.step, each.message));
  }
  if (check.count.holds(count)) return {};
  return fmt::format("referee message {}: {} times, not {} (messages: {})", check.message, count,
                     check.count.text(), fmt::join(messages, ", "));
}

std::string failure(const TouchCheck& check, const RunRecord& record) {
  const auto one_of = [&](int slot) {
    return std::ranges::find(check.slots, slot) != check.slots.end();
  };
  if (check.which == TouchCheck::Which::kCount) {
    const auto count = std::ranges::count_if(
        record.touches, [&](const Touch& touch) { return one_of(touch.slot); });
    if (check.count.holds(static_cast<double>(count))) return {};
    return fmt::format("{} touched the ball {} times, not {}", check.who, count,
                       check.count.text());
  }
  if (record.touches.empty()) return "no player touched the ball";

  const bool first = check.which == TouchCheck::Which::kFirst;
  const Touch& touch = first ? record.touches.front() : record.touches.back();
  if (one_of(touch.slot)) return {};

  return fmt::format("the {} touch was by {} at step {}, not by {}", first ? "first" : "last",
                     object_name(touch.slot), touch.step, check.who);
}

bool concerns(const std::vector<int>& unums, int unum) {
  return unums.empty() || std::ranges::find(unums, unum) != unums.end();
}

std::string failure(const ActionCheck& check, const RunRecord& record) {
  const auto* fields = protos::PlayerAction::descriptor();
  double count = 0;
  for (const ReceivedReply& reply : record.replies[index_of(check.side)]) {
    if (!concerns(check.unums, reply.unum)) continue;
    if (reply.step < check.from || reply.step > check.to) continue;
    for (const protos::PlayerAction& action : reply.actions.actions()) {
      const auto* field = fields->FindFieldByNumber(action.action_case());
      const bool kind = check.kind == "*" || (field != nullptr && field->name() == check.kind);
      if (kind &&
          std::ranges::all_of(check.where, [&](const auto& each) { return each.holds(action); })) {
        ++count;
      }
      if (check.first_only) break;
    }
  }

  if (check.count.holds(count)) return {};

  return fmt::format("{} actions {} of the {} Playmaker, not {}", count, check.kind,
                     side_name(check.side), check.count.text());
}

const match::TeamResult& team_of(const RunRecord& record, Side side) {
  return side == Side::kRight ? record.result.right : record.result.left;
}

std::string failure(const CommandCheck& check, const RunRecord& record) {
  double count = 0;
  for (const match::PlayerResult& player : team_of(record, check.side).players) {
    if (!concerns(check.unums, player.unum)) continue;
    const auto found = player.commands.find(check.kind);
    if (found != player.commands.end()) count += static_cast<double>(found->second);
  }
  if (check.count.holds(count)) return {};
  return fmt::format("{} commands {} of the {} side, not {}", count, check.kind,
                     side_name(check.side), check.count.text());
}

std::string failure(const RpcCheck& check, const RunRecord& record) {
  return fmt::format("{}", fmt::join(record.rpc_failures.at(check.index), "; "));
}

double percentile(const match::RpcLatency& us, std::string_view which) {
  return which == "p50" ? us.p50 : which == "p95" ? us.p95 : which == "p99" ? us.p99 : us.max;
}

std::string failure(const LatencyCheck& check, const RunRecord& record) {
  constexpr double kMicrosecond = 1e-3;  // in ms
  for (const auto& [which, expected] : check.percentiles_ms) {
    double worst = 0.0;
    for (const match::PlayerResult& player : team_of(record, check.side).players) {
      worst = std::max(worst, percentile(player.rpc_us, which) * kMicrosecond);
    }
    if (!expected.holds(worst)) {
      return fmt::format("the {} latency of the slowest {} player is {:.2f} ms, not {}", which,
                         side_name(check.side), worst, expected.text());
    }
  }

  return {};
}

std::string failure(const MissedCheck& check, const RunRecord& record) {
  double missed = 0;
  for (const match::PlayerResult& player : team_of(record, check.side).players) {
    missed += static_cast<double>(player.missed);
  }
  if (check.count.holds(missed)) return {};

  const auto& error = team_of(record, check.side).errors.first;
  return fmt::format("{} missed decisions of the {} side, not {}{}", missed, side_name(check.side),
                     check.count.text(),
                     error ? fmt::format("; first error: {} of {} at cycle {}: {}: {}", error->rpc,
                                         proxy::agent_name(error->unum), error->cycle,
                                         error->status, error->message)
                           : "");
}

std::string failure(const EndCheck& check, const RunRecord& record) {
  const match::EndReason reason = record.result.end_reason;
  if (reason == check.reason) return {};
  const auto& failure = record.result.failure;
  const bool has_output = failure && !failure->output.empty();
  return fmt::format("the run ended as {}, not {}{}{}{}", name(reason), name(check.reason),
                     record.result.message.empty() ? "" : ": ", record.result.message,
                     has_output ? "; last output line: " + failure->output.back() : "");
}

std::string failure(const GoldenCheck& check, const RunRecord& record) {
  const std::string found = fingerprint(check, record);
  if (found == check.golden) return {};
  if (check.golden.empty()) return fmt::format("no golden value accepted yet; found {}", found);
  return fmt::format("{} is {}, golden value is {}", check.what, found, check.golden);
}

std::string hash(std::string_view bytes) { return fmt::format("{:016x}", base::fnv1a(bytes)); }

}  // namespace

bool ObjectTest::holds(const StepFrame& frame) const {
  const ObjectFrame& it = object_in(frame, object);
  for (const Quantity& quantity : quantities) {
    if (!quantity.expected.holds(value_of(it, quantity.what))) return false;
  }

  if (!areas.empty() && std::ranges::none_of(areas, [&](const std::string& area) {
        return soccer::is_in_area(area, it.position);
      })) {
    return false;
  }
  if (!near) return true;
  const soccer::Vec2 goal = near->object ? object_in(frame, *near->object).position : near->point;
  return distance(it.position, goal) <= near->within;
}

std::string ObjectTest::describe(const StepFrame& frame) const {
  const ObjectFrame& it = object_in(frame, object);
  std::string text =
      fmt::format("{} is at ({:.2f}, {:.2f})", object_name(object), it.position.x, it.position.y);
  for (const auto& [what, expected] : quantities) {
    if (what == Quantity::What::kX || what == Quantity::What::kY) continue;
    text += fmt::format(", {} {}", Quantity::kNames.name(what),
                        mock_server::to_text(value_of(it, what)));
  }
  if (near && near->object) {
    text += fmt::format(", {:.2f} m from {}",
                        distance(it.position, object_in(frame, *near->object).position),
                        object_name(*near->object));
  }

  return text;
}

bool StepTest::holds(const StepFrame& frame, const RunRecord& record) const {
  if (object) return object->holds(frame);
  if (!modes.empty()) return std::ranges::find(modes, frame.mode) != modes.end();
  if (goals) return frame.score[0] + frame.score[1] >= *goals;
  return std::ranges::any_of(record.touches, [&](const Touch& touch) {
    return touch.step == frame.step &&
           std::find(touch_by->begin(), touch_by->end(), touch.slot) != touch_by->end();
  });
}

std::string failure(const Check& check, const RunRecord& record) {
  return std::visit([&record](const auto& what) { return failure(what, record); }, check.what);
}

std::optional<Side> playmaker_of(const Check& check) {
  return std::visit(
      [](const auto& what) -> std::optional<Side> {
        using What = std::decay_t<decltype(what)>;
        if constexpr (requires { what.side; } && !std::is_same_v<What, MissedCheck>) {
          return what.side;
        } else {
          return std::nullopt;
        }
      },
      check.what);
}

std::string fingerprint(const GoldenCheck& check, const RunRecord& record) {
  if (check.what == "game_log") return hash(record.game_log);
  if (check.what == "score") {
    const StepFrame& last = record.frames.back();
    return fmt::format("{} : {} at step {}", last.score[0], last.score[1], last.step);
  }
  std::vector<std::string> touches;
  for (const Touch& touch : record.touches) {
    touches.push_back(fmt::format("{} {}", touch.step, object_name(touch.slot)));
  }
  return fmt::format("{}", fmt::join(touches, ", "));
}

}  // namespace cls::scenario
