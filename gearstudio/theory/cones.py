"""Pitch, base, face and root cones of both members (theory 2), and everything else a tooth is made from."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.design import Design
from gearstudio.theory.lengthwise import Lengthwise
from gearstudio.theory.limit import ConeLimit, Limit
from gearstudio.theory.relief import Edge, FlankRelief, ReliefFrame, flank_relief

if TYPE_CHECKING:
    from gearstudio.theory.hypoid.pair import HypoidPair

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class MemberGeometry:
    """One member's geometry [mm, rad]; symbols of theory 1.

    ``reliefs`` is the micro-geometry of the concave and the convex flank, None where there is none. ``hypoid`` is the
    pair with offset axes that this member belongs to, None without an offset: then each flank has a base cone of its
    own, the one here being that of one flank, and `theory.modified.flank_of` makes the flanks.
    """

    name: str
    teeth: int
    hand: int
    module: float
    pitch_angle: float
    base_angle: float
    transverse_pressure_angle: float
    gamma: float
    outer_cone_distance: float
    face_width: float
    addendum: float
    dedendum: float
    half_tooth_azimuth: float
    fillet_radius: float
    lengthwise: Lengthwise
    tip_limit: ConeLimit
    root_limit: ConeLimit
    ends: str
    reliefs: tuple[FlankRelief | None, FlankRelief | None] = (None, None)
    hypoid: HypoidPair | None = None

    @property
    def tip_angle(self) -> float:
        """Face cone angle delta_a [rad]."""
        return self.tip_limit.angle

    @property
    def root_angle(self) -> float:
        """Root cone angle delta_f [rad]."""
        return self.root_limit.angle

    @property
    def base_limit(self) -> ConeLimit:
        """The base cone as a limit of the flank."""
        return ConeLimit(self.base_angle, 0.0, self.pitch_angle)

    @property
    def inner_cone_distance(self) -> float:
        """R - B, at the toe [mm]."""
        return self.outer_cone_distance - self.face_width

    @property
    def mean_cone_distance(self) -> float:
        """R_m = R - B/2 [mm]."""
        return self.outer_cone_distance - self.face_width / 2

    @property
    def base_radius(self) -> float:
        """R_b = R sin(delta_b) [mm]."""
        return self.outer_cone_distance * float(np.sin(self.base_angle))

    @property
    def fillet_angle(self) -> float:
        """Angular radius of the fillet that was asked for, R_f / R [rad] (theory 6)."""
        return self.fillet_radius / self.outer_cone_distance

    @property
    def pitch(self) -> float:
        """Angular pitch 2 pi / z [rad]."""
        return 2 * np.pi / self.teeth

    @property
    def relief_frame(self) -> ReliefFrame:
        """From what places on this member's flanks are measured; the lower edge is the one that is higher at R_m."""
        mean, root, tip = self.mean_cone_distance, self.root_limit, self.tip_limit
        low = root if root.at_sphere(mean) > self.base_angle else self.base_limit
        edges = (Edge(limit.angle, limit.offset) for limit in (low, tip))
        return ReliefFrame(mean, self.face_width / 2, self.pitch_angle, self.ends == "back_cone", *edges)

    def along_face(self, v: ArrayLike) -> Floats:
        """rho_u [mm] at places v along the face, 0 at the toe and 1 at the heel."""
        return np.asarray(self.inner_cone_distance + np.asarray(v, dtype=np.float64) * self.face_width)

    def face_share(self, rho_u: ArrayLike) -> Floats:
        """Places v along the face at rho_u [mm]; the inverse of `along_face`."""
        return np.asarray((np.asarray(rho_u, dtype=np.float64) - self.inner_cone_distance) / self.face_width)

    def limit_angle(self, limit: Limit, rho_u: ArrayLike) -> Floats:
        """Polar angle of a limit at a tooth end, by the kind of ends this member has [rad]."""
        return limit.at_sphere(rho_u) if self.ends == "sphere" else limit.at_back_cone(rho_u)

    def cone_distance(self, rho_u: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """Distance from the apex of the point of an end surface at a polar angle [mm] (theory 6)."""
        rho_u, polar_angle = np.asarray(rho_u, dtype=np.float64), np.asarray(polar_angle, dtype=np.float64)
        if self.ends == "sphere":
            return np.broadcast_to(rho_u, np.broadcast_shapes(rho_u.shape, polar_angle.shape))
        return np.asarray(rho_u / np.cos(polar_angle - self.pitch_angle))

    def end_distance(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """rho_u [mm] of the end surface through a point; the inverse of `cone_distance`."""
        rho, polar_angle = np.asarray(rho, dtype=np.float64), np.asarray(polar_angle, dtype=np.float64)
        return rho if self.ends == "sphere" else np.asarray(rho * np.cos(polar_angle - self.pitch_angle))


@dataclass(frozen=True)
class PairGeometry:
    """Both members of a pair and what they share.

    ``hypoid`` is the same pair as the standard has it, for pairs with an offset or a depth after ISO 23509; the mean
    spiral angle is then the wheel's. ``own_cone_pinion`` asks for a reference where there is an offset: the pinion's
    flanks as involutes on base cones of their own instead of conjugate ones.
    """

    pinion: MemberGeometry
    wheel: MemberGeometry
    shaft_angle: float
    normal_pressure_angle: float
    mean_spiral_angle: float
    mean_normal_module: float
    hypoid: HypoidPair | None = None
    own_cone_pinion: bool = False

    @property
    def has_offset(self) -> bool:
        """Whether the axes do not meet."""
        return self.wheel.hypoid is not None

    def member(self, name: str) -> MemberGeometry:
        """The member called ``"pinion"`` or ``"wheel"``."""
        return {"pinion": self.pinion, "wheel": self.wheel}[name]


def pitch_angles(pinion_teeth: int, wheel_teeth: int, shaft_angle: float) -> tuple[float, float]:
    """Pitch cone angles of pinion and wheel [rad] (theory 2)."""
    pinion = float(np.arctan2(np.sin(shaft_angle), wheel_teeth / pinion_teeth + np.cos(shaft_angle)))
    return pinion, shaft_angle - pinion


def outer_cone_distance(design: Design) -> float:
    """R [mm] of a design: m z_1 / (2 sin delta_1)."""
    pair = design.pair
    delta, _ = pitch_angles(pair.pinion_teeth, pair.wheel_teeth, np.radians(pair.shaft_angle_deg))
    return pair.outer_module * pair.pinion_teeth / (2 * float(np.sin(delta)))


def face_width(design: Design) -> float:
    """B [mm] of a design: its own value, or the factor times R."""
    given = design.pair.face_width
    return given if given is not None else design.pair.face_width_factor * outer_cone_distance(design)


@dataclass(frozen=True)
class _Angles:
    """Transverse pressure angle, mean spiral angle and base angles, which depend on each other."""

    transverse: float
    mean_spiral: float
    base: tuple[float, float]


def pair_geometry(design: Design) -> PairGeometry:
    """Derive both members from a design (theory 2, 4, 5).

    Raises
    ------
    GeometryError
        There is no such pair with offset axes, or with a depth after ISO 23509.
    """
    if design.pair.offset != 0 or design.depth.system != "outer_module":
        from gearstudio.theory.hypoid.design import hypoid_geometry

        return hypoid_geometry(design)
    pair, tooth = design.pair, design.tooth
    shaft_angle = float(np.radians(pair.shaft_angle_deg))
    deltas = pitch_angles(pair.pinion_teeth, pair.wheel_teeth, shaft_angle)
    outer, width = outer_cone_distance(design), face_width(design)
    mean = outer - width / 2
    angles = _pressure_and_spiral(design, deltas, outer, width)
    normal_module = pair.outer_module * mean / outer * float(np.cos(angles.mean_spiral))
    shifts = (tooth.profile_shift, -tooth.profile_shift)
    addenda = [pair.outer_module * (tooth.addendum_factor + x) for x in shifts]
    dedenda = [pair.outer_module * (tooth.addendum_factor + tooth.clearance_factor - x) for x in shifts]
    roots = [delta - float(np.arctan(h / outer)) for delta, h in zip(deltas, dedenda, strict=True)]
    pinion_hand = 1 if pair.pinion_hand == "right" else -1

    def member(index: int) -> MemberGeometry:
        delta, teeth = deltas[index], (pair.pinion_teeth, pair.wheel_teeth)[index]
        hand = pinion_hand if index == 0 else -pinion_hand
        thickness = (np.pi / 2 + 2 * shifts[index] * np.tan(angles.transverse)) / teeth
        base = angles.base[index]
        made = MemberGeometry(
            name=("pinion", "wheel")[index],
            teeth=teeth,
            hand=hand,
            module=pair.outer_module,
            pitch_angle=delta,
            base_angle=base,
            transverse_pressure_angle=angles.transverse,
            gamma=float(np.arccos(np.cos(delta) / np.cos(base))),
            outer_cone_distance=outer,
            face_width=width,
            addendum=addenda[index],
            dedendum=dedenda[index],
            half_tooth_azimuth=float(thickness - tooth.backlash / (2 * pair.outer_module * teeth)),
            fillet_radius=tooth.fillet_factor * normal_module,
            lengthwise=Lengthwise(
                design.lengthwise.curve, mean, angles.mean_spiral, delta, hand, design.lengthwise.cutter_radius
            ),
            tip_limit=_tip_limit(tooth.tip_cone, delta, outer, addenda[index], deltas[1 - index] - roots[1 - index]),
            root_limit=ConeLimit(roots[index], 0.0, delta),
            ends=tooth.ends,
        )
        given = design.modifications.pinion if index == 0 else design.modifications.wheel
        if given.concave.is_none and given.convex.is_none:
            return made
        frame = made.relief_frame
        return replace(made, reliefs=(flank_relief(given.concave, frame), flank_relief(given.convex, frame)))

    transverse = angles.transverse
    normal = float(np.arctan(np.tan(transverse) * np.cos(angles.mean_spiral)))
    return PairGeometry(member(0), member(1), shaft_angle, normal, angles.mean_spiral, normal_module)


def bevel_angles(design: Design) -> tuple[float, float]:
    """Transverse pressure angle and mean spiral angle [rad] of a pair without offset."""
    deltas = pitch_angles(design.pair.pinion_teeth, design.pair.wheel_teeth, np.radians(design.pair.shaft_angle_deg))
    angles = _pressure_and_spiral(design, deltas, outer_cone_distance(design), face_width(design))
    return angles.transverse, angles.mean_spiral


def _pressure_and_spiral(design: Design, deltas: tuple[float, float], outer: float, width: float) -> _Angles:
    """Resolve the angles that are given in different places; at the toe the spiral angle needs the base cone.

    The toe angle is that of the pinion's base cone (both members share the one on the pitch cone).
    With a normal pressure angle the base cone depends in turn on the mean spiral angle: tan(beta_m) =
    tan(beta_0) R_m / (R - B) sin(delta) / sin(delta_b), and sin(delta)/sin(delta_b) = 1/cos(alpha),
    so both members agree and the loop closes on sin^2(beta_m) in one quadratic.
    """
    given = float(np.radians(design.pair.pressure_angle_deg))
    spiral = float(np.radians(design.lengthwise.spiral_angle_deg))
    normal = design.pair.pressure_angle_kind == "normal"
    if design.lengthwise.spiral_angle_at == "toe":
        reach = np.tan(spiral) * (outer - width / 2) / (outer - width)
        if normal:
            # 1/cos^2(alpha) = 1 + tan^2(alpha_n)/cos^2(beta_m) and 1/cos^2(beta_m) = 1 + tan^2(beta_m)
            square = reach**2 * (1 + np.tan(given) ** 2) / (1 - (reach * np.tan(given)) ** 2)
            spiral = float(np.arctan(np.sqrt(square)))
        else:
            spiral = float(np.arctan(reach / np.cos(given)))
    transverse = float(np.arctan(np.tan(given) / np.cos(spiral))) if normal else given
    base = [float(np.arcsin(np.sin(delta) * np.cos(transverse))) for delta in deltas]
    return _Angles(transverse, spiral, (base[0], base[1]))


def _tip_limit(kind: str, delta: float, outer: float, addendum: float, mate_dedendum_angle: float) -> ConeLimit:
    if kind == "common_apex":
        return ConeLimit(delta + float(np.arctan(addendum / outer)), 0.0, delta)
    angle = delta + mate_dedendum_angle
    crown = np.hypot(outer, addendum)
    return ConeLimit(angle, float(crown * np.sin(delta + np.arctan(addendum / outer) - angle)), delta)
