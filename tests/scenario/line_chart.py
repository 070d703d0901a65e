"""A line chart as SVG: means with their 95 % intervals over a sweep."""

import math
from dataclasses import dataclass
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 640, 400             # [px]
LEFT, RIGHT, TOP, BOTTOM = 70, 20, 40, 56  # [px] round the axes
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")  # Okabe and Ito


@dataclass
class Line:
    name: str
    points: list  # (x, mean, low, high)


def ticks(low, high):
    """Round numbers, four to nine of them, that cover low to high."""
    size = 10.0 ** math.floor(math.log10((high - low) or 1.0))
    step = next(size * f for f in (0.1, 0.2, 0.5, 1.0, 2.0) if (high - low) / (size * f) <= 7.0)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(k * step, 10) for k in range(first, last + 1)]


def text(x, y, content, anchor="middle", more=""):
    return (f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>'
            f"{escape(content)}</text>")


class Axes:
    def __init__(self, lines):
        xs = [p[0] for line in lines for p in line.points]
        ys = [y for line in lines for p in line.points for y in p[1:]]
        self.xs, self.ys = ticks(min(xs), max(xs)), ticks(min(0.0, *ys), max(ys))

    def x(self, value):
        share = (value - self.xs[0]) / (self.xs[-1] - self.xs[0])
        return LEFT + share * (WIDTH - LEFT - RIGHT)

    def y(self, value):
        share = (value - self.ys[0]) / (self.ys[-1] - self.ys[0])
        return HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM)

    def drawn(self, x_label, y_label):
        parts = []
        for value in self.ys:
            y = self.y(value)
            parts.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
            parts.append(text(LEFT - 8, y + 4, f"{value:g}", "end"))
        for value in self.xs:
            x = self.x(value)
            parts.append(f'<path d="M{x:.1f} {HEIGHT - BOTTOM}v5" stroke="#444"/>')
            parts.append(text(x, HEIGHT - BOTTOM + 20, f"{value:g}"))
        parts.append(f'<path d="M{LEFT} {HEIGHT - BOTTOM}H{WIDTH - RIGHT}" stroke="#444"/>')
        parts.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, x_label))
        middle = (TOP + HEIGHT - BOTTOM) / 2
        turned = f'transform="rotate(-90 18 {middle:.1f})"'
        parts.append(text(18, middle, y_label, more=turned))
        return parts


def drawn_line(axes, line, colour):
    parts = []
    band = [(x, high) for x, _, _, high in line.points] + [(x, low) for x, _, low, _
                                                            in reversed(line.points)]
    at = " ".join(f"{axes.x(x):.1f},{axes.y(y):.1f}" for x, y in band)
    parts.append(f'<polygon points="{at}" fill="{colour}" opacity="0.18"/>')
    at = " ".join(f"{axes.x(p[0]):.1f},{axes.y(p[1]):.1f}" for p in line.points)
    parts.append(f'<polyline points="{at}" fill="none" stroke="{colour}" stroke-width="2"/>')
    for x, mean, *_ in line.points:
        parts.append(f'<circle cx="{axes.x(x):.1f}" cy="{axes.y(mean):.1f}" r="3.5" '
                     f'fill="{colour}"/>')
    return parts


def chart(title, x_label, y_label, lines):
    """The SVG's text."""
    axes = Axes(lines)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
             f'width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
             text(LEFT, 20, title, "start", 'font-weight="bold"'), *axes.drawn(x_label, y_label)]
    for k, line in enumerate(lines):
        colour = COLOURS[k % len(COLOURS)]
        parts += drawn_line(axes, line, colour)
        y = TOP + 8 + 18 * k
        parts.append(f'<path d="M{WIDTH - RIGHT - 12} {y}h12" stroke="{colour}" stroke-width="3"/>')
        parts.append(text(WIDTH - RIGHT - 18, y + 4, line.name, "end"))
    return "\n".join(parts) + "\n</svg>\n"
