"""Published numbers, computed again: what the program shows beside them, pass or fail."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from gearstudio.design import Design
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.involute import involute_azimuth

KHK = "KHK gear technical reference, Gleason spiral bevel pair 20/40"
ISO = "ISO 23509:2016, sample F.2, spiral bevel pair 14/39"
INVOLUTE = "Spherical involute, 14/39, transverse pressure angle 20°"
PAPER = "The paper: mean deviation of its three methods; the data of its gear are not printed"

_KHK_DESIGN = {
    "pair": {"pinion_teeth": 20, "wheel_teeth": 40, "outer_module": 3.0, "face_width": 20.0},
    "tooth": {
        "addendum_factor": 0.85,
        "clearance_factor": 0.188,
        "profile_shift": 0.2925,
        "tip_cone": "constant_clearance",
    },
}
_ISO_DESIGN = {
    "pair": {"pinion_teeth": 14, "wheel_teeth": 39, "outer_module": 176.893 / 39, "face_width": 25.4},
    "lengthwise": {"cutter_radius": 114.3},
}
_INVOLUTE_DESIGN = {"pair": {"pinion_teeth": 14, "wheel_teeth": 39, "pressure_angle_kind": "transverse"}}
_BEYOND_DECIMALS = 1e-9


@dataclass(frozen=True)
class Check:
    """One published value and what the program makes of it.

    Attributes
    ----------
    source, name, unit : str
    published : str
        As printed.
    value : float or None
        Computed; None where the publication does not say enough to compute it.
    """

    source: str
    name: str
    unit: str
    published: str
    value: float | None

    @property
    def decimals(self) -> int:
        """Printed places after the point."""
        return len(self.published.partition(".")[2])

    @property
    def computed(self) -> str:
        """The computed value with as many places as are printed."""
        return "" if self.value is None else f"{self.value:.{self.decimals}f}"

    @property
    def passed(self) -> bool | None:
        """Whether the value agrees to the last printed digit; None where there is nothing to compare."""
        if self.value is None:
            return None
        half = 0.5 * 10.0**-self.decimals
        return bool(abs(self.value - float(self.published)) <= half * (1 + _BEYOND_DECIMALS))


def self_check() -> tuple[Check, ...]:
    """Every published value, in the order of its publication."""
    return (*_khk(), *_iso(), *_involute(), *_paper())


Value = Callable[[MemberGeometry], float]


def _both(source: str, pair: PairGeometry, name: str, unit: str, printed: str, value: Value) -> Iterator[Check]:
    for member, text in zip((pair.pinion, pair.wheel), printed.split(), strict=True):
        yield Check(source, f"{member.name}: {name}", unit, text, float(value(member)))


def _tip(m: MemberGeometry, rho_u: float) -> tuple[float, float]:
    """Radius and height of the tip on the back or front cone [mm]."""
    delta = float(m.tip_limit.at_back_cone(rho_u))
    rho = rho_u / np.cos(delta - m.pitch_angle)
    return float(rho * np.sin(delta)), float(rho * np.cos(delta))


def _khk() -> Iterator[Check]:
    pair = pair_geometry(Design.model_validate(_KHK_DESIGN))

    def row(name: str, unit: str, printed: str, value: Value) -> Iterator[Check]:
        return _both(KHK, pair, name, unit, printed, value)

    yield from row("pitch angle", "°", "26.56505 63.43495", lambda m: np.degrees(m.pitch_angle))
    yield from row("outer cone distance", "mm", "67.08204 67.08204", lambda m: m.outer_cone_distance)
    yield from row("addendum", "mm", "3.4275 1.6725", lambda m: m.addendum)
    yield from row("dedendum", "mm", "2.2365 3.9915", lambda m: m.dedendum)
    yield from row("dedendum angle", "°", "1.90952 3.40519", lambda m: np.degrees(m.pitch_angle - m.root_angle))
    yield from row("face angle", "°", "29.97024 65.34447", lambda m: np.degrees(m.tip_angle))
    yield from row("root angle", "°", "24.65553 60.02976", lambda m: np.degrees(m.root_angle))
    yield from row("outside diameter", "mm", "66.1313 121.4959", lambda m: 2 * _tip(m, m.outer_cone_distance)[0])
    yield from row("apex to crown", "mm", "58.4672 28.5041", lambda m: _tip(m, m.outer_cone_distance)[1])
    yield from row(
        "axial face width",
        "mm",
        "17.3563 8.3479",
        lambda m: _tip(m, m.outer_cone_distance)[1] - _tip(m, m.inner_cone_distance)[1],
    )
    yield from row("inner outside diameter", "mm", "46.1140 85.1224", lambda m: 2 * _tip(m, m.inner_cone_distance)[0])


def _iso() -> Iterator[Check]:
    pair = pair_geometry(Design.model_validate(_ISO_DESIGN))

    def diameter(m: MemberGeometry, rho: float) -> float:
        return float(2 * rho * np.sin(m.pitch_angle))

    def row(name: str, unit: str, printed: str, value: Value) -> Iterator[Check]:
        return _both(ISO, pair, name, unit, printed, value)

    yield from row("pitch angle", "°", "19.747 70.253", lambda m: np.degrees(m.pitch_angle))
    m = pair.pinion
    for name, unit, printed, value in (
        ("mean cone distance", "mm", "81.273", m.mean_cone_distance),
        ("outer cone distance", "mm", "93.973", m.outer_cone_distance),
        ("inner cone distance", "mm", "68.573", m.inner_cone_distance),
        ("mean normal module", "mm", "3.213", pair.mean_normal_module),
        ("outer module", "mm", "4.536", m.module),
        ("outer spiral angle", "°", "36.846", np.degrees(m.lengthwise.spiral_angle(m.outer_cone_distance))),
        ("inner spiral angle", "°", "33.946", np.degrees(m.lengthwise.spiral_angle(m.inner_cone_distance))),
    ):
        yield Check(ISO, name, unit, printed, float(value))
    yield from row("mean pitch diameter", "mm", "54.918 152.987", lambda m: diameter(m, m.mean_cone_distance))
    yield from row("outer pitch diameter", "mm", "63.500 176.893", lambda m: diameter(m, m.outer_cone_distance))
    yield from row("inner pitch diameter", "mm", "46.337 129.080", lambda m: diameter(m, m.inner_cone_distance))


def _involute() -> Iterator[Check]:
    pair = pair_geometry(Design.model_validate(_INVOLUTE_DESIGN))

    def row(name: str, printed: str, value: Value) -> Iterator[Check]:
        return _both(INVOLUTE, pair, name, "°", printed, lambda m: float(np.degrees(value(m))))

    yield from row("base angle", "18.511139 62.181911", lambda m: m.base_angle)
    yield from row("roll angle at the pitch cone", "22.046567 49.313496", lambda m: m.gamma / np.sin(m.base_angle))
    yield from row(
        "azimuth at the pitch cone",
        "0.904538 2.183302",
        lambda m: float(involute_azimuth(m.pitch_angle, m.base_angle)),
    )


def _paper() -> Iterator[Check]:
    for name, printed in (
        ("first method, mean", "54.6"),
        ("second method, mean", "60.3"),
        ("third method, mean", "52.9"),
        ("largest", "71.3"),
        ("smallest", "43.4"),
    ):
        yield Check(PAPER, name, "µm", printed, None)
