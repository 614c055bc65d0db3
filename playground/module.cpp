// What the WebAssembly module exports and imports; playground/web/engine.js is its other side.
//
// A call that gives bytes returns their number, and output() their place, until the next call.
#include <google/protobuf/descriptor.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "base/text/json.h"
#include "league/matches/fixture.h"
#include "mock-server/behavior/behavior.h"
#include "mock-server/service/request_handler.h"
#include "playground/match.h"
#include "playground/verdict.h"
#include "proto/state_writer.h"
#include "proto/status_name.h"
#include "soccer/play_mode.h"

#define CLS_EXPORT(function) __attribute__((export_name(#function), used))

/// Decides for a team: `side` 0 is the left one, `rpc` a value of proto::Rpc, `state` a serialized
/// State. Returns 0 and leaves the serialized reply in reply_buffer(), or returns a status code of
/// gRPC and leaves a line of text there.
__attribute__((import_module("cls"), import_name("decide"))) extern "C" int cls_decide(
    int side, int rpc, const char* state, std::size_t size);

namespace cls::playground {
namespace {

using base::Json;
using soccer::Side;

/// Decides nothing: decisions go to the page. It answers the other calls.
class NoBehavior : public mock_server::Behavior {
 public:
  void decide(const protos::State&, protos::PlayerActions&) const override {}
};

/// A team whose decisions the page makes.
class PageTeam {
 public:
  explicit PageTeam(Side side) : side_(side) {}

  proxy::RpcStatus answer(proto::Rpc rpc, const google::protobuf::Message& request,
                          google::protobuf::Message& reply);

 private:
  Side side_;
  NoBehavior behavior_;
  mock_server::RequestHandler handler_{behavior_, nullptr};
  proto::StateWriter writer_;
};

/// A match with the page's teams.
struct PageMatch {
  std::shared_ptr<PageTeam> left = std::make_shared<PageTeam>(Side::kLeft);
  std::shared_ptr<PageTeam> right = std::make_shared<PageTeam>(Side::kRight);
  std::unique_ptr<Match> match;
};

// A module has no threads, so what calls share needs no lock.
struct Shared {
  std::string input;
  std::string output;
  std::string reply;
  std::map<int, PageMatch> matches;
  int next = 1;
};

Shared& shared() {
  static Shared the;
  return the;
}

proxy::RpcStatus PageTeam::answer(proto::Rpc rpc, const google::protobuf::Message& request,
                                  google::protobuf::Message& reply) {
  if (!is_decision(rpc)) {
    handler_.handle(rpc, request, reply);
    return {};
  }

  const std::string_view state =
      writer_.write(static_cast<const protos::State&>(request), proto::StateForm::kWhole);
  const int code = cls_decide(static_cast<int>(soccer::side_index(side_)), static_cast<int>(rpc),
                              state.data(), state.size());
  const std::string& bytes = shared().reply;
  if (code != proto::kStatusOk) return proxy::rpc_status(rpc, code, bytes);
  if (reply.ParseFromString(bytes)) return {};
  return {proxy::RpcOutcome::kProtocolError, proto::kStatusOk,
          std::string(name(rpc)) + ": the reply does not parse"};
}

std::size_t give(std::string bytes) {
  shared().output = std::move(bytes);
  return shared().output.size();
}

proxy::FallibleHandler handler_of(const std::shared_ptr<PageTeam>& team) {
  return [team](proto::Rpc rpc, const google::protobuf::Message& request,
                google::protobuf::Message& reply) { return team->answer(rpc, request, reply); };
}

std::string status_of(Match& match) {
  const simulator::World& world = match.world();
  const auto team = [&](Side side) {
    return Json{{"name", world.team(side).name.view()}, {"score", world.team(side).score}};
  };
  Json warnings = Json::array();
  for (std::string& line : match.take_warnings()) warnings.push_back(std::move(line));
  return Json{{"cycle", world.clock.time},      {"mode", name(world.mode)},
              {"over", match.over()},           {"left", team(Side::kLeft)},
              {"right", team(Side::kRight)},    {"failure", match.failure()},
              {"warnings", std::move(warnings)}}
      .dump();
}

Json schema_of(const google::protobuf::FieldDescriptor& field) {
  const google::protobuf::Descriptor* message = field.message_type();
  Json row = {{"number", field.number()},
              {"name", field.name()},
              {"type", field.type_name()},
              {"repeated", field.is_repeated()},
              {"map", field.is_map()}};
  if (message != nullptr) row["of"] = message->full_name();
  if (field.enum_type() != nullptr) row["of"] = field.enum_type()->full_name();
  if (field.containing_oneof() != nullptr) row["oneof"] = field.containing_oneof()->name();
  return row;
}

void add_schema(const google::protobuf::EnumDescriptor& type, Json& schema) {
  Json values = Json::object();
  for (int i = 0; i < type.value_count(); ++i)
    values[type.value(i)->name()] = type.value(i)->number();
  schema["enums"][type.full_name()] = std::move(values);
}

void add_schema(const google::protobuf::Descriptor& type, Json& schema) {
  Json fields = Json::array();
  for (int i = 0; i < type.field_count(); ++i) fields.push_back(schema_of(*type.field(i)));
  schema["messages"][type.full_name()] = std::move(fields);
  for (int i = 0; i < type.nested_type_count(); ++i) add_schema(*type.nested_type(i), schema);
  for (int i = 0; i < type.enum_type_count(); ++i) add_schema(*type.enum_type(i), schema);
}

// All messages and enumerations of playmaker.proto.
Json wire_schema() {
  const google::protobuf::FileDescriptor& file = *protos::State::descriptor()->file();
  Json schema = {{"messages", Json::object()}, {"enums", Json::object()}};
  for (int i = 0; i < file.message_type_count(); ++i) add_schema(*file.message_type(i), schema);
  for (int i = 0; i < file.enum_type_count(); ++i) add_schema(*file.enum_type(i), schema);
  return schema;
}

}  // namespace

extern "C" {

/// Room for the bytes that the next call reads.
CLS_EXPORT(input_buffer) char* input_buffer(std::size_t size) {
  shared().input.resize(size);
  return shared().input.data();
}

/// Room for the reply of a decision.
CLS_EXPORT(reply_buffer) char* reply_buffer(std::size_t size) {
  shared().reply.resize(size);
  return shared().reply.data();
}

/// Bytes of the last output; of an error, whose call returns no number of bytes.
CLS_EXPORT(output_size) std::size_t output_size() { return shared().output.size(); }

CLS_EXPORT(output) const char* output() { return shared().output.data(); }

/// The messages of the wire, as playground/web/messages.js reads them.
CLS_EXPORT(message_schema) std::size_t message_schema() { return give(wire_schema().dump()); }

/// The seed of a pair of matches, counted from 1, in `cls compare --seed SEED`.
CLS_EXPORT(pair_seed) double pair_seed(double seed, int pair) {
  return static_cast<double>(league::pairing_seed(static_cast<std::uint64_t>(seed), pair));
}

/// The verdict on the pairs in input_buffer() (verdict.h); 0 and an error as output.
CLS_EXPORT(judge_pairs) int judge_pairs() {
  const auto verdict = verdict_json(shared().input);
  give(verdict ? *verdict : verdict.error().message);
  return verdict ? 1 : 0;
}

/// Starts a match from the setup in input_buffer(): its number, or 0 and an error as output.
CLS_EXPORT(create_match) int create_match() {
  const auto setup = parse_setup(shared().input);
  if (!setup) return give(setup.error().message), 0;

  PageMatch made;
  auto match = Match::create(*setup, {handler_of(made.left), handler_of(made.right)});
  if (!match) return give(match.error().message), 0;
  made.match = *std::move(match);
  const int number = shared().next++;
  shared().matches.emplace(number, std::move(made));
  return number;
}

CLS_EXPORT(play_match) int play_match(int number, int steps) {
  return shared().matches.at(number).match->play(steps) ? 1 : 0;
}

CLS_EXPORT(take_game_log) std::size_t take_game_log(int number) {
  return give(shared().matches.at(number).match->take_game_log());
}

CLS_EXPORT(take_text_log) std::size_t take_text_log(int number) {
  return give(shared().matches.at(number).match->take_text_log());
}

CLS_EXPORT(take_view) std::size_t take_view(int number) {
  return give(shared().matches.at(number).match->take_view());
}

/// Of the left side (0) or the right one (1).
CLS_EXPORT(take_decisions) std::size_t take_decisions(int number, int side) {
  return give(
      shared().matches.at(number).match->take_decisions(side == 0 ? Side::kLeft : Side::kRight));
}

/// The state of the match as JSON: cycle, mode, over, left and right with name and score, failure,
/// and the warnings since the last call.
CLS_EXPORT(match_status) std::size_t match_status(int number) {
  return give(status_of(*shared().matches.at(number).match));
}

CLS_EXPORT(destroy_match) void destroy_match(int number) { shared().matches.erase(number); }

}  // extern "C"

}  // namespace cls::playground
