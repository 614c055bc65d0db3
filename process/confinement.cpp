// A seccomp filter for the system calls that change other processes; capabilities by capset.
#include "process/confinement.h"

#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace cls::process {
namespace {

#if !defined(__x86_64__)
#error "the numbers of system calls below are those of x86-64 and its 32-bit programs"
#endif

constexpr std::uint32_t kFirstX32Call = 0x4000'0000;

/// The arguments with which a call is allowed: the kernel reads process numbers as 32 bits.
enum class Allowed : std::uint8_t {
  kFirstIsZero,         ///< CALL(pid, ...)
  kFirstTwoAreZero,     ///< setpriority(PRIO_PROCESS, pid, ...)
  kOneThenZero,         ///< ioprio_set(IOPRIO_WHO_PROCESS, pid, ...)
  kFirstIsZeroOrReads,  ///< prlimit64(pid, resource, new limit, ...): or no new limit
  kOwnOrInVain,         ///< sched_setparam(pid, ...): others are told that it succeeded
  kUsualOrInVain,       ///< sched_setscheduler(pid, policy, ...): so are those who want real time
};

struct Rule {
  std::uint32_t call;
  std::uint32_t call_of_32_bits;
  Allowed allowed;
};

constexpr std::array<Rule, 9> kRules = {{
    {SYS_prlimit64, 340, Allowed::kFirstIsZeroOrReads},
    {SYS_setpriority, 97, Allowed::kFirstTwoAreZero},
    {SYS_ioprio_set, 289, Allowed::kOneThenZero},
    {SYS_sched_setaffinity, 241, Allowed::kFirstIsZero},
    {SYS_sched_setscheduler, 156, Allowed::kUsualOrInVain},
    {SYS_sched_setparam, 154, Allowed::kOwnOrInVain},
    {SYS_sched_setattr, 351, Allowed::kFirstIsZero},
    {SYS_migrate_pages, 294, Allowed::kFirstIsZero},
    {SYS_move_pages, 317, Allowed::kFirstIsZero},
}};

/// A program of the kernel's packet filter, which decides about each system call.
class Filter {
 public:
  constexpr Filter() {
    load(offsetof(seccomp_data, arch));

    // To the rules of 32-bit programs, which follow those of 64 bits.
    const std::size_t to_other = add(jump(BPF_JEQ, AUDIT_ARCH_X86_64, 0, 0));
    load(offsetof(seccomp_data, nr));
    add(jump(BPF_JGE, kFirstX32Call, 0, 1));
    add(verdict(kRefused));
    for (const Rule& rule : kRules) add_rule(rule.call, rule.allowed);
    add(verdict(SECCOMP_RET_ALLOW));

    steps_[to_other].jf = static_cast<std::uint8_t>(size_ - to_other - 1);
    add(jump(BPF_JEQ, AUDIT_ARCH_I386, 1, 0));
    add(verdict(kRefused));
    load(offsetof(seccomp_data, nr));
    for (const Rule& rule : kRules) add_rule(rule.call_of_32_bits, rule.allowed);
    add(verdict(SECCOMP_RET_ALLOW));
  }

  sock_fprog program() const {
    return {static_cast<unsigned short>(size_), const_cast<sock_filter*>(steps_.data())};
  }

 private:
  static constexpr std::uint32_t kRefused = SECCOMP_RET_ERRNO | EPERM;
  static constexpr std::uint32_t kPretended = SECCOMP_RET_ERRNO;  // 0: success, without the call

  static constexpr std::uint32_t low_half(std::size_t argument) {
    return static_cast<std::uint32_t>(offsetof(seccomp_data, args) + 8 * argument);
  }

  static constexpr sock_filter verdict(std::uint32_t value) {
    return {BPF_RET | BPF_K, 0, 0, value};
  }
  static constexpr sock_filter jump(std::uint16_t test, std::uint32_t value, std::uint8_t if_true,
                                    std::uint8_t if_false) {
    return {static_cast<std::uint16_t>(BPF_JMP | test | BPF_K), if_true, if_false, value};
  }

  constexpr std::size_t add(sock_filter step) {
    steps_[size_] = step;
    return size_++;
  }
  constexpr void load(std::size_t offset) {
    add({BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)});
  }

  /// A policy of real time has no effect, and no error either. The flag that children do not
  /// inherit it may be set, too.
  constexpr void add_pretended_real_time() {
    load(low_half(1));
    add({BPF_ALU | BPF_AND | BPF_K, 0, 0, ~std::uint32_t{SCHED_RESET_ON_FORK}});
    add(jump(BPF_JEQ, SCHED_FIFO, 1, 0));
    add(jump(BPF_JEQ, SCHED_RR, 0, 1));
    add(verdict(kPretended));
  }

  /// Each check is a load and a jump past the refusal or to it; a call that passes all is allowed.
  constexpr void add_rule(std::uint32_t call, Allowed allowed) {
    const std::size_t skip = add(jump(BPF_JEQ, call, 0, 0));
    const bool priority = allowed == Allowed::kFirstTwoAreZero;
    const bool io_priority = allowed == Allowed::kOneThenZero;
    const bool reads = allowed == Allowed::kFirstIsZeroOrReads;
    const bool in_vain = allowed == Allowed::kOwnOrInVain || allowed == Allowed::kUsualOrInVain;

    if (allowed == Allowed::kUsualOrInVain) add_pretended_real_time();
    load(low_half(0));
    if (reads) {
      add(jump(BPF_JEQ, 0, 4, 0));
      load(low_half(2));
      add(jump(BPF_JEQ, 0, 0, 3));
      load(low_half(2) + sizeof(std::uint32_t));
    } else if (priority || io_priority) {
      add(jump(BPF_JEQ, io_priority ? 1 : 0, 0, 3));
      load(low_half(1));
    }
    add(jump(BPF_JEQ, 0, 0, 1));

    add(verdict(SECCOMP_RET_ALLOW));
    // pthread_create() schedules a new thread by its number, and fails with it.
    add(verdict(in_vain ? kPretended : kRefused));
    steps_[skip].jf = static_cast<std::uint8_t>(size_ - skip - 1);
  }

  std::array<sock_filter, 200> steps_{};
  std::size_t size_ = 0;
};

constexpr Filter kFilter;

// Root gets its capabilities back at exec, but for those that it has given up here: no_new_privs.
bool drop_capabilities() {
  for (unsigned long capability = 0; capability <= 63; ++capability) {
    ::prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);  // needs privileges that it may lack
  }
  ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  return ::syscall(SYS_capset, &header, none.data()) == 0;
}

// Some hosts let all users have real-time priorities, or raise usual ones.
bool drop_priorities() {
  const rlimit none{0, 0};
  return ::setrlimit(RLIMIT_RTPRIO, &none) == 0 && ::setrlimit(RLIMIT_NICE, &none) == 0;
}

}  // namespace

bool can_confine() {
  const std::uint32_t action = SECCOMP_RET_ERRNO;
  return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

bool confine() {
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  if (!drop_priorities() || !drop_capabilities()) return false;
  const sock_fprog program = kFilter.program();
  // Without this flag old kernels make all programs slower, against attacks that do not matter
  // here.
  return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW,
                   &program) == 0;
}

}  // namespace cls::process
