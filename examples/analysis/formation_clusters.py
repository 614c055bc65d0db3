#!/usr/bin/env python3
"""The formations of a team: its places in play, sorted into clusters by k-means.

    cls convert game.rcg game.tracking.csv
    python3 examples/analysis/formation_clusters.py game.tracking.csv left formation.svg
"""
import sys

from svg import SCALE, Pitch, read, save

CLUSTERS = 4
EVERY = 25  # frames
ROUNDS = 50
COLORS = ("#0b6e4f", "#c8553d", "#2e5eaa", "#a06cd5")


def shape(row, letter):
    """Places of all players but the goalie, x and y in turn; nothing if one is missing."""
    values = [row[f"{letter}{i}_{axis}"] for i in range(2, 12) for axis in "xy"]
    return None if "" in values else [float(value) for value in values]


def distance(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b))


def cluster(shapes):
    # First centers: evenly distributed over the shapes, from the back of the pitch to the front.
    ordered = sorted(shapes, key=lambda one: sum(one[::2]))
    centers = [ordered[(2 * i + 1) * len(ordered) // (2 * CLUSTERS)] for i in range(CLUSTERS)]
    for _ in range(ROUNDS):
        members = [[] for _ in centers]
        for one in shapes:
            members[min(range(CLUSTERS), key=lambda i: distance(one, centers[i]))].append(one)
        moved = [[sum(axis) / len(own) for axis in zip(*own)] if own else center
                 for own, center in zip(members, centers)]
        if moved == centers:
            break
        centers = moved
    return centers, members


def main(path, side, out):
    frames = [row for row in read(path) if row["playmode"] == "play_on"][::EVERY]
    shapes = [one for row in frames if (one := shape(row, side[0]))]
    if len(shapes) < CLUSTERS:
        sys.exit(f"{path}: only {len(shapes)} frames in play with all players")
    centers, members = cluster(shapes)

    pitches = []
    for color, center, own in zip(COLORS, centers, members):
        pitch = Pitch(f"{100 * len(own) / len(shapes):.0f} % of {len(shapes)} frames in play, {side} team")
        pitch.lines()
        for i in range(0, len(center), 2):
            # Where the player was in a third of these frames, as the radius.
            spread = sorted(distance(center[i:i + 2], one[i:i + 2]) for one in own)
            radius = spread[len(spread) // 3] ** 0.5 if spread else 0
            pitch.circle(*center[i:i + 2], radius * SCALE, color + "30", "none")
        for i in range(0, len(center), 2):
            pitch.circle(*center[i:i + 2], 15, color)
            pitch.text(*center[i:i + 2], str(i // 2 + 2), 18, "white")
        pitches.append(pitch)
    save(out, pitches, columns=2)
    for center, own in zip(centers, members):
        print(f"{len(own)} frames, mean x {sum(center[::2]) * 2 / len(center):.1f}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
