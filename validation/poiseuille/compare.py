#!/usr/bin/python3
"""Runs plane Poiseuille flow at three spacings and compares its profiles with the series in time."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, channel  # noqa: E402
from lib.channel import NU, SPEED, TERMS, WIDTH  # noqa: E402

FORCE = 8 * NU * SPEED / WIDTH ** 2  # per mass [m/s²]


def velocity(y, t):
    """u = F/(2ν) y (L − y) − Σ 4 F L²/(ν π³ n³) sin(nπy/L) exp(−n² π² ν t/L²), n odd
    [Morris et al. 1997, section 5].
    """
    u = FORCE / (2 * NU) * y * (WIDTH - y)
    for n in range(1, 2 * TERMS, 2):
        u = u - (4 * FORCE * WIDTH ** 2 / (NU * np.pi ** 3 * n ** 3) * np.sin(n * np.pi * y / WIDTH)
                 * np.exp(-n ** 2 * np.pi ** 2 * NU * t / WIDTH ** 2))
    return u


CASE = channel.make_case("Poiseuille flow", FOLDER, "viscosity, walls without slip, a driving force", velocity)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
