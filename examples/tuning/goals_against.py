#!/usr/bin/env python3
"""How a team concedes goals: which ways of losing the ball and which finishes cost the most.

    python3 examples/tuning/goals_against.py TEAM FOLDER...

reads the matches below each FOLDER with `cls`, which is on PATH or named by the variable CLS. The
last column is a match folder and a cycle for `cls watch FOLDER`. docs/tuning.md says what follows.
"""
import json
import os
import shutil
import subprocess
import sys
from collections import defaultdict

OWN_THIRD = -17.5  # x of its end; the team attacks +x
CLOSE, FAR = 8.0, 18.0  # m, shots
INCOMPLETE = 65  # exit code of cls: a log without its end, of a match that is being played
RUN_UP = 60  # cycles before a goal in which its finish is looked for


def cls(*words):
    program = os.environ.get("CLS", "cls")
    if shutil.which(program) is None:
        sys.exit(f"no program '{program}': put cls on PATH, or name it in the variable CLS")
    run = subprocess.run([program, *words], stdout=subprocess.PIPE)
    if run.returncode not in (0, INCOMPLETE):
        sys.exit(run.returncode)
    return json.loads(run.stdout)


def attacking_x(event, side, end="from"):
    return event[end][0] if side == "left" else -event[end][0]


def third(x):
    return "own third" if x < OWN_THIRD else "middle" if x < -OWN_THIRD else "their third"


def origin(goal, events, victim):
    """How the other team got the ball that it scored with."""
    if goal["own_goal"]:
        return "own goal"
    if goal["from_set_play"]:
        return "set play"
    lost = [e for e in events if e["side"] == victim and e["frame"] < goal["frame"] and e["kind"] in ("pass", "carry", "shot", "tackle")]
    if not lost:
        return "kick-off"
    last = lost[-1]
    if last["kind"] == "pass" and "clearance" in last["marks"]:
        return f"clearance from {third(attacking_x(last, victim))}"
    kind = {"pass": "pass", "carry": "dribble", "shot": "shot", "tackle": "won tackle"}[last["kind"]]
    return f"{kind} lost in {third(attacking_x(last, victim))}"


def finish(goal, events, scorer):
    """The last pass before the shot, and from where the shot came."""
    if goal["shot_distance"] is None:
        return "without a shot"
    where = "close" if goal["shot_distance"] < CLOSE else "far" if goal["shot_distance"] > FAR else "middle"
    passes = [e for e in events if e["side"] == scorer and e["kind"] == "pass" and e["result"] == "completed" and goal["frame"] - RUN_UP <= e["frame"] < goal["frame"]]
    marks = passes[-1]["marks"] if passes else []
    how = next((mark for mark in ("cross", "cutback", "through", "switch") if mark in marks), "pass" if passes else "solo")
    return f"{how}, {where} shot"


def goals_against(team, folder):
    sides = {}
    for match in cls("results", folder, "--json")["matches"]:
        for side in ("left", "right"):
            if match[side]["name"] == team:
                sides[match["file"]] = side
    for match in cls("stats", folder, "--json", "--events")["matches"]:
        victim = sides.get(match["file"])
        if victim is None or not match["complete"]:
            continue
        scorer = "right" if victim == "left" else "left"
        goals = [goal for goal in match["goals"] if goal["side"] == scorer]
        rows = [(origin(goal, match["events"], victim), finish(goal, match["events"], scorer), goal["cycle"]) for goal in goals]
        yield match["file"], rows


def print_table(title, classes, total):
    print(f"\n{title:<32} goals  share  seen in")
    for name, places in sorted(classes.items(), key=lambda item: (-len(item[1]), item[0])):
        file, cycle = places[0]
        print(f"{name:<32} {len(places):>5}  {len(places) / total:>4.0%}   {file} {cycle}")


def main(team, *folders):
    origins, finishes, matches = defaultdict(list), defaultdict(list), 0
    for folder in folders:
        for file, rows in goals_against(team, folder):
            matches += 1
            for begin, end, cycle in rows:
                origins[begin].append((file, cycle))
                finishes[end].append((file, cycle))
    total = sum(map(len, origins.values()))
    if matches == 0:
        sys.exit(f"no match of {team} in {', '.join(folders)}")
    print(f"{team}: {total} goals against in {matches} {'match' if matches == 1 else 'matches'}, {total / matches:.2f} a match")
    if total > 0:
        print_table("origin", origins, total)
        print_table("finish", finishes, total)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
