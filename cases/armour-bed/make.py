#!/usr/bin/env python3
"""Writes the twelve cases of this folder from Tables 6-1 to 6-3 of Kazemi (2017): make.py FOLDER."""
import math
import sys

BEDS = {  # levels and grain size in m
    "B1": dict(trough=0.0366, crest=0.0876, d50=0.0136, offset=0.02, kappa=0.27, slope=0.0026),
    "B2": dict(trough=-0.0055, crest=0.0715, d50=0.0196, offset=0.0, kappa=0.15, slope=0.0028),
}
LEVELS = {
    "B1": {60: 0.184, 90: 0.217, 120: 0.248, 150: 0.271, 180: 0.296},
    "B2": {60: 0.166, 90: 0.200, 120: 0.230, 150: 0.256, 180: 0.279, 220: 0.306, 250: 0.330},
}
TEXT = """# Turbulent flow over and within the armoured gravel bed {bed} at {q} l/s: test {bed}-Q{q} of Kazemi (2017), Tables 6-1 to 6-3.
# A piece of the flume between periodic faces, driven by g S0 at the measured level; it starts with the velocities of the
# column model, which it must keep. The printed discharge, level and slope contradict each other; level and slope are taken.
# The hydrostatic pressure is taken out of the pair forces: the lattice of particles would otherwise hold the water in the bed
#   --set plugins.equations.pressure=full
[case]
name = "{name}"
title = "Armour bed {bed}, {q} l/s"

[domain]
dimension = 2
x = [0, {length:.10g}]
z = [{bottom:.10g}, {top:.10g}]
smoothing_ratio = 1.5

[initial]
particles = {{ spacing = {spacing:.12g} }} # {rows} rows from the wall under the bed to the surface
inside = "z < {level:g}"
velocity = "reference"

[plugins.equations]
id = "wcsph"
sound_speed = "{sound:.3g} m/s" # 10 sqrt(g H), H from the wall to the surface
bed_slope = {slope:g}
surface = {level:g}
pressure = "dynamic"
reference_level = {reference:.6g} # a support below the surface
laminar = true

[plugins.kernel]
id = "wendland-c2"

[plugins.filter]
id = "delta-sph"
delta = 0.1

[plugins.porosity]
id = "armour-ramp"
trough = {trough:g}
crest = {crest:g}
porosity = 0.22

[plugins.drag]
id = "armour-layer"
trough = {trough:g}
grain_diameter = {d50:g}

[plugins.turbulence]
id = "mixing-length"
profile = "three-layer"
heights = "levels"
bed_level = {bottom:g}
depth = {depth:.6g}
trough = {trough:g}
crest = {crest:g}
length_offset = {offset:g}
kappa_rough = {kappa:g}

[plugins.wall]
kind = "boundary"
id = "dummy-wall"

[plugins.sides]
kind = "boundary"
id = "periodic"

[time]
end = "20 s"
integrator = "semi-implicit-euler"
cfl = 1.0

[output]
fields = ["velocity", "pressure", "porosity"]

[reference]
id = "armour-bed-column"
bottom = {bottom:g}
trough = {trough:g}
crest = {crest:g}
level = {level:g}
slope = {slope:g}
grain_diameter = {d50:g}
length_offset = {offset:g}
kappa_rough = {kappa:g}
"""

folder = sys.argv[1]
for bed, levels in LEVELS.items():
    for q, level in levels.items():
        b = BEDS[bed]
        bottom = b["trough"] - 0.05
        depth = level - bottom
        rows = round(depth / 0.005)
        spacing = depth / rows
        with open(f"{folder}/{bed}-Q{q}.toml", "w") as out:
            out.write(TEXT.format(bed=bed, q=q, name=f"{bed}-Q{q}".lower(), level=level, bottom=bottom, depth=depth,
                                  rows=rows, spacing=spacing, length=16 * spacing, top=bottom + (rows + 8) * spacing,
                                  sound=10 * math.sqrt(9.81 * depth), reference=level - 3 * spacing, **b))
