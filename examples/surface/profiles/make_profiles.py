#!/usr/bin/env python3
"""Profiles by formula in place of a stylus' records of planed wood: five across the grain, with pores,
and three along it; 800 points each, 10 um apart, x and z in um. usage: make_profiles.py FOLDER"""
import math
import sys
from pathlib import Path

STEP, POINTS, WAVES = 10.0, 800, 24


def height(x, trace, longest, amplitude):
    """Waves from 80 um to the longest, whose slopes are alike; their phases differ by trace."""
    z = 0.0
    for k in range(WAVES):
        wave = 80.0*(longest/80.0)**(k/(WAVES - 1))
        phase = 2*math.pi*math.modf((k + 1)*(trace + 1)*0.6180339887)[0] + 2.4*k*k
        z += amplitude*wave/longest*math.cos(2*math.pi*x/wave + phase)
    return z


def pore(x, trace):
    """Vessels 200 um wide and 45 um deep, 700 um apart."""
    middle = (x + 190.0*trace) % 700.0 - 350.0
    return 45.0*math.cos(math.pi*middle/200.0)**2 if abs(middle) < 100.0 else 0.0


folder = Path(sys.argv[1])
for trace in range(5):
    lines = ["x [um],z [um]"]
    for i in range(POINTS):
        x = i*STEP
        z = height(x, trace, 800.0, 2.5) + 8.0*math.cos(2*math.pi*x/8000.0)
        lines.append(f"{x:.1f},{z - pore(x, trace):.3f}")
    (folder/f"across_{trace + 1}.csv").write_text("\n".join(lines) + "\n")
for trace in range(3):
    lines = ["x [um],z [um]"]
    lines += [f"{i*STEP:.1f},{height(i*STEP, trace + 7, 1600.0, 5.0):.3f}" for i in range(POINTS)]
    (folder/f"along_{trace + 1}.csv").write_text("\n".join(lines) + "\n")
