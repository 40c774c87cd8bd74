"""What is told of the point of a solid under the pointer: face, tooth, place and deviation."""

from __future__ import annotations

import os
import sys

import numpy as np
import pytest
from PySide6.QtCore import QObject, QPointF

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.profile import tooth_profile
from tests.ui.made_up_solid import solid_of
from ui.session import Key

pytestmark = [
    pytest.mark.ui,
    pytest.mark.gl,
    pytest.mark.skipif(
        os.environ.get("QT_QPA_PLATFORM") == "offscreen"
        or (sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))),
        reason="needs a screen with OpenGL",
    ),
]
KEYS = tuple(Key(member, "rotating_line", "optimised") for member in ("pinion", "wheel"))


@pytest.fixture(scope="module")
def built():
    from ui.solids import meshed

    return {key: meshed(Design(), solid_of(Design(), key.member)) for key in KEYS}


@pytest.mark.parametrize("in_mesh", [False, True])
def test_the_face_under_the_pointer_is_told_with_its_tooth_and_place(qtbot, view, built, in_mesh: bool) -> None:
    from ui.solid_layers import SolidOptions
    from ui.solid_pointer import SolidPointer

    keys = KEYS if in_mesh else KEYS[1:]
    view.show(pair_geometry(Design()), keys, built, SolidOptions(), ("", ""))
    view.grid.set_view("pair" if in_mesh else "iso")
    if in_mesh:
        view.turn(0.4)
    told: list = []
    keeper = QObject()
    pointer = SolidPointer(view, told.append, keeper)
    viewport = view.grid.viewport
    viewport.pointer_moved.emit(QPointF(450, 300))
    assert not told
    pointer.show_solids({key.member: built[key] for key in keys})
    places = [QPointF(x, y) for x in range(150, 800, 90) for y in range(90, 560, 70)]
    for place in places:
        viewport.pointer_moved.emit(place)
        pointer._update()
    found = [hover for hover in told if hover is not None]
    assert len(found) > 20
    for hover in found:
        words, _, azimuth = hover.flank.partition("    φ ")
        member, face, *tooth = [word.strip() for word in words.split(",")]
        geometry = pair_geometry(Design()).member(member.lower())
        theory = GearTheory(geometry, tooth_profile(geometry), built[KEYS[member == "Wheel"]].result.outline)
        point = np.array(hover.xyz)
        number = int(tooth[0].split()[1]) - 1 if tooth else 0
        assert abs(theory.distance(face, theory.to_first(point, number))) < 1e-4
        assert hover.rho == pytest.approx(np.linalg.norm(point))
        assert float(azimuth.rstrip("°").replace("−", "-")) == pytest.approx(
            np.degrees(np.arctan2(point[1], point[0])), abs=1e-3
        )
        assert (hover.deviation_um is not None) == (face in ("concave", "convex"))
    assert any(hover.deviation_um is not None for hover in found)
    pointer.show_solids({})
    assert told[-1] is None
