// Starting servers and talking to them.
#include "tests/simulator/real_host.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/real_server.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using simulator::Door;
using std::chrono::milliseconds;

class RealHost : public Host {
 public:
  RealHost(std::vector<std::string> words, const std::vector<std::string>& settings) {
    for (int& port : ports_) port = free_udp_port();
    for (const std::string& word :
         {"server::port=" + std::to_string(ports_[0]),
          "server::coach_port=" + std::to_string(ports_[1]),
          "server::olcoach_port=" + std::to_string(ports_[2]),
          std::string("server::game_logging=off"), std::string("server::text_logging=off")}) {
      words.push_back(word);
    }
    words.insert(words.end(), settings.begin(), settings.end());
    const std::string path = folder_.path();
    server_ = std::make_unique<Command>(
        words, std::vector<std::string>{"RCSS_CONF_DIR=" + path + "/conf", "USER=nobody"}, path);
    wait_for_start();
  }

  ~RealHost() override {
    server_->send_signal(SIGTERM);
    server_->finish();
  }

  void send(const std::string& client, const std::string& datagram) override {
    auto& socket = clients_[client];
    if (socket == nullptr) socket = std::make_unique<UdpClient>(port(door_of(client)));
    socket->send(datagram);
    spoken_ = Time::now();
  }

  void pass_cycles(int count) override {
    std::this_thread::sleep_for(milliseconds(100 * count + 20));
    spoken_ = Time::now();
  }

  // A server that has all to say is given a moment to say too much.
  std::vector<std::string> take(const std::string& client, std::size_t expected,
                                const std::vector<std::string>& shown) override {
    const auto patience = Time::now() + milliseconds(expected > 0 ? 1000 : 0);
    auto moment = spoken_ + milliseconds(30);
    std::vector<std::string> told;
    while (true) {
      const auto now = Time::now();
      const bool waits = now < moment || (told.size() < expected && now < patience);
      const std::string message = clients_[client]->wait(milliseconds(waits ? 10 : 0));
      if (message.empty() && !waits) return told;
      if (message.empty()) continue;
      note(client, message);
      if (!counts(message, shown)) continue;
      told.push_back(message);
      moment = std::max(moment, now + milliseconds(10));
    }
  }

  std::vector<std::string> clients() const override {
    std::vector<std::string> names;
    for (const auto& [name, client] : clients_) names.push_back(name);
    return names;
  }

 private:
  int port(Door door) const { return ports_[static_cast<std::size_t>(door)]; }

  void wait_for_start() {
    for (int i = 0; i < 200; ++i) {
      UdpClient probe(port(Door::kGame));
      probe.send("(anybody)");
      if (probe.wait(milliseconds(50)) == "(error unknown_command)") return;
      std::this_thread::sleep_for(milliseconds(20));
    }
    throw std::runtime_error("the server does not start: " + server_->out());
  }

  using Time = std::chrono::steady_clock;

  Time::time_point spoken_;  ///< when something was last done
  TemporaryFolder folder_;
  int ports_[3] = {};
  std::unique_ptr<Command> server_;
  std::map<std::string, std::unique_ptr<UdpClient>> clients_;
};

}  // namespace

std::unique_ptr<Host> make_real_host(const std::vector<std::string>& command,
                                     const std::vector<std::string>& settings) {
  return std::make_unique<RealHost>(command, settings);
}

}  // namespace cls::tests
