"""Matches of cls as tracking data of kloppy, from the tables of `cls convert`."""
from __future__ import annotations

import csv
import gzip
import os
from datetime import timedelta
from typing import Any, Dict, Iterator, List, Optional, TextIO, Tuple, Union

from kloppy.domain import (BallState, CustomCoordinateSystem, Dimension, Ground, Metadata,
                           MetricPitchDimensions, Orientation, Origin, Period, Player, PlayerData,
                           Point, Provider, Team, TrackingDataset, VerticalOrientation)
from kloppy.domain.services.frame_factory import create_frame

from cls_gym._config import ConfigError

FRAME_RATE = 10
_PLAYERS = 11
_NOT_PLAYED = ("", "before_kick_off", "half_time", "time_over", "time_up", "time_extended")
_KEPT = ("vx", "vy", "body", "neck", "stamina", "t")

Row = Dict[str, str]


def load_tracking(file: Union[str, os.PathLike[str]], *, limit: Optional[int] = None
                  ) -> TrackingDataset:
    """The match of a table `cls convert MATCH NAME.tracking.csv`, plain or gzip: a frame for each
    row in which a half is played, at most `limit`.

    Meters from the center of the pitch, y downwards, left to right for the left ("home") team in
    both halves; transform() gives other systems. The speed of players is in meters per second;
    their `other_data` has `vx`, `vy`, `body`, `neck`, `stamina` and the type `t` in the units of
    the table, that of a frame `cycle`, `playmode` and `score`. Players are "left_1" to "right_11".
    Raises ConfigError for a file that is no such table.
    """
    with _opened(file) as text:
        rows = list(_rows(text, os.fspath(file), limit))
    teams = [_team(rows, letter, side, ground) for letter, side, ground in
             (("l", "left", Ground.HOME), ("r", "right", Ground.AWAY))]
    periods = _periods(rows)
    system = CustomCoordinateSystem(
        Origin.CENTER, VerticalOrientation.TOP_TO_BOTTOM,
        MetricPitchDimensions(x_dim=Dimension(-52.5, 52.5), y_dim=Dimension(-34.0, 34.0),
                              pitch_length=105.0, pitch_width=68.0, standardized=False))
    about = Metadata(teams=teams, periods=periods, frame_rate=FRAME_RATE,
                     orientation=Orientation.STATIC_HOME_AWAY, flags=None,
                     pitch_dimensions=system.pitch_dimensions, coordinate_system=system,
                     provider=Provider.OTHER)
    frames = [_frame(row, number, periods[half], teams) for row, half, number in rows]
    dataset: TrackingDataset = TrackingDataset(records=frames, metadata=about)
    return dataset


def _opened(file: Union[str, os.PathLike[str]]) -> TextIO:
    kind: Any = gzip.open if os.fspath(file).endswith(".gz") else open
    text: TextIO = kind(file, "rt", encoding="utf-8", newline="")
    return text


def _rows(text: TextIO, name: str, limit: Optional[int]) -> Iterator[Tuple[Row, int, int]]:
    """Rows of halves, each with the number of its half and that in the half, from 0."""
    table = csv.DictReader(text, escapechar="\\", doublequote=False)
    missing = {"#", "cycle", "playmode", "b_x", "l1_x", "r11_y"} - set(table.fieldnames or ())
    if missing:
        raise ConfigError(f"load_tracking: {name} has no column {min(missing)!r}; write it with "
                          "`cls convert MATCH NAME.tracking.csv`")
    half, number, taken, before = -1, 0, 0, ""
    for row in table:
        mode, last = row["playmode"], before
        before = mode
        if mode in _NOT_PLAYED:
            continue
        if limit is not None and taken >= limit:
            return
        # A kick-off comes after a goal, or it begins a half.
        kicks_off = mode.startswith("kick_off_") and not last.startswith(("kick_off_", "goal_"))
        if last in _NOT_PLAYED or kicks_off:
            half, number = half + 1, 0
        yield row, half, number
        number += 1
        taken += 1
    if not taken:
        raise ConfigError(f"load_tracking: no half is played in {name}")


def _team(rows: List[Tuple[Row, int, int]], letter: str, side: str, ground: Ground) -> Team:
    name = next((row[f"{letter}_name"] for row, *_ in rows if row[f"{letter}_name"]), side)
    team = Team(team_id=side, name=name, ground=ground)
    team.players = [Player(player_id=f"{side}_{number}", team=team, jersey_no=number,
                           name=f"{name} {number}") for number in range(1, _PLAYERS + 1)]
    return team


def _periods(rows: List[Tuple[Row, int, int]]) -> List[Period]:
    """Halves, one after the other in time."""
    lengths: Dict[int, int] = {}
    for _, half, number in rows:
        lengths[half] = number + 1
    periods, start = [], 0
    for half, length in lengths.items():
        periods.append(Period(id=half + 1, start_timestamp=timedelta(seconds=start / FRAME_RATE),
                              end_timestamp=timedelta(seconds=(start + length) / FRAME_RATE)))
        start += length
    return periods


def _frame(row: Row, number: int, period: Period, teams: List[Team]) -> Any:
    players = {}
    for letter, team in zip("lr", teams):
        for player in team.players:
            data = _player(row, f"{letter}{player.jersey_no}_")
            if data is not None:
                players[player] = data
    mode = row["playmode"]
    about = {"cycle": int(row["cycle"]), "playmode": mode,
             "score": (int(row["l_score"] or 0), int(row["r_score"] or 0))}
    return create_frame(
        frame_id=int(row["#"]), timestamp=timedelta(seconds=number / FRAME_RATE), period=period,
        ball_coordinates=Point(float(row["b_x"]), float(row["b_y"])), players_data=players,
        ball_state=BallState.ALIVE if mode == "play_on" else BallState.DEAD,
        ball_owning_team=None, other_data=about)


def _player(row: Row, start: str) -> Optional[PlayerData]:
    """A player; None: not connected."""
    if not row[start + "x"]:
        return None
    kept = {key: float(row[start + key]) for key in _KEPT if row.get(start + key)}
    speed = None
    if "vx" in kept:
        speed = (kept["vx"] ** 2 + kept["vy"] ** 2) ** 0.5 * FRAME_RATE
    return PlayerData(coordinates=Point(float(row[start + "x"]), float(row[start + "y"])),
                      speed=speed, other_data=kept)
