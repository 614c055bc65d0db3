#!/usr/bin/env python3
"""Expected threat: the probability that possession in a cell of the pitch ends in a goal, as a map.

    cls stats cup --format csv-events > events.csv
    python3 examples/analysis/expected_threat.py events.csv threat.svg

In each cell a team shoots or moves the ball, as often as it did in the matches. A shot scores as often as
shots did there; a completed move is worth what its target is worth.
"""
import sys

from svg import LENGTH, WIDTH, Pitch, read, save

COLUMNS, ROWS = 12, 8
ROUNDS = 10  # moves ahead


def cell(x, y):
    column = min(max(int((x / LENGTH + 0.5) * COLUMNS), 0), COLUMNS - 1)
    row = min(max(int((y / WIDTH + 0.5) * ROWS), 0), ROWS - 1)
    return row * COLUMNS + column


def seen(row, end):
    """A point as the team sees it that attacks to the right."""
    sign = 1 if row["side"] == "left" else -1
    return sign * float(row[end + "_x"]), sign * float(row[end + "_y"])


def main(path, out):
    cells = COLUMNS * ROWS
    shots, goals, tries = [0] * cells, [0] * cells, [0] * cells
    moves = [[0] * cells for _ in range(cells)]
    for row in read(path):
        if row["kind"] not in ("pass", "carry", "shot"):
            continue
        start = cell(*seen(row, "from"))
        tries[start] += 1
        if row["kind"] == "shot":
            shots[start] += 1
            goals[start] += row["result"] == "goal"
        elif row["kind"] == "carry" or row["result"] == "completed":
            moves[start][cell(*seen(row, "to"))] += 1

    threat = [0.0] * cells
    for _ in range(ROUNDS):
        threat = [(goals[i] + sum(count * threat[j] for j, count in enumerate(moves[i]) if count)) / tries[i]
                  if tries[i] else 0.0 for i in range(cells)]

    highest = max(threat) or 1.0
    pitch = Pitch(f"Expected threat in %, attack to the right: {sum(tries)} actions, {sum(shots)} shots, "
                  f"{sum(goals)} goals")
    width, height = LENGTH / COLUMNS, WIDTH / ROWS
    for i, value in enumerate(threat):
        x, y = i % COLUMNS * width - LENGTH / 2, i // COLUMNS * height - WIDTH / 2
        shade = f"rgba(11,110,79,{(value / highest) ** 0.5:.3f})"
        pitch.rectangle(x, y, width, height, shade, "#ffffff")
    pitch.lines()
    for i, value in enumerate(threat):
        x, y = i % COLUMNS * width - LENGTH / 2, i // COLUMNS * height - WIDTH / 2
        color = "white" if value > 0.3 * highest else "#22302b"
        pitch.text(x + width / 2, y + height / 2, f"{100 * value:.1f}" if tries[i] else "-", 12, color)
    save(out, [pitch])

    print(f"shots {sum(shots)}")
    print(f"goals {sum(goals)}")
    print(f"highest threat {max(threat):.4f}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
