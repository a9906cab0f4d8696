"""What is measured of a run, each by the name that the cases' limits use. Fractions are of 1, distances of d.

d is the mean of two particles' spacings; the first frame is the state that the scene describes.
"""
import sys
import tomllib
from functools import cached_property
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "validation"))

from lib.pairs import near_pairs  # noqa: E402
from lib.run_output import FLUID, SOLID, WALL, RunOutput  # noqa: E402

TORN = 1.75    # of its first length: rubber that is far from doubling its length has no business there
FILLED = 0.75  # d; half the diagonal of a lattice's square is 0.71 d
JOINED = 2.0   # d; what is nearer belongs to one piece
REACH, INSIDE = 2.05, 12  # d, and how many neighbours a particle of a square lattice has within that
NEAR = 1.2     # d; the nearest neighbours of a square lattice, not its diagonals


class Run:
    """A run's files, and what several figures need of them."""

    def __init__(self, folder, scale, twin=None):
        self.output, self.twin = RunOutput(folder), twin
        self.scene = tomllib.loads((Path(folder) / "scene.toml").read_text())
        self.scale_name = scale

    @cached_property
    def frames(self):
        return list(self.output.frames())

    @cached_property
    def spacing(self):
        """Of each particle of a frame [m], by its body; a wall has its own."""
        d = self.scene["method"]["spacing"]
        values = np.array([d * body.get("spacing_ratio", 1) for body in self.scene["bodies"].values()])
        first = self.frames[0]
        of_body = values[np.minimum(first["body"].astype(int), len(values) - 1)]
        return np.where(first.of(WALL), d, of_body)

    @cached_property
    def mass(self):
        """Of each particle [kg/m]; 0 for walls."""
        bodies, materials = self.scene["bodies"], self.scene["materials"]
        density = np.array([materials[body["material"]]["density"] for body in bodies.values()])
        first = self.frames[0]
        of_body = density[np.minimum(first["body"].astype(int), len(density) - 1)]
        return np.where(first.of(WALL), 0, of_body * self.spacing ** 2)

    @cached_property
    def density0(self):
        return self.mass / self.spacing ** 2

    @cached_property
    def energy(self):
        return self.output.probe("energy.total")

    @cached_property
    def energy_scale(self):
        """What energies are compared with [J/m]: a number, the highest kinetic energy, or the range of the potential one."""
        if not isinstance(self.scale_name, str):
            return float(self.scale_name)
        if self.scale_name == "potential":
            return float(np.ptp(self.output.probe("energy.potential")))
        return float(self.output.probe(f"energy.{self.scale_name}").max())

    @property
    def gravity(self):
        return np.array(self.scene.get("gravity", [0, 0])[:2])


def finite(run):
    """Values that are not finite: in probes, and in the positions, velocities and densities of frames."""
    energies = run.output.probe("energy.total")
    count = np.count_nonzero(~np.isfinite(energies))
    for frame in run.frames:
        own = ~frame.of(WALL)
        for values in (frame.points[own], frame["velocity"][own], frame["density"][own]):
            count += np.count_nonzero(~np.isfinite(values))
    return int(count)


def energy_gain(run):
    """The largest rise of the total energy above its lowest value until then."""
    return float((run.energy - np.minimum.accumulate(run.energy)).max() / run.energy_scale)


def energy_excess(run):
    """The largest rise of the total energy above that of the start."""
    return float((run.energy - run.energy[0]).max() / run.energy_scale)


def energy_loss(run):
    return float((run.energy[0] - run.energy[-1]) / run.energy_scale)


def energy_drift(run):
    """Mean of the last tenth less mean of the first one."""
    tenth = max(1, len(run.energy) // 10)
    return float((run.energy[-tenth:].mean() - run.energy[:tenth].mean()) / run.energy_scale)


def kinetic_end(run):
    """Highest kinetic energy of the last tenth."""
    kinetic = run.output.probe("energy.kinetic")
    return float(kinetic[-max(1, len(kinetic) // 10):].max() / run.energy_scale)


def momentum(run):
    """Change that no gravity explains, of the sum of m |v| of the first frame, or of M g t if nothing moves there."""
    got = np.stack([run.output.probe("momentum.x"), run.output.probe("momentum.y")], axis=1)
    fall = run.mass.sum() * np.outer(run.output.time, run.gravity)
    moved = (run.mass * run.frames[0].speed()).sum()
    return float(np.abs(got - got[0] - fall).max() / (moved if moved > 0 else np.abs(fall).max()))


def angular_momentum(run):
    """Change about the centre of mass, of the sum of m |x| |v| about it in the first frame."""
    def of(frame):
        velocity = np.asarray(frame["velocity"], dtype=float)[:, :2]
        weight = run.mass[:, None] / run.mass.sum()
        x, v = frame.points - (weight * frame.points).sum(axis=0), velocity - (weight * velocity).sum(axis=0)
        return (run.mass * (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0])).sum(), (run.mass * np.hypot(*x.T) * np.hypot(*v.T)).sum()
    first, scale = of(run.frames[0])
    return float(max(abs(of(frame)[0] - first) for frame in run.frames) / scale)


def fluid_density(run):
    """Largest error of the density, p/(rho0 c0^2) at rest."""
    mask = run.frames[0].of(FLUID)
    return float(max(np.abs(frame["density"][mask] / run.density0[mask] - 1).max() for frame in run.frames))


def fluid_pair(run):
    """Smallest distance of two fluid particles."""
    return _smallest(run, lambda frame: frame.of(FLUID), lambda frame, i, j: np.ones(len(i), bool))


def coupling_pair(run):
    """Smallest distance of a fluid particle from one of a solid or of a wall."""
    return _smallest(run, lambda frame: np.ones(len(frame.points), bool),
                     lambda frame, i, j: frame.of(FLUID)[i] != frame.of(FLUID)[j])


def bodies_pair(run):
    """Smallest distance of particles of two solid bodies."""
    return _smallest(run, lambda frame: frame.of(SOLID), lambda frame, i, j: frame["body"][i] != frame["body"][j])


def inner_pair(run):
    """Smallest distance of two fluid particles that both have all the neighbours of a lattice: no spray, no surface."""
    least = 2.0
    for frame in run.frames:
        index = np.flatnonzero(frame.of(FLUID))
        i, j = near_pairs(frame.points[index], REACH * run.spacing.max())
        i, j = index[i], index[j]
        ratio = np.linalg.norm(frame.points[i] - frame.points[j], axis=1) / (0.5 * (run.spacing[i] + run.spacing[j]))
        i, j, ratio = (values[ratio < REACH] for values in (i, j, ratio))
        inside = np.bincount(np.concatenate([i, j]), minlength=len(frame.points)) >= INSIDE
        both = inside[i] & inside[j]
        if both.any():
            least = min(least, float(ratio[both].min()))
    return least


def _smallest(run, mask, wanted):
    """Over all frames; no more than 2: what is farther apart does not meet."""
    least = 2.0
    for frame in run.frames:
        index = np.flatnonzero(mask(frame))
        if len(index) < 2:
            continue
        i, j = near_pairs(frame.points[index], 2 * run.spacing.max())
        i, j = index[i], index[j]
        use = wanted(frame, i, j)
        i, j = i[use], j[use]
        if len(i):
            distance = np.linalg.norm(frame.points[i] - frame.points[j], axis=1)
            least = min(least, float((distance / (0.5 * (run.spacing[i] + run.spacing[j]))).min()))
    return least


def wall_depth(run):
    """How deep fluid is behind a mirror wall."""
    deepest = 0.0
    for wall in run.scene.get("walls", {}).values():
        if wall["kind"] != "mirror":
            continue
        point, normal = np.array(wall["point"][:2]), np.array(wall["normal"][:2])
        for frame in run.frames:
            fluid = frame.of(FLUID)
            depth = -((frame.points[fluid] - point) @ normal / np.linalg.norm(normal)) / run.spacing[fluid]
            deepest = max(deepest, float(depth.max()))
    return deepest


def fluid_speed(run):
    """The fastest that a fluid particle became in any step, of the speed of sound."""
    return run.output.summary["max_mach"]


def _bonds(run):
    """Nearest neighbours of one solid body at the start."""
    first = run.frames[0]
    index = np.flatnonzero(first.of(SOLID))
    i, j = near_pairs(first.points[index], NEAR * run.spacing[index].max())
    i, j = index[i], index[j]
    same = first["body"][i] == first["body"][j]
    return i[same], j[same]


def torn(run):
    """Share of the bonds between nearest neighbours of a solid that are TORN times as long at the end."""
    i, j = _bonds(run)
    length = [np.linalg.norm(frame.points[i] - frame.points[j], axis=1) for frame in (run.frames[0], run.frames[-1])]
    return float(np.mean(length[1] > TORN * length[0]))


def cracked(run):
    """Share of those bonds that are torn and have nothing in their middle; others have only been re-arranged."""
    i, j = _bonds(run)
    last, first = run.frames[-1].points, run.frames[0].points
    long = np.linalg.norm(last[i] - last[j], axis=1) > TORN * np.linalg.norm(first[i] - first[j], axis=1)
    own = last[np.flatnonzero(run.frames[0].of(SOLID))]
    middle = 0.5 * (last[i[long]] + last[j[long]])
    empty = [np.hypot(*(own - at).T).min() > FILLED * run.spacing.min() for at in middle]
    return float(np.count_nonzero(empty) / len(i))


def pieces(run):
    """Into how many pieces the solid bodies have come, less their number."""
    last = run.frames[-1]
    index = np.flatnonzero(last.of(SOLID))
    i, j = near_pairs(last.points[index], JOINED * run.spacing[index].max())
    body = last["body"][index]
    keep = body[i] == body[j]
    return _components(len(index), i[keep], j[keep]) - len(np.unique(body))


def _components(count, i, j):
    """Of a graph, by spreading the lowest label along its edges and halving the paths."""
    label = np.arange(count)
    while True:
        low = np.minimum(label[i], label[j])
        new = label.copy()
        np.minimum.at(new, i, low)
        np.minimum.at(new, j, low)
        new = new[new]
        if np.array_equal(new, label):
            return len(np.unique(label))
        label = new


def rebound(run):
    """Speed of the first body along x at the end over that of the start, backwards."""
    first, last = run.frames[0], run.frames[-1]
    mask = first.of(SOLID) & (first["body"] == 0)
    return float(-last["velocity"][mask, 0].mean() / first["velocity"][mask, 0].mean())


def tip(run):
    """Largest displacement that the probe `free_end` or `middle` shows, in m."""
    name = next(n for n in ("free_end", "middle") if f"{n}.x" in run.output.probes)
    return float(np.hypot(run.output.probe(f"{name}.x"), run.output.probe(f"{name}.y")).max())


def void(run):
    """Radius of the largest circle without a particle inside the middle half of the fluid, in the last frame."""
    points = run.frames[-1].points[run.frames[-1].of(FLUID)]
    d = run.spacing.min()
    centre = points.mean(axis=0)
    radius = 0.5 * np.sqrt(len(points) / np.pi) * d  # half that of a disc of as much fluid
    steps = np.arange(-radius, radius, d / 3)
    grid = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    grid = grid[np.hypot(*grid.T) < radius] + centre
    near = points[np.hypot(*(points - centre).T) < radius + 5 * d]
    return float(max(np.hypot(*(near - at).T).min() for at in grid) / d)


def fall(run):
    """Error of the mean velocity of a free fall at the end, over g t."""
    last = run.frames[-1]
    fluid = last.of(FLUID)
    expected = run.gravity * last.time
    mean = np.asarray(last["velocity"], dtype=float)[fluid, :2].mean(axis=0)
    return float(np.abs(mean - expected).max() / np.abs(expected).max())


def _shape_of(frame):
    return frame.points - frame.points.mean(axis=0)


def shape(run):
    """The farthest that a particle has moved within a body that falls freely."""
    first, last = _shape_of(run.frames[0]), _shape_of(run.frames[-1])
    return float(np.linalg.norm(last - first, axis=1).max() / run.spacing.min())


def twin(run):
    """The largest difference of places, relative to the centre, from the run that this one repeats elsewhere."""
    a, b = _shape_of(run.frames[-1]), _shape_of(run.twin.frames[-1])
    return float(np.linalg.norm(a - b, axis=1).max() / run.spacing.min())


def bits(run):
    """Fields of the last frame that differ from those of the run with one thread, points counted as one."""
    a, b = run.frames[-1], run.twin.frames[-1]
    names = set(a._fields) | set(b._fields)
    different = sum(name not in a or name not in b or a[name].tobytes() != b[name].tobytes() for name in names)
    return int(different) + int(a.points.tobytes() != b.points.tobytes())


def leaked(run):
    """Fluid particles behind the scene's solid: above the highest particle of a lid, below the lowest of a floor."""
    last = run.frames[-1]
    y, fluid, solid = last.points[:, 1], last.of(FLUID), last.of(SOLID)
    if run.frames[0].points[solid, 1].mean() > run.frames[0].points[fluid, 1].mean():
        return int(np.count_nonzero(y[fluid] > y[solid].max()))
    return int(np.count_nonzero(y[fluid] < y[solid].min()))


FIGURES = {f.__name__: f for f in (
    finite, energy_gain, energy_excess, energy_loss, energy_drift, kinetic_end, momentum, angular_momentum, fluid_density,
    fluid_pair, inner_pair, coupling_pair, bodies_pair, wall_depth, fluid_speed, torn, cracked, pieces, rebound, tip, void,
    fall, shape, twin, bits, leaked)}
