"""Plots learning curves as SVG.

    python -m robonewbie.curve walk.policy.csv run.policy.csv > curves.svg
    python -m robonewbie.curve Stand=Stand-1.policy.csv,Stand-2.policy.csv > stand.svg    mean and range of several seeds
"""

import csv
import sys
from pathlib import Path
from xml.sax.saxutils import escape

WIDTH, HEIGHT, LEFT, BELOW = 640, 300, 56, 40
COLOURS = ["#0b6bcb", "#c2410c", "#15803d", "#7e22ce"]


def read(path):
    """Returns the training cycles so far (in millions) and the mean return for each row of a learning curve."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    cycles, reward, total = [], [], 0
    for row in rows:
        total = int(row["steps"]) if "steps" in row else total + int(row["cycles"])
        cycles.append(total / 1e6)
        reward.append(float(row["reward"]))
    return cycles, reward


def smoothed(values, window):
    """Returns the moving average over the last ``window`` values."""
    return [sum(values[max(0, i - window + 1) : i + 1]) / len(values[max(0, i - window + 1) : i + 1]) for i in range(len(values))]


def together(name, curves):
    """Combines the curves of several seeds, truncated to the shortest; returns name, cycles, mean, minimum and maximum."""
    length = min(len(xs) for xs, _ in curves)
    rewards = list(zip(*(ys[:length] for _, ys in curves)))
    mean = [sum(row) / len(row) for row in rewards]
    return name, curves[0][0][:length], mean, [min(row) for row in rewards], [max(row) for row in rewards]


def svg(curves):
    """Plots curves, each given as a name, cycles in millions, and returns: a thin line for the returns, a thick one for their moving average.

    A curve of several seeds also has minima and maxima, and the area between them is shaded.
    """
    most = max(x for _, xs, *_ in curves for x in xs) or 1
    low = min(0, *(y for _, _, *rows in curves for ys in rows for y in ys))
    high = max(y for _, _, *rows in curves for ys in rows for y in ys)
    high = high if high > low else low + 1

    def points(xs, ys):
        return " ".join(
            f"{LEFT + (WIDTH - LEFT - 10) * x / most:.1f},{10 + (HEIGHT - BELOW - 10) * (high - y) / (high - low):.1f}"
            for x, y in zip(xs, ys)
        )

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
    ]
    for i in range(5):
        y, x = low + (high - low) * i / 4, most * i / 4
        parts.append(f'<polyline points="{points([0, most], [y, y])}" stroke="#ddd" fill="none"/>')
        parts.append(f'<text x="{LEFT - 6}" y="{points([0], [y]).split(",")[1]}" text-anchor="end">{y:.1f}</text>')
        anchor = "middle" if i < 4 else "end"
        parts.append(f'<text x="{points([x], [0]).split(",")[0]}" y="{HEIGHT - 22}" text-anchor="{anchor}">{x:.1f}</text>')
    for i, (name, xs, ys, *spread) in enumerate(curves):
        colour = COLOURS[i % len(COLOURS)]
        if spread:
            around = points(xs + xs[::-1], spread[0] + spread[1][::-1])
            parts.append(f'<polygon points="{around}" fill="{colour}" fill-opacity="0.2"/>')
        parts.append(f'<polyline points="{points(xs, ys)}" stroke="{colour}" stroke-opacity="0.25" fill="none"/>')
        parts.append(
            f'<polyline points="{points(xs, smoothed(ys, max(1, len(ys) // 20)))}" stroke="{colour}" stroke-width="2" fill="none"/>'
        )
        parts.append(f'<text x="{WIDTH - 16}" y="{HEIGHT - BELOW - 10 - 18 * i}" fill="{colour}" text-anchor="end">{escape(name)}</text>')
    parts.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 6}" text-anchor="middle">millions of cycles (20 ms each)</text></svg>')
    return "\n".join(parts)


def main(files=None):
    """Runs the command line."""
    files = sys.argv[1:] if files is None else files
    if not files:
        sys.exit("Name the curves: python -m robonewbie.curve walk.policy.csv > curves.svg")
    print(svg([_curve(file) for file in files]))


def _curve(file):
    name, equals, several = file.partition("=")
    if equals:
        return together(name, [read(one) for one in several.split(",")])
    return (Path(file).name.removesuffix(".policy.csv"), *read(file))


if __name__ == "__main__":
    main()
