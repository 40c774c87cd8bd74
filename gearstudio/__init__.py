"""GearStudio's core: spiral bevel gears from the exact spherical involute; no window in here.

Conventions, said once and kept everywhere
------------------------------------------
* Lengths in mm. Angles in radians; where a person reads or writes one (design file, command line,
  window, report) it is in degrees and its name ends in ``_deg``.
* One member stands with its cone apex at the origin, its axis along +z and its teeth at z > 0.
  Azimuth turns right-handed about z. A right-hand member has ``hand = +1``: its azimuth grows outward.
* The concave flank is the one with ``side == hand``; ``side = +1`` is the flank at larger azimuth.
* Points have shape ``(..., 3)``, float64. Surface grids are ``(n_u, n_v, 3)`` with u along the profile
  (root to tip) and v lengthwise (toe to heel).
* A deviation is signed and normal to the flank; positive means metal added.
"""

__version__ = "0.1.0"
