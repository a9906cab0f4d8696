"""How far a field at the particles is from being smooth."""
import numpy as np

from .pairs import near_pairs

FEWEST = 10  # neighbours: a linear fit in the plane takes three


def from_linear(points, values, radius):
    """What each particle's value differs by from the linear least-squares fit to those within `radius`, itself
    included; NaN where they are fewer than FEWEST. A smooth field leaves its curvature, some radius^2/8 of it."""
    i, j = near_pairs(points, radius)
    i, j = np.concatenate([i, j, np.arange(len(points))]), np.concatenate([j, i, np.arange(len(points))])
    apart = points[j] - points[i]
    basis = np.column_stack([np.ones(len(i)), apart / radius])
    size = basis.shape[1]
    matrix = np.zeros((len(points), size, size))
    right = np.zeros((len(points), size))
    np.add.at(matrix, i, basis[:, :, None] * basis[:, None, :])
    np.add.at(right, i, basis * values[j][:, None])
    result = np.full(len(points), np.nan)
    enough = matrix[:, 0, 0] > FEWEST
    fit = np.linalg.solve(matrix[enough] + 1e-12 * np.eye(size), right[enough][:, :, None])
    result[enough] = values[enough] - fit[:, 0, 0]
    return result
