"""What is measured on the frames of a gate run, in one pass over them."""
from dataclasses import dataclass, field

import numpy as np

from gate_outline import GateOutline, fluid_spacing_by_id
from lib.pairs import share_closer_than
from lib.run_output import FLUID, WALL

SPEED_LIMIT = 3.0        # m/s: no water may move faster than twice the free fall from the level
CLOSE = 0.5              # pairs closer than this fraction of their mean spacing count as clumped
REACH = 3.0              # of all pairs closer than this: the kernel's support 2h = 3d
NEAR_WALL = 2e-3         # m: water closer to the gate or wall than this is counted as its film


@dataclass
class GateMeasures:
    time: list = field(default_factory=list)
    inside: list = field(default_factory=list)          # fluid particles inside the gate
    within_surface: list = field(default_factory=list)  # fluid particles inside its material surface
    behind: list = field(default_factory=list)          # fluid particles where they can only come through the gate
    tunnelled: list = field(default_factory=list)       # fluid particles that crossed it since the frame before
    clumped: list = field(default_factory=list)         # share of the pairs
    film_top: list = field(default_factory=list)        # highest water at the gate and wall [m]; NaN = none


def measure(run):
    result = GateMeasures()
    first = run.frame_near(0.0)
    wall = first.of(WALL)
    wall_top = first.points[wall, 1].max() if wall.any() else first.points[:, 1].max()
    outline = GateOutline(first, wall_top)
    spacing = fluid_spacing_by_id(first)
    before = None
    for frame in run.frames():
        fluid = frame.of(FLUID)
        water, ids = frame.points[fluid], frame["id"][fluid].astype(int)
        gate = outline.place(frame)
        result.time.append(frame.time)
        result.inside.append(int(gate.inside(water).sum()))
        result.within_surface.append(int(gate.within_surface(water).sum()))
        result.behind.append(int(gate.behind(water).sum()))
        result.clumped.append(share_closer_than(water, spacing[ids], CLOSE, REACH))
        film = water[gate.near_wet_side(water, NEAR_WALL), 1]
        result.film_top.append(float(film.max()) if film.size else np.nan)
        now = dict(zip(ids, water)), gate, frame.time
        result.tunnelled.append(_tunnelled(before, now) if before else 0)
        before = now
    return result


def _tunnelled(before, now):
    """Particles that were beside the gate or wall on one side and are beside it on the other, seen from the gate's own
    position each time. Water that goes round the foot passes below it in between, not beside the gate."""
    (old, old_gate, _), (new, gate, _) = before, now
    common = sorted(old.keys() & new.keys())
    was = old_gate.side(np.array([old[i] for i in common]))
    is_now = gate.side(np.array([new[i] for i in common]))
    return int(np.count_nonzero(was * is_now < 0))
