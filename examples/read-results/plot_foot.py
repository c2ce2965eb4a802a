"""Draws how the rail's foot warms after a train: `plot_foot.py OUT.svg NAME=RESULTS …`.

Each run gives a curve of the foot's highest rise over untouched rail, on a logarithmic scale.
"""

import math
import sys
from pathlib import Path

import pandas

WIDTH, HEIGHT = 720, 380
LEFT, RIGHT, TOP, BOTTOM = 64, 150, 40, 48
COLOURS = ("#c4452d", "#2d6fc4", "#4b8b3b", "#8a5fb0")
MINUTES, LEAST_MK, MOST_MK = 60.0, 0.1, 1000.0
THRESHOLD_MK = 15.0


def x(minutes):
    return LEFT + (WIDTH - LEFT - RIGHT) * minutes / MINUTES


def y(millikelvin):
    share = math.log(millikelvin / LEAST_MK) / math.log(MOST_MK / LEAST_MK)
    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * share


def text(at_x, at_y, words, anchor="start", colour="#333"):
    return f'<text x="{at_x:.0f}" y="{at_y:.0f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'


def line(points, colour, width=1.0, dash=""):
    path = " ".join(f"{px:.1f},{py:.1f}" for px, py in points)
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{dashes}/>'


def frame():
    parts = [text(LEFT, 22, "Rise of the rail foot, mK, over the time since the train came, min")]
    for minutes in range(0, 61, 10):
        parts.append(line([(x(minutes), y(LEAST_MK)), (x(minutes), y(MOST_MK))], "#e4e4e4"))
        parts.append(text(x(minutes), HEIGHT - BOTTOM + 20, minutes, "middle"))
    for power in range(-1, 4):
        level = 10.0**power
        parts.append(line([(x(0), y(level)), (x(MINUTES), y(level))], "#e4e4e4"))
        parts.append(text(LEFT - 8, y(level) + 5, f"{level:g}", "end"))
    parts.append(line([(x(0), y(THRESHOLD_MK)), (x(MINUTES), y(THRESHOLD_MK))], "#333", 1.2, "6 4"))
    parts.append(text(x(MINUTES) + 8, y(THRESHOLD_MK) + 5, "15 mK: a camera"))
    return parts


def curve(name, results, colour):
    rail = pandas.read_parquet(Path(results) / "series" / "rail.parquet")
    rail = rail[rail["rail"] == "left"]
    time, rise = rail["time"] / 60.0, 1e3 * rail["foot.present.rise"]
    seen = [(x(t), y(mk)) for t, mk in zip(time, rise) if mk >= LEAST_MK and t <= MINUTES]
    end = seen[-1][1]
    return [line(seen, colour, 2.2), text(x(MINUTES) + 8, end + 5, name, colour=colour)]


def main():
    out, *runs = sys.argv[1:]
    parts = frame()
    for run, colour in zip(runs, COLOURS):
        parts += curve(*run.split("=", 1), colour)
    body = "\n".join(parts)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="14">'
    background = f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    Path(out).write_text(f"{head}\n{background}\n{body}\n</svg>\n")


if __name__ == "__main__":
    main()
