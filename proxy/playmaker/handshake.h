// The handshake of one agent with its Playmaker: sequence of calls and tolerated failures.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "player/world/match_parameters.h"
#include "proto/playmaker.pb.h"
#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Register, SendServerParams, SendPlayerParams, SendPlayerType once per type, SendInitMessage
/// (docs/spec/proxy-behavior.md 1.2). Makes no calls: the user sends request() and passes each
/// reply to handle_reply().
class Handshake {
 public:
  enum class Next : std::uint8_t {
    kCall,      ///< send request()
    kComplete,  ///< the agent is registered
    kFailed,    ///< unreachable, late or not of this interface; the same call may be repeated
  };

  Handshake(protos::RegisterRequest registration,
            std::shared_ptr<const player::MatchParameters> parameters);

  proto::Rpc rpc() const;
  const google::protobuf::Message& request() const { return *request_; }

  /// A Playmaker of the first interface, without Register, gets an identity built from the
  /// request. Errors of the calls after Register are tolerated: see warning().
  Next handle_reply(const Reply& reply);

  /// Valid after the reply to Register.
  const protos::RegisterResponse& identity() const { return identity_; }
  /// Warning about the latest reply; empty: none.
  const std::string& warning() const { return warning_; }
  std::size_t completed_calls() const { return position_; }
  std::size_t calls() const { return parameters_->types.size() + 4; }

 private:
  void make_request();

  protos::RegisterRequest registration_;
  std::shared_ptr<const player::MatchParameters> parameters_;
  protos::RegisterResponse identity_;
  std::unique_ptr<google::protobuf::Message> request_;
  std::size_t position_ = 0;
  std::string warning_;
};

}  // namespace cls::proxy
