#!/usr/bin/python3
"""CSM1, CSM2 and CSM3 by finite elements of our own; writes reference_finite_elements.csv (ten minutes).

A second opinion, with the cylinder's arc as the bar's end, and for CSM3 with the periods that we compare: its published
mean and amplitude are those of the last of ten seconds, and depend on how the second mode stands just then.
"""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib.curves import crossings, peak  # noqa: E402
from lib.plane_strain import Solid, graded  # noqa: E402

DENSITY, POISSON, GRAVITY = 1000.0, 0.4, 2.0
STATIC_MESH, SWING_MESH, STEP, END = (60, 4), (36, 2), 0.002, 3.1  # elements along and across; s
HEADER = f"""# Point A, mm and Hz, by finite elements (finite_elements.py): {STATIC_MESH[0]} x {STATIC_MESH[1]} biquadratic elements; csm3:
# {SWING_MESH[0]} x {SWING_MESH[1]}, steps of {STEP} s; (max + min)/2 and (max - min)/2 of the second period between falling passes of the middle.
case,u_x,u_x_amplitude,u_y,u_y_amplitude,frequency
"""


def bar(along, across, youngs):
    """Finer towards the cylinder, whose arc is its end; and the node that is point A."""
    y = np.linspace(0.19, 0.21, 2 * across + 1)
    root = 0.2 + np.sqrt(0.05 ** 2 - (y - 0.2) ** 2)
    x = root + (0.6 - root) * graded(along, 1.5)[:, None]
    solid = Solid(x, np.broadcast_to(y, x.shape), youngs, POISSON, DENSITY)
    solid.hold(solid.nodes[0])
    solid.add_weight(GRAVITY)
    return solid, solid.nodes[-1, across]


def second_period(rows):
    time, x, y = rows.T
    start, end = crossings(time, y - 0.5 * (y.max() + y.min()), upward=False)[1:3]
    use, values = (time >= start) & (time <= end), []
    for u in (x, y):
        top, bottom = peak(time[use], u[use])[1], -peak(time[use], -u[use])[1]
        values += [(top + bottom) / 2, (top - bottom) / 2]
    return values + [1 / (end - start)]


def main():
    rest = []
    for youngs in (1.4e6, 5.6e6):
        solid, point_a = bar(*STATIC_MESH, youngs)
        rest.append(1e3 * solid.at_rest()[point_a])
    lines = [f"csm{k + 1},{x:.4f},,{y:.4f},," for k, (x, y) in enumerate(rest)]
    solid, point_a = bar(*SWING_MESH, 1.4e6)
    rows = solid.swinging(point_a, END, STEP) * (1, 1e3, 1e3)
    lines.append("csm3," + ",".join(f"{v:.4f}" for v in second_period(rows)))
    (FOLDER / "reference_finite_elements.csv").write_text(HEADER + "\n".join(lines) + "\n")
    print(HEADER + "\n".join(lines))


if __name__ == "__main__":
    main()
