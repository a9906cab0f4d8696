#!/usr/bin/python3
"""The plate's first period in plane elasticity, by finite elements; writes reference_plane_elasticity.csv.

Timoshenko's beam is free to contract at its clamp; the plate is held there, which makes it a little stiffer. Elements of
nine nodes (biquadratic), graded towards the clamp's corners; as the mesh is a lattice, mass and stiffness are Kronecker
products of those of lines, M_x x M_y and so on. The only script that needs Debian's python3-scipy (sparse matrices).
"""
import sys
from pathlib import Path

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import eigsh

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib.beams import Plate, timoshenko_period  # noqa: E402

HEIGHT, BULK, SHEAR, DENSITY = 0.02, 3.25e6, 0.715e6, 1000.0
MESHES = ((40, 4), (120, 16))  # elements along and across
HEADER = """# First period of the plate (nu = 0.3975, clamped at x = 0) in plane elasticity, over Timoshenko's; by finite elements
# (plane_elasticity.py), {meshes} elements.
slenderness,coarse,fine
"""


def line(elements, length, grading):
    """Integrals of f g, f' g' and f' g over a line of quadratic elements that grow as (k/n)^grading."""
    ends = length * np.linspace(0, 1, elements + 1) ** grading
    nodes = 2 * elements + 1
    mass, stiffness, mixed = np.zeros((3, nodes, nodes))
    points, weights = np.polynomial.legendre.leggauss(3)
    for k in range(elements):
        half, at = 0.5 * (ends[k + 1] - ends[k]), slice(2 * k, 2 * k + 3)
        for s, w in zip(points, weights):
            f = np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2])
            slope = np.array([s - 0.5, -2 * s, s + 0.5]) / half
            mass[at, at] += w * half * np.outer(f, f)
            stiffness[at, at] += w * half * np.outer(slope, slope)
            mixed[at, at] += w * half * np.outer(slope, f)
    return tuple(sparse.csr_matrix(a) for a in (mass, stiffness, mixed))


def first_period(plate, along, across):
    (mass_x, stiff_x, mixed_x), (mass_y, stiff_y, mixed_y) = line(along, plate.length, 1.8), line(across, plate.height, 1)
    lam, cut = BULK - 2 / 3 * SHEAR, slice(1, None)  # the first column of nodes is held
    mass_x, stiff_x, mixed_x = mass_x[cut, cut], stiff_x[cut, cut], mixed_x[cut, cut]
    xx, yy, xy = (sparse.kron(a, b) for a, b in ((stiff_x, mass_y), (mass_x, stiff_y), (mixed_x, mixed_y.T)))
    wave = lam + 2 * SHEAR
    coupling = lam * xy + SHEAR * xy.T
    stiffness = sparse.bmat([[wave * xx + SHEAR * yy, coupling], [coupling.T, wave * yy + SHEAR * xx]], format="csc")
    mass = DENSITY * sparse.kron(mass_x, mass_y)
    smallest = eigsh(stiffness, k=1, M=sparse.block_diag([mass, mass], format="csc"), sigma=0, return_eigenvectors=False)
    return 2 * np.pi / np.sqrt(smallest[0])


def main():
    text = HEADER.format(meshes=" and ".join(f"{a} x {b}" for a, b in MESHES))
    for slenderness in (10, 20, 40):
        plate = Plate.with_moduli(slenderness * HEIGHT, HEIGHT, DENSITY, BULK, SHEAR)
        ratios = [first_period(plate, *mesh) / timoshenko_period(plate) for mesh in MESHES]
        text += f"{slenderness}," + ",".join(f"{r:.5f}" for r in ratios) + "\n"
    (FOLDER / "reference_plane_elasticity.csv").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
