"""The gear around the flanks: one tooth, or all of them, as meshes for the eye (theory 6); numpy alone.

A tooth is a set of smooth patches (tip, flanks, fillets, root, ends); each has normals of its own, so the edges
between them stay crisp on a coarse grid. The other teeth are the same patches turned, in one mesh.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank
from gearstudio.theory.modified import flank_on
from gearstudio.theory.profile import profile_of
from gearstudio.theory.vectors import from_spherical, wrapped
from ui.grids import grid_normals, grid_triangles
from ui.layers import GREY, TOOTH_BARED, TOOTH_WALLS, TOOTH_WHOLE, Layer, Style
from ui.meshes import Mesh, copies, joined

Floats = NDArray[np.float64]
Angles = tuple[Floats, Floats]

_RIM = 1.1
"""Thickness of the body below the root, in tooth depths."""
_OVERLAP = 0.002
_SAMPLES = {"root": 3, "fillet": 7, "meridian": 2, "flank": 15, "tip": 3}
_COARSE = {"root": 2, "fillet": 4, "meridian": 2, "flank": 7, "tip": 2}
_ALONG = 33
_OUTLINE = 16
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
    rising, falling = _Tooth(member, dict.fromkeys(_SAMPLES, _OUTLINE), 2).halves()
    whole = np.concatenate([rising, falling[::-1]])
    return whole[:, 0], whole[:, 1]


def _resolution(teeth: int) -> tuple[dict[str, int], int]:
    """Samples on the profile and along the face, so that the whole gear stays light."""
    return (_SAMPLES if teeth <= 12 else _COARSE), int(np.clip(480 // teeth, 6, 25))


class _Tooth:
    """Patches of the tooth at azimuth 0 as grids (profile, face, 3)."""

    def __init__(self, member: MemberGeometry, samples: dict[str, int], along: int) -> None:
        self.member, self.samples = member, samples
        self.profile = profile_of(member)
        self.rho_u = np.linspace(member.inner_cone_distance, member.outer_cone_distance, along)
        self.root, self.after, before = self.profile.across("root", self.rho_u)
        self.before = before - member.pitch
        self.middle = (self.after + before) / 2
        depth = float(member.limit_angle(member.tip_limit, self.rho_u[-1])) - float(self.root[-1])
        low = float(self.root.min())
        self.hub = max(low - _RIM * depth, 0.45 * low)

    def faces(self, bared: bool) -> list[Floats]:
        """Everything between the middles of two spaces; bared of the working flanks, with a sharp foot."""
        halves = [self._sharp_half(side) if bared else self._half(side) for side in (1, -1)]
        shown = [angles for half in halves for name, angles in half.items() if not (bared and name == "flank")]
        made = [self._place(delta, phi) for delta, phi in shown]
        for end in (0, -1):
            for half in halves:
                delta = np.concatenate([d[:, end] for d, _ in half.values()])
                phi = np.concatenate([p[:, end] for _, p in half.values()])
                made.append(self._cap(delta, phi, end))
        return made

    def halves(self) -> tuple[Floats, Floats]:
        """Both sides from the middle of a space to that of the tip, (profile, face, 3) each."""
        one, other = (np.concatenate([self._place(*part) for part in self._half(s).values()]) for s in (1, -1))
        return one, other

    def walls(self) -> list[Floats]:
        """What closes a tooth that stands alone: sides in the middle of the spaces, and the floor."""
        first, last = self.middle - self.member.pitch, self.middle
        delta = self.hub + np.linspace(0.0, 1.0, 4)[:, None] * (self.root - self.hub)
        around = first + np.linspace(0.0, 1.0, 9)[:, None] * (last - first)
        sides = [self._place(delta, np.broadcast_to(azimuth, delta.shape)) for azimuth in (last, first)]
        return [*sides, self._place(np.full_like(around, self.hub), around)]

    def bore(self) -> Floats:
        """The inner surface of the whole body."""
        around = np.linspace(0, 2 * np.pi, 145)[:, None]
        ends = self.member.cone_distance(self.rho_u[[0, -1]], np.full(2, self.hub))
        return from_spherical(ends[None, :], self.hub, around)

    def _half(self, side: int) -> dict[str, Angles]:
        made: dict[str, Angles] = {}
        if self.profile.has_root:
            edge, share = self.after if side > 0 else self.before, self._shares("root")
            made["root"] = self.root, self._middle(side) + share * (edge - self._middle(side))
        for name in self.profile.below(side):
            made[name] = self.profile.rising(name, side, self._shares(name), self.rho_u)
        made["flank"] = self._flank(self.profile.flank(side))
        return self._completed(side, made | {"tip": self._tip(side)})

    def _sharp_half(self, side: int) -> dict[str, Angles]:
        """The half tooth without fillets: the root led up to the working flank's lower edge."""
        flank = self._flank(flank_on(self.member, side))
        low, foot = flank[0][0], flank[1][0]
        s, middle = np.linspace(0.0, 1.0, 4)[:, None], self._middle(side)
        made: dict[str, Angles] = {"root": (self.root, middle + s * (foot - middle))}
        if np.any(low > self.root + 1e-9):
            made["meridian"] = (self.root + s * (low - self.root), foot)
        return self._completed(side, made | {"flank": flank, "tip": self._tip(side)})

    def _shares(self, name: str) -> Floats:
        return np.linspace(0.0, 1.0, self.samples[name])[:, None]

    def _middle(self, side: int) -> Floats:
        """The middle of the space on a side."""
        return self.middle if side > 0 else self.middle - self.member.pitch

    def _tip(self, side: int) -> Angles:
        """From a flank to the middle of the tip."""
        delta, first, last = self.profile.across("tip", self.rho_u)
        edge = last if side > 0 else first
        return delta, edge + self._shares("tip") * ((first + last) / 2 - edge)

    def _flank(self, flank: Flank) -> Angles:
        v = (self.rho_u - self.rho_u[0]) / self.member.face_width
        rho, delta, phi = flank.locate(flank.points(self._shares("flank"), v))
        return delta, wrapped(phi - self.member.lengthwise.azimuth(rho))

    def _completed(self, side: int, half: dict[str, Angles]) -> dict[str, Angles]:
        """Every segment as full (profile, along) arrays; a little over the middle of the space, against cracks."""
        made: dict[str, Angles] = {}
        for name, (delta, phi) in half.items():
            shape = (max(np.shape(x)[0] if np.ndim(x) > 1 else 1 for x in (delta, phi)), len(self.rho_u))
            azimuth = np.array(np.broadcast_to(phi, shape))
            if not made:
                azimuth[0] += side * _OVERLAP * self.member.pitch
            made[name] = np.broadcast_to(delta, shape), azimuth
        return made

    def _place(self, delta: Floats, phi: Floats) -> Floats:
        """Points of polar angles and azimuths (n, along) of a profile, with the twist of the tooth."""
        rho = self.member.cone_distance(self.rho_u, delta)
        return from_spherical(rho, delta, phi + self.member.lengthwise.azimuth(rho))

    def _cap(self, delta: Floats, phi: Floats, end: int) -> Floats:
        """End face of half a tooth: from its outline down to the bore."""
        rho_u = self.rho_u[end]
        azimuth = phi + self.member.lengthwise.azimuth(self.member.cone_distance(rho_u, delta))
        places = np.linspace(0.0, 1.0, 4 if self.member.ends == "sphere" else 2)[:, None]
        polar = self.hub + places * (delta - self.hub)
        return from_spherical(self.member.cone_distance(rho_u, polar), polar, azimuth[None, :])


def _joined(grids: list[Floats]) -> Mesh:
    meshes = [Mesh(g.reshape(-1, 3), grid_normals(g).reshape(-1, 3), grid_triangles(*g.shape[:2])) for g in grids]
    return joined(meshes)


def _layer(layer_id: str, part: str, mesh: Mesh, style: Style = _STYLE) -> Layer:
    return Layer(layer_id, part, "surface", mesh.points, style, mesh.cells, mesh.normals)
