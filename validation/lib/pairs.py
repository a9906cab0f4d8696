"""Which particles are near each other, and how even their spacing is."""
import numpy as np


def near_pairs(points, radius):
    """Index arrays (i, j), i != j, of all unordered pairs closer than `radius`, by cells of that size."""
    cell = np.floor((points - points.min(axis=0)) / radius).astype(np.int64) + 1
    row = cell[:, 1].max() + 2
    key = cell[:, 0] * row + cell[:, 1]
    order = np.argsort(key, kind="stable")
    ordered = key[order]
    found_i, found_j = [], []
    for offset in (0, 1, row - 1, row, row + 1):  # half of the neighbour cells: each pair once
        first = np.searchsorted(ordered, ordered + offset, side="left")
        last = np.searchsorted(ordered, ordered + offset, side="right")
        if offset == 0:
            first = np.arange(len(ordered)) + 1
        count = np.maximum(last - first, 0)
        i = np.repeat(np.arange(len(ordered)), count)
        start = np.repeat(np.cumsum(count) - count, count)
        j = np.repeat(first, count) + np.arange(count.sum()) - start
        distance2 = ((points[order[i]] - points[order[j]]) ** 2).sum(axis=1)
        near = distance2 < radius * radius
        found_i.append(order[i[near]])
        found_j.append(order[j[near]])
    return np.concatenate(found_i), np.concatenate(found_j)


def share_closer_than(points, spacing, fraction, reach):
    """Of the pairs closer than `reach` · d, the share closer than `fraction` · d; d is the mean of the two spacings."""
    i, j = near_pairs(points, reach * spacing.max())
    ratio = np.linalg.norm(points[i] - points[j], axis=1) / (0.5 * (spacing[i] + spacing[j]))
    within = np.count_nonzero(ratio < reach)
    return np.count_nonzero(ratio < fraction) / within if within else 0.0
