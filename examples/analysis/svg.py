"""Pictures of a pitch as SVG, without libraries."""
import csv

LENGTH, WIDTH = 105.0, 68.0  # meters
SCALE, MARGIN, TITLE = 8, 16, 40
LINE, TEXT = "#9aa5a0", "#22302b"


def read(path):
    """The rows of a table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Pitch:
    """Draws in meters from the center; y grows downwards."""

    def __init__(self, title):
        self.width = LENGTH * SCALE + 2 * MARGIN
        self.height = WIDTH * SCALE + 2 * MARGIN + TITLE
        self.parts = []
        self.text(0, -WIDTH / 2 - 3, title, 18)

    def x(self, x):
        return round(MARGIN + (x + LENGTH / 2) * SCALE, 1)

    def y(self, y):
        return round(TITLE + MARGIN + (y + WIDTH / 2) * SCALE, 1)

    def lines(self):
        """The lines of the pitch, over what was drawn before."""
        self.rectangle(-LENGTH / 2, -WIDTH / 2, LENGTH, WIDTH)
        for side in (-1, 1):
            self.rectangle(min(side * LENGTH / 2, side * 36), -20.16, 16.5, 40.32)
            self.rectangle(min(side * LENGTH / 2, side * (LENGTH / 2 + 1.5)), -7.01, 1.5, 14.02)
        self.line(0, -WIDTH / 2, 0, WIDTH / 2, LINE, 1.5)
        self.circle(0, 0, 9.15 * SCALE, "none", LINE)

    def rectangle(self, x, y, width, height, fill="none", stroke=LINE):
        self.parts.append(f'<rect x="{self.x(x)}" y="{self.y(y)}" width="{width * SCALE:.1f}" '
                          f'height="{height * SCALE:.1f}" fill="{fill}" stroke="{stroke}" stroke-width="1.5"/>')

    def line(self, x1, y1, x2, y2, color, width):
        self.parts.append(f'<line x1="{self.x(x1)}" y1="{self.y(y1)}" x2="{self.x(x2)}" y2="{self.y(y2)}" '
                          f'stroke="{color}" stroke-width="{width:.1f}" stroke-linecap="round"/>')

    def circle(self, x, y, radius, fill, stroke="white"):
        self.parts.append(f'<circle cx="{self.x(x)}" cy="{self.y(y)}" r="{radius:.1f}" fill="{fill}" '
                          f'stroke="{stroke}" stroke-width="1.5"/>')

    def text(self, x, y, text, size=12, color=TEXT):
        text = text.replace("&", "&amp;").replace("<", "&lt;")
        self.parts.append(f'<text x="{self.x(x)}" y="{self.y(y)}" font-size="{size}" fill="{color}" '
                          f'text-anchor="middle" dominant-baseline="central">{text}</text>')

def save(path, pitches, columns=1):
    """Writes the pitches into one picture, row by row."""
    width, height = pitches[0].width, pitches[0].height
    rows = -(-len(pitches) // columns)
    scale = 1 / columns
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" '
                   f'height="{height * rows * scale:.0f}" font-family="sans-serif">\n'
                   '<rect width="100%" height="100%" fill="white"/>\n')
        for i, pitch in enumerate(pitches):
            x, y = i % columns * width * scale, i // columns * height * scale
            file.write(f'<g transform="translate({x:.0f} {y:.0f}) scale({scale:.3f})">\n'
                       + "\n".join(pitch.parts) + "\n</g>\n")
        file.write("</svg>\n")
