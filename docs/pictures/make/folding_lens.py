#!/usr/bin/env python3
"""Makes docs/pictures/folding_lens.svg: a grid on the ideal plane, through a lens that is one-to-one, and through one that folds.

    docs/pictures/make/folding_lens.py docs/pictures/folding_lens.svg

Needs Python 3 alone. Coordinates are in units of the frame's half diagonal, so the H-FOV does not matter.
"""
import math
import sys

ASPECT = 9 / 16
HALF_WIDTH = 1 / math.hypot(1, ASPECT)
HALF_HEIGHT = HALF_WIDTH * ASPECT
CERTIFIED = (-0.372, 0.203, -0.071)  # KITTI's camera 00
FOLDING = (-0.62, 0.0, 0.0)          # folds where 1 + 3 k1 r² = 0
SCALE, PANEL, GAP = 205, (400, 250), 14


def distorted(lens, x, y):
    s = x * x + y * y
    factor = 1 + lens[0] * s + lens[1] * s**2 + lens[2] * s**3
    return x * factor, y * factor


def folded(lens, x, y):
    """Whether the map turns the picture inside out here: its slope along the radius is negative."""
    s = x * x + y * y
    return 1 + 3 * lens[0] * s + 5 * lens[1] * s**2 + 7 * lens[2] * s**3 < 0


def twin_radii(lens):
    """Two radii on the frame's diagonal, before and behind the fold, that the lens shows in one point."""
    outer = 0.97
    shown = distorted(lens, outer, 0)[0]
    low, high = 0.0, 1 / math.sqrt(-3 * lens[0])
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if distorted(lens, middle, 0)[0] < shown else (low, middle)
    return low, outer


def grid_lines():
    steps = 60
    for i in range(17):
        x = HALF_WIDTH * (i / 8 - 1)
        yield [(x, HALF_HEIGHT * (2 * t / steps - 1)) for t in range(steps + 1)]
    for i in range(10):
        y = HALF_HEIGHT * (2 * i / 9 - 1)
        yield [(HALF_WIDTH * (2 * t / steps - 1), y) for t in range(steps + 1)]


def pieces(lens, line):
    """The line cut where the lens folds: (is it folded, its points)."""
    run, run_wrong = [line[0]], None
    for a, b in zip(line, line[1:]):
        wrong = folded(lens, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        if run_wrong is not None and wrong != run_wrong:
            yield run_wrong, run
            run = [a]
        run_wrong = wrong
        run.append(b)
    yield run_wrong, run


def panel(left, title, note, lens, dots):
    centre_x, centre_y = left + PANEL[0] / 2, 40 + PANEL[1] / 2
    place = lambda x, y: f"{centre_x + SCALE * x:.1f} {centre_y + SCALE * y:.1f}"
    parts = [f'<rect x="{left}" y="40" width="{PANEL[0]}" height="{PANEL[1]}" fill="#f4f6f8"/>',
             f'<text x="{left + 6}" y="26" font-size="16" font-weight="bold">{title}</text>',
             f'<text x="{left + 6}" y="{40 + PANEL[1] + 22}">{note}</text>']
    for line in grid_lines():
        for wrong, points in pieces(lens, line):
            path = "M" + "L".join(place(*distorted(lens, *point)) for point in points)
            parts.append(f'<path d="{path}" stroke="{"#d6331a" if wrong else "#2a6496"}" stroke-width="1.3" fill="none"/>')
    direction = (HALF_WIDTH, HALF_HEIGHT)
    for radius, colour, size in dots:
        x, y = place(*distorted(lens, radius * direction[0], radius * direction[1])).split()
        parts.append(f'<circle cx="{x}" cy="{y}" r="{size}" fill="{colour}" stroke="#fff" stroke-width="1"/>')
    return "\n".join(parts)


def main(target):
    inner, outer = twin_radii(FOLDING)
    dots = [(outer, "#d6331a", 6.5), (inner, "#f0a30a", 4)]
    width, height = 3 * PANEL[0] + 2 * GAP, PANEL[1] + 76
    panels = [panel(0, "Ideal plane", "two points of the scene", (0, 0, 0), dots),
              panel(PANEL[0] + GAP, "A certified lens", "one-to-one: two points, two pixels", CERTIFIED, dots),
              panel(2 * (PANEL[0] + GAP), "A lens that folds", "red: turned over; both points in one pixel", FOLDING, dots)]
    with open(target, "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
                   f'font-family="sans-serif" font-size="15" fill="#222">\n<rect width="{width}" height="{height}" fill="#fff"/>\n'
                   + "\n".join(panels) + "\n</svg>\n")


main(sys.argv[1])
