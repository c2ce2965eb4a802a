"""What the friction law does to the heat: the first look on R 800 m, on rails from used to clean.

Runs the scenarios, a quarter of a minute each, and prints the table of docs/foot-heating.md.
"""

import tempfile
from pathlib import Path

import hotfoot

VEHICLES = ("locomotive-coco-134t", "wagon-coco-134t-unpowered")
# Values in place of those of the vehicles' files.
LAWS = {
    "0.36, 0.54: these runs": {},
    "0.47, 0.54": {"friction": 0.47},
    "0.47, 1: clean rails": {"friction": 0.47, "initial_slope": 1.0},
    "0.47, 1 that does not flatten (Kalker)": {"friction": 0.47, "initial_slope": 1.0, "remaining_slope": 1.0},
}
# That of the first look, but for radius and cant.
TRACK = """
start_m = 50.0
[[alignment]]
length_m = 50.0
transition = true
[[alignment]]
length_m = 100.0
radius_m = 800.0
[[alignment]]
length_m = 50.0
transition = true
"""
# On the straight, and in the arc.
PROBES = ("chainage_25_m", "chainage_150_m")


def run(law, folder):
    """Friction heat of the outer rail on the straight and in the arc, J/m."""
    (folder / "track.toml").write_text(TRACK)
    settings = {"track.file": folder / "track.toml"}
    for number, name in enumerate(VEHICLES, 1):
        values = "".join(f"{key} = {value}\n" for key, value in law.items())
        (folder / f"{number}.toml").write_text(f'extends = "{name}"\n[multibody.contact.creep]\n{values}')
        settings[f"train.vehicles[{number}].type"] = folder / f"{number}.toml"
    results = hotfoot.run("first-look", results=folder / "results", settings=settings)
    return [results.figure(f"left.heat.friction.{probe}") for probe in PROBES]


def main():
    print("| coefficient, slope at the beginning | arc of R 800 m | straight |\n|---|---|---|")
    used = None
    for name, law in LAWS.items():
        with tempfile.TemporaryDirectory() as folder:
            heat = run(law, Path(folder))
        used = used or heat
        more = [f", {100.0 * (value / of - 1.0):.0f} % more" if law else "" for value, of in zip(heat, used)]
        straight, arc = (f"{value:.4g} J/m{share}" for value, share in zip(heat, more))
        print(f"| {name} | {arc} | {straight} |")


if __name__ == "__main__":
    main()
