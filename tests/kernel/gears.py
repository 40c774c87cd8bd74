"""What tests of whole gears share: designs by a few changes, and points inside the faces of a solid."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepTools import BRepTools
from OCP.gp import gp_Pnt2d
from OCP.IntTools import IntTools_FClass2d
from OCP.TopAbs import TopAbs_State

from gearstudio.design import Design, with_field
from gearstudio.kernel.cutting import Face
from gearstudio.methods.tooth import Tooth
from gearstudio.theory.profile import ToothProfile

Floats = NDArray[np.float64]
Changes = Mapping[str, Any]
INSIDE = TopAbs_State.TopAbs_IN


def changed(changes: Changes, design: Design | None = None) -> Design:
    """A design, the default one or another, with other values in some fields."""
    design = Design() if design is None else design
    for path, value in changes.items():
        design = with_field(design, path, value)
    return design


def points_inside(face: Face, wanted: int = 6) -> Floats:
    """Some points well inside a face, however it is trimmed, shape (n, 3)."""
    surface, inside = BRepAdaptor_Surface(face), IntTools_FClass2d(face, 1e-7)
    u0, u1, v0, v1 = BRepTools.UVBounds_s(face)
    found: list[tuple[float, float, float]] = []
    for n in (4, 12, 40, 120):
        at = (np.arange(n) + 0.5) / n
        places = [(u0 + a * (u1 - u0), v0 + b * (v1 - v0)) for a in at for b in at]
        places = [place for place in places if inside.Perform(gp_Pnt2d(*place)) == INSIDE]
        if len(places) >= wanted:
            kept = places[:: max(1, len(places) // wanted)]
            found = [(p.X(), p.Y(), p.Z()) for p in (surface.Value(*place) for place in kept)]
            break
    return np.array(found)


def off_fillet(tooth: Tooth, side: int, points: Floats) -> Floats:
    """How far points (..., 3) of a fillet lie from the circle of theory [mm], turned with the flank, shape (...)."""
    member, profile = tooth.member, tooth.profile
    rho, delta, phi = profile.flank(side).locate(points)
    if not isinstance(profile, ToothProfile):
        return profile.off_fillet(side, rho, delta, phi - member.lengthwise.azimuth(rho))
    fillet = profile.fillet
    turned = member.lengthwise.azimuth(rho) + profile.shift(side, rho, delta)
    azimuth = side * (phi - turned) - fillet.centre_azimuth
    half = np.sin((delta - fillet.centre_angle) / 2) ** 2
    half = half + np.sin(delta) * np.sin(fillet.centre_angle) * np.sin(azimuth / 2) ** 2
    return np.asarray((2 * np.arcsin(np.sqrt(half)) - fillet.radius) * rho)


def by_name(faces: Iterable[tuple[str, Face]]) -> dict[str, list[Face]]:
    """Faces of a gear by their names; a name may stand for several pieces."""
    found: dict[str, list[Face]] = {}
    for name, face in faces:
        found.setdefault(name, []).append(face)
    return found
