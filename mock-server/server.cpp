// Building and stopping the gRPC server.
#include "mock-server/server.h"

#include <fmt/format.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>

#include <chrono>
#include <utility>

#include "mock-server/service/team_responder.h"
#include "proto/grpc_settings.h"

namespace cls::mock_server {

using base::Error;
using base::Result;

Server::Server(Mock mock)
    : mock_(std::move(mock)),
      expectations_(mock_.expectations),
      handler_(*mock_.behavior, mock_.expectations.empty() ? nullptr : &expectations_),
      responder_(handler_, mock_.faults, mock_.die),
      service_(0, proto::kAgentRpcs, kStateMemory,
               [this](auto rpc, const auto& request, auto& reply, Workspace&) {
                 return responder_.respond(rpc, request, reply);
               }),
      team_service_(proto::kAgentRpcs, proto::kRpcs, kTeamMemory,
                    [this](auto rpc, const auto& request, auto& reply, Workspace& workspace) {
                      return respond_to_team(responder_, rpc, request, reply, workspace);
                    }) {}

Server::~Server() { stop(); }

Result<void> Server::listen(const std::string& address) {
  proto::apply_grpc_settings();

  grpc::ServerBuilder builder;
  builder.RegisterService(&service_);
  builder.RegisterService(&team_service_);

  // A second server on the same port must fail, not share it.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, proto::kTeamCallWindow);
  builder.SetMaxReceiveMessageSize(-1);

  if (!address.empty()) {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
    builder.AddListeningPort(address, grpc::InsecureServerCredentials(), &port_);
  }

  server_ = builder.BuildAndStart();
  if (server_ == nullptr || (!address.empty() && port_ == 0)) {
    return Error{fmt::format("the mock Playmaker cannot listen on {}", address)};
  }
  return {};
}

Result<std::unique_ptr<Server>> Server::start(Mock mock) {
  std::unique_ptr<Server> server(new Server(std::move(mock)));
  TRY(server->listen(""));
  return server;
}

Result<std::unique_ptr<Server>> Server::start(Mock mock, const std::string& host, int port) {
  std::unique_ptr<Server> server(new Server(std::move(mock)));
  TRY(server->listen(fmt::format("{}:{}", host, port)));
  return server;
}

std::shared_ptr<grpc::Channel> Server::in_process_channel() {
  grpc::ChannelArguments arguments;
  proto::limit_replies(arguments);  // as clients over a socket do
  return server_->InProcessChannel(arguments);
}

void Server::stop() {
  if (server_ != nullptr) server_->Shutdown(std::chrono::system_clock::now());
}

}  // namespace cls::mock_server
