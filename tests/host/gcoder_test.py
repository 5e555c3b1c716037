"""Debian's printrun reads a sliced file: same number of layers, same filament.

usage: gcoder_test.py RIND MAKE_PART
"""

import json
import pathlib
import subprocess
import sys
import tempfile

from printrun import gcoder

FILAMENT_TOLERANCE = 0.005


def check(rind, make_part, folder, name, arguments):
    part, out, stats = folder / "part.stl", folder / "out.gcode", folder / "stats.json"
    subprocess.run([make_part, name, "-o", part], check=True)
    subprocess.run(
        [rind, "slice", part, "-o", out, "--stats", stats, "--quiet", *arguments], check=True
    )
    counted = json.loads(stats.read_text())
    with open(out, encoding="ascii") as file:
        model = gcoder.GCode(file)
    layers = counted["layers"]
    marks = out.read_text(encoding="ascii").count(";LAYER_CHANGE\n")
    ours = counted["filament_mm"]["total"]
    # The last retraction draws back what is never returned.
    theirs = model.filament_length
    print(f"{name}: {layers} layers, printrun {model.layers_count}; "
          f"{ours:.2f} mm, printrun {theirs:.2f} mm")
    assert marks == layers, f"{marks} layer marks"
    assert model.layers_count == layers, "number of layers"
    assert abs(theirs - ours) <= FILAMENT_TOLERANCE * ours, "filament"


def main():
    rind, make_part = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        check(rind, make_part, folder, "box", ["--layer-height", "0.25"])
        check(rind, make_part, folder, "tube",
              ["--layer-height", "0.4", "--set", "retraction_lift=0.4"])


main()
