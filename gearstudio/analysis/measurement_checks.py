"""Whether measured points are of this gear at all: refused with the likeliest reason if not."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement_fit import assign, deviations, fit_pose, places
from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.modified import flank_on
from gearstudio.validation import check

Floats = NDArray[np.float64]

_BESIDE_DEPTH = 0.3
_BESIDE_FACE = 0.1
_MOST_BESIDE = 0.2
_UNITS = ((25.4, "inches"), (1000.0, "metres"), (0.001, "micrometres"))
_WORST_RMS_MODULES = 0.012
_WORST_RMS_MM = 0.045
"""A flank with 100 µm of every error of angle, crowning, bias and pitch at once stays below, for modules from 4."""
_WORST_PLACED_MODULES = 0.05
"""Farther off, a part that may not be turned or shifted lies no longer near its own flanks."""
_DOUBTED_RMS_MODULES = 0.0007
_DOUBTED_RMS_MM = 0.003
_EXPLAINED = 0.3
"""Another gear explains the deviations when it leaves less than this part of them; errors of making seldom look so."""
_LOOKED_AT = 150
_MATE_TEETH = (1, 2, 3, 4, 5, 6)
_OWN_TEETH = (1, 2)
_PRESSURE_ANGLES = (14.5, 16.0, 17.5, 20.0, 22.5, 25.0)


@dataclass(frozen=True)
class Fitted:
    """A best fit: what it was free to find (turn, shift), and the rms deviation that it leaves [mm]."""

    free: tuple[bool, bool]
    rms: float


def beside_flank(member: MemberGeometry, points: Floats) -> Floats:
    """How far points lie outside the room in which a flank may be measured, not positive inside, shape (n,)."""
    face, profile = places(member, points)
    beyond = np.maximum(np.maximum(-face, face - 1) - _BESIDE_FACE, np.maximum(-profile, profile - 1) - _BESIDE_DEPTH)
    return np.where(np.isfinite(beyond), beyond, np.inf)


def share_beside(member: MemberGeometry, points: Floats) -> float:
    """The part of the points that lies beside the flanks."""
    with np.errstate(all="ignore"):
        return float(np.mean(beside_flank(member, points) > 0))


def check_size(pair: PairGeometry, member: MemberGeometry, points: Floats) -> None:
    """Raises GeometryError where too many points lie beside the teeth: another unit, the mate, another gear."""
    share = share_beside(member, points)
    if share <= _MOST_BESIDE:
        return
    for factor, unit in _UNITS:
        if share_beside(member, points * factor) <= _MOST_BESIDE:
            raise GeometryError(
                f"the points look as if they were in {unit}: multiplied by {factor:g} they lie on the "
                f"{member.name}'s teeth; convert them to mm"
            )
    rho, delta, _ = flank_on(member, 1).locate(points)
    angles = np.degrees(np.r_[delta.min(), delta.max(), member.root_angle, member.tip_angle])
    mate = _mate(pair, member)
    hint = f"they fit the {mate.name}" if share_beside(mate, points) <= _MOST_BESIDE else (
        "they are of another gear, or the origin is not at the apex and z not along the axis"
    )  # fmt: skip
    raise GeometryError(
        f"{share:.0%} of the points lie beside the {member.name}'s teeth: they are {rho.min():.5g} to "
        f"{rho.max():.5g} mm from the apex and at {angles[0]:.4g}° to {angles[1]:.4g}° from the axis, its flanks at "
        f"{member.inner_cone_distance:.5g} to {member.outer_cone_distance:.5g} mm and {angles[2]:.4g}° to "
        f"{angles[3]:.4g}°; {hint}"
    )


def check_fit(
    pair: PairGeometry,
    member: MemberGeometry,
    points: Floats,
    fitted: Fitted,
    design: Design | None = None,
    explained: Callable[[], str] = str,
) -> None:
    """Raises GeometryError where deviations are larger than a part's can be, or are those of another gear.

    Parameters
    ----------
    pair, member
    points : ndarray, shape (n, 3)
        As measured [mm].
    fitted : Fitted
    design : Design, optional
        Of the pair: pairs with other numbers of teeth or another pressure angle are tried as well.
    explained : callable
        Says what else explains them; asked only when they are refused and no such pair does.
    """
    allowed = _WORST_RMS_MODULES * member.module + _WORST_RMS_MM
    some, rms = points[:: max(1, len(points) // _LOOKED_AT)], fitted.rms
    if rms > allowed and not all(fitted.free) and _left(member, some) <= allowed:
        if rms <= _WORST_PLACED_MODULES * member.module:
            return
        raise GeometryError(
            f"the points are {rms:.3g} mm rms from this {member.name}'s flanks as they lie; they fit when the best fit "
            "may turn and shift the part"
        )
    if rms <= _DOUBTED_RMS_MODULES * member.module + _DOUBTED_RMS_MM:
        return
    hint = "" if design is None else _better(design, member, some, fitted)
    if rms <= allowed and not hint:
        return
    limit = f", where {allowed:.3g} mm could be a measured deviation" if rms > allowed else ""
    raise GeometryError(
        f"the points do not lie on this {member.name}'s flanks: {rms:.3g} mm rms are left after the best fit{limit}; "
        f"{hint or explained() or _guess(pair, member, some, allowed)}"
    )


def _guess(pair: PairGeometry, member: MemberGeometry, points: Floats, allowed: float) -> str:
    mate = _mate(pair, member)
    if _left(member, points * np.array([1.0, -1.0, 1.0])) <= allowed:
        return "they fit a gear of the other hand"
    if share_beside(mate, points) <= _MOST_BESIDE and _left(mate, points) <= allowed:
        return f"they fit the {mate.name}"
    return "they are of another gear (number of teeth, spiral angle, hand)"


def _better(design: Design, member: MemberGeometry, points: Floats, fitted: Fitted) -> str:
    """The gear that explains the deviations, in words; empty where none does."""
    best, words = _EXPLAINED * fitted.rms, ""
    for title, other in _other_gears(design, member):
        left = _left(other, points)
        if left < best:
            best, words = left, title
    return f"they fit {words}: {best:.2g} mm rms are left" if words else ""


def _other_gears(design: Design, member: MemberGeometry) -> Iterator[tuple[str, MemberGeometry]]:
    """The same member of pairs that differ in one number, in words and as geometry."""
    own, mate = ("pinion_teeth", "wheel_teeth") if member.name == "pinion" else ("wheel_teeth", "pinion_teeth")
    changes = [(mate, getattr(design.pair, mate) + sign * n) for n in _MATE_TEETH for sign in (-1, 1)]
    changes += [(own, getattr(design.pair, own) + sign * n) for n in _OWN_TEETH for sign in (-1, 1)]
    changes += [("pressure_angle_deg", angle) for angle in _PRESSURE_ANGLES]
    for field, value in changes:
        tried = _with(design, field, value)
        if tried is None or value == getattr(design.pair, field):
            continue
        teeth = f"{tried.pair.pinion_teeth}/{tried.pair.wheel_teeth} teeth"
        words = f"a pressure angle of {value:g}°" if field == "pressure_angle_deg" else teeth
        with suppress(GeometryError):
            yield f"the {member.name} of a pair with {words}", pair_geometry(tried).member(member.name)


def _with(design: Design, field: str, value: float) -> Design | None:
    tried = design.model_copy(update={"pair": design.pair.model_copy(update={field: value})})
    return None if any(issue.severity == "error" for issue in check(tried)) else tried


def _mate(pair: PairGeometry, member: MemberGeometry) -> MemberGeometry:
    return pair.wheel if member is pair.pinion else pair.pinion


def _left(member: MemberGeometry, points: Floats) -> float:
    """Root mean square of the deviations that a best fit to a member leaves [mm]."""
    try:
        own = fit_pose(member, points, None, (True, True))[0].undo(points)
        return float(np.sqrt(np.mean(deviations(member, own, assign(member, own)) ** 2)))
    except GeometryError:
        return np.inf
