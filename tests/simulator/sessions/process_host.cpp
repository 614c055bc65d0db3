// Starts a server process and exchanges datagrams with it.
#include "tests/simulator/sessions/process_host.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using simulator::ListeningPort;
using std::chrono::milliseconds;

class ProcessHost : public Host {
 public:
  ProcessHost(std::vector<std::string> arguments, const std::vector<std::string>& settings) {
    for (int& port : ports_) port = free_udp_port();
    for (const std::string& argument :
         {"server::port=" + std::to_string(ports_[0]),
          "server::coach_port=" + std::to_string(ports_[1]),
          "server::olcoach_port=" + std::to_string(ports_[2]),
          std::string("server::game_logging=off"), std::string("server::text_logging=off")}) {
      arguments.push_back(argument);
    }

    arguments.insert(arguments.end(), settings.begin(), settings.end());
    const std::string path = folder_.path();
    server_ = std::make_unique<Command>(
        arguments, std::vector<std::string>{"RCSS_CONF_DIR=" + path + "/conf", "USER=nobody"},
        path);
    wait_for_start();
  }

  ~ProcessHost() override {
    server_->send_signal(SIGTERM);
    server_->finish();
  }

  void send(const std::string& client, const std::string& datagram) override {
    auto& socket = clients_[client];
    if (socket == nullptr) socket = std::make_unique<UdpClient>(port(port_of(client)));
    socket->send(datagram);
    last_action_ = Time::now();
  }

  void pass_cycles(int count) override {
    std::this_thread::sleep_for(milliseconds(100 * count + 20));
    last_action_ = Time::now();
  }

  // After the expected messages, waits a little longer for unexpected ones.
  std::vector<std::string> receive(const std::string& client, std::size_t expected,
                                   const std::vector<std::string>& included) override {
    const auto timeout = Time::now() + milliseconds(expected > 0 ? 1000 : 0);
    auto quiet_until = last_action_ + milliseconds(30);
    std::vector<std::string> messages;

    while (true) {
      const auto now = Time::now();
      const bool waits = now < quiet_until || (messages.size() < expected && now < timeout);
      const std::string message = clients_[client]->wait(milliseconds(waits ? 10 : 0));
      if (message.empty() && !waits) return messages;
      if (message.empty()) continue;
      record(client, message);
      if (!is_relevant(message, included)) continue;
      messages.push_back(message);
      quiet_until = std::max(quiet_until, now + milliseconds(10));
    }
  }

  std::vector<std::string> clients() const override {
    std::vector<std::string> names;
    for (const auto& [name, client] : clients_) names.push_back(name);
    return names;
  }

 private:
  int port(ListeningPort role) const { return ports_[static_cast<std::size_t>(role)]; }

  void wait_for_start() {
    for (int i = 0; i < 200; ++i) {
      UdpClient probe(port(ListeningPort::kPlayers));
      probe.send("(probe)");
      if (probe.wait(milliseconds(50)) == "(error unknown_command)") return;
      std::this_thread::sleep_for(milliseconds(20));
    }
    throw std::runtime_error("the server does not start: " + server_->out());
  }

  using Time = std::chrono::steady_clock;

  Time::time_point last_action_;  ///< time of the last datagram or pause
  TemporaryFolder folder_;
  int ports_[3] = {};
  std::unique_ptr<Command> server_;
  std::map<std::string, std::unique_ptr<UdpClient>> clients_;
};

}  // namespace

std::unique_ptr<Host> make_process_host(const std::vector<std::string>& command,
                                        const std::vector<std::string>& settings) {
  return std::make_unique<ProcessHost>(command, settings);
}

}  // namespace cls::tests
