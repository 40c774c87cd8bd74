"""The axial section of a member's blank and its dimensions, as plain arrays; no widget.

Places are (height, radius) in millimetres: the axis lies along the first coordinate, the apex at its origin.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.blank import BlankSizes, blank_outline
from ui.formatting import fixed
from ui.units import value_text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gearstudio.design import Design
    from gearstudio.theory.chamfer import EndChamfer
    from gearstudio.theory.cones import MemberGeometry
    from gearstudio.theory.limit import ConeLimit

Floats = NDArray[np.float64]
Place = tuple[float, float]
_ARC = 17


@dataclass(frozen=True)
class Dimension:
    """A dimension line.

    Attributes
    ----------
    kind : {"along", "diameter", "aligned"}
        Measured along the axis (drawn below), from the axis (drawn at the right), or between two places.
    start, end : (height, radius)
    text : str
    row : int
        How far out it is drawn; 0 next to the part.
    """

    kind: Literal["along", "diameter", "aligned"]
    start: Place
    end: Place
    text: str
    row: int = 0


@dataclass(frozen=True, eq=False)
class BlankShape:
    """What a section drawing shows.

    Attributes
    ----------
    body : ndarray, shape (n, 2)
        Closed outline of the metal below the roots.
    tooth : ndarray, shape (m, 2)
        Closed outline of the tooth.
    pitch : ndarray, shape (2, 2)
        The pitch cone's element, from the apex to the back cone.
    dimensions : tuple of Dimension
    notes : tuple of str
        Angles, in words.
    """

    body: Floats
    tooth: Floats
    pitch: Floats
    dimensions: tuple[Dimension, ...]
    notes: tuple[str, ...]

    @property
    def extent(self) -> tuple[Place, Place]:
        """Lowest and highest place, axis and apex included."""
        points = np.concatenate([self.body, self.tooth, self.pitch, [[0.0, 0.0]]])
        low, high = points.min(axis=0), points.max(axis=0)
        return (float(low[0]), 0.0), (float(high[0]), float(high[1]))


def blank_shape(design: Design, member: MemberGeometry) -> BlankShape:
    """Lay out the section of a member.

    Raises
    ------
    BlankError
        A size that makes no body.
    """
    outline = blank_outline(member, BlankSizes(**getattr(design.blank, member.name).model_dump()))
    body = outline.points[:, ::-1]
    roots, tips = (_element(member, limit) for limit in (member.root_limit, member.tip_limit))
    heel_foot = _end(member, 1.0, body[0], roots[1])
    toe_foot = _end(member, 0.0, roots[0], body[-1])
    (toe_top, *toe_edge), (heel_top, *heel_edge) = _tops(outline.chamfers, tips)
    tooth = np.concatenate(
        [_end(member, 1.0, roots[1], heel_top), *heel_edge, *toe_edge, _end(member, 0.0, toe_top, roots[0])]
    )
    pitch = _element(member, None)
    metal = np.concatenate([body, toe_foot[::-1][1:], heel_foot[::-1][:-1]])
    angles = (("δ_a", member.tip_angle), ("δ", member.pitch_angle), ("δ_f", member.root_angle))
    notes = tuple(f"{name} {fixed(np.degrees(angle), 2)}°" for name, angle in angles)
    notes += tuple(f"c {_mm(outline.sizes.end_chamfer)}" for _ in outline.chamfers[:1])
    line = np.array([[0.0, 0.0], pitch[1]])
    return BlankShape(metal, tooth, line, _dimensions(member, outline.sizes, tips, pitch), notes)


def _element(member: MemberGeometry, limit: ConeLimit | None) -> Floats:
    """Toe and heel of a cone's element (height, radius); of the pitch cone for None, shape (2, 2)."""
    rho_u = np.array([member.inner_cone_distance, member.outer_cone_distance])
    angle = np.full(2, member.pitch_angle) if limit is None else member.limit_angle(limit, rho_u)
    rho = member.cone_distance(rho_u, angle)
    return np.stack([rho * np.cos(angle), rho * np.sin(angle)], axis=-1)


def _tops(chamfers: Sequence[EndChamfer], tips: Floats) -> list[list[Floats]]:
    """Where toe and heel end below the tip (height, radius), and the other edge of a chamfer there, shape (1, 2)."""
    tops = [[tip] for tip in tips]
    for chamfer in chamfers:
        tops[chamfer.end] = [np.array(chamfer.foot[::-1]), np.array([chamfer.face[::-1]])]
    return tops


def _end(member: MemberGeometry, v: float, start: Floats, end: Floats) -> Floats:
    """The end surface from one place to another: a line, or an arc where teeth end on spheres."""
    if member.ends != "sphere":
        return np.stack([start, end])
    rho = member.along_face(v)
    angles = np.linspace(np.arctan2(start[1], start[0]), np.arctan2(end[1], end[0]), _ARC)
    return rho * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def _dimensions(member: MemberGeometry, sizes: BlankSizes, tips: Floats, pitch: Floats) -> tuple[Dimension, ...]:
    bore, hub, length, back, web = (
        float(getattr(sizes, name) or 0.0)
        for name in ("bore_diameter", "hub_diameter", "hub_length", "mounting_distance", "web_thickness")
    )
    tip = float(tips[1, 1])
    made = [
        Dimension("aligned", _place(tips[0]), _place(tips[1]), f"B {_mm(member.face_width)}"),
        Dimension("aligned", (0.0, 0.0), _place(pitch[1]), f"R {_mm(member.outer_cone_distance)}", -1),
        Dimension("along", (back - web, 0.0), (back, 0.0), f"b_w {_mm(web)}"),
        Dimension("along", (0.0, 0.0), (back, 0.0), f"t_B {_mm(back)}", 1),
    ]
    across = [(back, bore, "d")] if bore > 0 else []
    if length > web * (1 + 1e-9):
        made.append(Dimension("along", (back - length, 0.0), (back, 0.0), f"L_h {_mm(length)}", 2))
        across.append((back - length, hub, "D_h"))
    if sizes.shank_diameter:
        end = back + sizes.shank_length
        made.append(Dimension("along", (back, 0.0), (end, 0.0), f"L_s {_mm(sizes.shank_length)}"))
        across.append((end, sizes.shank_diameter, "d_s"))
    across.append((float(tips[1, 0]), 2 * tip, "d_a"))
    made += [
        Dimension("diameter", (height, 0.0), (height, diameter / 2), f"{name} ⌀{_mm(diameter)}", row)
        for row, (height, diameter, name) in enumerate(sorted(across, key=lambda x: x[1]))
    ]
    return tuple(made)


def _place(point: Floats) -> Place:
    return float(point[0]), float(point[1])


def _mm(value: float) -> str:
    return value_text(value, "mm", 2 if value < 1000 else 1)
