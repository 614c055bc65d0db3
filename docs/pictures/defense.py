#!/usr/bin/env python3
"""Draws what parameters of the planner's defense change: the same moment, played without and with them, side by side.

    docs/pictures/defense.py build/bin/cls docs/pictures

A moment is a book of one situation (docs/formats/book.md), which the embedded server plays twice with the same seed.
Attackers follow a script that knows nothing of the defense. The colors are those of goal.svg, which cls writes.
"""
import csv
import io
import json
import math
import re
import subprocess
import sys
import tempfile
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples" / "analysis"))
from svg import MARGIN, Pitch, save  # pylint: disable=wrong-import-position

SEED = 1
WARM_UP = 10  # cycles before the moment, in which players only perceive
PLAYER_DECAY = 0.4
STAMINA = 8000
STYLE = ".chart .faint{opacity:.4}.chart .saved{fill:none;stroke:#868e89}"
GOAL_X = -52.5
PLAYERS = [f"{side}{unum}" for side in "lr" for unum in range(1, 12)]


# The script of the attackers. They see the pitch from their own side, where a point has the other signs.

def exactly(*actions):
    """A reply beside which the agent does nothing of its own, such as a shot."""
    return {"actions": [*actions, {"neck_turn_to_ball": {}}],
            "ignore_preprocess": True, "ignore_shootInPreprocess": True, "ignore_doIntention": True,
            "ignore_doforcekick": True, "ignore_doHeardPassRecieve": True}


def point(x, y):
    return {"x": -x, "y": -y}


def kick(target, speed, least):
    return {"body_smart_kick": {"target_point": point(*target), "first_speed": speed,
                                "first_speed_threshold": least, "max_steps": 2}}


FACE_BALL = {"body_turn_to_ball": {"cycle": 1}}
WITH_BALL = {"self.is_kickable": True}


# Moments.

@dataclass
class Player:
    """Its place at the moment, to which it ran along its body with this speed (meters a cycle)."""
    x: float
    y: float
    body: float = 0.0
    speed: float = 0.0
    stamina: float = STAMINA
    type: int = 0

    def frame(self, steps_ago):
        step = (self.speed * math.cos(math.radians(self.body)), self.speed * math.sin(math.radians(self.body)))
        return [self.x - steps_ago * step[0], self.y - steps_ago * step[1],
                step[0] * PLAYER_DECAY, step[1] * PLAYER_DECAY, self.body]


@dataclass
class Moment:
    """A resting ball and 22 players; those who are not named wait at the side lines of the attackers' half."""
    ball: tuple
    defenders: dict
    attackers: dict
    rules: list
    cycles: int
    defense: str = "mock:planner"

    def players(self):
        for named in (self.defenders, self.attackers):
            for unum in range(1, 12):
                yield named.get(unum) or Player(40 - 3 * unum, 33 if unum % 2 else -33, 180)

    def situation(self):
        frames = [[*self.ball, 0, 0, *(value for player in self.players() for value in player.frame(ago))]
                  for ago in range(WARM_UP, -1, -1)]
        states = [[player.type, player.stamina, 1, 1, 60000] for player in self.players()]
        return {"class": "defense", "log": 0, "time": 1000, "score": [0, 0], "mode": "play_on",
                "players": states, "frames": frames}


class Games:
    """Plays moments in a temporary folder."""

    def __init__(self, cls, folder):
        self.cls, self.folder, self.matches = str(Path(cls).resolve()), Path(folder), 0
        with open(ROOT / "examples" / "tuning" / "strong.toml", "rb") as file:
            self.strong = tomllib.load(file)
        # Any match has the player types of its seed.
        self.usual_types = self.types("mock:planner", "usual")
        self.run("book", "make", "usual", "--out", "usual.book", "--count", "4")
        with open(self.folder / "usual.book", encoding="utf-8") as file:
            self.head = file.readline()

    def run(self, *words):
        return subprocess.run([self.cls, *words, "--quiet"], cwd=self.folder, check=True, stdout=subprocess.PIPE,
                              encoding="utf-8").stdout

    def rows(self, match):
        table = self.run("convert", f"{match}/match.rcg", "-", "--to", "tracking")
        return list(csv.DictReader(io.StringIO(table)))

    def types(self, side, name):
        """The types that the coaches chose, by player."""
        self.run("match", side, "mock:planner", "--seed", str(SEED), "--cycles", "600", "--dir", name)
        last = self.rows(name)[-1]
        return {player: int(last[f"{player}_t"]) for player in PLAYERS}

    def parameters(self, values):
        """A file with parameters of the planner, and a side that has them."""
        path = self.folder / "parameters.toml"
        path.write_text("".join(f"{name} = {value}\n" for name, value in values.items()), encoding="utf-8")
        return f"planner:{path}"

    def script(self, name, rules):
        """A side whose players follow the rules, and stand if none holds."""
        path = self.folder / name
        path.write_text(json.dumps({"rules": rules, "otherwise": "hold"}), encoding="utf-8")
        return f"mock:{path}"

    def play(self, moment, values):
        """Frames from the moment on. `values`: parameters of the defenders."""
        (self.folder / "moment.book").write_text(self.head + json.dumps(moment.situation()) + "\n", encoding="utf-8")
        self.matches += 1
        match = f"match-{self.matches}"
        self.run("match", f"{self.parameters(values)}={moment.defense}", self.script("attack.json", moment.rules),
                 "--book", "moment.book", "--situations", "1", "--cycles", str(moment.cycles), "--seed", str(SEED),
                 "--dir", match)
        return [Frame(row) for row in self.rows(match)[WARM_UP - 1:]]


class Frame:
    """One cycle of a tracking table."""

    def __init__(self, row):
        self.mode = row["playmode"]
        self.ball = (float(row["b_x"]), float(row["b_y"]))
        self.players = {name: (float(row[f"{name}_x"]), float(row[f"{name}_y"]), float(row[f"{name}_body"]))
                        for name in PLAYERS}

    def at(self, name):
        return self.players[name][:2]


# Drawing.

class Panel(Pitch):
    line_color, text_color, note_color = ".lines", ".title", ".text"

    def __init__(self, title, area, scale, notes):
        super().__init__(title, area, scale, notes)
        left, top, right, bottom = area
        edge = MARGIN / scale
        self.rectangle(left - edge, top - edge, right - left + 2 * edge, bottom - top + 2 * edge, ".pitch")
        self.lines()

    def disc(self, name, frame, extra="", radius=8.5):
        """A player with its body direction, and its number unless the disc is small."""
        side = "left" if name[0] == "l" else "right"
        x, y, body = frame.players[name]
        reach = 1.6 * radius / self.scale
        self.line(x, y, x + reach * math.cos(math.radians(body)), y + reach * math.sin(math.radians(body)),
                  f".{side}-line{extra}", 0.35 * radius)
        self.circle(x, y, radius, f".{side}{extra}")
        if radius > 7:
            self.text(x, y, name[1:], 12, ".unum on")

    def walk(self, name, frames, every=1, width=2.0):
        """A player at the first and the last frame, and its way."""
        self.disc(name, frames[0], " faint", 6)
        self.path(thinned([frame.at(name) for frame in frames], every),
                  ".left-line" if name[0] == "l" else ".right-line", width)
        self.disc(name, frames[-1])

    def ball_way(self, frames, every=1, width=1.5):
        self.path(thinned([frame.ball for frame in frames], every), ".ball-line", width)

    def ball(self, frame):
        self.circle(*frame.ball, 4.5, ".ball")


def thinned(points, every):
    return points[:-1:every] + points[-1:]


def meters(one, other):
    return math.dist(one, other)


def mean(values):
    values = list(values)
    return sum(values) / len(values)


# The pictures.

def kicks(frames, least=0.8):
    """Indices of the frames after which the ball moves otherwise than it rolls."""
    def step(i):
        return [b - a for a, b in zip(frames[i].ball, frames[i + 1].ball)]
    rolling = [[0.94 * part for part in step(i - 1)] for i in range(1, len(frames) - 1)]
    return [i for i in range(1, len(frames) - 1) if meters(step(i), rolling[i - 1]) > least]


def goalie(games):
    """A pass from the wing, and 13 shots aimed at places of the goal a meter apart."""
    passer, shooter, waits = (-39, 20), (-37, 9), 8
    aims = range(-6, 7)

    def moment(aim):
        along = math.atan2(shooter[1] - passer[1], shooter[0] - passer[0])
        behind = (passer[0] - 0.45 * math.cos(along), passer[1] - 0.45 * math.sin(along))
        intercept = {"body_intercept": {"face_point": point(GOAL_X, 0)}}
        rules = [{"when": {"unum": 10, "cycle": [0, WARM_UP + waits]}, "reply": exactly(FACE_BALL)},
                 {"when": {"unum": 10, "state": WITH_BALL}, "reply": exactly(kick(shooter, 2.0, 0.5))},
                 {"when": {"unum": 11, "state": WITH_BALL}, "reply": exactly(kick((GOAL_X, aim), 2.7, 1.5))},
                 {"when": {"unum": 11, "cycle": [WARM_UP + waits + 2, 1000]}, "reply": exactly(intercept)},
                 {"when": {"unum": [10, 11]}, "reply": exactly(FACE_BALL)}]
        return Moment(ball=passer, defenders={1: Player(-50, 0), 2: Player(-52, 30)},
                      attackers={1: Player(50, 0, 180), 10: Player(*behind, math.degrees(along)),
                                 11: Player(*shooter, -150)},
                      rules=rules, cycles=30, defense="mix:1=mock:planner;2-11=mock:hold;coach=mock:hold")

    panels = []
    for across in (0, 1):
        shots = {}
        for aim in aims:
            frames = games.play(moment(aim), {"goalie_across": across})
            changes = kicks(frames)
            shot = max(i for i in changes if meters(frames[i].ball, frames[i].at("r11")) < 2)
            is_goal = any(frame.mode == "goal_r" for frame in frames)
            stopped = [i for i in range(shot + 1, len(frames)) if frames[i].mode != "play_on" or i in changes]
            end = min(stopped, default=len(frames) - 1)
            shots[aim] = (frames, changes[0], shot, end, is_goal)
        goals = sum(shot[-1] for shot in shots.values())
        frames, passed, shot, end, _ = shots[3]
        turns = sum(abs(frames[i + 1].players["l1"][2] - frames[i].players["l1"][2]) > 1 for i in range(passed, end))
        panel = Panel(f"goalie_across = {across}", (-54, -7, -30, 21), 15,
                      [f"Goals (orange): {goals} of {len(aims)} shots",
                       f"During the thick one the goalie turns in {turns} of {end - passed} cycles"])
        for others, _, start, stop, is_goal in shots.values():
            panel.path([frame.ball for frame in others[start:stop + 1]], ".right-line" if is_goal else ".saved", 1.2)
        panel.disc("r10", frames[passed])
        panel.disc("r11", frames[shot])
        panel.ball_way(frames[passed:end + 1], width=2.5)
        panel.walk("l1", frames[passed:end + 1])
        panel.disc("l1", frames[shot], " faint", 6)
        panel.ball(frames[end])
        panels.append(panel)
    return panels


def dribble(carrier, target, dashes):
    """The rules of a player who keeps dribbling, as soon as the moment begins."""
    way = {"body_dribble": {"target_point": point(*target), "distance_threshold": 1, "dash_power": 100,
                            "dash_count": dashes}}
    return [{"when": {"unum": carrier, "cycle": [0, WARM_UP - 1]}, "reply": exactly(FACE_BALL)},
            {"when": {"unum": carrier}, "reply": exactly(way, {"body_intercept": {}})}]


def chase(games):
    """Tired players, whom a dribbler on the wing has passed."""
    ball, carrier = (4, 20), (4.5, 20)
    passed = [f"l{unum}" for unum in range(4, 9)]
    own = {1: (-48, 2), 2: (-22, -6), 3: (-22, 5), 4: (8, -12), 5: (12, 14), 6: (9, 2), 7: (18, -10), 8: (17, 12),
           9: (24, -14), 10: (25, 17), 11: (32, 0)}
    defenders = {unum: Player(*place, stamina=3300 if unum > 1 else STAMINA) for unum, place in own.items()}
    others = {1: (50, 0), 2: (36, -8), 3: (36, 6), 4: (28, -18), 5: (28, 20), 6: (24, 0), 7: (20, -4), 8: (20, 8),
              9: (2, 4), 10: (2, -12), 11: carrier}
    moment = Moment(ball, defenders, {unum: Player(*place, 180) for unum, place in others.items()},
                    dribble(11, (-44, 18), dashes=6), cycles=60)

    panels = []
    strong = {name: games.strong[name] for name in ("chase_stamina", "tired_below", "rested_above")}
    for title, values in (("without", {}), ("with", strong)):
        frames = games.play(moment, values)
        back = mean(frames[0].at(name)[0] - frames[-1].at(name)[0] for name in passed)
        behind = mean(frames[-1].at(name)[0] - frames[-1].ball[0] for name in passed)
        panel = Panel(f"{title} chase_stamina", (-52.5, -24, 32, 32), 4.2,
                      [f"In {len(frames) - 1} cycles players 4 to 8 run back {back:.0f} m",
                       f"and are {behind:.0f} m behind the ball"])
        for unum in (9, 10, 11):
            panel.disc(f"l{unum}", frames[0], " faint", 4)
        for unum in range(2, 11):
            panel.disc(f"r{unum}", frames[0], " faint", 4)
        panel.ball_way(frames, 2)
        panel.walk("r11", frames, 4, 1.2)
        for unum in range(1, 9):
            panel.walk(f"l{unum}", frames, 3)
        panels.append(panel)
    return panels


def backs(games):
    """A winger of the fastest type runs past a side back of the type that the coach gave it."""
    winger = Player(6, -20, 180, type=games.usual_types["r11"])
    fast_types = games.types(games.parameters({"fast_backs": 1}) + "=mock:planner", "fast")
    panels = []
    for fast, types in enumerate((games.usual_types, fast_types)):
        defenders = {1: Player(-49, 0), 2: Player(-42, -2), 3: Player(-42, 8), 5: Player(0, 16, 180),
                     4: Player(10, -17, 180, type=types["l4"])}
        run = dribble(11, (-46, -20), dashes=8)
        frames = games.play(Moment((5.5, -20), defenders, {11: winger}, run, cycles=32), {})
        apart = meters(frames[-1].at("l4"), frames[-1].at("r11"))
        panel = Panel(f"fast_backs = {fast}", (-30, -28, 14, -8), 8.1,
                      [f"After {len(frames) - 1} cycles player 4 is {apart:.0f} m from the winger"])
        panel.ball_way(frames)
        for name in ("r11", "l4"):
            panel.walk(name, frames)
        panels.append(panel)
    return panels


def legs(games):
    """A player who runs elsewhere, and then to a point behind it."""
    start = (-26, 0)
    target = (start[0] + 15, start[1])
    go = {"body_go_to_point": {"target_point": {"x": target[0], "y": target[1]}, "distance_threshold": 0.5,
                               "max_dash_power": 100}}
    runner = [{"when": {"unum": 7, "cycle": [0, WARM_UP - 1]}, "reply": exactly(FACE_BALL)},
              {"when": {"unum": 7}, "reply": exactly(go)}]
    panels = []
    for two in (0, 1):
        runs = games.script("run.json", runner)
        moment = Moment((20, 0), {7: Player(*start, body=-120, speed=0.5)}, {}, [], cycles=10, defense=runs)
        frames = games.play(moment, {"leg_dashes": two})
        panel = Panel(f"leg_dashes = {two}", (-29, -3, -9, 2.5), 18,
                      [f"After {len(frames) - 1} cycles {meters(frames[-1].at('l7'), target):.1f} m of 15 m are left"])
        panel.path([start, target], ".half", 1)
        panel.circle(*target, 4.5, ".spot")
        for frame in frames[:-1]:
            panel.disc("l7", frame, " faint", 6)
        panel.disc("l7", frames[-1])
        panels.append(panel)
    return panels


PICTURES = {"goalie-across": goalie, "chase-stamina": chase, "fast-backs": backs, "leg-dashes": legs}


def main(cls, folder):
    folder = Path(folder)
    drawn = (folder / "goal.svg").read_text(encoding="utf-8")
    colors = re.search("<style>(.*?)</style>", drawn, re.DOTALL).group(1)
    with tempfile.TemporaryDirectory() as work:
        games = Games(cls, work)
        for name, draw in PICTURES.items():
            save(folder / f"{name}.svg", draw(games), columns=2, scale=1, gap=16, style=colors + STYLE)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
