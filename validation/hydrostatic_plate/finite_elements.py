#!/usr/bin/python3
"""The plate's sag in plane elasticity, by finite elements; prints it for three meshes (half of the plate; seconds)."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib.plane_strain import Solid, graded  # noqa: E402


def sag(along, across):
    """[m]"""
    x = 0.5 * graded(along, 1.8)[:, None]
    y = np.linspace(-0.05, 0, 2 * across + 1)
    solid = Solid(np.broadcast_to(x, (len(x), len(y))), np.broadcast_to(y, (len(x), len(y))), 67.5e9, 0.34, 2700.0)
    solid.hold(solid.nodes[0])
    solid.hold(solid.nodes[-1], axes=(0,))  # the plane of symmetry
    solid.add_weight(9.81)
    solid.press_on_top(1000 * 9.81 * 2)
    return solid.at_rest()[solid.nodes[-1, across], 1]


if __name__ == "__main__":
    for mesh in ((20, 2), (60, 6), (100, 10)):
        print(f"{mesh[0]} x {mesh[1]} elements: {1e3 * sag(*mesh):.5f} mm")
