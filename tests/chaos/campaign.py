"""A short tournament under faults, and the promises that hold afterwards."""
import fcntl
import json
import os
import pathlib
import random
import re
import sqlite3
import subprocess
import time

import faults
import plan
import processes

LIMIT = 300.0  # seconds of a tournament with all its faults, on a loaded host
# Exit codes with which a disturbed run may end; the same command then continues.
EXPECTED = {0, 1, 65, 69, 73, 74, 75, 78, 130, 143, 129, 131}
# What a crash of cls prints or leaves in a result.
CRASH = re.compile(r"Assertion|terminate called|Sanitizer|Segmentation|SIGSEGV|SIGABRT|SIGBUS|SIGFPE"
                   r"|SIGILL|internal error|double free|corrupted")

# The dynamic loader's line, with exit code 127.
LOADER = "error while loading shared libraries"


class Campaign:
    def __init__(self, options, seed, folder, forwarder, references):
        self.cls = options.cls
        self.options = options
        self.seed = seed
        self.random = random.Random(seed)
        self.folder = folder / "cup"
        self.on_small_disk = options.small_disk
        self.temporary = folder / "tmp"
        self.temporary.mkdir(parents=True)
        self.forwarder = forwarder
        self.references = references
        self.mark = f"{os.getpid()}-{seed}-{time.monotonic_ns()}"
        self.environment = {**os.environ, processes.MARK: self.mark, "TMPDIR": str(self.temporary)}
        self.process = None
        self.errors = references.folder / f"errors-{seed}"  # where no disk is full
        self.last_fault = ""
        self.plan = plan.PLANS[seed % len(plan.PLANS)]
        self.wanted = None
        self.planted = []  # links, which must not be followed
        self.decoy = folder / "decoy"
        self.log = []
        self.violations = []
        self.begin = time.monotonic()

    def processes(self):
        return processes.marked(self.mark)

    def violate(self, text):
        self.violations.append(text)

    def note(self, text):
        self.log.append(f"{time.monotonic() - self.begin:6.2f} s  {text}")

    # ---- the run

    def start(self):
        with open(self.errors, "wb") as errors:
            self.process = subprocess.Popen(
                [self.cls, "tournament", "run", self.folder, "--quiet", "--no-preflight"],
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors,
                env=self.environment)

    def is_running(self):
        return self.process is not None and self.process.poll() is None

    def check_exit(self, code, errors, who):
        """One reason for each failure, and no crash."""
        if code < 0:
            if -code in (6, 7, 8, 11, 4):
                self.violate(f"{who} was ended by signal {-code}: {errors}")
            return
        limited = self.last_fault.startswith("limit_")
        if limited and code == 127 and LOADER in errors:
            return  # the limit struck before cls began
        if code not in EXPECTED and not (code == 70 and limited):
            self.violate(f"{who} ended with {code}: {errors}")
        # Without memory or descriptors gRPC may end a match; the run survives it.
        if CRASH.search(errors) and not limited:
            self.violate(f"{who} ({code}) prints: {errors}")
        lines = [line for line in errors.splitlines() if line.strip()]
        if code not in (0, 1, 130, 143) and not any(line.startswith("cls: ") for line in lines):
            self.violate(f"{who} ended with {code} and no reason: {errors!r}")

    def finish_run(self):
        code = self.process.wait()
        errors = self.errors.read_text(errors="replace")
        self.check_exit(code, errors, "run")
        self.note(f"run ended with {code}  {errors.strip()[:300]}")
        self.process = None
        return code

    def play(self):
        """True when the tournament is complete."""
        plan.write(self.folder, self.plan, self.cls, self.forwarder.port, self.references.villains)
        count = self.random.randint(1, self.options.faults)
        self.start()
        for _ in range(count):
            time.sleep(self.random.choice([0.0, 0.05, 0.2, 0.5, 1.0]) * self.random.random())
            fault = faults.choose(self.random, self.options.only or self.plan.get("faults"))
            self.last_fault = fault.__name__
            # A store can only be damaged between two runs.
            if fault is faults.corrupt_store and self.is_running():
                faults.kill_run_and_matches(self)
                self.process.wait()
                if left := processes.wait_gone(self.mark, 5):
                    self.violate(f"after SIGKILL to run and matches: {left}")
            done = fault(self)
            self.note(f"{fault.__name__}: {done}")
            if done:
                self.options.counts[fault.__name__] += 1
            if not self.is_running():
                if self.process is not None and self.finish_run() == 0:
                    break
                self.start()
        while time.monotonic() - self.begin < LIMIT:
            while self.is_running() and time.monotonic() - self.begin < LIMIT:
                time.sleep(0.02)
            if self.is_running():
                break
            if self.process is not None and self.finish_run() == 0:
                return True
            self.last_fault = ""
            self.start()
        self.violate(f"not complete after {LIMIT:.0f} s")
        for process in self.processes():
            self.note(f"{process} ({process.command}):\n{process.stacks()}")
        return False

    # ---- the promises

    def check(self):
        self.wanted = self.references.of(self.seed % len(plan.PLANS))
        self.begin = time.monotonic()
        complete = self.play()
        if left := processes.wait_gone(self.mark, 4):
            self.violate("processes are left: " + ", ".join(f"{p} ({p.command})" for p in left))
            processes.kill_all(self.mark)
        if complete:
            self.check_intrusion()
            self.check_files()
            self.check_events()
            self.check_outcome()
        return self.violations

    def check_intrusion(self):
        """Neither a thief nor a link that a stranger has planted got anything."""
        for log in self.folder.rglob("*team.log"):
            # A thief may join for its own side, under any name.
            own = re.compile(rf"b'\((init|reconnect) {log.name[0]} ")
            for line in log.read_text(errors="replace").splitlines():
                if "TAKEN" in line and not own.search(line):
                    self.violate(f"{log.relative_to(self.folder)}: {line}")
        if self.planted and self.decoy.read_text() != faults.DECOY:
            self.violate(f"a planted link was followed: one of {self.planted}")
        for link in self.planted:
            if link.is_symlink():
                link.unlink()

    def check_files(self):
        with open(self.folder / "lock", "rb") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                self.violate("the lock is held")
        names = [path for path in self.folder.rglob("*") if not path.is_dir()]
        for path in names:
            # What is below unfinished/ belongs to check_unfinished().
            partial = path.name.startswith(".partial-") and path.parent.name != "unfinished"
            left = partial or path.name.startswith(".hook-")
            if left or path.name in ("tournament.db-wal", "tournament.db-shm", "stop"):
                self.violate(f"a temporary file is left: {path.relative_to(self.folder)}")
        if rest := list(self.temporary.iterdir()):
            self.violate(f"files are left in TMPDIR: {rest}")

    def check_events(self):
        done = {}
        sequence = -1
        for line in (self.folder / "events.jsonl").read_text().splitlines():
            try:
                event = json.loads(line)
            except ValueError:
                continue  # cut by a kill in the middle of a write
            if event["seq"] <= sequence:
                self.violate(f"event {event['seq']} after {sequence}")
            sequence = event["seq"]
            index = event.get("match")
            if event["type"] == "match_started" and index in done:
                self.violate(f"match {index} is played again after it was finished")
            if event["type"] == "match_finished" and not event["again"]:
                done[index] = event
        database = sqlite3.connect(self.folder / "tournament.db")
        for index, outcome in database.execute("SELECT number, outcome FROM match"):
            if CRASH.search(outcome or ""):
                self.violate(f"match {index}: {outcome}")
        database.close()

    def check_unfinished(self, document):
        """Only folders of matches that count may be below unfinished/. What a `work` leaves that is
        killed while the run ends, the next run removes."""
        kept = {pathlib.Path(match["folder"]).name for match in document["matches"]
                if match.get("folder")}
        left = [path for path in self.folder.glob("unfinished/*") if path.name not in kept]
        if left:
            self.start()
            self.finish_run()
        for path in left:
            if path.exists():
                self.violate(f"a killed `work` left {path.relative_to(self.folder)}")

    def check_loser(self, document):
        """A team that breaks the rules loses each of its matches by forfeit, and nobody else does."""
        loser = self.plan.get("loser")
        for match in document["matches"] if loser else []:
            sides = {"left": match["left"], "right": match["right"]}
            fair = [side for side, team in sides.items() if team != loser]
            wanted = fair[0] if len(fair) == 1 else None
            got = match.get("winner") if match.get("forfeit") else None
            if got != wanted:
                self.violate(f"match {match['index']} {sides}: won by forfeit: {got}, not {wanted}")

    def check_outcome(self):
        document, errors, code = plan.report(self.cls, self.folder)
        if document is None:
            self.violate(f"no report: exit {code}: {errors}")
            return
        self.check_unfinished(document)
        self.check_loser(document)
        got = plan.outcome(document, self.folder, self.plan)
        wanted = self.wanted
        if got == wanted:
            return
        for one, other in zip(got["matches"], wanted["matches"]):
            if one != other:
                self.violate(f"match {one['index']} differs: {one} instead of {other}")
        if len(got["matches"]) != len(wanted["matches"]):
            self.violate(f"{len(got['matches'])} matches instead of {len(wanted['matches'])}")
        if got["standings"] != wanted["standings"]:
            self.violate(f"standings differ: {got['standings']}")
