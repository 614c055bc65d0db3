// One socket per agent, all polled together.
#include "proxy/playmaker/thrift_playmaker.h"

#include <grpcpp/support/status.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <thread>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/system/tcp_connect.h"
#include "base/system/unique_fd.h"
#include "proxy/playmaker/replies.h"
#include "proxy/playmaker/thrift_wire.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;
using Clock = std::chrono::steady_clock;
using Time = Clock::time_point;
using std::chrono::milliseconds;

// Poll interval of a waiting thread for cancel().
constexpr milliseconds kCancelPoll{50};
// Between attempts to connect to a Playmaker that is starting.
constexpr milliseconds kConnectInterval{100};
constexpr milliseconds kConnectTimeout{100};

Time deadline_after(RpcTimeout timeout) {
  return timeout == kNoTimeout ? Time::max() : Clock::now() + timeout;
}

/// The connection of an agent, and its call in flight.
struct Connection {
  base::UniqueFd fd;
  std::string received;  ///< of a reply that has not arrived completely
  std::string sent;      ///< reused
  ReplyMemory memory;
  std::int32_t sequence = 0;
  bool answered = false;  ///< over the current connection
  bool lost = false;      ///< not yet returned by take_connection_loss()

  bool busy = false;
  Rpc rpc = Rpc::kRegister;
  Time begun;
  Time deadline;
};

class ThriftPlaymaker : public Playmaker {
 public:
  explicit ThriftPlaymaker(GrpcTarget target) : target_(std::move(target)) {}

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool /*wait_for_ready*/) override {
    start(agent, rpc, request, deadline_after(timeout), Clock::now() + kConnectTimeout);
  }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    assert(outstanding() == 0 && "blocking calls do not mix with outstanding ones");
    const Time deadline = deadline_after(timeout);
    const bool registers = proto::is_registration(rpc);
    start(agent, rpc, request, deadline, registers ? deadline : Clock::now() + kConnectTimeout);
    return *wait(Time::max(), rpc != Rpc::kSendByeCommand);
  }

  bool take_connection_loss(int agent) override {
    Connection& one = of(agent);
    if (one.fd && !one.busy) notice_end(one);
    return std::exchange(one.lost, false);
  }

  std::optional<Reply> next_reply() override { return wait(Time::max(), true); }
  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    return wait(Clock::now() + timeout, true);
  }
  void cancel() override { cancelled_ = true; }

 private:
  Connection& of(int agent) { return connections_.at(base::index(agent)); }
  std::string who(int agent) const { return address(target_, std::max(agent, 1)); }

  std::size_t outstanding() const {
    return base::index(std::ranges::count(connections_, true, &Connection::busy)) + failed_.size();
  }

  void fail(int agent, Rpc rpc, grpc::StatusCode code, const std::string& text) {
    failed_.push_back(failed_reply(agent, rpc, rpc_status(rpc, code, who(agent) + ": " + text)));
  }

  // Connects if needed, and sends the call; a failure becomes a reply.
  void start(int agent, Rpc rpc, const Message& request, Time deadline, Time connect_until) {
    if (cancelled_ && rpc != Rpc::kSendByeCommand) {
      failed_.push_back(cancelled_reply(agent, rpc));
      return;
    }
    if (static_cast<int>(rpc) >= proto::kAgentRpcs) {
      return fail(agent, rpc, grpc::StatusCode::UNIMPLEMENTED, "Thrift has no call for a team");
    }

    Connection& one = of(agent);
    if (!one.fd && !connect(one, agent, rpc, connect_until)) return;
    one.sent.clear();
    append_thrift_call(name(rpc), ++one.sequence, request, one.sent);
    one.rpc = rpc;
    one.begun = Clock::now();
    one.deadline = deadline;

    if (send_all(one)) {
      one.busy = true;
    } else {
      lose(one);
      fail(agent, rpc, grpc::StatusCode::UNAVAILABLE, "connection lost");
    }
  }

  bool connect(Connection& one, int agent, Rpc rpc, Time until) {
    const int port = port_of(target_, agent);
    for (;;) {
      one.fd =
          base::connect_tcp(target_.host, port, std::min(until, Clock::now() + kConnectTimeout));
      if (one.fd) break;

      if (cancelled_) {
        failed_.push_back(cancelled_reply(agent, rpc));
        return false;
      }
      if (Clock::now() + kConnectInterval >= until) {
        fail(agent, rpc, grpc::StatusCode::UNAVAILABLE, "nothing listens there");
        return false;
      }
      std::this_thread::sleep_for(kConnectInterval);
    }

    const int on = 1;
    ::setsockopt(one.fd.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    one.received.clear();
    one.answered = false;
    return true;
  }

  // A request is larger than the buffer of a socket may be.
  bool send_all(Connection& one) const {
    std::string_view rest = one.sent;
    while (!rest.empty()) {
      const ssize_t sent = ::send(one.fd.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
      if (sent > 0) {
        rest.remove_prefix(static_cast<std::size_t>(sent));
      } else if (errno == EAGAIN || errno == EINTR) {
        if (cancelled_ || Clock::now() >= one.deadline) return false;
        base::wait_for_events(one.fd.get(), POLLOUT, Clock::now() + kCancelPoll);
      } else {
        return false;
      }
    }

    return true;
  }

  static void lose(Connection& one) {
    one.fd = base::UniqueFd();
    one.lost = one.lost || std::exchange(one.answered, false);
    one.busy = false;
  }

  // A closed connection is readable, and has no bytes. What else has come is a late reply.
  static void notice_end(Connection& one) {
    char byte = 0;
    const ssize_t peeked = ::recv(one.fd.get(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    if (peeked == 0 || (peeked < 0 && errno != EAGAIN && errno != EINTR)) lose(one);
  }

  // The next reply; nullopt at `until`, or when no call is outstanding.
  std::optional<Reply> wait(Time until, bool cancellable) {
    for (;;) {
      if (!failed_.empty()) {
        Reply reply = std::move(failed_.back());
        failed_.pop_back();
        return reply;
      }
      if (outstanding() == 0) return std::nullopt;
      if (cancellable && cancelled_) {
        cancel_calls();
        continue;
      }
      if (auto reply = poll_once(until)) return reply;
      if (failed_.empty() && Clock::now() >= until) return std::nullopt;
    }
  }

  void cancel_calls() {
    for (int agent = 0; agent < kAgentNumbers; ++agent) {
      Connection& one = of(agent);
      if (!std::exchange(one.busy, false)) continue;
      failed_.push_back(cancelled_reply(agent, one.rpc));
    }
  }

  std::optional<Reply> poll_once(Time until) {
    std::vector<pollfd> polled;
    std::vector<int> agents;
    const Time now = Clock::now();
    Time wake = std::min(until, now + kCancelPoll);
    for (int agent = 0; agent < kAgentNumbers; ++agent) {
      const Connection& one = of(agent);
      if (!one.busy) continue;
      polled.push_back({one.fd.get(), POLLIN, 0});
      agents.push_back(agent);
      wake = std::min(wake, one.deadline);
    }

    const auto left = std::chrono::ceil<milliseconds>(std::max(wake - now, Clock::duration(0)));
    ::poll(polled.data(), polled.size(), static_cast<int>(left.count()));
    for (std::size_t i = 0; i < polled.size(); ++i) {
      if (polled[i].revents == 0) continue;
      if (auto reply = receive(agents[i])) return reply;
    }
    expire();
    return std::nullopt;
  }

  // The reply of a call that has expired comes later; its number tells it from the next one.
  void expire() {
    const Time now = Clock::now();
    for (int agent = 0; agent < kAgentNumbers; ++agent) {
      Connection& one = of(agent);
      if (!one.busy || now < one.deadline) continue;
      one.busy = false;
      fail(agent, one.rpc, grpc::StatusCode::DEADLINE_EXCEEDED, "no reply in time");
      failed_.back().latency = latency(one);
    }
  }

  static std::chrono::microseconds latency(const Connection& one) {
    return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - one.begun);
  }

  std::optional<Reply> receive(int agent) {
    Connection& one = of(agent);
    std::array<char, 65536> buffer;
    const ssize_t size = ::recv(one.fd.get(), buffer.data(), buffer.size(), 0);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return std::nullopt;
    if (size <= 0) {
      lose(one);
      fail(agent, one.rpc, grpc::StatusCode::UNAVAILABLE, "connection lost");
      return std::nullopt;
    }
    one.received.append(buffer.data(), static_cast<std::size_t>(size));
    return read_reply(agent, one);
  }

  std::optional<Reply> read_reply(int agent, Connection& one) {
    using Kind = ThriftReply::Kind;
    for (;;) {
      Message& message = one.memory.create(one.rpc);
      const ThriftReply read = read_thrift_reply(one.received, message);
      const bool endless =
          read.kind == Kind::kIncomplete && one.received.size() > proto::max_reply_bytes(one.rpc);
      if (read.kind == Kind::kIncomplete && !endless) return std::nullopt;

      Reply reply = empty_reply(agent, one.rpc);
      reply.latency = latency(one);
      if (endless || read.kind == Kind::kInvalid) {
        reply.status = {RpcOutcome::kProtocolError, 0,
                        who(agent) + ": " + (endless ? "an endless reply" : read.error)};
        lose(one);
        return reply;
      }

      one.received.erase(0, read.size);
      if (read.sequence != one.sequence) continue;  // of a call that expired

      one.busy = false;
      one.answered = true;
      if (proto::is_registration(one.rpc)) one.lost = false;
      if (read.kind == Kind::kException) {
        const bool unknown = read.exception_type == ThriftReply::kUnknownMethod;
        reply.status = rpc_status(
            one.rpc, unknown ? grpc::StatusCode::UNIMPLEMENTED : grpc::StatusCode::UNKNOWN,
            read.error);
      } else {
        reply.message = &message;
      }
      return reply;
    }
  }

  GrpcTarget target_;
  std::array<Connection, kAgentNumbers> connections_;
  std::vector<Reply> failed_;  ///< replies of calls that never left, or broke
  std::atomic<bool> cancelled_{false};
};

}  // namespace

std::unique_ptr<Playmaker> make_thrift_playmaker(const GrpcTarget& target) {
  return std::make_unique<ThriftPlaymaker>(target);
}

}  // namespace cls::proxy
