"""Tournaments to play, and their undisturbed outcomes."""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess

# A decision that is missed would make another, valid match: here it makes an invalid one, which is
# played again.
SETTINGS = """[tournament]
format = "{format}"
cycles = {cycles}
seed = {seed}
swap_sides = false
concurrency = 2
on_crash = "{on_crash}"
max_reruns = 1000
max_missed = {max_missed}
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
    # Over UDP, with a team that attacks the others (thief.py). The order in which datagrams of two
    # programs arrive is the system's, so the games differ; that they are played whole does not.
    *({"format": "round-robin", "cycles": 20, "sides": ["mock", villain, "run"],
       "more": 'mode = "synch"',
       "compared": ["index", "round", "left", "right", "end_reason", "cycles", "forfeit"]}
      for villain in ("thief", "burner", "flooder")),
    # Teams that lose each match, by their own fault, and nobody else does. Faults that end programs
    # of the others would make these lose, too.
    *({"format": "round-robin", "cycles": 80, "sides": ["mock", villain, "run"],
       "more": 'mode = "realtime"' + more, "on_crash": "forfeit", "max_missed": 1000,
       "loser": "T2",
       "faults": ["kill_run", "kill_run_and_matches", "interrupt_run", "interrupt_twice"],
       "compared": ["index", "round", "left", "right", "forfeit"]}
      for villain, more in (("filler", '\nside_disk = "16M"'), ("quitter", ""))),
]

# Where it is installed: on a server that accepts any client and any monitor, strangers too.
RCSSSERVER = os.environ.get("CLS_RCSSSERVER") or shutil.which("rcssserver")
if RCSSSERVER:
    PLANS.append({"format": "round-robin", "cycles": 20, "sides": ["mock", "thief", "run"],
                  "more": f'mode = "synch"\nserver = "{RCSSSERVER}"',
                  "faults": ["kill_run", "kill_match", "kill_guard", "kill_keeper",
                             "kill_run_and_matches", "interrupt_run", "interrupt_twice", "squat"],
                  "compared": ["index", "round", "left", "right", "end_reason", "cycles", "forfeit"]})

COMPARED = ["index", "round", "stage", "left", "right", "seed", "end_reason", "score", "penalty_score",
            "cycles", "forfeit", "winner", "game log"]

# A team that attacks: players and a coach by `cls proxy`, and the attack beside them.
VILLAIN = """#!/bin/sh
while [ $# -gt 0 ]; do
  case $1 in -p) port=$2;; -P) coach=$2;; -t) name=$2;; esac
  shift; [ $# -gt 0 ] && [ "${1#-}" = "$1" ] && shift
done
export PATH=/usr/bin:/bin  # a sandboxed program cannot read an interpreter in a home folder
{attack}
./cls mock hold --port 0 > "$TMPDIR/mock" &
until [ -s "$TMPDIR/mock" ]; do sleep 0.05; done
playmaker=$(sed -n 's/.*listening on //p' "$TMPDIR/mock")
exec ./cls proxy --port "$port" --coach-port "$coach" --teamname "$name" --playmaker "$playmaker"
"""


# What each does; the quitter leaves in the middle of a match.
ATTACKS = {
    "thief": 'python3 thief.py "$port" "$coach" T1 T3 2>&1 &',
    **{kind: f'python3 villain.py {kind} "$port" 2>&1 &'
       for kind in ("burner", "flooder", "filler")},
    "quitter": '(sleep 3; kill $$) &',
}


def write_villains(folder, cls):
    """Folders for `team:`, by name. A sandboxed team can read what is in its own, so each holds a
    copy of cls."""
    folder.mkdir()
    for name, attack in ATTACKS.items():
        team = folder / name
        team.mkdir()
        shutil.copy2(cls, team / "cls")
        for program in ("thief.py", "villain.py"):
            shutil.copy2(pathlib.Path(__file__).parent / program, team)
        (team / "start.sh").write_text(VILLAIN.replace("{attack}", attack))
        (team / "start.sh").chmod(0o755)
    return folder


def write(folder, plan, cls, tcp_port, villains):
    """cls.toml of a plan in a new folder."""
    folder.mkdir(parents=True)
    text = SETTINGS.format(format=plan["format"], cycles=plan["cycles"], seed=7,
                           on_crash=plan.get("on_crash", "rerun"),
                           max_missed=plan.get("max_missed", 0), more=plan.get("more", ""))
    endpoints = {"run": f"run:{cls} mock --port {{port}}", "tcp": f"127.0.0.1:{tcp_port}",
                 **{name: f"team:{villains / name}" for name in ATTACKS}}
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


def outcome(document, folder, plan):
    """What must be equal whatever happened: matches with their game logs, and tables."""
    compared = plan.get("compared", COMPARED)
    matches = []
    for match in document["matches"]:
        same = {key: match.get(key) for key in compared if key != "game log"}
        if "game log" in compared:
            log = pathlib.Path(folder) / (match.get("folder") or "") / "match.rcg.gz"
            same["game log"] = digest(log)
        if match.get("forfeit"):
            same["winner"] = match.get("winner")
        matches.append(same)
    return {"matches": matches, "standings": document["standings"] if "score" in compared else None}


class References:
    """The undisturbed outcome of each plan, played once."""

    def __init__(self, cls, folder, tcp_port):
        self.cls, self.folder, self.tcp_port = cls, pathlib.Path(folder), tcp_port
        self.villains = write_villains(self.folder / "villains", cls)
        self.known = {}

    def of(self, number):
        if number not in self.known:
            folder = self.folder / f"reference-{number}"
            write(folder, PLANS[number], self.cls, self.tcp_port, self.villains)
            done = subprocess.run([self.cls, "tournament", "run", folder, "--quiet"], check=False,
                                  capture_output=True, text=True, timeout=300, env=os.environ)
            if done.returncode != 0:
                raise RuntimeError(f"the undisturbed tournament failed: {done.stderr}")
            self.known[number] = outcome(report(self.cls, folder)[0], folder, PLANS[number])
        return self.known[number]
