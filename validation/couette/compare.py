#!/usr/bin/python3
"""Runs plane Couette flow at three spacings and compares its profiles with the series in time."""
import sys
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))

from lib import case, channel  # noqa: E402
from lib.channel import NU, SPEED, TERMS, WIDTH  # noqa: E402


def velocity(y, t):
    """u = U y/L + Σ 2U/(nπ) (−1)^n sin(nπy/L) exp(−n² π² ν t/L²) [Morris et al. 1997, section 5]."""
    u = SPEED * y / WIDTH
    for n in range(1, TERMS):
        u = u + (2 * SPEED / (n * np.pi) * (-1) ** n * np.sin(n * np.pi * y / WIDTH)
                 * np.exp(-n ** 2 * np.pi ** 2 * NU * t / WIDTH ** 2))
    return u


CASE = channel.make_case("Couette flow", FOLDER, "viscosity, a moving wall without slip", velocity)

if __name__ == "__main__":
    sys.exit(case.main(CASE))
