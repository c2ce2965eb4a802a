"""The wheel on a machine without Rust: installed, run, and linked for an old C library.

`cargo xtask wheel-test` builds the wheel, names it in HOTFOOT_WHEEL, and calls these tests.
"""

import os
import re
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest
from elftools.elf.elffile import ELFFile
from elftools.elf.gnuversions import GNUVerNeedSection

WHEEL = Path(os.environ["HOTFOOT_WHEEL"])
OLDEST_GLIBC = (2, 28)
MOST_MB = 25.0
MOST_S = 60.0
# What every Linux of that age has, by the policy manylinux_2_28 (PEP 600).
LIBRARIES = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1", "libutil.so.1"} | {
    "libgcc_s.so.1", "ld-linux-x86-64.so.2"
}

STEP = """
import hotfoot
with hotfoot.System("first-look", results="stepped", duration_s=0.1) as system:
    system.step(100)
    print(system["vehicle[3].velocity"])
print(hotfoot.open("stepped").figure("left.foot.highest"))
"""


@pytest.fixture(scope="session")
def machine(tmp_path_factory):
    """The folder of the programs of an environment in which only the wheel is installed, and what that took, s."""
    folder = tmp_path_factory.mktemp("machine")
    subprocess.run([sys.executable, "-m", "venv", folder / "venv"], check=True)
    programs = folder / "venv" / "bin"
    begin = time.monotonic()
    command = [programs / "pip", "install", "--quiet", "--disable-pip-version-check", WHEEL]
    subprocess.run(command, check=True, env=environment(folder))
    return programs, time.monotonic() - begin


@pytest.fixture(scope="session")
def installed(machine):
    return machine[0]


def environment(folder):
    """The environment of a user who has neither Rust nor this repository: no program is found by its name."""
    return {"PATH": str(folder / "nothing"), "HOME": str(folder), "LANG": "C.UTF-8", "TMPDIR": str(folder)}


def test_from_nothing_to_the_report_of_the_first_look_takes_less_than_a_minute(machine, tmp_path):
    programs, install = machine
    begin = time.monotonic()
    command = [programs / "hotfoot", "run", "first-look", "--quiet"]
    done = subprocess.run(command, cwd=tmp_path, env=environment(tmp_path), capture_output=True, text=True)
    run = time.monotonic() - begin
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "results" / "first-look" / "report.html").is_file()
    assert "foot" in done.stdout
    print(f"\n{WHEEL.stat().st_size / 1e6:.1f} MB; pip install {install:.1f} s; hotfoot run first-look {run:.1f} s")
    assert install + run < MOST_S


def test_a_new_scenario_finds_the_rolling_stock_of_the_wheel(installed, tmp_path):
    for command in (["new", "mine"], ["check", "mine"]):
        done = subprocess.run(
            [installed / "hotfoot", *command], cwd=tmp_path, env=environment(tmp_path), capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
    assert str(installed.parent) in (tmp_path / "mine" / "scenario.toml").read_text()


def test_a_system_is_stepped_from_python(installed, tmp_path):
    command = [installed / "python", "-c", STEP]
    done = subprocess.run(command, cwd=tmp_path, env=environment(tmp_path), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    velocity, rise = map(float, done.stdout.split())
    assert 16.0 < velocity < 18.0
    assert rise >= 0.0


def test_the_wheel_is_small_and_needs_five_libraries_of_python():
    assert WHEEL.stat().st_size < MOST_MB * 1e6
    with zipfile.ZipFile(WHEEL) as content:
        (metadata,) = (name for name in content.namelist() if name.endswith("/METADATA"))
        needed = re.findall(r"^Requires-Dist: (\w+)", content.read(metadata).decode(), re.MULTILINE)
    assert needed == ["numpy", "pandas", "pyarrow", "xarray", "zarr"]


def test_the_oldest_python_of_the_metadata_is_that_of_the_modules_interface():
    with zipfile.ZipFile(WHEEL) as content:
        (metadata,) = (name for name in content.namelist() if name.endswith("/METADATA"))
        oldest = re.search(r"^Requires-Python: >=3\.(\d+)$", content.read(metadata).decode(), re.MULTILINE)
    assert f"-cp3{oldest[1]}-abi3-" in WHEEL.name


def test_no_program_or_library_needs_a_newer_c_library_or_another_one(tmp_path):
    files = list(binaries(tmp_path))
    assert len(files) == 6, files
    for file in files:
        needed = glibc_versions(file)
        assert needed, file
        print(f"\n{file.name}: glibc {'.'.join(map(str, max(needed)))}", end="")
        assert max(needed) <= OLDEST_GLIBC, f"{file}: glibc {max(needed)}"
        assert libraries(file) <= LIBRARIES, file


def binaries(folder):
    """The program, the module, and the library of each FMU, unpacked."""
    with zipfile.ZipFile(WHEEL) as content:
        content.extractall(folder)
    package = folder / "hotfoot"
    yield package / "bin" / "hotfoot"
    yield package / "_native.abi3.so"
    for fmu in package.glob("fmus/*.fmu"):
        with zipfile.ZipFile(fmu) as content:
            content.extractall(folder / fmu.stem)
        yield from (folder / fmu.stem).glob("binaries/**/*.so")


def glibc_versions(file):
    """The versions of glibc whose symbols a program or library needs, as (2, 17)."""
    with file.open("rb") as stream:
        sections = ELFFile(stream).iter_sections()
        needs = [section for section in sections if isinstance(section, GNUVerNeedSection)]
        versions = [version.name for need in needs for _, all_of in need.iter_versions() for version in all_of]
    numbers = (re.fullmatch(r"GLIBC_(\d+)\.(\d+)(?:\.\d+)?", version) for version in versions)
    return {(int(number[1]), int(number[2])) for number in numbers if number}


def libraries(file):
    """The libraries that a program or library needs."""
    with file.open("rb") as stream:
        dynamic = ELFFile(stream).get_section_by_name(".dynamic")
        return {tag.needed for tag in dynamic.iter_tags("DT_NEEDED")}
