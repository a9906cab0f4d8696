"""What `sluice check --draw` draws, by its colours. Usage: test_scene_picture.py PROGRAM TESTS"""
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from matplotlib import image

WATER, PLATE, CLAMPED, WALL = 0x458CC7, 0xD18042, 0xD18042 >> 1 & 0x7F7F7F, 0x98A1AB
LEGEND = 1000  # from this column on [pixels]


def draw(program, scene, settings=()):
    """Colours of the picture as whole numbers, and the exit code."""
    with tempfile.TemporaryDirectory() as folder:
        words = [program, "check", str(scene), "--draw", f"{folder}/scene.png"]
        for setting in settings:
            words += ["--set", setting]
        code = subprocess.run(words, capture_output=True).returncode
        pixels = np.rint(255 * image.imread(f"{folder}/scene.png")[:, :, :3]).astype(int)
    return pixels @ [0x10000, 0x100, 1], code


def check(holds, what):
    if not holds:
        sys.exit(f"FAILED: {what}")


def box_of(colors, color):
    """First and last column and row of a colour, left of the legend."""
    rows, columns = np.nonzero(colors[:, :LEGEND] == color)
    return columns.min(), columns.max(), rows.min(), rows.max()


def main():
    program, tests = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    tank = tests / "wrong_edits/scene.toml"
    colors, code = draw(program, tank)
    check(code == 0 and colors.shape == (720, 1280), "the tank's picture")
    count = {color: np.count_nonzero(colors[:, :LEGEND] == color) for color in (WATER, PLATE, CLAMPED)}
    # 600 particles of water, 80 of the plate of which 8 are held; discs are cut by names and edges here and there.
    check(abs(count[WATER] / count[PLATE] - 600 / 72) < 0.8, f"areas of water and plate: {count}")
    check(abs(count[PLATE] / count[CLAMPED] - 72 / 8) < 1.5, f"areas of plate and clamp: {count}")
    for color in (WATER, PLATE, CLAMPED):
        check(np.count_nonzero(colors[:, LEGEND:] == color) >= 100, f"the legend lacks {color:06x}")
    # 0.1 m lie between water and plate, which is as high.
    left, right, top, bottom = box_of(colors, WATER)
    plate_left, _, plate_top, _ = box_of(colors, PLATE)
    metre = (right - left) / 0.3
    check(abs((plate_left - right) / metre - 0.1) < 0.01, "distance of water and plate")
    check(abs(plate_top - top) <= 2, "height of water and plate")
    check(abs((bottom - top) / metre - 0.2) < 0.01, "lengths along x and y")

    # A scene that is refused is drawn as it stands: the plate in the water.
    colors, code = draw(program, tank, ["bodies.water.shape.box.max=[0.5, 0.2]"])
    check(code == 2, "water in the plate is not refused")
    check(box_of(colors, WATER)[1] > box_of(colors, PLATE)[1], "water behind the plate")

    colors, code = draw(program, tests / "scenes/small_gate.toml")
    check(code == 0 and np.count_nonzero(colors == WALL) > 100, "fixed walls")
    colors, code = draw(program, tests / "scenes/still_water_3d.toml")
    shades = len(np.unique(colors[:, :LEGEND]))
    check(code == 0 and shades > 100, f"balls have {shades} shades")
    print("pictures of scenes show what is where")


if __name__ == "__main__":
    main()
