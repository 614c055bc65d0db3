// The hand-shake of one agent with its Playmaker: which calls, in which order, what may fail.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <memory>
#include <string>

#include "proto/playmaker.pb.h"
#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/world/match_parameters.h"

namespace cls::proxy {

/// Register, SendServerParams, SendPlayerParams, SendPlayerType once per type, SendInitMessage
/// (proxy behaviour 1.2). Plain sequence: whoever makes the calls asks for the next one and tells
/// what came of it.
class Introduction {
 public:
  enum class Next : std::uint8_t {
    kCall,    ///< request() is the next call's
    kDone,    ///< the Playmaker knows the agent
    kFailed,  ///< it cannot be reached or does not speak the interface; the same call may be tried
              ///< again
  };

  Introduction(protos::RegisterRequest who, std::shared_ptr<const MatchParameters> parameters);

  proto::Rpc rpc() const;
  const google::protobuf::Message& request() const { return *request_; }

  /// What the call of now came to; `identity` is Register's answer. A Playmaker without Register
  /// (of the first interface) is given an identity of our making; one that fails at what it is only
  /// told is left in peace: see remark().
  Next take(const RpcStatus& status, const protos::RegisterResponse* identity);

  /// Valid once Register was answered.
  const protos::RegisterResponse& identity() const { return identity_; }
  /// Worth a warning about the latest call; empty: nothing is.
  const std::string& remark() const { return remark_; }
  /// Calls that were answered, of how many.
  std::size_t answered() const { return position_; }
  std::size_t calls() const { return parameters_->types.size() + 4; }

 private:
  void make_request();

  protos::RegisterRequest who_;
  std::shared_ptr<const MatchParameters> parameters_;
  protos::RegisterResponse identity_;
  std::unique_ptr<google::protobuf::Message> request_;
  std::size_t position_ = 0;
  std::string remark_;
};

}  // namespace cls::proxy
