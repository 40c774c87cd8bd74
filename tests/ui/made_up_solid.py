"""Solids without a CAD kernel: the faces of theory interpolated, with properties that a test may rely on or not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.interpolate import make_interp_spline

from gearstudio.design import Design
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import FaceResult, Floats, MassProperties, SolidResult
from gearstudio.theory.blank import BlankSizes, blank_outline
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.profile import Segment, ToothProfile, tooth_profile

_NODES = 13
_DEGREE = 5


def solid_of(design: Design, member: str, method: str = "rotating_line", variant: str = "optimised") -> SolidResult:
    """A member's solid; volume and area are those of a cube of 10 mm."""
    geometry = pair_geometry(design).member(member)
    outline = blank_outline(geometry, BlankSizes(**getattr(design.blank, member).model_dump()))
    faces = faces_of(geometry)
    points = np.concatenate([face.surface.uniform_grid(9, 9).reshape(-1, 3) for face in faces])
    radius = float(np.hypot(points[:, 0], points[:, 1]).max())
    heights = np.concatenate([points[:, 2], outline.points[:, 1]])
    box = np.array([[-radius, -radius, heights.min()], [radius, radius, heights.max()]])
    properties = MassProperties(1000.0, 600.0, (0.0, 0.0, 5.0), np.diag([1.0, 1.0, 2.0]) * 1e4)
    return SolidResult(
        member, method, variant, "assemble", geometry.teeth, faces, outline.points, geometry.ends == "sphere",
        True, True, 6 * geometry.teeth + 5, 4e-7, properties, box, 0.25,
    )  # fmt: skip


def faces_of(member: MemberGeometry) -> tuple[FaceResult, ...]:
    """One pitch in the order of azimuth."""
    profile = tooth_profile(member)
    sides = [name for name in profile.segments if name not in ("root", "tip")]
    made = [FaceResult(name, -1, _surface(member, _half(profile, name, -1))) for name in sides]
    made.append(FaceResult("tip", 0, _surface(member, _across(profile, "tip", 0.0))))
    made += [FaceResult(name, 1, _surface(member, _half(profile, name, 1))) for name in reversed(sides)]
    if "root" in profile.segments:
        made.append(FaceResult("root", 0, _surface(member, _across(profile, "root", member.pitch / 2))))
    return tuple(made)


Angles = Callable[[Floats, Floats], tuple[Floats, Floats]]


def _half(profile: ToothProfile, name: Segment, side: int) -> Angles:
    def angles(u: Floats, tip: Floats) -> tuple[Floats, Floats]:
        delta, phi = profile.angles(name, u if side < 0 else 1 - u, tip)
        return delta, side * phi

    return angles


def _across(profile: ToothProfile, name: Segment, middle: float) -> Angles:
    def angles(u: Floats, tip: Floats) -> tuple[Floats, Floats]:
        delta, phi = profile.angles(name, np.full_like(u, 0.0 if name == "tip" else 1.0), tip)
        return delta, middle + (2 * u - 1) * np.abs(phi - middle)

    return angles


def _surface(member: MemberGeometry, angles: Angles) -> NurbsSurface:
    nodes = (1 - np.cos(np.pi * np.arange(_NODES) / (_NODES - 1))) / 2
    u, v = np.broadcast_arrays(nodes[:, None], nodes[None, :])
    rho_u = member.inner_cone_distance + v * member.face_width
    delta, phi = angles(u, member.limit_angle(member.tip_limit, rho_u))
    rho = member.cone_distance(rho_u, delta)
    azimuth, flat = phi + member.lengthwise.azimuth(rho), rho * np.sin(delta)
    points = np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), rho * np.cos(delta)], axis=-1)
    by_u = make_interp_spline(nodes, points, k=_DEGREE, axis=0)
    by_v = make_interp_spline(nodes, by_u.c, k=_DEGREE, axis=1)
    return NurbsSurface(np.moveaxis(by_v.c, 0, 1), by_u.t, by_v.t, _DEGREE, _DEGREE)
