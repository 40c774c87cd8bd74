"""What the views show of a member and of a method's result: layers as plain arrays, no renderer.

The layers fall into three groups by what they depend on: the member alone (`member_layers`, kept for the last few
members, so that three views share the very same objects), a result (`result_layers`), and the roll of the tangent
plane (`rolling_layers`), which is all there is to compute anew while the plane rolls.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearstudio.results import FlankResult, VariantResult
from gearstudio.theory.cloud import flank_grid
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.involute import base_cone_spiral, generating_line, polar_angle, roll_arc, start_azimuth
from gearstudio.theory.involute import tangent_plane as plane_axes
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.modified import flank_of
from gearstudio.theory.vectors import from_spherical
from ui import layers as look
from ui.grids import facing, grid_normals, grid_segments, grid_triangles, path_segments
from ui.layers import Ink, Layer, Style
from ui.tooth_mesh import context_layers, end_profiles

Floats = NDArray[np.float64]

_THEORY_GRID = (33, 49)
_SWEPT_GRID = (25, 65)
_CLOUD = (7, 7)
_AROUND = 181
_SPOKES = 24

_MAP = Style(Ink("#e9e9e9", "#d9d9d9"), gloss=0.06)
_EDGE = Style(look.INK, width=1.6, lift=2)
_GLASS = 0.22


@dataclass(frozen=True)
class SceneOptions:
    """Choices that are no switch of a layer: the flank that the plane generates."""

    flank: FlankName = "concave"


@lru_cache(maxsize=6)
def member_layers(member: MemberGeometry) -> tuple[Layer, ...]:
    """Layers that depend on the member alone; the same objects for the same member."""
    return (
        *context_layers(member),
        *_cone("base_cone", member, member.base_angle, look.VIOLET),
        *_cone("pitch_cone", member, member.pitch_angle, look.SAGE),
        *_theory(member),
        *_cloud(member),
        *_base_spirals(member),
        *_end_sections(member),
    )


def result_layers(result: VariantResult) -> tuple[Layer, ...]:
    """CAD flanks, their deviation and what they were made from."""
    made: list[Layer] = []
    for name, flank in result.flanks.items():
        made += _cad_flank(name, flank)
        made += _construction(name, flank)
    return tuple(made)


def rolling_layers(member: MemberGeometry, roll: float, options: SceneOptions | None = None) -> tuple[Layer, ...]:
    """Tangent plane, generating line and what it has swept at a roll in [0, 1]."""
    flank = flank_of(member, (options or SceneOptions()).flank).swept
    contact = _contact(flank, roll)
    return (*_tangent_plane(flank.member, contact), *_generating_line(flank, contact))


def roll_span_deg(member: MemberGeometry, options: SceneOptions | None = None) -> float:
    """Roll angle [deg] of the plane from the first to the last touch of the flank."""
    first, last = _contact_span(flank_of(member, (options or SceneOptions()).flank).swept)
    return float(np.degrees(abs(last - first)))


# ---- the member -----------------------------------------------------------------------------------------


def _cone(layer_id: str, member: MemberGeometry, angle: float, ink: Ink) -> tuple[Layer, ...]:
    around = np.linspace(0, 2 * np.pi, _AROUND)
    rho = member.outer_cone_distance
    grid = from_spherical(np.array([1e-3 * rho, rho])[:, None], angle, around[None, :])
    normals = from_spherical(1.0, angle + np.pi / 2, around)
    rims = [grid[-1], from_spherical(member.inner_cone_distance, angle, around)]
    return (
        _surface(layer_id, "cone", grid, Style(ink, opacity=_GLASS, gloss=0.3), np.broadcast_to(normals, grid.shape)),
        _paths(layer_id, "rims", rims, Style(ink, width=1.8)),
    )


def _theory(member: MemberGeometry) -> list[Layer]:
    u, v = np.linspace(0, 1, _THEORY_GRID[0])[:, None], np.linspace(0, 1, _THEORY_GRID[1])[None, :]
    made = []
    for name in FLANKS:
        flank = flank_of(member, name)
        grid = flank.points(u, v)
        made.append(
            _surface("theory_flank", name, grid, Style(look.MINT, opacity=0.5, gloss=0.3, lift=1), flank.normals(u, v))
        )
        made.append(_paths("theory_flank", f"{name} edge", [border_of(grid)], Style(look.MINT, width=1.8, lift=2)))
    return made


def _cloud(member: MemberGeometry) -> list[Layer]:
    clouds = [flank_grid(flank_of(member, name), *_CLOUD) for name in FLANKS]
    rows, cols = _CLOUD
    one = grid_segments(rows, cols, 1, 1)
    cells = np.concatenate([one + index * rows * cols for index in range(len(clouds))])
    points = np.concatenate([cloud.reshape(-1, 3) for cloud in clouds])
    return [
        Layer("points", "theory lines", "lines", points, Style(look.GRAPHITE, width=1.5, lift=3), cells),
        Layer("points", "theory points", "points", points, Style(look.INK, width=6.0, lift=4)),
    ]


def _base_spirals(member: MemberGeometry) -> list[Layer]:
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 65)
    paths = [base_cone_spiral(member, flank_of(member, name).side, rho) for name in FLANKS]
    return [_paths("base_spiral", "both", paths, Style(look.PURPLE, width=3.0, lift=4))]


def _end_sections(member: MemberGeometry) -> list[Layer]:
    return [_paths("sections", "ends", list(end_profiles(member)), Style(look.INK, width=2.2, lift=3))]


# ---- a result -------------------------------------------------------------------------------------------


def _cad_flank(name: str, flank: FlankResult) -> list[Layer]:
    grid = flank.points
    normals = grid_normals(grid).reshape(-1, 3)
    points, cells = grid.reshape(-1, 3), grid_triangles(*grid.shape[:2])
    deviation = np.asarray(flank.deviation_um, dtype=np.float64).ravel()
    edge = border_of(grid)
    return [
        Layer("deviation", name, "surface", points, _MAP, cells, normals, deviation),
        _paths("deviation", f"{name} edge", [edge], _EDGE),
        Layer("cad_flank", name, "surface", points, Style(look.STEEL, gloss=0.25), cells, normals),
        _paths("cad_flank", f"{name} edge", [edge], _EDGE),
    ]


_CURVES = {
    "position": ("sections", Style(look.MAGENTA, width=1.8, lift=3)),
    "section": ("sections", Style(look.INK, width=1.8, lift=3)),
    "guide": ("guides", Style(look.GREEN, width=2.4, lift=4)),
    "u_line": ("points", Style(look.GRAPHITE, width=1.5, lift=3)),
    "v_line": ("points", Style(look.GRAPHITE, width=1.5, lift=3)),
    "points": ("points", Style(look.INK, width=5.5, lift=4)),
}


def _construction(name: str, flank: FlankResult) -> list[Layer]:
    made = []
    for kind, (layer_id, style) in _CURVES.items():
        paths = [np.asarray(curve.points).reshape(-1, 3) for curve in flank.curves if curve.kind == kind]
        if not paths:
            continue
        if kind == "points":
            made.append(Layer(layer_id, f"{name} {kind}", "points", np.concatenate(paths), style))
        else:
            made.append(_paths(layer_id, f"{name} {kind}", paths, style))
    return made


# ---- the roll -------------------------------------------------------------------------------------------


def _contact_span(flank: InvoluteFlank) -> tuple[float, float]:
    """Azimuths of contact when the line first and last touches the working flank."""
    u, v = np.array([0.0, 1.0])[:, None], np.linspace(0, 1, 33)[None, :]
    contact = flank.side * flank.contact_azimuth(*flank.coordinates(u, v))
    return flank.side * float(contact.max()), flank.side * float(contact.min())


def _contact(flank: InvoluteFlank, roll: float) -> float:
    first, last = _contact_span(flank)
    return first + min(max(roll, 0.0), 1.0) * (last - first)


def _tangent_plane(member: MemberGeometry, contact: float) -> tuple[Layer, ...]:
    """The disc; its spokes are fixed to it and so show that it turns as it rolls."""
    along, across, normal = plane_axes(member.base_angle, contact)
    radius = member.outer_cone_distance

    def at(angle: Floats, rho: Floats) -> Floats:
        return rho[..., None] * (np.cos(angle)[..., None] * along + np.sin(angle)[..., None] * across)

    around = np.linspace(0, 2 * np.pi, _AROUND)
    disc = at(*np.broadcast_arrays(around[None, :], np.array([1e-3 * radius, radius])[:, None]))
    spokes = np.arange(_SPOKES) * (2 * np.pi / _SPOKES) - contact * np.sin(member.base_angle)
    reach = np.array([member.inner_cone_distance, radius])
    marks = [at(np.full(2, angle), reach) for angle in spokes]
    return (
        _surface(
            "tangent_plane",
            "disc",
            disc,
            Style(look.CYAN, opacity=_GLASS, gloss=0.4),
            np.broadcast_to(normal, disc.shape),
        ),
        _paths("tangent_plane", "rim", [disc[-1]], Style(look.CYAN, width=2.0)),
        _paths("tangent_plane", "spokes", marks, Style(look.CYAN, width=1.0, opacity=0.6)),
        _paths("tangent_plane", "contact", [at(np.zeros(2), np.array([0.0, radius]))], Style(look.VIOLET, width=2.2)),
    )


def _generating_line(flank: InvoluteFlank, contact: float) -> tuple[Layer, ...]:
    """The rigid line, the part of it that lies on the flank, and what it has swept so far."""
    member, (rows, cols) = flank.member, _SWEPT_GRID
    v = np.linspace(0, 1, cols)
    place = _reached(flank, v, contact)
    u = np.linspace(0, 1, rows)[:, None] * np.clip(place, 0.0, 1.0)
    grid, normals = flank.points(u, v[None, :]), flank.normals(u, v[None, :])
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, cols)
    line = generating_line(member, flank.side, rho, contact)
    active = (place >= -1e-9) & (place <= 1 + 1e-9)
    touching = grid[-1]
    ends = np.stack([touching[:-1], touching[1:]], axis=1)
    dark = ~(active[:-1] & active[1:])
    ends[dark, 1] = ends[dark, 0]
    return (
        _surface("generating_line", "swept", grid, Style(look.MINT, gloss=0.25, lift=2), normals),
        _paths("generating_line", "line", [line], Style(look.MAGENTA, width=2.4, lift=3)),
        Layer(
            "generating_line",
            "touching",
            "lines",
            ends.reshape(-1, 3),
            Style(look.MAGENTA, width=5.0, lift=5),
            path_segments((2,) * (cols - 1)),
        ),
    )


def _reached(flank: InvoluteFlank, v: Floats, contact: float) -> Floats:
    """How far along u the line has come at each v; below 0 it has not arrived, above 1 it has left, shape (n,)."""
    member = flank.member
    low, high = (roll_arc(limit, member.base_angle) for limit in flank.limits(v))
    rho_u = member.along_face(v)
    psi = (low + high) / 2
    for _ in range(6):
        rho = member.cone_distance(rho_u, polar_angle(np.clip(psi, low, high), member.base_angle))
        psi = flank.side * (start_azimuth(member, flank.side, rho) - contact) * np.sin(member.base_angle)
    return np.asarray((psi - low) / (high - low))


# ---- records --------------------------------------------------------------------------------------------


def _surface(layer_id: str, part: str, grid: Floats, style: Style, normals: Floats) -> Layer:
    cells = facing(grid, normals)
    flat = np.asarray(normals, dtype=np.float64).reshape(-1, 3)
    return Layer(layer_id, part, "surface", grid.reshape(-1, 3), style, cells, flat)


def _paths(layer_id: str, part: str, paths: list[Floats], style: Style) -> Layer:
    cells = path_segments(tuple(len(path) for path in paths))
    return Layer(layer_id, part, "lines", np.concatenate(paths), style, cells)


def border_of(grid: Floats) -> Floats:
    """The closed border of a grid, shape (n, 3)."""
    return np.concatenate([grid[:, 0], grid[-1, 1:], grid[-2::-1, -1], grid[0, -2::-1]])
