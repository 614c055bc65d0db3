// Building and stopping the gRPC server.
#include "mock-server/server.h"

#include <fmt/format.h>

#include <chrono>

namespace cls::mock_server {

using soccer::Error;
using soccer::Result;

Server::Server(std::unique_ptr<Behaviour> behaviour)
    : behaviour_(std::move(behaviour)), service_(*behaviour_) {}

Server::~Server() { stop(); }

Result<void> Server::listen(const std::string& address) {
  grpc::ServerBuilder builder;
  builder.RegisterService(&service_);
  // A second server on the same port must fail, not share it.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  if (!address.empty()) {
    grpc::EnableDefaultHealthCheckService(true);
    builder.AddListeningPort(address, grpc::InsecureServerCredentials(), &port_);
  }
  server_ = builder.BuildAndStart();
  if (server_ == nullptr || (!address.empty() && port_ == 0)) {
    return Error{fmt::format("the mock Playmaker cannot listen on {}", address)};
  }
  return {};
}

Result<std::unique_ptr<Server>> Server::start(std::unique_ptr<Behaviour> behaviour) {
  std::unique_ptr<Server> server(new Server(std::move(behaviour)));
  const auto listening = server->listen("");
  if (!listening) return listening.error();
  return server;
}

Result<std::unique_ptr<Server>> Server::start(std::unique_ptr<Behaviour> behaviour,
                                              const std::string& host, int port) {
  std::unique_ptr<Server> server(new Server(std::move(behaviour)));
  const auto listening = server->listen(fmt::format("{}:{}", host, port));
  if (!listening) return listening.error();
  return server;
}

std::shared_ptr<grpc::Channel> Server::in_process_channel() {
  return server_->InProcessChannel(grpc::ChannelArguments());
}

void Server::stop() {
  if (server_ != nullptr) server_->Shutdown(std::chrono::system_clock::now());
}

}  // namespace cls::mock_server
