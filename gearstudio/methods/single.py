"""One tooth as a solid of its own, closed below along the root cone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.kernel.cutting import Face
from gearstudio.kernel.shell import GearShell, closed_tooth
from gearstudio.methods.base import SAFETY, Target
from gearstudio.methods.grafts import Angles, blended, edge_of, profile_space
from gearstudio.methods.space import fitted, space_v
from gearstudio.methods.tooth import Tooth
from gearstudio.theory.section import Profile

Floats = NDArray[np.float64]


def tooth_solid(tooth: Tooth, target: Target) -> GearShell:
    """The solid of a tooth: its faces from fillet to fillet, in their order, then the one below, then the ends."""
    member = tooth.member
    surfaces = [face.surface for face in tooth.faces if face.kind != "root"]
    first, last = surfaces[0], surfaces[-1]
    bottom = fitted(
        f"{member.name} tooth's lower side",
        profile_space(),
        space_v(first),
        blended(
            member,
            _bottom_angles(tooth.profile),
            lambda y: edge_of(member, last, 1.0, y),
            lambda y: edge_of(member, first, 0.0, y),
        ),
        SAFETY * target.tolerance,
    )
    return closed_tooth([*surfaces, bottom], member.ends == "sphere", chamfers=tooth.chamfers)


def tooth_names(tooth: Tooth, shell: GearShell) -> tuple[tuple[str, Face], ...]:
    """Names of the solid's faces, as of a gear's but without the number."""
    titles = [face.title(tooth.member.hand) for face in tooth.faces if face.kind != "root"]
    titles += ["lower side", *(chamfer.title for chamfer in tooth.chamfers)]
    return tuple(zip(titles, (*shell.tooth_faces[0], *shell.chamfer_faces[0]), strict=True))


def _bottom_angles(profile: Profile) -> Angles:
    """The root cone below the tooth, with falling azimuth."""

    def angles(x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        delta, after, before = profile.across("root", rho_u)
        return delta, after + x * (before - profile.member.pitch - after)

    return angles
