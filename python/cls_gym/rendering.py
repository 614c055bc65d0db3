"""Images of a situation: text for a terminal and pixels, with NumPy alone."""
from __future__ import annotations

import functools
import sys
import threading
from typing import Callable, List, NamedTuple, Sequence, Tuple

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


def _averaged(pixels: np.ndarray) -> np.ndarray:
    """Blocks of _OVERSAMPLE x _OVERSAMPLE pixels as one pixel each."""
    height, width = (n // _OVERSAMPLE for n in pixels.shape[:2])
    blocks = pixels.reshape(height, _OVERSAMPLE, width, _OVERSAMPLE, 3)
    sums: np.ndarray = blocks.sum(axis=(1, 3), dtype=np.uint16)
    return ((sums + _OVERSAMPLE ** 2 // 2) // _OVERSAMPLE ** 2).astype(np.uint8)


class _Sprite(NamedTuple):
    """A picture in oversampled pixels around a point, with the places that it covers."""

    mask: np.ndarray    # bool[2 r, 2 r]
    pixels: np.ndarray  # uint8[2 r, 2 r, 3]


_DRAWING = threading.Lock()
_TURN = 5    # degrees between the pictures of a player
_REACH = 34  # half the size of a sprite in oversampled pixels; a player with its beam has 1.9 m
_DARK = (24, 28, 30)


@functools.lru_cache(maxsize=4096)
def _player_sprite(side: str, number: int, goalie: bool, agent: bool, degrees: int) -> _Sprite:
    places = (np.arange(-_REACH, _REACH) + 0.5) / (_SCALE * _OVERSAMPLE)
    x, y = places[None, :], places[:, None]
    distance = np.hypot(x, y)
    pixels = np.zeros((2 * _REACH, 2 * _REACH, 3), np.uint8)
    mask = np.zeros((2 * _REACH, 2 * _REACH), np.bool_)

    def paint(where: np.ndarray, color: Tuple[int, int, int]) -> None:
        pixels[where] = color
        mask[where] = True

    if agent:
        paint((distance <= 1.55) & (distance >= 1.25), (255, 255, 255))
    paint(distance <= 1.15, _DARK)
    paint(distance <= 1.0, (_GOALIES if goalie else _COLORS)[side])
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    along = np.clip(x * c + y * s, 1.0, 1.9)
    paint(np.hypot(x - along * c, y - along * s) <= 0.17, _DARK)
    _paint_number(str(number), paint)
    return _Sprite(mask, pixels)


def _paint_number(text: str, paint: Callable[[np.ndarray, Tuple[int, int, int]], None]) -> None:
    """Digits in the center."""
    size = round(0.22 * _SCALE * _OVERSAMPLE)
    where = np.zeros((2 * _REACH, 2 * _REACH), np.bool_)
    start = _REACH - size * (4 * len(text) - 1) // 2
    for place, digit in enumerate(text):
        for index, bit in enumerate(_FONT[digit]):
            if bit == "1":
                column = start + size * (4 * place + index % 3)
                row = _REACH + size * (index // 3) - 5 * size // 2
                where[row:row + size, column:column + size] = True
    paint(where, _DARK)


@functools.lru_cache(maxsize=1)
def _ball_sprite() -> _Sprite:
    places = (np.arange(-_REACH, _REACH) + 0.5) / (_SCALE * _OVERSAMPLE)
    distance = np.hypot(places[None, :], places[:, None])
    pixels = np.where((distance <= 0.48)[..., None], np.uint8(255), np.array(_DARK, np.uint8))
    return _Sprite(distance <= 0.6, pixels)


class _Scene:
    """The empty pitch, on which the sprites of one frame at a time are drawn."""

    def __init__(self, half: bool) -> None:
        canvas = _empty_pitch(half)
        self.left, self.top, self.scale = canvas.left, canvas.top, canvas.scale
        self.empty = canvas.pixels
        self.fine = canvas.pixels.copy()      # oversampled
        self.coarse = _averaged(canvas.pixels)
        self.boxes: List[Tuple[slice, slice]] = []

    def draw(self, x: float, y: float, sprite: _Sprite) -> None:
        height, width = self.fine.shape[:2]
        row = round((y - self.top) * self.scale) - _REACH
        column = round((x - self.left) * self.scale) - _REACH
        rows = slice(min(max(row, 0), height), min(max(row + 2 * _REACH, 0), height))
        columns = slice(min(max(column, 0), width), min(max(column + 2 * _REACH, 0), width))
        if rows.start == rows.stop or columns.start == columns.stop:
            return
        part = (slice(rows.start - row, rows.stop - row),
                slice(columns.start - column, columns.stop - column))
        np.copyto(self.fine[rows, columns], sprite.pixels[part], where=sprite.mask[part][..., None])
        self.boxes.append((rows, columns))

    def image(self) -> np.ndarray:
        """The frame; the pitch is empty again."""
        image = self.coarse.copy()
        for box in self.boxes:
            fine, coarse = zip(*(_whole_pixels(one) for one in box))
            image[coarse] = _averaged(self.fine[fine])
        for box in self.boxes:
            self.fine[box] = self.empty[box]
        self.boxes.clear()
        return image


def _whole_pixels(part: slice) -> Tuple[slice, slice]:
    """The pixels of the image that a range of oversampled pixels touches: fine, coarse."""
    first, last = part.start // _OVERSAMPLE, -(-part.stop // _OVERSAMPLE)
    return slice(first * _OVERSAMPLE, last * _OVERSAMPLE), slice(first, last)


def _empty_pitch(half: bool) -> _Canvas:
    """Lines and goals."""
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
    return canvas


@functools.lru_cache(maxsize=2)
def _scene(half: bool) -> _Scene:
    return _Scene(half)


def rgb_array(frame: Frame) -> np.ndarray:
    """The situation as uint8[height, width, 3]: 608 x 904 pixels, half a pitch 608 x 468."""
    with _DRAWING:  # the pitch is shared
        scene = _scene(frame.half)
        for player in frame.players:
            scene.draw(player.x, player.y,
                       _player_sprite(player.side, player.number, player.goalie, player.agent,
                                      round(player.body / _TURN) * _TURN % 360))
        scene.draw(*frame.ball, _ball_sprite())
        return scene.image()


__all__: List[str] = ["Frame", "Player", "ansi", "rgb_array", "show"]
