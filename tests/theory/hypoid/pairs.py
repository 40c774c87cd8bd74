"""Hypoid pairs that tests share: those with independently computed numbers, typical axles, random ones."""

from __future__ import annotations

import json
from dataclasses import replace
from math import radians, tan
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from gearstudio.errors import GeometryError
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.axes import Axes
from gearstudio.theory.hypoid.conjugate import pinion_flank, wheel_flank
from gearstudio.theory.hypoid.inputs import DepthInput, HypoidError, HypoidInput, MemberName
from gearstudio.theory.hypoid.pair import HypoidPair, hypoid_pair
from gearstudio.theory.hypoid.undercut import trouble

Record = dict[str, Any]
REFERENCE: list[Record] = json.loads((Path(__file__).parents[2] / "data" / "hypoid.json").read_text(encoding="utf-8"))[
    "pairs"
]


def reference_input(record: Record) -> HypoidInput:
    """The input of a reference record: its hand counts left as +1, its space is half a pitch whatever the shift."""
    given, shift = record["inputs"], record["inputs"]["xhm1"]
    return HypoidInput(
        pinion_teeth=given["z1"],
        wheel_teeth=given["z2"],
        offset=given["a"],
        wheel_outer_pitch_diameter=given["de2"],
        face_width=given["b2"],
        spiral_angle_deg=given["beta1"],
        cutter_radius=given["rc0"],
        shaft_angle_deg=given["Sigma"],
        pressure_angle_deg=given["alpha_d_deg"],
        limit_pressure_angle_factor=given["f_alim"],
        pinion_hand="right" if given["hand2"] > 0 else "left",
        depth=DepthInput(
            taper=given["taper"],
            depth_factor=2 * given["khap"],
            clearance_factor=(given["khfp"] / given["khap"] - 1) / 2,
            mean_addendum_factor=0.5 - shift / (2 * given["khap"]),
            thickness_factor=-2 * shift * tan(radians(given["alpha_d_deg"])),
        ),
    )


AXLE = HypoidInput(11, 41, 25.0, 225.0, 34.0, 50.0, 88.9)
PAIRS = {
    "axle": AXLE,
    "below": replace(AXLE, offset=-25.0, spiral_angle_deg=30.0, cutter_radius=114.3, pinion_hand="right"),
    "acute": replace(AXLE, shaft_angle_deg=80.0, pinion_hand="right"),
    "obtuse": HypoidInput(17, 40, -25.0, 260.0, 40.0, 30.0, 114.3, shaft_angle_deg=100.0),
    "truck": HypoidInput(11, 41, 40.0, 300.0, 45.0, 50.0, 114.3, backlash=0.2, ends="sphere"),
    "of wheel": replace(AXLE, spiral_angle_of="wheel", spiral_angle_deg=33.0, curve="logarithmic"),
    "archimedean": replace(AXLE, curve="archimedean", offset=-15.0, spiral_angle_deg=32.0),
    "bevel": replace(AXLE, offset=0.0, spiral_angle_deg=35.0),
}
PRESETS = {
    "passenger car": HypoidInput(11, 41, 25.4, 195.0, 30.0, 48.0, 76.2, backlash=0.15),
    "pick-up": HypoidInput(10, 41, 38.1, 240.0, 37.0, 50.0, 88.9, backlash=0.18),
    "heavy truck": HypoidInput(9, 37, 40.0, 420.0, 62.0, 45.0, 152.4, backlash=0.3),
    "all-wheel drive, 80°": HypoidInput(13, 37, 15.0, 170.0, 27.0, 42.0, 76.2, shaft_angle_deg=80.0, backlash=0.12),
    "pinion on the other side": HypoidInput(13, 42, -10.0, 170.0, 30.0, 30.0, 76.2, pinion_hand="right", backlash=0.12),
}


def sound_pair(given: HypoidInput) -> HypoidPair:
    """A pair whose conjugate flanks are both regular and whose teeth have tips; a HypoidError if there is none."""
    pair = hypoid_pair(given)
    for side in (1, -1):
        wrong = trouble(pair, side)
        if wrong is not None:
            raise HypoidError("depth.mean_addendum_factor", f"a flank of the pinion {wrong}")
    if min(least_top_land(pair, "pinion"), least_top_land(pair, "wheel")) <= 0:
        raise HypoidError("depth.mean_addendum_factor", "the teeth are pointed")
    return pair


def least_top_land(pair: HypoidPair, name: MemberName) -> float:
    """Narrowest place of a member's tip, along its circle from flank to flank [mm]; not positive is pointed."""
    v = np.linspace(0.0, 1.0, 7)
    widths = []
    for flank in FLANKS:
        edge = (wheel_flank(pair, flank) if name == "wheel" else pinion_flank(pair, flank)).points(1.0, v)
        widths.append(np.hypot(edge[:, 0], edge[:, 1]) * pair.side(name, flank) * np.arctan2(edge[:, 1], edge[:, 0]))
    return float(np.min(widths[0] + widths[1]))


def in_world(axes: Axes, points: ArrayLike, turn: float = 0.0) -> np.ndarray:
    """Points (..., 3) of a pinion that has turned, in the world."""
    matrix, shift = axes.pinion_placement(turn)
    return np.asarray(points) @ matrix.T + shift


def random_pairs(count: int, seed: int) -> list[HypoidPair]:
    """Valid pairs of both signs and both hands over a wide range, without undercut."""
    rng = np.random.default_rng(seed)
    found: list[HypoidPair] = []
    while len(found) < count:
        teeth = int(rng.integers(6, 21))
        ratio, diameter = rng.uniform(1.3, 6.0), rng.uniform(60.0, 500.0)
        distance = diameter / 2
        given = HypoidInput(
            teeth,
            max(round(teeth * ratio), teeth + 1),
            diameter * rng.uniform(-0.18, 0.22),
            diameter,
            distance * rng.uniform(0.15, 0.33),
            rng.uniform(15.0, 52.0),
            distance * rng.uniform(0.5, 1.4),
            shaft_angle_deg=rng.uniform(65.0, 105.0),
            spiral_angle_of=("pinion", "wheel")[rng.integers(2)],
            pressure_angle_deg=rng.uniform(17.0, 25.0),
            limit_pressure_angle_factor=rng.choice([0.0, 0.5, 1.0]),
            pinion_hand=("left", "right")[rng.integers(2)],
            curve=("circular_arc", "circular_arc", "archimedean", "logarithmic")[rng.integers(4)],
            ends=("back_cone", "sphere")[rng.integers(2)],
            depth=DepthInput(taper=("standard", "uniform", "duplex", "tilted_root")[rng.integers(4)]),
        )
        try:
            found.append(sound_pair(given))
        except GeometryError:
            continue
    return found
