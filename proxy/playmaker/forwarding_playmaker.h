// The base of Playmakers that watch or replace calls to another one.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Forwards all calls to `inner`, which must outlive the object.
class ForwardingPlaymaker : public Playmaker {
 public:
  explicit ForwardingPlaymaker(Playmaker& inner) : inner_(inner) {}

  void announce_team(TeamRegistration team) override { inner_.announce_team(std::move(team)); }
  void begin(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
             RpcTimeout timeout, bool wait_for_ready) override {
    inner_.begin(agent, rpc, request, timeout, wait_for_ready);
  }
  void send() override { inner_.send(); }
  Reply call(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
             RpcTimeout timeout) override {
    return inner_.call(agent, rpc, request, timeout);
  }
  bool take_connection_loss(int agent) override { return inner_.take_connection_loss(agent); }
  std::optional<Reply> next_reply() override { return received(inner_.next_reply()); }
  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    return received(inner_.next_reply_within(timeout));
  }
  std::string take_warning() override { return inner_.take_warning(); }
  void cancel() override { inner_.cancel(); }

 protected:
  /// A reply to a call that begin() started.
  virtual void on_reply(const Reply& /*reply*/) {}

 private:
  std::optional<Reply> received(std::optional<Reply> reply) {
    if (reply) on_reply(*reply);
    return reply;
  }

  Playmaker& inner_;
};

}  // namespace cls::proxy
