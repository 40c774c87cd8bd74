"""The gear around the flanks: one tooth, or all of them, as meshes for the eye (theory 6); numpy alone.

A tooth is a set of smooth patches (tip, flanks, fillets, root, ends); each has normals of its own, so the edges
between them stay crisp on a coarse grid. The other teeth are the same patches turned, in one mesh.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute import azimuth_from_arc, involute_azimuth, polar_angle
from gearstudio.theory.modified import flank_of
from gearstudio.theory.profile import ToothProfile, tooth_profile
from ui.grids import grid_normals, grid_triangles, on_cone
from ui.layers import GREY, TOOTH_BARED, TOOTH_WALLS, TOOTH_WHOLE, Layer, Style
from ui.meshes import Mesh, copies, joined

Floats = NDArray[np.float64]
Angles = tuple[Floats, Floats]

_RIM = 1.1
"""Thickness of the body below the root, in tooth depths."""
_OVERLAP = 1.004
_SAMPLES = {"root": 3, "fillet": 7, "meridian": 2, "flank": 15, "tip": 3}
_COARSE = {"root": 2, "fillet": 4, "meridian": 2, "flank": 7, "tip": 2}
_ALONG = 33
_STYLE, _BEHIND = Style(GREY, gloss=0.10), Style(GREY, gloss=0.10, lift=-1)


def context_layers(member: MemberGeometry) -> tuple[Layer, ...]:
    """The tooth with its flanks, the tooth without them, what closes it alone, and the rest of the gear."""
    fine, coarse = _Tooth(member, _SAMPLES, _ALONG), _Tooth(member, *_resolution(member.teeth))
    others = copies(_joined(coarse.faces(bared=False)), member.pitch * np.arange(1, member.teeth))
    return (
        _layer("tooth", TOOTH_WHOLE, _joined(fine.faces(bared=False))),
        _layer("tooth", TOOTH_BARED, _joined(fine.faces(bared=True))),
        _layer("tooth", TOOTH_WALLS, _joined(fine.walls())),
        _layer("gear", "teeth", joined([others, _joined([coarse.bore()])]), _BEHIND),
    )


@lru_cache(maxsize=6)
def end_profiles(member: MemberGeometry) -> tuple[Floats, Floats]:
    """Profiles of the tooth at toe and heel, from space to space, (n, 3) each."""
    profile = tooth_profile(member)
    return profile.outline(0.0), profile.outline(1.0)


def _resolution(teeth: int) -> tuple[dict[str, int], int]:
    """Samples on the profile and along the face, so that the whole gear stays light."""
    return (_SAMPLES if teeth <= 12 else _COARSE), int(np.clip(480 // teeth, 6, 25))


class _Tooth:
    """Patches of the tooth at azimuth 0 as grids (profile, face, 3)."""

    def __init__(self, member: MemberGeometry, samples: dict[str, int], along: int) -> None:
        self.member, self.samples = member, samples
        self.profile: ToothProfile = tooth_profile(member)
        self.rho_u = np.linspace(member.inner_cone_distance, member.outer_cone_distance, along)
        self.tip = member.limit_angle(member.tip_limit, self.rho_u)
        depth = float(self.tip[-1]) - member.root_angle
        self.hub = max(member.root_angle - _RIM * depth, 0.45 * member.root_angle)

    def faces(self, bared: bool) -> list[Floats]:
        """Everything between the middles of two spaces; bared of the working flanks, with a sharp foot."""
        half = self._sharp_half() if bared else self._half()
        shown = [angles for name, angles in half.items() if not (bared and name == "flank")]
        made = [self._place(delta, sign * phi) for sign in (1.0, -1.0) for delta, phi in shown]
        for end in (0, -1):
            delta = np.concatenate([d[:, end] for d, _ in half.values()])
            phi = np.concatenate([p[:, end] for _, p in half.values()])
            made += [self._cap(delta, sign * phi, end) for sign in (1.0, -1.0)]
        return made

    def walls(self) -> list[Floats]:
        """What closes a tooth that stands alone: sides in the middle of the spaces, and the floor."""
        member = self.member
        delta = np.linspace(self.hub, member.root_angle, 4)[:, None] * np.ones_like(self.rho_u)
        around = np.linspace(-member.pitch / 2, member.pitch / 2, 9)[:, None] * np.ones_like(self.rho_u)
        sides = [self._place(delta, np.full_like(delta, sign * member.pitch / 2)) for sign in (1.0, -1.0)]
        return [*sides, self._place(np.full_like(around, self.hub), around)]

    def bore(self) -> Floats:
        """The inner surface of the whole body."""
        around = np.linspace(0, 2 * np.pi, 145)[:, None]
        ends = self.member.cone_distance(self.rho_u[[0, -1]], np.full(2, self.hub))
        return on_cone(ends[None, :], np.float64(self.hub), around)

    def _half(self) -> dict[str, Angles]:
        made = {}
        for name in self.profile.segments:
            s = np.linspace(0.0, 1.0, self.samples[name])[:, None] * np.ones_like(self.rho_u)
            made[name] = self.profile.angles(name, s, self.tip)
        return self._completed(made)

    def _sharp_half(self) -> dict[str, Angles]:
        """The half tooth without fillets: the root led up to the working flank's lower edge."""
        member = self.member
        flank = self._working_flank()
        low, foot = flank[0][0], flank[1][0]
        s = np.linspace(0.0, 1.0, 4)[:, None]
        half = member.pitch / 2
        made = {"root": (np.full_like(s, member.root_angle), half + s * (foot - half))}
        if np.any(low > member.root_angle + 1e-9):
            made["meridian"] = (member.root_angle + s * (low - member.root_angle), foot[None, :])
        s = np.linspace(0.0, 1.0, self.samples["tip"])[:, None]
        made |= {"flank": flank, "tip": self.profile.angles("tip", s, self.tip)}
        return self._completed(made)

    def _working_flank(self) -> Angles:
        member = self.member
        flank = flank_of(member, "concave")
        v = (self.rho_u - self.rho_u[0]) / member.face_width
        psi, _ = flank.coordinates(np.linspace(0, 1, self.samples["flank"])[:, None], v[None, :])
        start = member.half_tooth_azimuth + involute_azimuth(member.pitch_angle, member.base_angle)
        return polar_angle(psi, member.base_angle), start - azimuth_from_arc(psi, member.base_angle)

    def _completed(self, half: dict[str, Angles]) -> dict[str, Angles]:
        """Every segment as full (profile, along) arrays; a little over the middle of the space, against cracks."""
        made: dict[str, Angles] = {}
        for name, (delta, phi) in half.items():
            shape = (*np.broadcast_shapes(delta.shape, phi.shape)[:-1], len(self.rho_u))
            azimuth = np.array(np.broadcast_to(phi, shape))
            if not made:
                azimuth[0] *= _OVERLAP
            made[name] = np.broadcast_to(delta, shape), azimuth
        return made

    def _place(self, delta: Floats, phi: Floats) -> Floats:
        """Points of polar angles and azimuths (n, along) of a profile, with the twist of the tooth."""
        rho = self.member.cone_distance(self.rho_u, delta)
        return on_cone(rho, delta, phi + self.member.lengthwise.azimuth(rho))

    def _cap(self, delta: Floats, phi: Floats, end: int) -> Floats:
        """End face of half a tooth: from its outline down to the bore."""
        rho_u = self.rho_u[end]
        azimuth = phi + self.member.lengthwise.azimuth(self.member.cone_distance(rho_u, delta))
        places = np.linspace(0.0, 1.0, 4 if self.member.ends == "sphere" else 2)[:, None]
        polar = self.hub + places * (delta - self.hub)
        return on_cone(self.member.cone_distance(rho_u, polar), polar, azimuth[None, :])


def _joined(grids: list[Floats]) -> Mesh:
    meshes = [Mesh(g.reshape(-1, 3), grid_normals(g).reshape(-1, 3), grid_triangles(*g.shape[:2])) for g in grids]
    return joined(meshes)


def _layer(layer_id: str, part: str, mesh: Mesh, style: Style = _STYLE) -> Layer:
    return Layer(layer_id, part, "surface", mesh.points, style, mesh.cells, mesh.normals)
