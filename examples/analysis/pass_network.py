#!/usr/bin/env python3
"""Who passes to whom: a picture from the table of events.

    cls stats game.rcg --format csv-events > events.csv
    python3 examples/analysis/pass_network.py events.csv left network.svg
"""
import sys
from collections import Counter, defaultdict

from svg import Pitch, read, save

COLOR = {"left": "#0b6e4f", "right": "#c8553d"}
MIN_PASSES = 3  # lines below are left out of the picture


def main(path, side, out):
    passes = [row for row in read(path) if row["kind"] == "pass" and row["side"] == side]
    completed = [row for row in passes if row["result"] == "completed"]
    pairs = Counter((row["unum"], row["other_unum"]) for row in completed)

    # A player stands where its passes begin and where it receives.
    places = defaultdict(list)
    for row in completed:
        places[row["unum"]].append((float(row["from_x"]), float(row["from_y"])))
        places[row["other_unum"]].append((float(row["to_x"]), float(row["to_y"])))
    mean = {unum: tuple(sum(axis) / len(axis) for axis in zip(*points)) for unum, points in places.items()}

    between = Counter()
    for (passer, receiver), count in pairs.items():
        between[tuple(sorted((passer, receiver)))] += count
    pitch = Pitch(f"Passes of the {side} team: {len(completed)} of {len(passes)} completed")
    pitch.lines()
    for (one, other), count in sorted(between.items(), key=lambda item: item[1]):
        if count >= MIN_PASSES:
            pitch.line(*mean[one], *mean[other], COLOR[side] + "80", count)
    for unum, (x, y) in mean.items():
        pitch.circle(x, y, 8 + len(places[unum]) ** 0.5, COLOR[side])
        pitch.text(x, y, unum, 13, "white")
    save(out, [pitch])

    print(f"attempted {len(passes)}")
    print(f"completed {len(completed)}")
    for (passer, receiver), count in pairs.most_common(5):
        print(f"{passer} to {receiver}: {count}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
