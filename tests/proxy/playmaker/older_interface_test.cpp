// Playmakers of older interfaces, which lack the newer fields and RPCs.
#include <gmock/gmock.h>
#include <google/protobuf/dynamic_message.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "proto/rpc.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "tests/proxy/agent/scripted_server.h"
#include "tests/proxy/playmaker/playmaker_server.h"

namespace cls::proxy {
namespace {

using google::protobuf::DescriptorProto;
using google::protobuf::FileDescriptorProto;
using google::protobuf::Message;
using proto::Rpc;
using testing::HasSubstr;
using tests::ScriptedServer;

/// Interface versions; 0 is the first one, without Register.
enum Version { kFirst = 0, kV7 = 7, kV9 = 9 };

using Fields = std::map<std::string, std::set<int>>;

// Fields added by each version (docs/spec/playmaker-wire.md 1.2).
const Fields kSinceV10 = {{"Player", {32}}};
const Fields kSinceV9 = {{"PenaltyKickState", {8}},
                         {"Player", {31}},
                         {"Self", {42}},
                         {"PlayerAction", {67, 68, 69}},
                         {"ServerParam", {227}}};
const Fields kSinceV7 = {{"Self", {37, 38, 39, 40, 41}},
                         {"WorldModel", {32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42}},
                         {"State", {4}},
                         {"HeliosOffensivePlanner", {10, 11, 12, 13}},
                         {"PlayerAction", {65, 66}},
                         {"PlayerActions", {2, 3, 4, 5, 6}},
                         {"ServerParam", {223, 224, 225, 226}}};

void remove(FileDescriptorProto& file, const Fields& fields) {
  for (DescriptorProto& message : *file.mutable_message_type()) {
    const auto found = fields.find(message.name());
    if (found == fields.end()) continue;
    const std::size_t before = static_cast<std::size_t>(message.field_size());
    auto& list = *message.mutable_field();
    list.erase(
        std::remove_if(list.begin(), list.end(),
                       [&](const auto& field) { return found->second.count(field.number()) > 0; }),
        list.end());
    EXPECT_EQ(before - static_cast<std::size_t>(message.field_size()), found->second.size())
        << message.name();
  }
}

// In the first interface, field 1 of requests was the agent type.
void give_agent_type(FileDescriptorProto& file) {
  for (DescriptorProto& message : *file.mutable_message_type()) {
    for (auto& field : *message.mutable_field()) {
      if (field.name() != "register_response" || field.number() != 1) continue;
      field.set_name("agent_type");
      field.set_json_name("agentType");
      field.set_type(google::protobuf::FieldDescriptorProto::TYPE_ENUM);
      field.set_type_name(".protos.AgentType");
    }
  }
}

/// The messages of an older interface.
class OlderMessages {
 public:
  explicit OlderMessages(Version version) {
    FileDescriptorProto file;
    protos::State::descriptor()->file()->CopyTo(&file);
    file.clear_service();
    remove(file, kSinceV10);
    if (version < kV9) remove(file, kSinceV9);
    if (version < kV7) remove(file, kSinceV7);
    if (version < kV7) give_agent_type(file);
    EXPECT_NE(pool_.BuildFile(file), nullptr);
  }
  std::unique_ptr<Message> make(const std::string& name) {
    const auto* type = pool_.FindMessageTypeByName("protos." + name);
    return std::unique_ptr<Message>(factory_.GetPrototype(type)->New());
  }

 private:
  google::protobuf::DescriptorPool pool_;
  google::protobuf::DynamicMessageFactory factory_;
};

int number_in(const Message& message, const std::string& name) {
  return message.GetReflection()->GetInt32(message, message.GetDescriptor()->FindFieldByName(name));
}

const Message& part_of(const Message& message, const std::string& name) {
  return message.GetReflection()->GetMessage(message,
                                             message.GetDescriptor()->FindFieldByName(name));
}

/// A Playmaker that knows only those messages.
class OlderPlaymaker : public grpc::CallbackGenericService {
 public:
  explicit OlderPlaymaker(Version version) : version_(version), messages_(version) {}

  int decisions() const { return decisions_; }
  int unreadable() const { return unreadable_; }
  int strangers() const { return strangers_; }

 private:
  class Reactor : public grpc::ServerGenericBidiReactor {
   public:
    Reactor(OlderPlaymaker& playmaker, std::string method)
        : playmaker_(playmaker), method_(std::move(method)) {
      StartRead(&request_);
    }
    void OnReadDone(bool ok) override {
      if (!ok) return;
      grpc::Slice bytes;
      request_.DumpToSingleSlice(&bytes);
      std::string answer;
      const grpc::Status status =
          playmaker_.answer(method_, std::string(bytes.begin(), bytes.end()), answer);
      const grpc::Slice slice(answer);
      answer_ = grpc::ByteBuffer(&slice, 1);

      if (status.ok()) {
        StartWriteAndFinish(&answer_, grpc::WriteOptions(), status);
      } else {
        Finish(status);
      }
    }
    void OnDone() override { delete this; }

   private:
    OlderPlaymaker& playmaker_;
    std::string method_;
    grpc::ByteBuffer request_;
    grpc::ByteBuffer answer_;
  };

  grpc::ServerGenericBidiReactor* CreateReactor(
      grpc::GenericCallbackServerContext* context) override {
    return new Reactor(*this, context->method().substr(std::string("/protos.Game/").size()));
  }

  grpc::Status answer(const std::string& method, const std::string& bytes, std::string& reply) {
    const Rpc rpc = *proto::rpc_from_name(method);
    if (version_ == kFirst && (rpc == Rpc::kRegister || rpc == Rpc::kSendByeCommand)) {
      return {grpc::StatusCode::UNIMPLEMENTED, "no such method"};
    }
    const auto request = messages_.make(proto::request_prototype(rpc).GetDescriptor()->name());
    if (!request->ParseFromString(bytes)) ++unreadable_;
    const auto answer = messages_.make(proto::reply_prototype(rpc).GetDescriptor()->name());

    if (rpc == Rpc::kRegister) {
      answer->GetReflection()->SetInt32(answer.get(),
                                        answer->GetDescriptor()->FindFieldByName("client_id"),
                                        900 + number_in(*request, "uniform_number"));
    }

    if (rpc == Rpc::kGetPlayerActions) decide(*request, *answer);
    reply = answer->SerializeAsString();
    return grpc::Status::OK;
  }

  void decide(const Message& state, Message& actions) {
    ++decisions_;
    if (version_ != kFirst) {
      const int id = number_in(part_of(state, "register_response"), "client_id");
      if (id <= 900 || id > 911) ++strangers_;
    }
    if (number_in(part_of(state, "world_model"), "cycle") < 1) ++strangers_;
    const auto* list = actions.GetDescriptor()->FindFieldByName("actions");
    Message* action = actions.GetReflection()->AddMessage(&actions, list);
    const auto* dash_field = action->GetDescriptor()->FindFieldByName("dash");
    Message* dash = action->GetReflection()->MutableMessage(action, dash_field);
    dash->GetReflection()->SetFloat(dash, dash->GetDescriptor()->FindFieldByName("power"), 44.0F);
  }

  Version version_;
  OlderMessages messages_;
  std::atomic<int> decisions_{0};
  std::atomic<int> unreadable_{0};
  std::atomic<int> strangers_{0};
};

class OlderInterface : public testing::TestWithParam<Version> {};
INSTANTIATE_TEST_SUITE_P(, OlderInterface, testing::Values(kFirst, kV7, kV9),
                         [](const auto& version) { return "V" + std::to_string(version.param); });

TEST_P(OlderInterface, PlaysFromRegisterToBye) {
  constexpr int kCycles = 5;
  OlderPlaymaker older(GetParam());
  tests::PlaymakerServer of_playmaker(older);
  const auto playmaker = make_grpc_playmaker(tests::loopback(of_playmaker.port()));
  ScriptedServer server;
  TeamOptions options;
  options.name = "us";
  Team team(options, *playmaker);
  server.admit(team);

  for (int cycle = 1; cycle <= kCycles; ++cycle) {
    server.send_cycle(cycle);
    EXPECT_EQ(team.run_cycle(), 11);
  }

  team.leave();
  EXPECT_EQ(older.decisions(), 11 * kCycles);
  EXPECT_EQ(older.unreadable(), 0);
  EXPECT_EQ(older.strangers(), 0);

  for (const auto& player : team.players()) {
    EXPECT_EQ(player->statistics().missed, 0) << player->statistics().last_failure.message;
    EXPECT_EQ(player->identity().client_id(), GetParam() == kFirst ? 0 : 900 + player->unum());
    const auto said = server.take(player->unum());
    EXPECT_THAT(said.front(), HasSubstr("(dash 44)"));
  }

  EXPECT_EQ(team.take_warnings().size(), GetParam() == kFirst ? 1U : 0U);
}

}  // namespace
}  // namespace cls::proxy
