"""Prints what docs/foot-heating.md says beside its table of the foot study: `foot_study.py RESULTS`.

`cargo xtask foot-study` runs the scenarios into RESULTS, prints the table, and calls this.
"""

import sys
from pathlib import Path

import hotfoot


def stated(results, key):
    """The text of a figure, and where it was found."""
    figure = results.figures.loc[key]
    return f"{figure['text']}, {figure['place']}"


def deep(results):
    """The highest rise 60 mm deep, K, and how long after the train, min."""
    rail = results.table("rail", ["time", "rail", "highest.depth[2].rise"])
    rail = rail[rail["rail"] == "left"].reset_index()
    highest = rail["highest.depth[2].rise"].idxmax()
    after = rail["time"][highest] - results.manifest["run"]["rails"]["last_train_end_s"]
    return f"{rail['highest.depth[2].rise'][highest]:.2f} K, {after / 60.0:.1f} min after the train"


def of_the_locomotive(results):
    """The locomotive's share of all friction."""
    power = results.table("vehicles", ["vehicle", "friction_power"]).groupby("vehicle")["friction_power"].sum()
    return f"{100.0 * power[1] / power.sum():.1f} %"


def colder(results):
    """By how much the foot under the last wheel is colder than rail beside it at most."""
    rail = results.table("rail", ["rail", "camera.train.rise"])
    return f"{-rail.loc[rail['rail'] == 'left', 'camera.train.rise'].min():.2f} K"


LINES = [
    ("straight", "reversible change of the foot by bending", lambda r: stated(r, "left.foot.thermoelastic")),
    ("r800", "highest rise 60 mm deep", deep),
    ("r300", "highest rise 60 mm deep", deep),
    ("straight", "share of the locomotive in all friction", of_the_locomotive),
    ("traction", "share of the locomotive in all friction", of_the_locomotive),
    ("day", "foot under the last wheel colder than rail beside it", colder),
]


def main():
    folder = Path(sys.argv[1])
    for name, what, value in LINES:
        print(f"{name}: {what}: {value(hotfoot.open(folder / name))}")


if __name__ == "__main__":
    main()
