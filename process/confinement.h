// Confined programs: they cannot change other processes of their user, and have no privileges.
#pragma once

namespace cls::process {

/// True if the kernel can confine programs: it was built with seccomp filters, and a container does
/// not forbid them.
bool can_confine();

/// For good, for this process and all its descendants: no capabilities, also as root, none by
/// set-user-ID programs; and limits (prlimit), priorities, scheduling, processor cores and memory
/// nodes may be changed of the caller itself only (pid 0), not of a process or thread by its
/// number. Priorities cannot rise. Calls that schedule a thread by its number, or in real time, say
/// that they succeeded and have no effect, because pthread_create() fails with them.
/// Async-signal-safe, for use between fork and exec. False with errno set on failure.
bool confine();

}  // namespace cls::process
