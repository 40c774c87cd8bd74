"""The turned body that carries the teeth, as an outline in the axial half-plane (radius, height).

The outline runs from the back cone, below the roots at the heel, round the body to the front cone below
the roots at the toe; the tooth ends on back and front cone close it towards the teeth. Height is measured
along the axis from the apex; the back face stands at the mounting distance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import FieldError
from gearstudio.theory.chamfer import EndChamfer, chamfer_limits, end_chamfers
from gearstudio.theory.cones import MemberGeometry

Floats = NDArray[np.float64]

_RIM_IN_DEPTHS = 1.0
_LARGEST_RIM_SHARE = 0.35
_BORE_SHARE = 0.45
_HUB_OVER_BORE = 1.7
_SMALLEST_WALL_SHARE = 0.05
_ROUNDING = 1 + 1e-5  # a limit may be typed with the six digits of its message


@dataclass(frozen=True)
class BlankSizes:
    """What a design says about a member's body [mm]; None is derived from the pair.

    Attributes
    ----------
    bore_diameter : float or None
        0 for no bore.
    hub_diameter, hub_length : float or None
        The hub reaches from the back face this far toward the apex.
    mounting_distance : float or None
        From the apex to the back face.
    web_thickness : float or None
        Of the disc between hub and rim, from the back face.
    shank_diameter, shank_length : float
        A solid shank behind the back face; 0 for none. It takes the place of the bore.
    end_chamfer : float
        Of the edges between tip and ends of the teeth, along either; 0 for none.
    """

    bore_diameter: float | None = None
    hub_diameter: float | None = None
    hub_length: float | None = None
    mounting_distance: float | None = None
    web_thickness: float | None = None
    shank_diameter: float = 0.0
    shank_length: float = 0.0
    end_chamfer: float = 0.0


@dataclass(frozen=True)
class BlankOutline:
    """A member's body with every size filled in.

    Attributes
    ----------
    points : ndarray, shape (n, 2)
        (radius, height) from the back cone to the front cone [mm]; a radius of 0 lies on the axis.
    sizes : BlankSizes
        As used, nothing None.
    chamfers : tuple of EndChamfer
        At toe and heel, or none.
    """

    points: Floats
    sizes: BlankSizes
    chamfers: tuple[EndChamfer, ...] = ()


class BlankError(FieldError):
    """A body that cannot be turned; ``field`` is the size to change."""


def blank_outline(member: MemberGeometry, sizes: BlankSizes) -> BlankOutline:
    """Lay out a member's body.

    Raises
    ------
    BlankError
        A size that makes no body, with what would.
    """
    heel_root, toe_root = _root_point(member, 1.0), _root_point(member, 0.0)
    heel_rim, toe_rim = _rim_point(member, 1.0), _rim_point(member, 0.0)
    back = heel_rim[1] if sizes.mounting_distance is None else sizes.mounting_distance
    heel_rim = _meet_back_face(member, heel_root, heel_rim, back)
    derived_front = min(toe_rim[1], _deepest(member, toe_root[0]) * (1 - 1e-9))
    web = back - derived_front if sizes.web_thickness is None else sizes.web_thickness
    front = back - web
    toe_rim = _front_cone_at(member, toe_root, front)
    wall = _SMALLEST_WALL_SHARE * toe_root[0]
    largest = 2 * (min(toe_rim[0], heel_rim[0]) - wall)
    shank = sizes.shank_diameter > 0 and sizes.shank_length > 0
    bore = 0.0 if shank else _bore(sizes, largest)
    hub, hub_length = _hub(member, sizes, bore, web, back, largest)
    profile = [heel_rim]
    if heel_rim[1] < back - 1e-9 * back:
        profile.append((heel_rim[0], back))
    if shank:
        radius = _shank_radius(sizes, heel_rim[0] - wall)
        profile += [(radius, back), (radius, back + sizes.shank_length), (0.0, back + sizes.shank_length)]
    else:
        profile.append((bore / 2, back))
    if hub_length > web:
        profile += [(bore / 2, back - hub_length), (hub / 2, back - hub_length), (hub / 2, front)]
    else:
        profile.append((bore / 2, front))
    profile.append(toe_rim)
    used = replace(
        sizes,
        bore_diameter=bore,
        hub_diameter=hub,
        hub_length=hub_length,
        mounting_distance=back,
        web_thickness=web,
        shank_diameter=sizes.shank_diameter if shank else 0.0,
    )
    return BlankOutline(np.array(profile, dtype=np.float64), used, _chamfers(member, sizes.end_chamfer))


def crown_height(member: MemberGeometry) -> float:
    """Height of the toe's tip above the apex [mm]: no part of the hub may reach nearer to the mate."""
    rho_u = member.inner_cone_distance
    tip = float(member.limit_angle(member.tip_limit, rho_u))
    return float(member.cone_distance(rho_u, tip)) * float(np.cos(tip))


def _end_point(member: MemberGeometry, v: float, below_pitch: float) -> tuple[float, float]:
    """Point of an end surface at a depth below the pitch cone, (radius, height) [mm]."""
    rho_u = float(member.along_face(v))
    if member.ends == "sphere":
        angle = member.pitch_angle - below_pitch / rho_u
        return float(rho_u * np.sin(angle)), float(rho_u * np.cos(angle))
    sin_d, cos_d = float(np.sin(member.pitch_angle)), float(np.cos(member.pitch_angle))
    return rho_u * sin_d - below_pitch * cos_d, rho_u * cos_d + below_pitch * sin_d


def _depth_below_pitch(member: MemberGeometry, v: float) -> float:
    rho_u = float(member.along_face(v))
    lean = member.pitch_angle - float(member.limit_angle(member.root_limit, rho_u))
    return rho_u * (lean if member.ends == "sphere" else float(np.tan(lean)))


def _root_point(member: MemberGeometry, v: float) -> tuple[float, float]:
    return _end_point(member, v, _depth_below_pitch(member, v))


def _rim_point(member: MemberGeometry, v: float) -> tuple[float, float]:
    """Where the rim ends below the root: one whole depth, less where the body is small."""
    scale = float(member.along_face(v)) / member.outer_cone_distance
    root_radius = _root_point(member, v)[0]
    cos_d = max(float(np.cos(member.pitch_angle)), 1e-6)
    rim = min(_RIM_IN_DEPTHS * (member.addendum + member.dedendum) * scale, _LARGEST_RIM_SHARE * root_radius / cos_d)
    return _end_point(member, v, _depth_below_pitch(member, v) + rim)


def _meet_back_face(
    member: MemberGeometry, root: tuple[float, float], rim: tuple[float, float], back: float
) -> tuple[float, float]:
    """The outline's first point: on the back cone, no further than the back face."""
    if back >= rim[1]:
        return rim
    slack = 1e-3 * (rim[1] - root[1])
    if back < root[1] + slack:
        raise BlankError(
            "mounting_distance",
            f"a back face {back:.6g} mm from the apex cuts into the roots at the heel; "
            f"use at least {_rounded_up(root[1] + 2 * slack):.6g} mm",
        )
    share = (back - root[1]) / (rim[1] - root[1])
    return _between(member, 1.0, share)


def _rounded_up(value: float) -> float:
    """The next value of six digits, so that what a message offers does hold."""
    step = 10.0 ** (np.floor(np.log10(abs(value))) - 5)
    return float(np.ceil(value / step) * step)


def _rounded_down(value: float) -> float:
    return -_rounded_up(-value)


def _front_cone_at(member: MemberGeometry, root: tuple[float, float], front: float) -> tuple[float, float]:
    """The outline's last point: on the front cone at the height of the web's front face."""
    highest = _deepest(member, root[0])
    lowest = root[1] + 1e-3 * min(member.addendum + member.dedendum, highest - root[1])
    if not lowest <= front <= highest:
        change = front - float(np.clip(front, lowest, highest))
        raise BlankError(
            "web_thickness",
            f"the web's front face, {front:.6g} mm from the apex, must lie on the front cone between {lowest:.6g} "
            f"and {highest:.6g} mm; change the thickness by {change:+.4g} mm",
        )
    sin_d = float(np.sin(member.pitch_angle))
    if member.ends == "sphere":
        rho_u = member.inner_cone_distance
        return float(np.sqrt(max(rho_u**2 - front**2, 0.0))), front
    below = (front - member.inner_cone_distance * float(np.cos(member.pitch_angle))) / sin_d
    return _end_point(member, 0.0, below)


def _deepest(member: MemberGeometry, root_radius: float) -> float:
    """Greatest height at which the front end surface still leaves room for a body round the axis [mm]."""
    rho_u, radius = member.inner_cone_distance, 2 * _SMALLEST_WALL_SHARE * root_radius
    if member.ends == "sphere":
        return float(np.sqrt(rho_u**2 - radius**2))
    sin_d, cos_d = float(np.sin(member.pitch_angle)), max(float(np.cos(member.pitch_angle)), 1e-9)
    return rho_u * cos_d + (rho_u * sin_d - radius) / cos_d * sin_d


def _between(member: MemberGeometry, v: float, share: float) -> tuple[float, float]:
    root, rim = _root_point(member, v), _rim_point(member, v)
    if member.ends != "sphere":
        return root[0] + share * (rim[0] - root[0]), root[1] + share * (rim[1] - root[1])
    height = root[1] + share * (rim[1] - root[1])
    rho_u = float(member.along_face(v))
    return float(np.sqrt(rho_u**2 - height**2)), height


def _bore(sizes: BlankSizes, largest: float) -> float:
    if sizes.bore_diameter is None:
        return _BORE_SHARE * largest
    if sizes.bore_diameter > _ROUNDING * largest:
        raise BlankError(
            "bore_diameter",
            f"a bore of {sizes.bore_diameter:.6g} mm leaves no wall under the roots; use at most {largest:.6g} mm",
        )
    return sizes.bore_diameter


def _hub(
    member: MemberGeometry, sizes: BlankSizes, bore: float, web: float, back: float, largest: float
) -> tuple[float, float]:
    given = sizes.hub_diameter
    hub = min(max(_HUB_OVER_BORE * bore, 0.3 * largest), 0.5 * (bore + largest)) if given is None else given
    length = web if sizes.hub_length is None else sizes.hub_length
    if (given is not None or length > web) and not bore < hub < largest:
        raise BlankError(
            "hub_diameter",
            f"a hub of {hub:.6g} mm must lie between the bore and the rim; use more than {bore:.6g} "
            f"and less than {largest:.6g} mm",
        )
    reach = back - crown_height(member)
    if sizes.hub_length is not None and length > _ROUNDING * reach:
        raise BlankError("hub_length", f"a hub {length:.6g} mm long reaches beyond the toe; use at most {reach:.6g} mm")
    return hub, length


def _shank_radius(sizes: BlankSizes, largest: float) -> float:
    if sizes.shank_diameter / 2 > _ROUNDING * largest:
        raise BlankError(
            "shank_diameter",
            f"a shank of {sizes.shank_diameter:.6g} mm is wider than the back face; use at most {2 * largest:.6g} mm",
        )
    return sizes.shank_diameter / 2


def _chamfers(member: MemberGeometry, length: float) -> tuple[EndChamfer, ...]:
    least, most = chamfer_limits(member)
    if length > _ROUNDING * most:
        raise BlankError(
            "end_chamfer",
            f"a chamfer of {length:.6g} mm leaves no tip between toe and heel or reaches the roots; "
            f"use at most {_rounded_down(most):.6g} mm",
        )
    if 0 < length < least / _ROUNDING:
        raise BlankError(
            "end_chamfer",
            f"a chamfer of {length:.6g} mm is too small to be modelled; use 0 for none, or at least "
            f"{_rounded_up(least):.6g} mm",
        )
    return end_chamfers(member, length)
