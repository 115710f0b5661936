# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""A small canvas that writes SVG: panels with a world of metres in them, and the shapes that figures of arcs need."""

from math import cos, radians, sin
from xml.sax.saxutils import escape

INK, PAPER, GREY, BLUE, MAGENTA, GREEN, AMBER = ("#18212B", "#F7F8FA", "#8A97A5", "#1763C6", "#C2185B", "#1B7F4B",
                                                  "#B26A00")

Point = tuple[float, float]


class Canvas:
    """Collects shapes in pixels; `text` is the picture."""

    def __init__(self, width: int, height: int, title: str):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                      f'height="{height}" font-family="sans-serif" font-size="13" fill="{INK}">',
                      f"<title>{escape(title)}</title>",
                      f'<rect width="{width}" height="{height}" fill="{PAPER}"/>']

    def add(self, part: str) -> None:
        self.parts.append(part)

    def label(self, x: float, y: float, words: str, colour: str = INK, anchor: str = "start", size: int = 13,
              weight: str = "normal") -> None:
        self.add(f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size}" '
                 f'font-weight="{weight}">{escape(words)}</text>')

    def bar(self, x: float, y: float, width: float, height: float, colour: str, opacity: float = 1.0) -> None:
        self.add(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{colour}" '
                 f'fill-opacity="{opacity}"/>')

    def stroke(self, x1: float, y1: float, x2: float, y2: float, colour: str = INK, width: float = 1.0,
               dash: str = "") -> None:
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.add(f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="{colour}" stroke-width="{width}"{dashes}/>')

    def text(self) -> str:
        return "\n".join([*self.parts, "</svg>"]) + "\n"


class Panel:
    """A part of a canvas that shows a piece of the world, x to the right and y up, in metres."""

    def __init__(self, canvas: Canvas, left: float, top: float, scale: float, x_low: float, y_high: float):
        self.canvas, self.left, self.top, self.scale, self.x_low, self.y_high = canvas, left, top, scale, x_low, y_high

    def place(self, p: Point) -> Point:
        return self.left + (p[0] - self.x_low) * self.scale, self.top + (self.y_high - p[1]) * self.scale

    def line(self, a: Point, b: Point, colour: str = INK, width: float = 1.5, dash: str = "") -> None:
        self.canvas.stroke(*self.place(a), *self.place(b), colour, width, dash)

    def path(self, points: list[Point], colour: str = INK, width: float = 1.5, closed: bool = False) -> None:
        steps = "L".join(f"{x:.1f} {y:.1f}" for x, y in map(self.place, points))
        self.canvas.add(f'<path d="M{steps}{"Z" if closed else ""}" fill="none" stroke="{colour}" '
                        f'stroke-width="{width}"/>')

    def arc(self, centre: Point, radius: float, middle_deg: float, half_deg: float, colour: str = BLUE,
            width: float = 1.5) -> None:
        self.arcs([(centre, radius, middle_deg, half_deg)], colour, width, 1.0)

    def arcs(self, arcs: list[tuple[Point, float, float, float]], colour: str, width: float, opacity: float) -> None:
        """Many arcs alike: (centre, radius, middle in degrees, half of it in degrees) each."""
        steps = []
        for centre, radius, middle_deg, half_deg in arcs:
            x1, y1 = self.place(on_circle(centre, radius, middle_deg - half_deg))
            x2, y2 = self.place(on_circle(centre, radius, middle_deg + half_deg))
            steps.append(f"M{x1:.1f} {y1:.1f}A{radius * self.scale:.1f} {radius * self.scale:.1f} 0 0 0 {x2:.1f} {y2:.1f}")
        self.canvas.add(f'<path d="{"".join(steps)}" fill="none" stroke="{colour}" stroke-width="{width}" '
                        f'stroke-opacity="{opacity}"/>')

    def dots(self, points: list[Point], colour: str, radius: float) -> None:
        """Many dots alike."""
        steps = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in map(self.place, points))
        self.canvas.add(f'<path d="{steps}" stroke="{colour}" stroke-width="{2 * radius}" stroke-linecap="round"/>')

    def clip(self, width: float, height: float) -> None:
        """Cuts what follows at a box of so many metres, until `unclip`."""
        name = f"clip{len(self.canvas.parts)}"
        self.canvas.add(f'<clipPath id="{name}"><rect x="{self.left}" y="{self.top}" width="{width * self.scale:.1f}" '
                        f'height="{height * self.scale:.1f}"/></clipPath><g clip-path="url(#{name})">')

    def unclip(self) -> None:
        self.canvas.add("</g>")

    def dot(self, p: Point, colour: str = INK, radius: float = 4.0, hollow: bool = False) -> None:
        x, y = self.place(p)
        look = f'fill="{PAPER}" stroke="{colour}" stroke-width="1.5"' if hollow else f'fill="{colour}"'
        self.canvas.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" {look}/>')

    def words(self, p: Point, words: str, colour: str = INK, anchor: str = "start", dx: float = 0.0,
              dy: float = 0.0) -> None:
        x, y = self.place(p)
        self.canvas.label(x + dx, y + dy, words, colour, anchor)

    def sensor(self, p: Point, heading_deg: float) -> None:
        """A small triangle that looks along its heading."""
        corners = [(7.0, 0.0), (-5.0, 5.0), (-5.0, -5.0)]
        x, y = self.place(p)
        c, s = cos(radians(heading_deg)), sin(radians(heading_deg))
        steps = "L".join(f"{x + c * a - s * b:.1f} {y - s * a - c * b:.1f}" for a, b in corners)
        self.canvas.add(f'<path d="M{steps}Z" fill="{INK}"/>')


def on_circle(centre: Point, radius: float, direction_deg: float) -> Point:
    return (centre[0] + radius * cos(radians(direction_deg)), centre[1] + radius * sin(radians(direction_deg)))
