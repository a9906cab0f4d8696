"""Where the gate and its wall are in a frame, and where water must not be.

The gate is a box at t = 0; its particles keep their ids, so the outline found then can be drawn in every frame.
"""
import numpy as np
from matplotlib.path import Path as Polygon

from lib.run_output import FLUID, SOLID


class GateOutline:
    def __init__(self, first_frame, wall_top):
        solid = first_frame.of(SOLID)
        x, y = first_frame.points[solid].T
        ids = first_frame["id"][solid]
        self.spacing = spacing_of(x)
        column = np.round((x - x.min()) / self.spacing).astype(int)
        row = np.round((y - y.min()) / spacing_of(y)).astype(int)
        site = {(c, r): i for c, r, i in zip(column, row, ids)}
        columns, rows = range(column.max() + 1), range(row.max() + 1)
        self.wet_face = [site[0, r] for r in rows]                # from the foot up
        self.dry_face = [site[columns[-1], r] for r in rows]
        self.foot = [site[c, 0] for c in columns]
        head = [site[c, rows[-1]] for c in columns]
        self.loop = self.wet_face + head[1:-1] + self.dry_face[::-1] + self.foot[-2:0:-1]
        self.thickness = len(columns) * self.spacing
        self.wall_top = wall_top

    def place(self, frame):
        """The outline's positions in one frame."""
        solid = frame.of(SOLID)
        position = dict(zip(frame["id"][solid], frame.points[solid]))
        return GatePosition(self, lambda ids: np.array([position[i] for i in ids]))


class GatePosition:
    """The gate at one instant; its outline passes through the centres of its outermost particles."""

    def __init__(self, outline, at):
        self.outline = outline
        self.loop, self.wet, self.dry, self.foot = (
            at(outline.loop), at(outline.wet_face), at(outline.dry_face), at(outline.foot))
        self.middle = 0.5 * (self.wet + self.dry)

    def inside(self, points):
        """Mask of the points inside the gate, deeper than the centres of its outermost particles."""
        return Polygon(self.loop).contains_points(points)

    def within_surface(self, points):
        """Mask of the points inside the gate's material surface, half a spacing outside those centres."""
        return Polygon(self._moved_out(0.5 * self.outline.spacing)).contains_points(points)

    def pocket(self):
        """The space behind the gate that water can only reach through it: above its dry face, as far as one thickness
        beyond the foot and no lower there than one thickness above it."""
        s = self.outline.thickness
        lip = self.dry[0]
        right = max(lip[0], self.dry[:, 0].max()) + s
        above = self.dry[self.dry[:, 1] > lip[1] + s]
        top = self.outline.wall_top
        return np.vstack([above, [above[-1, 0], top], [right, top], [right, lip[1] + s]])

    def behind(self, points):
        return Polygon(self.pocket()).contains_points(points) & ~self.inside(points)

    def barrier(self):
        """Centre line of the gate from its foot upwards, prolonged along the wall."""
        return np.vstack([self.middle, [self.middle[-1, 0], self.outline.wall_top]])

    def side(self, points):
        """+1 for points beside the gate or wall on the dry side, −1 on the wet side, 0 for those that are nearest to the
        foot: below the gate, or within one thickness of its end, where a side means nothing."""
        _, along, side = nearest_on_polyline(points, self.barrier())
        return np.where(along > self.outline.thickness, side, 0)

    def near_wet_side(self, points, distance):
        """Mask of the points closer than `distance` to the wet face or to the wall above it, on that side."""
        face = np.vstack([self.wet, [self.wet[-1, 0], self.outline.wall_top]])
        face[:, 0] -= 0.5 * self.outline.spacing
        near = distance_to_polyline(points, face) < distance
        dry = points[:, 0] > np.interp(points[:, 1], face[:, 1], face[:, 0]) + 0.5 * self.outline.thickness
        return near & ~dry

    def _moved_out(self, distance):
        tangent = np.roll(self.loop, -1, axis=0) - np.roll(self.loop, 1, axis=0)
        normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)  # the loop runs clockwise: this points outwards
        return self.loop + distance * normal / np.linalg.norm(normal, axis=1, keepdims=True)


def spacing_of(coordinate):
    """Distance of the lattice lines on which the coordinates lie."""
    lines = np.unique(np.round(coordinate, 7))
    gaps = np.diff(lines)
    return float(np.median(gaps[gaps > 0.05 * gaps.max()]))


def fluid_spacing_by_id(first_frame):
    """Initial spacing of every fluid particle, from the lattice of its own body, as an array over ids."""
    fluid = first_frame.of(FLUID)
    ids, body, x = first_frame["id"][fluid].astype(int), first_frame["body"][fluid], first_frame.points[fluid, 0]
    spacing = np.zeros(ids.max() + 1)
    for b in np.unique(body):
        spacing[ids[body == b]] = spacing_of(x[body == b])
    return spacing


def nearest_on_polyline(points, line):
    """Of the nearest point of the polyline: its distance, the length along the line to it, and the side on which the
    points lie (+1 to the right of the line's direction, −1 to the left)."""
    best, along_line, side, walked = np.full(len(points), np.inf), np.zeros(len(points)), np.zeros(len(points)), 0.0
    for a, b in zip(line[:-1], line[1:]):
        t, length = b - a, np.linalg.norm(b - a)
        along = np.clip((points - a) @ t / max(t @ t, 1e-30), 0, 1)
        away = points - a - along[:, None] * t
        distance = np.linalg.norm(away, axis=1)
        nearer = distance < best
        best[nearer] = distance[nearer]
        along_line[nearer] = walked + along[nearer] * length
        side[nearer] = np.sign(t[1] * away[nearer, 0] - t[0] * away[nearer, 1])
        walked += length
    return best, along_line, side


def distance_to_polyline(points, line):
    return nearest_on_polyline(points, line)[0]
