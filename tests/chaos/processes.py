"""Processes of a run, found by a mark in their environment, whatever their parents are."""
import os
import signal
import subprocess
import time

MARK = "CLS_CHAOS_MARK"


def _read(pid, name):
    try:
        with open(f"/proc/{pid}/{name}", "rb") as file:
            return file.read()
    except OSError:
        return b""


class Process:
    def __init__(self, pid):
        self.pid = pid
        words = [word.decode(errors="replace") for word in _read(pid, "cmdline").split(b"\0") if word]
        self.command = " ".join(words)
        self.role = role_of(words)

    def send(self, number):
        try:
            os.kill(self.pid, number)
        except OSError:
            pass

    def stacks(self):
        """What its threads wait for, if gdb is installed, and its open files and limits."""
        text = _read(self.pid, "limits").decode() + "descriptors: "
        try:
            text += " ".join(os.listdir(f"/proc/{self.pid}/fd")) + "\n"
            text += subprocess.run(["gdb", "-p", str(self.pid), "-batch", "-ex",
                                    "thread apply all bt 16"], check=False, capture_output=True,
                                   text=True, errors="replace", timeout=60).stdout
        except (OSError, subprocess.TimeoutExpired) as error:
            text += f"no stacks: {error}"
        return text

    def __repr__(self):
        return f"{self.role} {self.pid}"


def role_of(words):
    """run, match, work, guard, keeper, playmaker, server or other."""
    if words and words[0].startswith("match-guard"):
        return "guard"
    if words and words[0].startswith("match-keeper"):
        return "keeper"
    line = " ".join(words[1:3])
    for beginning, role in (("tournament run", "run"), ("tournament work", "work"), ("match", "match"),
                            ("mock", "playmaker"), ("server", "server")):
        if line.startswith(beginning) and os.path.basename(words[0]) == "cls":
            return role
    return "other"


def marked(mark):
    """All living processes with this mark; zombies and the caller are left out."""
    wanted = f"{MARK}={mark}".encode()
    found = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit() or int(entry) == os.getpid():
            continue
        if wanted not in _read(entry, "environ").split(b"\0"):
            continue
        state = _read(entry, "stat").rpartition(b")")[2].split()
        if state and state[0] not in (b"Z", b"X"):
            found.append(Process(int(entry)))
    return found


def wait_gone(mark, seconds):
    """The processes that are left after this time."""
    end = time.monotonic() + seconds
    while True:
        left = marked(mark)
        if not left or time.monotonic() > end:
            return left
        time.sleep(0.05)


def kill_all(mark):
    """Cleans up after a violation."""
    for _ in range(20):
        left = marked(mark)
        if not left:
            return
        for process in left:
            process.send(signal.SIGKILL)
        time.sleep(0.1)
