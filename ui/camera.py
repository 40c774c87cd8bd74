"""Where one looks from: a camera as a plain record, moved by functions; no renderer."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

HALF_ANGLE = np.radians(11.0)
"""Half the vertical angle of view in perspective."""
ZOOM_RANGE = (1e-3, 20.0)
"""Smallest and largest half height of the view, of the radius of what there is."""
_FILL_TOOTH, _FILL_ALL = 0.74, 0.90
_ISO = np.array([0.82, -0.47, -0.62])
_OVER_THE_MESH = np.array([0.50, -0.74, -0.45])


def unit(vector: ArrayLike) -> Floats:
    """A vector of length 1."""
    vector = np.asarray(vector, dtype=np.float64)
    return np.asarray(vector / np.linalg.norm(vector))


@dataclass(frozen=True, eq=False)
class Camera:
    """A camera.

    Attributes
    ----------
    focal : ndarray, shape (3,)
        The point in the middle of the view [mm].
    back : ndarray, shape (3,)
        Unit vector from there to the eye.
    up : ndarray, shape (3,)
        Unit vector, square to ``back``.
    half_height : float
        Of the view, at the focal point [mm].
    parallel : bool
        Without perspective.
    """

    focal: Floats
    back: Floats
    up: Floats
    half_height: float
    parallel: bool = False

    @property
    def right(self) -> Floats:
        """Unit vector to the right on the screen."""
        return np.cross(self.up, self.back)

    @property
    def distance(self) -> float:
        """From the eye to the focal point [mm]."""
        return self.half_height / float(np.tan(HALF_ANGLE))

    @property
    def eye(self) -> Floats:
        """Position of the eye [mm]."""
        return self.focal + self.distance * self.back

    def turned(self, yaw: float, pitch: float) -> Camera:
        """Carried around the focal point by angles [rad] to the right and up."""
        back = np.cos(yaw) * self.back - np.sin(yaw) * self.right
        back = unit(np.cos(pitch) * back - np.sin(pitch) * self.up)
        return replace(self, back=back, up=_square_up(self.up, back))

    def rolled(self, angle: float) -> Camera:
        """Turned about the line of sight [rad]."""
        return replace(self, up=unit(np.cos(angle) * self.up + np.sin(angle) * self.right))

    def panned(self, right: float, up: float) -> Camera:
        """What is seen moves right and up by so many half heights."""
        return replace(self, focal=self.focal - self.half_height * (right * self.right + up * self.up))

    def zoomed(self, factor: float, x: float = 0.0, y: float = 0.0) -> Camera:
        """Enlarged by a factor about a place on the screen given in half heights from the middle."""
        shift = (1 - 1 / factor) * self.half_height
        focal = self.focal + shift * (x * self.right + y * self.up)
        return replace(self, focal=focal, half_height=self.half_height / factor)

    def centred(self, focal: ArrayLike) -> Camera:
        """With another point in the middle."""
        return replace(self, focal=np.asarray(focal, dtype=np.float64))

    def ray(self, x: float, y: float) -> tuple[Floats, Floats]:
        """Start and unit direction of the ray through a place given in half heights from the middle."""
        plane = self.half_height * (x * self.right + y * self.up)
        if self.parallel:
            return self.eye + plane, -self.back
        return self.eye, unit(self.focal + plane - self.eye)

    def project(self, points: ArrayLike) -> Floats:
        """Places of points on the screen, in half heights from the middle, shape (..., 2)."""
        offset = np.asarray(points, dtype=np.float64) - self.focal
        flat = np.stack([offset @ self.right, offset @ self.up], axis=-1) / self.half_height
        if self.parallel:
            return flat
        depth = 1 - (offset @ self.back) / self.distance
        return np.asarray(flat / np.where(depth > 1e-6, depth, np.nan)[..., None])

    def clipping(self, centre: ArrayLike, radius: float) -> tuple[float, float]:
        """Nearest and farthest distance to draw so that a sphere is all there.

        In perspective nothing is drawn within a fifth of the way to the focal point: depth would lose its
        resolution there, and what coincides could no longer be told apart.
        """
        middle = float((self.eye - np.asarray(centre)) @ self.back)
        near, far = middle - 1.01 * radius, middle + 1.01 * radius
        if self.parallel:
            return near, far
        near = max(near, 0.2 * self.distance)
        return near, max(far, 1.5 * near)


@dataclass(frozen=True, eq=False)
class Focus:
    """What there is to look at: the whole, one tooth, and the outward direction of each of its flanks."""

    centre: Floats
    radius: float
    points: Floats
    tooth_centre: Floats
    tooth_radius: float
    tooth_points: Floats
    flanks: dict[str, Floats]

    def resembles(self, other: Focus) -> bool:
        """Whether a camera set up for the other still suits this one."""
        moved = float(np.linalg.norm(self.tooth_centre - other.tooth_centre))
        return moved < 0.6 * other.tooth_radius and 0.6 < self.tooth_radius / other.tooth_radius < 1.6


VIEWS = ("pair", "tooth", "concave", "convex", "flank", "iso", "front", "back", "left", "right", "top", "bottom", "fit")
_DIRECTIONS = {
    "iso": _ISO,
    "pair": _OVER_THE_MESH,
    "front": np.array([1.0, 0.0, 0.0]),
    "back": np.array([-1.0, 0.0, 0.0]),
    "right": np.array([0.0, 1.0, 0.0]),
    "left": np.array([0.0, -1.0, 0.0]),
    "top": np.array([0.0, 0.0, -1.0]),
    "bottom": np.array([0.0, 0.0, 1.0]),
}


def view(name: str, focus: Focus, aspect: float, current: Camera | None = None, above: float = 0.0) -> Camera:
    """Camera of a named view; the gear's apex is up.

    Parameters
    ----------
    name : str
        One of `VIEWS`. ``fit`` keeps the direction of the current camera, ``flank`` is the concave one.
    focus : Focus
    aspect : float
        Width over height of one view.
    current : Camera, optional
        Its projection is kept.
    above : float
        Share of the height of the view that titles take; what is shown whole stays below them.
    """
    parallel = current is not None and current.parallel
    if name == "fit" and current is not None:
        return _filling(current, focus.points, aspect, _FILL_ALL, above)
    if name in ("tooth", "concave", "convex", "flank") and focus.flanks:
        back = _tooth_direction("concave" if name == "flank" else name, focus)
        aimed = Camera(focus.tooth_centre, back, _apex_up(back), focus.tooth_radius, parallel)
        return _filling(aimed, focus.tooth_points, aspect, _FILL_TOOTH)
    back = unit(_DIRECTIONS.get(name, _ISO))
    if name == "iso" and focus.flanks.get("concave", _ISO)[1] > 0:
        back = back * np.array([1.0, -1.0, 1.0])
    aimed = Camera(focus.centre, back, _apex_up(back), focus.radius, parallel)
    return _filling(aimed, focus.points, aspect, _FILL_ALL, above)


def _filling(camera: Camera, points: Floats, aspect: float, share: float, above: float = 0.0) -> Camera:
    """Points in the middle of what is free below, taking up a share of it; perspective by a few corrections."""
    axes = np.stack([camera.right, camera.up, camera.back])
    places, focal, half = axes @ points.T, axes @ camera.focal, camera.half_height
    for _ in range(4):
        depth: Floats | float = 1.0
        if not camera.parallel:
            depth = 1 - (places[2] - focal[2]) / replace(camera, half_height=half).distance
            places, depth = places[:, depth > 1e-6], depth[depth > 1e-6]
        seen = [(places[axis] - focal[axis]) / depth for axis in (0, 1)]
        low, high = ([float(end(one)) for one in seen] for end in (np.min, np.max))
        half = max((high[0] - low[0]) / aspect, (high[1] - low[1]) / (1 - above)) / (2 * share)
        focal = focal + np.array([low[0] + high[0], low[1] + high[1] + 2 * above * half, 0.0]) / 2
    return replace(camera, focal=axes.T @ focal, half_height=float(half))


def _tooth_direction(name: str, focus: Focus) -> Floats:
    """From outside at the tooth's tip, leaning to a flank, or straight at it."""
    outward = unit(focus.tooth_centre * np.array([1.0, 1.0, 0.0]))
    across = sum(focus.flanks.values(), np.zeros(3))
    tip = unit(across) if np.linalg.norm(across) > 1e-6 else outward
    if name in focus.flanks:
        return unit(unit(focus.flanks[name]) + 0.9 * tip)  # over the neighbour that would hide the root
    lean = unit(focus.flanks["concave"]) if "concave" in focus.flanks else np.zeros(3)
    return unit(tip + 0.20 * lean + 0.12 * outward)


def _apex_up(back: Floats) -> Floats:
    return _square_up(np.array([0.0, 0.0, -1.0]), back)


def _square_up(up: Floats, back: Floats) -> Floats:
    square = up - (up @ back) * back
    if np.linalg.norm(square) < 1e-6:
        square = np.array([-1.0, 0.0, 0.0]) - (-back[0]) * back
    return unit(square)
