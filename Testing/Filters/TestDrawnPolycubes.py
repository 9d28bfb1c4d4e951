"""Polycubes drawn by hand, for solids of genus 0 and 2: Shape Correspondence keeps their corners and curves exactly, and
flips nothing."""
import polycubes
from shapetesting import read

for name, surface, genus in (('Horse', 'HorseSmall.vtp', 0), ('Skull', 'PhantomSkullSmall.vtp', 2)):
    polycubes.Drawn(read(surface), read(name + 'Polycube.vtu'), 2, polycubes.LOOPS[name]).check(genus)
