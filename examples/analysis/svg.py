"""Pictures of a pitch as SVG, without libraries."""
import csv

LENGTH, WIDTH = 105.0, 68.0  # meters
SCALE, MARGIN, TITLE = 8, 16, 40
LINE, TEXT = "#9aa5a0", "#22302b"
WHOLE = (-LENGTH / 2, -WIDTH / 2, LENGTH / 2, WIDTH / 2)
NOTE = 18  # height of a line below a pitch


def read(path):
    """The rows of a table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def look(fill, stroke="none", width=0.0):
    """The attributes of a shape. A fill that begins with a point is a class of the style sheet that save() gets."""
    colors = f'class="{fill[1:]}"' if fill.startswith(".") else f'fill="{fill}" stroke="{stroke}"'
    return colors + (f' stroke-width="{width:.1f}"' if width else "")


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;")


class Pitch:
    """Draws in meters from the center; y grows downwards. `area` is what it shows: left, top, right and bottom;
    `notes` are lines of text below."""
    line_color, text_color, note_color = LINE, TEXT, TEXT

    def __init__(self, title, area=WHOLE, scale=SCALE, notes=()):
        self.title, self.area, self.scale, self.notes = title, area, scale, notes
        left, top, right, bottom = area
        self.width = (right - left) * scale + 2 * MARGIN
        self.field_height = (bottom - top) * scale + 2 * MARGIN
        self.height = TITLE + self.field_height + (NOTE * len(notes) + 8 if notes else 0)
        self.parts = []

    def x(self, x):
        return round(MARGIN + (x - self.area[0]) * self.scale, 1)

    def y(self, y):
        return round(MARGIN + (y - self.area[1]) * self.scale, 1)

    def lines(self):
        """The lines of the pitch, over what was drawn before."""
        self.rectangle(-LENGTH / 2, -WIDTH / 2, LENGTH, WIDTH)
        for side in (-1, 1):
            self.rectangle(min(side * LENGTH / 2, side * 36), -20.16, 16.5, 40.32)
            self.rectangle(min(side * LENGTH / 2, side * (LENGTH / 2 + 1.5)), -7.01, 1.5, 14.02)
        self.line(0, -WIDTH / 2, 0, WIDTH / 2, self.line_color, 1.5)
        self.circle(0, 0, 9.15 * self.scale, *self.outline())

    def outline(self):
        """Fill and stroke of a shape of which only the line is seen."""
        return (self.line_color,) if self.line_color.startswith(".") else ("none", self.line_color)

    def rectangle(self, x, y, width, height, *colors):
        self.parts.append(f'<rect x="{self.x(x)}" y="{self.y(y)}" width="{width * self.scale:.1f}" '
                          f'height="{height * self.scale:.1f}" {look(*(colors or self.outline()), width=1.5)}/>')

    def line(self, x1, y1, x2, y2, color, width):
        self.path([(x1, y1), (x2, y2)], color, width)

    def path(self, points, color, width):
        colors = (color,) if color.startswith(".") else ("none", color)
        places = " ".join(f"{self.x(x)},{self.y(y)}" for x, y in points)
        self.parts.append(f'<polyline points="{places}" {look(*colors, width=width)} stroke-linecap="round"/>')

    def circle(self, x, y, radius, fill, stroke="white"):
        self.parts.append(f'<circle cx="{self.x(x)}" cy="{self.y(y)}" r="{radius:.1f}" {look(fill, stroke, 1.5)}/>')

    def text(self, x, y, text, size=12, color=TEXT):
        self.parts.append(f'<text x="{self.x(x)}" y="{self.y(y)}" font-size="{size}" {look(color)} '
                          f'text-anchor="middle" dominant-baseline="central">{escaped(text)}</text>')

    def picture(self):
        """The parts of the area, cut at its margin, with title and notes."""
        lines = [f'<text x="{self.width / 2:.0f}" y="{TITLE - 8}" font-size="18" {look(self.text_color)} '
                 f'text-anchor="middle">{escaped(self.title)}</text>',
                 f'<svg y="{TITLE}" width="{self.width:.0f}" height="{self.field_height:.0f}">', *self.parts, "</svg>"]
        for i, note in enumerate(self.notes):
            lines.append(f'<text x="{self.width / 2:.0f}" y="{TITLE + self.field_height + NOTE * i + 17:.0f}" '
                         f'font-size="13" {look(self.note_color)} text-anchor="middle">{escaped(note)}</text>')
        return "\n".join(lines)


def save(path, pitches, columns=1, scale=None, gap=0, style=""):
    """Writes the pitches into one picture, row by row, scaled to the width of one of them unless `scale` is given."""
    scale = scale or 1 / columns
    width, height = pitches[0].width * scale, pitches[0].height * scale
    across, down = (width + gap) * columns - gap, height * -(-len(pitches) // columns)
    titles = escaped("; ".join(pitch.title for pitch in pitches)).replace('"', "&quot;")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" class="chart" viewBox="0 0 {across:.0f} {down:.0f}" '
                   f'width="{across:.0f}" height="{down:.0f}" role="img" aria-label="{titles}" '
                   'font-family="sans-serif">\n')
        if style:
            file.write(f"<style>{style}</style>\n")
        file.write('<rect width="100%" height="100%" fill="white" class="ground"/>\n')
        for i, pitch in enumerate(pitches):
            x, y = i % columns * (width + gap), i // columns * height
            file.write(f'<g transform="translate({x:.0f} {y:.0f}) scale({scale:.3f})">\n{pitch.picture()}\n</g>\n')
        file.write("</svg>\n")
