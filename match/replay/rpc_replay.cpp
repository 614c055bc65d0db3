// Asking again and comparing.
#include "match/replay/rpc_replay.h"

#include <fmt/format.h>
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include "base/index.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/split.h"
#include "match/saved/saved_match.h"
#include "match/sides/agent_side.h"
#include "match/terms/match_options.h"
#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/playmaker/playmaker_errors.h"

namespace cls::match {
namespace {

using base::Error;
using base::Json;
using base::Result;
using google::protobuf::Message;
using proto::Rpc;
using recording::RecordedCall;
using soccer::Side;

// The side of all calls; nothing when both sides have some.
std::optional<Side> only_side(const std::string& file) {
  std::string error;
  const auto reader = proto::RecordingReader::open(file, error);
  std::optional<Side> side;
  RecordedCall call;
  while (reader != nullptr && reader->next(call)) {
    const Side caller = call.side() == side_number(Side::kRight) ? Side::kRight : Side::kLeft;
    if (side && *side != caller) return std::nullopt;
    side = caller;
  }
  return side;
}

Side side_to_ask(const ReplayOptions& options, const recording::RecordingHeader& header) {
  if (options.side) return *options.side;
  if (const auto side = only_side(options.file)) return *side;

  const bool left_is_mock = header.left_endpoint().starts_with("mock");
  const bool right_is_mock = header.right_endpoint().starts_with("mock");
  return left_is_mock && !right_is_mock ? Side::kRight : Side::kLeft;
}

// "modified: actions[0].dash.power: 100 -> 80" without its first word.
std::vector<std::string> differing_fields(const Message& recorded, const Message& now) {
  google::protobuf::util::MessageDifferencer differencer;
  std::string report;
  differencer.ReportDifferencesToString(&report);
  if (differencer.Compare(recorded, now)) return {};

  constexpr std::string_view kModified = "modified: ";
  std::vector<std::string> fields;
  for (std::string_view line : base::split(report, '\n')) {
    if (line.starts_with(kModified)) line.remove_prefix(kModified.size());
    if (!line.empty()) fields.emplace_back(line);
  }
  return fields;
}

int cycle_of(Rpc rpc, const RecordedCall& call) {
  protos::State state;
  if (!is_decision(rpc) || !state.ParseFromString(call.request())) return 0;
  return state.world_model().cycle();
}

// The handshake of an agent belongs to each of its decisions.
bool is_wanted(const ReplayOptions& options, const RecordedCall& call) {
  if (options.agent && call.agent() != *options.agent) return false;
  const auto rpc = proto::rpc_from_name(call.rpc());
  return !options.cycle || !rpc || !is_decision(*rpc) || cycle_of(*rpc, call) == *options.cycle;
}

// The selected calls, if they are not all: "player 7 in cycle 1234".
std::string selection(const ReplayOptions& options) {
  const std::string who = options.agent ? proxy::agent_name(*options.agent) : "the side";
  return options.cycle ? fmt::format("{} in cycle {}", who, *options.cycle) : who;
}

void move_by_agent(std::vector<ReplyDifference>& calls, std::vector<ReplyDifference>& out) {
  std::ranges::sort(calls, {}, &ReplyDifference::agent);
  std::ranges::move(calls, std::back_inserter(out));
  calls.clear();
}

class Replay {
 public:
  Replay(const ReplayOptions& options, proxy::Playmaker& playmaker, ReplayResult& result)
      : options_(options), playmaker_(playmaker), result_(result) {}

  // One call of the side; the error ends the replay.
  Result<void> take(const RecordedCall& call) {
    const auto rpc = proto::rpc_from_name(call.rpc());
    if (!rpc) return {};

    ++result_.calls;
    if (call.step() != step_) finish_step();
    step_ = call.step();

    std::unique_ptr<Message> request(proto::request_prototype(*rpc).New());
    if (!request->ParseFromString(call.request())) {
      result_.file_error = fmt::format("{}: call {} is damaged", options_.file, result_.calls);
      return {};
    }
    set_identity(*rpc, identities_.at(base::index(call.agent())), *request);
    if (is_decision(*rpc)) {
      asked_.at(base::index(call.agent())) = call;
      playmaker_.begin(call.agent(), *rpc, *request, proxy::RpcTimeout(options_.rpc_deadline_ms));
      return {};
    }
    finish_step();
    return ask(*rpc, call, *request);
  }

  void finish_step() {
    while (const auto reply = playmaker_.next_reply()) {
      const RecordedCall& call = asked_.at(base::index(reply->agent));
      compare(call, reply->message, reply->status);
    }
    move_by_agent(fresh_, result_.differences);
    move_by_agent(failing_, result_.failing);
  }

 private:
  Result<void> ask(Rpc rpc, const RecordedCall& call, const Message& request) {
    const proxy::RpcTimeout limit(static_cast<int>(options_.start_timeout_s * 1000));
    const proxy::Reply reply = playmaker_.call(call.agent(), rpc, request, limit);
    if (rpc == Rpc::kRegister) {
      if (!reply.status.ok() && reply.status.outcome != proxy::RpcOutcome::kUnimplemented) {
        return Error{reply.status.message};
      }
      const auto* identity = reply.as<protos::RegisterResponse>();
      identities_.at(base::index(call.agent())) =
          identity == nullptr ? protos::RegisterResponse() : *identity;
    }
    compare(call, reply.message, reply.status);
    finish_step();
    return {};
  }

  void compare(const RecordedCall& call, const Message* now, const proxy::RpcStatus& status) {
    const Rpc rpc = *proto::rpc_from_name(call.rpc());
    if (call.status() != 0) return compare_failed(rpc, call, status);
    std::unique_ptr<Message> recorded(proto::reply_prototype(rpc).New());
    recorded->ParseFromString(call.reply());

    // The Playmaker chooses the numbers of agents.
    if (rpc == Rpc::kRegister && now != nullptr) {
      static_cast<protos::RegisterResponse&>(*recorded).set_client_id(
          static_cast<const protos::RegisterResponse&>(*now).client_id());
    }

    std::vector<std::string> fields = now == nullptr
                                          ? std::vector<std::string>{"no reply: " + status.message}
                                          : differing_fields(*recorded, *now);
    if (!fields.empty()) return add(rpc, call, std::move(fields), fresh_);
    ++result_.same;
  }

  // An RPC that the Playmaker does not implement is as recorded if it still does not.
  void compare_failed(Rpc rpc, const RecordedCall& call, const proxy::RpcStatus& status) {
    if (status.outcome == proxy::RpcOutcome::kUnimplemented && call.status() == status.code) {
      ++result_.same;
      return;
    }

    ++result_.skipped;
    if (!status.ok()) {
      return add(rpc, call, {"fails as when recorded: " + status.message}, failing_);
    }
    ++result_.answered;
  }

  static void add(Rpc rpc, const RecordedCall& call, std::vector<std::string> fields,
                  std::vector<ReplyDifference>& out) {
    out.push_back({call.step(), cycle_of(rpc, call), call.agent(), call.rpc(), std::move(fields)});
  }

  const ReplayOptions& options_;
  proxy::Playmaker& playmaker_;
  ReplayResult& result_;
  int step_ = 0;
  std::array<protos::RegisterResponse, proxy::kAgentNumbers> identities_;
  std::array<RecordedCall, proxy::kAgentNumbers> asked_;
  std::vector<ReplyDifference> fresh_;
  std::vector<ReplyDifference> failing_;
};

// The Playmaker to ask; `host` becomes that of its programs.
Result<PlaymakerConnection> connect(const ReplayOptions& options, const ReplayResult& result,
                                    std::optional<process::ProcessHost>& host) {
  if (options.endpoint.starts_programs()) {
    TRY_INIT(auto created, process::ProcessHost::create());
    host.emplace(std::move(created));
  }

  SideSetup setup;
  setup.side = result.side;
  setup.name = result.side == Side::kLeft ? result.header.left_name() : result.header.right_name();
  setup.seed = result.header.seed();
  setup.folder = options.folder;
  setup.host = host ? &*host : nullptr;
  return connect_playmaker(options.endpoint, setup);
}

// Asks the calls that the options select, up to a signal or an error of the file.
Result<void> ask_all(const ReplayOptions& options, proto::RecordingReader& reader,
                     proxy::Playmaker& playmaker, const std::atomic<int>& stop_signal,
                     ReplayResult& result) {
  Replay replay(options, playmaker, result);
  RecordedCall call;
  bool any_decision = false;
  while (reader.next(call)) {
    result.interrupted = stop_signal.load() != 0;
    if (result.interrupted) break;
    if (call.side() != side_number(result.side) || !is_wanted(options, call)) continue;

    const auto rpc = proto::rpc_from_name(call.rpc());
    any_decision = any_decision || (rpc && is_decision(*rpc));
    TRY(replay.take(call));
    if (!result.file_error.empty()) return {};
  }

  replay.finish_step();
  result.file_error = reader.parse_error();
  const bool selects = options.cycle || options.agent;
  if (result.file_error.empty() && selects && !any_decision && !result.interrupted) {
    result.file_error = fmt::format("{}: no decision of {} of the {} side", options.file,
                                    selection(options), side_name(result.side));
  }
  return {};
}

Json json_of(const std::vector<ReplyDifference>& calls) {
  Json list = Json::array();
  for (const ReplyDifference& each : calls) {
    list.push_back({{"step", each.step},
                    {"cycle", each.cycle},
                    {"agent", each.agent},
                    {"rpc", each.rpc},
                    {"fields", each.fields}});
  }
  return list;
}

}  // namespace

Result<ReplayResult> replay_recording(const ReplayOptions& options,
                                      const std::atomic<int>& stop_signal) {
  ReplayResult result;
  const auto reader = proto::RecordingReader::open(options.file, result.file_error);
  if (reader == nullptr) return result;

  result.header = reader->header();
  result.side = side_to_ask(options, result.header);
  std::optional<process::ProcessHost> host;
  TRY_INIT(const auto connection, connect(options, result, host));
  TRY(ask_all(options, *reader, *connection.playmaker, stop_signal, result));
  return result;
}

std::string to_json(const ReplayResult& result) {
  Json json = {{"schema", "cls.replay/1"},  {"side", side_name(result.side)},
               {"calls", result.calls},     {"same", result.same},
               {"skipped", result.skipped}, {"different", result.differences.size()}};
  json["answered"] = result.answered;
  json["differences"] = json_of(result.differences);
  json["failing"] = json_of(result.failing);
  return base::json_document(json);
}

std::string to_text(const ReplayResult& result, std::size_t most) {
  std::string text;
  const auto list = [&](const std::vector<ReplyDifference>& calls) {
    for (const ReplyDifference& each : std::span(calls).first(std::min(most, calls.size()))) {
      text += fmt::format("cycle {} (step {}), {}, {}:\n", each.cycle, each.step,
                          proxy::agent_name(each.agent), each.rpc);
      for (const std::string& field : each.fields) text += fmt::format("    {}\n", field);
    }
    if (calls.size() > most) {
      text += fmt::format("... and {} more (--json has all)\n", calls.size() - most);
    }
  };
  list(result.differences);
  list(result.failing);

  text += fmt::format("{} calls of the {} side: {} replies as recorded, {} different", result.calls,
                      side_name(result.side), result.same, result.differences.size());
  if (result.skipped > 0) {
    text += fmt::format(
        ", {} skipped\n(no reply to compare with was recorded; now {} with a reply, {} without)",
        result.skipped, result.answered, result.failing.size());
  }
  return text + "\n";
}

}  // namespace cls::match
