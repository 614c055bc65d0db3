"""Images of a situation: text for a terminal and pixels, with NumPy alone."""
from __future__ import annotations

import functools
import sys
from typing import List, NamedTuple, Sequence, Tuple

import numpy as np

HALF_LENGTH, HALF_WIDTH = 52.5, 34.0  # of the pitch, in meters
MARGIN = 4.0                          # around the pitch, in meters
GOAL_HALF_WIDTH, GOAL_DEPTH = 7.01, 2.44


class Player(NamedTuple):
    """A player on the pitch. x, y in meters from the center, +x to the right goal, +y down."""

    side: str      # "left" or "right"
    number: int    # 1 to 11
    x: float
    y: float
    body: float    # direction in degrees, clockwise as in the soccer server
    goalie: bool
    agent: bool    # controlled by the caller's actions


class Frame(NamedTuple):
    """What a render shows."""

    title: str
    ball: Tuple[float, float]
    players: Sequence[Player]
    half: bool     # show only x >= 0


# ---- text

_COLUMNS, _ROWS = 78, 25


def ansi(frame: Frame) -> str:
    """The situation as 27 lines of at most 80 columns.

    `o` is the ball, digits are left players (uniform number; 0 is 10, # is 11), letters a to k are
    right players 1 to 11.
    """
    left = 0.0 if frame.half else -HALF_LENGTH
    cells = [[" "] * _COLUMNS for _ in range(_ROWS)]

    def put(x: float, y: float, text: str) -> None:
        column = round((x - left) / (HALF_LENGTH - left) * (_COLUMNS - 1))
        row = round((y + HALF_WIDTH) / (2 * HALF_WIDTH) * (_ROWS - 1))
        cells[min(max(row, 0), _ROWS - 1)][min(max(column, 0), _COLUMNS - 1)] = text

    for y in np.arange(-HALF_WIDTH, HALF_WIDTH + 1, 2.8):
        put(36.0, float(np.clip(y, -20.16, 20.16)), ".")
        if not frame.half:
            put(-36.0, float(np.clip(y, -20.16, 20.16)), ".")
            put(0.0, float(y), ".")
    for y in (-GOAL_HALF_WIDTH, GOAL_HALF_WIDTH):
        put(HALF_LENGTH, y, "+")
        if not frame.half:
            put(-HALF_LENGTH, y, "+")
    for player in frame.players:
        names = "1234567890#" if player.side == "left" else "abcdefghijk"
        put(player.x, player.y, names[player.number - 1])
    put(*frame.ball, "o")
    border = "+" + "-" * _COLUMNS + "+"
    lines = [border, *("|" + "".join(row) + "|" for row in cells), border]
    return "\n".join([frame.title, *lines]) + "\n"


def show(frame: Frame) -> None:
    """Writes the text to stdout; on a terminal, over the one before."""
    home = "\x1b[H\x1b[2J" if sys.stdout.isatty() else ""
    sys.stdout.write(home + ansi(frame))
    sys.stdout.flush()


# ---- pixels

_SCALE = 8       # pixels per meter
_OVERSAMPLE = 2  # in both directions, averaged at the end
_GRASS = (62, 128, 70)
_GRASS_DARK = (56, 119, 64)
_LINE = (232, 238, 232)
_COLORS = {"left": (246, 205, 58), "right": (214, 62, 58)}
_GOALIES = {"left": (64, 190, 110), "right": (190, 92, 214)}
_FONT = {  # 3 x 5 pixels, row by row
    "0": "111101101101111", "1": "010110010010111", "2": "111001111100111",
    "3": "111001111001111", "4": "101101111001001", "5": "111100111001111",
    "6": "111100111101111", "7": "111001001001001", "8": "111101111101111",
    "9": "111101111001111",
}


class _Canvas:
    """An image in meters: (left, -HALF_WIDTH - MARGIN) is its upper left corner."""

    def __init__(self, left: float) -> None:
        self.left = left
        self.top = -HALF_WIDTH - MARGIN
        self.scale = _SCALE * _OVERSAMPLE
        width = round((HALF_LENGTH + MARGIN - left) * self.scale)
        height = round(2 * (HALF_WIDTH + MARGIN) * self.scale)
        self.pixels = np.empty((height, width, 3), np.uint8)

    def _region(self, x0: float, y0: float, x1: float, y1: float) -> Tuple[slice, slice]:
        rows = [round((y - self.top) * self.scale) for y in (y0, y1)]
        columns = [round((x - self.left) * self.scale) for x in (x0, x1)]
        return slice(max(rows[0], 0), max(rows[1], 0)), slice(max(columns[0], 0),
                                                              max(columns[1], 0))

    def rectangle(self, x0: float, y0: float, x1: float, y1: float,
                  color: Tuple[int, int, int]) -> None:
        self.pixels[self._region(x0, y0, x1, y1)] = color

    def outline(self, x0: float, y0: float, x1: float, y1: float, thick: float = 0.2) -> None:
        h = thick / 2
        for x in (x0, x1):
            self.rectangle(x - h, y0 - h, x + h, y1 + h, _LINE)
        for y in (y0, y1):
            self.rectangle(x0 - h, y - h, x1 + h, y + h, _LINE)

    def ring(self, x: float, y: float, radius: float, hole: float, color: Tuple[int, int, int],
             beyond: float = -np.inf, below: float = np.inf) -> None:
        """A ring; `hole` 0 makes it a disk. Only its part with beyond <= x <= below."""
        rows, columns = self._region(x - radius - 0.5, y - radius - 0.5, x + radius + 0.5,
                                     y + radius + 0.5)
        part = self.pixels[rows, columns]
        ys = (np.arange(part.shape[0]) + rows.start + 0.5) / self.scale + self.top
        xs = (np.arange(part.shape[1]) + columns.start + 0.5) / self.scale + self.left
        distance = np.hypot(xs[None, :] - x, ys[:, None] - y)
        inside = (distance <= radius) & (distance >= hole)
        part[inside & ((xs >= beyond) & (xs <= below))[None, :]] = color

    def beam(self, x: float, y: float, degrees: float, length: float,
             color: Tuple[int, int, int]) -> None:
        """A short line from (x, y)."""
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        for t in np.linspace(0.0, length, 24):
            self.ring(x + t * c, y + t * s, 0.17, 0.0, color)

    def number(self, x: float, y: float, text: str, color: Tuple[int, int, int]) -> None:
        """Digits centered at (x, y)."""
        size = 0.22
        start = x - size * (4 * len(text) - 1) / 2
        for place, digit in enumerate(text):
            for index, bit in enumerate(_FONT[digit]):
                if bit == "1":
                    px = start + size * (4 * place + index % 3)
                    py = y + size * (index // 3 - 2.5)
                    self.rectangle(px, py, px + size, py + size, color)

    def image(self) -> np.ndarray:
        height, width = (n // _OVERSAMPLE for n in self.pixels.shape[:2])
        blocks = self.pixels[:height * _OVERSAMPLE, :width * _OVERSAMPLE].reshape(
            height, _OVERSAMPLE, width, _OVERSAMPLE, 3)
        return blocks.mean(axis=(1, 3)).round().astype(np.uint8)


@functools.lru_cache(maxsize=2)
def _pitch(half: bool) -> np.ndarray:
    """The empty pitch, oversampled."""
    left = -2.0 if half else -HALF_LENGTH - MARGIN
    canvas = _Canvas(left)
    canvas.pixels[:] = _GRASS
    for stripe in range(-6, 6, 2):
        canvas.rectangle(stripe * 10.5 + 10.5, canvas.top, stripe * 10.5 + 21.0, -canvas.top,
                         _GRASS_DARK)
    canvas.outline(-HALF_LENGTH, -HALF_WIDTH, HALF_LENGTH, HALF_WIDTH)
    canvas.rectangle(-0.1, -HALF_WIDTH, 0.1, HALF_WIDTH, _LINE)
    canvas.ring(0.0, 0.0, 9.25, 9.05, _LINE)
    for side in (-1, 1):
        goal = sorted((side * HALF_LENGTH, side * (HALF_LENGTH + GOAL_DEPTH)))
        canvas.rectangle(goal[0], -GOAL_HALF_WIDTH, goal[1], GOAL_HALF_WIDTH, (196, 202, 208))
        for depth, width in ((16.5, 20.16), (5.5, 9.16)):
            x = sorted((side * (HALF_LENGTH - depth), side * HALF_LENGTH))
            canvas.outline(x[0], -width, x[1], width)
        spot = side * (HALF_LENGTH - 11.0)
        canvas.ring(spot, 0.0, 0.35, 0.0, _LINE)
        edge = HALF_LENGTH - 16.5
        canvas.ring(spot, 0.0, 9.25, 9.05, _LINE, beyond=-edge if side < 0 else -np.inf,
                    below=edge if side > 0 else np.inf)
    return canvas.pixels


def rgb_array(frame: Frame) -> np.ndarray:
    """The situation as uint8[height, width, 3]: 608 x 904 pixels, half a pitch 608 x 468."""
    canvas = _Canvas(-2.0 if frame.half else -HALF_LENGTH - MARGIN)
    canvas.pixels[:] = _pitch(frame.half)
    dark: Tuple[int, int, int] = (24, 28, 30)
    for player in frame.players:
        color = (_GOALIES if player.goalie else _COLORS)[player.side]
        if player.agent:
            canvas.ring(player.x, player.y, 1.55, 1.25, (255, 255, 255))
        canvas.ring(player.x, player.y, 1.15, 0.0, dark)
        canvas.ring(player.x, player.y, 1.0, 0.0, color)
        canvas.beam(player.x + 1.0 * np.cos(np.radians(player.body)),
                    player.y + 1.0 * np.sin(np.radians(player.body)), player.body, 0.9, dark)
        canvas.number(player.x, player.y, str(player.number), dark)
    canvas.ring(*frame.ball, 0.6, 0.0, dark)
    canvas.ring(*frame.ball, 0.48, 0.0, (255, 255, 255))
    return canvas.image()


__all__: List[str] = ["Frame", "Player", "ansi", "rgb_array", "show"]
