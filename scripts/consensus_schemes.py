# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""The figures of docs/methods/consensus.md that explain: the idea, a vote, a link. Their geometry is computed, and what
they count is counted with the rules and constants of the method."""

from math import atan2, degrees, hypot, sqrt

from svg_canvas import AMBER, BLUE, GREEN, GREY, INK, MAGENTA, Canvas, Panel, Point, on_circle


def idea() -> str:
    """Three arcs of a wall, three arcs of a pole."""
    canvas = Canvas(760, 300, "A wall is tangent to its arcs; a pole lies on its arcs")
    canvas.label(20, 26, "A wall is tangent to its arcs", weight="bold")
    canvas.label(400, 26, "A pole lies on its arcs", weight="bold")
    draw_wall(Panel(canvas, 20, 40, 165, -0.1, 1.5))
    draw_pole(Panel(canvas, 400, 40, 165, -0.1, 1.5))
    canvas.add(f'<path d="M380 14V286" stroke="{GREY}" stroke-width="0.7"/>')
    return canvas.text()


def draw_wall(panel: Panel) -> None:
    wall_y = 1.3
    panel.line((-0.05, wall_y), (1.95, wall_y), INK, 4)
    sensors = [((0.35, 0.55), 99.0), ((0.93, 0.68), 84.0), ((1.5, 0.45), 95.0)]
    for at, heading in sensors:
        r = wall_y - at[1]
        panel.line(at, (at[0], wall_y), GREY, 1.2, "5 4")
        panel.arc(at, r, heading, 32, width=2)
        panel.sensor(at, heading)
    for (a, _), (b, _) in zip(sensors, sensors[1:]):
        panel.dot(crossing(a, wall_y - a[1], b, wall_y - b[1]), AMBER, 4.5, hollow=True)
    for at, _ in sensors:
        panel.dot((at[0], wall_y), MAGENTA)
    panel.words((-0.05, 0.2), "touching points (red): one direction, one line;", dx=2)
    panel.words((-0.05, 0.2), "crossings (amber): shallow, and beside the wall", dx=2, dy=17)


def crossing(a: Point, ra: float, b: Point, rb: float) -> Point:
    """Where two circles cross, the upper one."""
    d = hypot(b[0] - a[0], b[1] - a[1])
    along = (d * d + ra * ra - rb * rb) / (2 * d)
    aside = sqrt(max(0.0, ra * ra - along * along))
    ux, uy = (b[0] - a[0]) / d, (b[1] - a[1]) / d
    return (a[0] + along * ux - aside * uy, a[1] + along * uy + aside * ux)


def draw_pole(panel: Panel) -> None:
    pole = (0.95, 1.2)
    for at, off in [((0.35, 0.72), -14.0), ((0.9, 0.45), 10.0), ((1.6, 0.7), 8.0)]:
        bearing = degrees(atan2(pole[1] - at[1], pole[0] - at[0]))
        panel.line(at, pole, GREY, 1.2, "5 4")
        panel.arc(at, hypot(pole[0] - at[0], pole[1] - at[1]), bearing + off, 32, width=2)
        panel.sensor(at, bearing + off)
    panel.dot(pole, MAGENTA, 6)
    panel.words((-0.05, 0.2), "all arcs pass through one place,", dx=2)
    panel.words((-0.05, 0.2), "with a normal of its own each", dx=2, dy=17)


class Surface:
    """An accepted point, seen from its sensor: the ray and the piece of surface of step D."""

    def __init__(self, sensor: Point, position: Point):
        self.sensor, self.position = sensor, position
        length = hypot(position[0] - sensor[0], position[1] - sensor[1])
        self.normal = ((position[0] - sensor[0]) / length, (position[1] - sensor[1]) / length)

    def crossed_by(self, other: "Surface", option: dict) -> bool:
        """Whether the ray of `other` goes through this surface (step D)."""
        n = self.normal
        before = dot(minus(self.position, other.sensor), n)
        behind = dot(minus(other.position, self.position), n)
        facing = dot(n, other.normal)
        if before <= option["front_m"] or behind <= option["behind_m"] or facing <= 0.2:
            return False
        hit = minus(other.sensor, self.position)
        hit = (hit[0] + before / facing * other.normal[0], hit[1] + before / facing * other.normal[1])
        return abs(n[0] * hit[1] - n[1] * hit[0]) < option["element_m"]

    def supports(self, other: "Surface", option: dict) -> bool:
        apart = minus(self.position, other.position)
        return hypot(*apart) <= option["element_m"] and dot(self.normal, other.normal) > 0.5

    def draw(self, panel: Panel, option: dict, colour: str, width: float = 4.0) -> None:
        along = (-self.normal[1] * option["element_m"], self.normal[0] * option["element_m"])
        panel.line(minus(self.position, along), minus(self.position, (-along[0], -along[1])), colour, width)
        panel.dot(self.position, colour, 4)


def minus(a: Point, b: Point) -> Point:
    return (a[0] - b[0], a[1] - b[1])


def dot(a: Point, b: Point) -> float:
    return a[0] * b[0] + a[1] * b[1]


def vote(option: dict) -> str:
    """Two quarrels: a lone point before a wall, and a ray that ends behind one."""
    canvas = Canvas(760, 350, "The vote: who crosses whom")
    wall = [Surface((0.15 + 0.09 * k, 0.0), (0.15 + 0.09 * k, 1.3)) for k in range(20)]
    ghost = Surface((0.5, 0.0), (0.78, 0.72))
    beyond = Surface((0.5, 0.0), (1.08, 1.62))
    panel = Panel(canvas, 20, 40, 150, -0.05, 1.72)
    canvas.label(20, 26, "Many rays pass a lone point: it goes", weight="bold")
    count_one(panel, wall, ghost, option)
    panel = Panel(canvas, 400, 40, 150, -0.05, 1.72)
    canvas.label(400, 26, "A ray through a well supported wall: it goes", weight="bold")
    count_other(panel, wall, beyond, option)
    canvas.add(f'<path d="M380 14V336" stroke="{GREY}" stroke-width="0.7"/>')
    return canvas.text()


def count_one(panel: Panel, wall: list[Surface], ghost: Surface, option: dict) -> None:
    passing = [w for w in wall if ghost.crossed_by(w, option)]
    for w in wall:
        if w in passing:
            panel.line(w.sensor, w.position, BLUE, 1.3)
            panel.sensor(w.sensor, 90)
        w.draw(panel, option, INK, 3)
    panel.line(ghost.sensor, ghost.position, GREY, 1.3, "5 4")
    ghost.draw(panel, option, MAGENTA)
    panel.sensor(ghost.sensor, 69)
    support = 1 + sum(w.supports(ghost, option) for w in wall)
    panel.words((-0.05, -0.1), f"sup = {support}, pas = {len(passing)}", dy=8)
    verdict = len(passing) >= option["passed"] and len(passing) > option["passed_ratio"] * support
    panel.words((-0.05, -0.1), f"pas ≥ {option['passed']:g} and pas > {option['passed_ratio']:g} sup: "
                f"{'voted out' if verdict else 'stays'}", MAGENTA, dy=25)


def count_other(panel: Panel, wall: list[Surface], ray: Surface, option: dict) -> None:
    crossed = [w for w in wall if w.crossed_by(ray, option)]
    for w in wall:
        w.draw(panel, option, GREEN if w in crossed else INK, 3)
    panel.line(ray.sensor, ray.position, MAGENTA, 1.5, "5 4")
    ray.draw(panel, option, MAGENTA)
    panel.sensor(ray.sensor, 70)
    blocked = len(crossed)
    panel.words((-0.05, -0.1), f"blk = {blocked}: supported pieces (green) on its way", dy=8)
    panel.words((-0.05, -0.1), f"blk ≥ {option['blocked']:g}: {'voted out' if blocked >= option['blocked'] else 'stays'}",
                MAGENTA, dy=25)


def link(option: dict) -> str:
    """A gap that nobody looked through, and one that rays go through."""
    canvas = Canvas(760, 290, "A link that is drawn, and one that is not")
    canvas.label(20, 26, "Nothing passes the gap: linked", weight="bold")
    canvas.label(400, 26, "Rays pass the gap: left open", weight="bold")
    passing = [((0.55, 0.0), (0.92, 1.26)), ((0.8, 0.0), (0.88, 1.26)), ((1.2, 0.0), (0.84, 1.26))]
    for left, rays in ((20, []), (400, passing)):
        draw_gap(Panel(canvas, left, 40, 150, -0.05, 1.3), rays, option)
    canvas.add(f'<path d="M380 14V276" stroke="{GREY}" stroke-width="0.7"/>')
    return canvas.text()


def draw_gap(panel: Panel, rays: list[tuple[Point, Point]], option: dict) -> None:
    ends = [0.62, 1.12]
    y = 0.95
    for x in [0.12, 0.22, 0.32, 0.42, 0.52, ends[0], ends[1], 1.22, 1.32, 1.42, 1.52, 1.62]:
        Surface((x, 0.0), (x, y)).draw(panel, option | {"element_m": 0.05}, INK, 3)
    for begin, end in rays:
        panel.line(begin, end, BLUE, 1.3)
        panel.dot(end, BLUE, 3.5)
        panel.sensor(begin, degrees(atan2(end[1] - begin[1], end[0] - begin[0])))
    gap = ends[1] - ends[0]
    if len(rays) < option["link_crossings"]:
        pieces = round(gap / option["link_step_m"])
        for k in range(1, pieces):
            panel.dot((ends[0] + gap * k / pieces, y), GREY, 3)
        panel.words((-0.05, -0.1), f"gap of {gap:.2f} m, at most {option['link_m']:g} m: "
                    f"a point every {100 * option['link_step_m']:g} cm", dy=8)
    else:
        panel.words((-0.05, -0.1), f"{len(rays)} rays cross it, {option['link_crossings']} are enough: a doorway", dy=8)
