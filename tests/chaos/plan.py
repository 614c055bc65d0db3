"""Tournaments to play, and their undisturbed outcomes."""
import hashlib
import json
import os
import pathlib
import subprocess

# A decision that is missed would make another, valid match: here it makes an invalid one, which is
# played again.
SETTINGS = """[tournament]
format = "{format}"
cycles = {cycles}
seed = {seed}
swap_sides = false
concurrency = 2
on_crash = "rerun"
max_reruns = 1000
max_missed = 0
rpc_deadline = 60000
start_timeout = 15
stall_after = 3
{more}
[server]
kick_off_wait = 2
"""

# Short: the game logs, not the scores, show whether a match was disturbed.
PLANS = [
    {"format": "round-robin", "cycles": 15, "sides": ["mock", "mock:hold", "run"]},
    {"format": "round-robin", "cycles": 10, "sides": ["run", "mock", "tcp"]},
    {"format": "knockout", "cycles": 10, "sides": ["mock", "run", "mock:hold", "mock"]},
    {"format": "swiss", "cycles": 10, "sides": ["mock", "tcp", "mock:hold", "run"],
     "more": "rounds = 2"},
    {"format": "groups", "cycles": 8, "sides": ["mock", "mock:hold", "mock", "run"],
     "more": "groups = 2\nadvance = 1\nthird_place = false"},
]


def write(folder, plan, cls, tcp_port):
    """cls.toml of a plan in a new folder."""
    folder.mkdir(parents=True)
    text = SETTINGS.format(format=plan["format"], cycles=plan["cycles"], seed=7,
                           more=plan.get("more", ""))
    endpoints = {"run": f"run:{cls} mock --port {{port}}", "tcp": f"127.0.0.1:{tcp_port}"}
    for number, side in enumerate(plan["sides"], 1):
        text += f'[teams.T{number}]\nendpoint = "{endpoints.get(side, side)}"\n'
    (folder / "cls.toml").write_text(text)


def report(cls, folder, environment=None):
    """The JSON report of a tournament, and the error lines and exit code of the command."""
    done = subprocess.run([cls, "tournament", "report", folder, "--format", "json"], check=False,
                          capture_output=True, text=True, env=environment, timeout=60)
    document = json.loads(done.stdout) if done.returncode == 0 else None
    return document, done.stderr, done.returncode


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else "missing"


def outcome(document, folder):
    """What must be equal whatever happened: matches with their game logs, and tables."""
    matches = []
    for match in document["matches"]:
        same = {key: match.get(key) for key in ("index", "round", "stage", "left", "right", "seed",
                                                "end_reason", "score", "penalty_score", "cycles",
                                                "forfeit", "winner")}
        same["game log"] = digest(pathlib.Path(folder) / (match.get("folder") or "") / "match.rcg.gz")
        matches.append(same)
    return {"matches": matches, "standings": document["standings"]}


class References:
    """The undisturbed outcome of each plan, played once."""

    def __init__(self, cls, folder, tcp_port):
        self.cls, self.folder, self.tcp_port = cls, pathlib.Path(folder), tcp_port
        self.known = {}

    def of(self, number):
        if number not in self.known:
            folder = self.folder / f"reference-{number}"
            write(folder, PLANS[number], self.cls, self.tcp_port)
            done = subprocess.run([self.cls, "tournament", "run", folder, "--quiet"], check=False,
                                  capture_output=True, text=True, timeout=120, env=os.environ)
            if done.returncode != 0:
                raise RuntimeError(f"the undisturbed tournament failed: {done.stderr}")
            self.known[number] = outcome(report(self.cls, folder)[0], folder)
        return self.known[number]
