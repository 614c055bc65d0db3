#!/usr/bin/env python3
"""Draws the learning curves of learn_numpy.py and learn_torch.py (--curve) as SVG.

    python3 examples/training/plot_curves.py curves.svg curve-1.json curve-2.json
"""
import argparse
import json
import sys

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 720, 360, 64, 40, 24, 48
COLORS = ("#0b6e4f", "#c8553d", "#2e5eaa", "#a06cd5", "#d4a017")


def smooth(values, width=5):
    """Means of the last few values."""
    return [sum(values[max(0, i - width + 1):i + 1]) / len(values[max(0, i - width + 1):i + 1])
            for i in range(len(values))]


def ticks(end):
    """Four to nine round numbers from 0 to `end`."""
    step = 10 ** (len(str(int(end))) - 1)
    while end < 4 * step:
        step /= 2
    return [step * i for i in range(int(end / step) + 1)]


def main(out, paths, title):
    runs = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            runs.append(json.load(file))
    end = max(run["curve"][-1][0] for run in runs)

    def x(steps):
        return LEFT + (WIDTH - LEFT - RIGHT) * steps / end

    def y(share):
        return TOP + (HEIGHT - TOP - BOTTOM) * (1 - share)

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
             'font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
             f'<text x="{LEFT}" y="22" font-size="15">{title}</text>']
    for share in (0, 0.25, 0.5, 0.75, 1):
        lines.append(f'<path d="M{LEFT} {y(share):.1f}H{WIDTH - RIGHT}" stroke="#dddddd"/>'
                     f'<text x="{LEFT - 8}" y="{y(share) + 4:.1f}" text-anchor="end">'
                     f'{share:.2f}</text>')
    for steps in ticks(end):
        lines.append(f'<text x="{x(steps):.1f}" y="{HEIGHT - 26}" text-anchor="middle">'
                     f'{steps / 1000:.0f} k</text>')
    lines.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" '
                 'text-anchor="middle">steps of the worlds together</text>')
    for number, run in enumerate(runs):
        color = COLORS[number % len(COLORS)]
        shares = smooth([point[1] for point in run["curve"]])
        points = " ".join(f"{x(point[0]):.1f},{y(share):.1f}"
                          for point, share in zip(run["curve"], shares))
        lines.append(f'<polyline points="{points}" fill="none" stroke="{color}" '
                     'stroke-width="2"/>')
        # A training that was interrupted has no evaluation.
        result = f': {run["goals"]:.3f} of {run["episodes"]} fresh' if "goals" in run else ""
        at = y(0.04) - 20 * (len(runs) - 1 - number)
        lines.append(f'<path d="M{WIDTH - 260} {at - 4:.0f}h22" stroke="{color}" '
                     f'stroke-width="2"/><text x="{WIDTH - 232}" y="{at:.0f}">{run["label"]}{result}</text>')
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "</svg>\n"]))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", metavar="OUT.svg")
    parser.add_argument("curves", metavar="CURVE.json", nargs="+")
    parser.add_argument("--title", default="Share of training episodes that end with a goal")
    options = parser.parse_args()
    sys.exit(main(options.out, options.curves, options.title))
