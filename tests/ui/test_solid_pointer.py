"""What is told of the point of a solid under the pointer: face, tooth, place and deviation."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QObject, QPointF

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.profile import tooth_profile
from tests.ui.made_up_solid import solid_of
from tests.ui.screen import NEEDS_SCREEN
from ui.session import Key

pytestmark = NEEDS_SCREEN
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
        assert (member.lower(), face) == (hover.member, hover.face)
        assert [f"tooth {hover.tooth}"] * (hover.tooth is not None) == tooth
        geometry = pair_geometry(Design()).member(hover.member)
        theory = GearTheory(geometry, tooth_profile(geometry), built[KEYS[member == "Wheel"]].result.outline)
        point = np.array(hover.xyz)
        named = face.removesuffix(" flank")
        candidates = (named,) if named in theory.names else ("end", "body")
        first = theory.to_first(point, (hover.tooth or 1) - 1)
        assert min(abs(theory.distance(name, first)) for name in candidates) < 1e-4
        assert hover.rho == pytest.approx(np.linalg.norm(point))
        assert float(azimuth.rstrip("°").replace("−", "-")) == pytest.approx(
            np.degrees(np.arctan2(point[1], point[0])), abs=1e-3
        )
        assert (hover.deviation_um is not None) == (hover.side != "")
    assert any(hover.deviation_um is not None for hover in found)
    pointer.show_solids({})
    assert told[-1] is None


def test_a_click_pins_a_point_that_turns_with_its_gear(qtbot, view, built) -> None:
    from ui.solid_layers import SolidOptions
    from ui.solid_pointer import SolidPointer

    view.show(pair_geometry(Design()), KEYS, built, SolidOptions(), ("", ""))
    view.grid.set_view("pair")
    keeper = QObject()
    pointer = SolidPointer(view, lambda _hover: None, keeper)
    viewport, pointing = view.grid.viewport, view.grid.pointing
    place = QPointF(0.5 * viewport.width(), 0.6 * viewport.height())
    viewport.clicked.emit(place)
    assert pointing.pin is None
    pointer.show_solids({key.member: built[key] for key in KEYS})
    viewport.clicked.emit(place)
    pin, before = pointing.pin, np.array(pointing.pin_place)
    assert pin.member in ("pinion", "wheel") and pin.face
    x, y = viewport.look.project(before)
    assert (viewport.place_of(0, float(x), float(y)) - place).manhattanLength() < 4
    view.turn(0.2)
    qtbot.waitUntil(lambda: np.linalg.norm(np.array(pointing.pin_place) - before) > 1e-3, timeout=3000)
    assert pointing.pin is pin
    frame = view.frames[pin.member]
    assert np.allclose(frame.turn.after(frame.base).back(np.array(pointing.pin_place)), pin.xyz)
    pointer.pins = False
    viewport.clicked.emit(QPointF(0.5 * viewport.width(), 0.3 * viewport.height()))
    assert pointing.pin is pin
    pointer.show_solids({})
    assert pointing.pin is None


@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_ends_and_body_are_called_by_their_places(built, member: str) -> None:
    from ui.solid_faces import face_name

    geometry = pair_geometry(Design()).member(member)
    outline = built[KEYS[member == "wheel"]].result.outline
    theory = GearTheory(geometry, tooth_profile(geometry), outline)
    for v, name in ((0.0, "toe"), (1.0, "heel")):
        rho_u = np.array([geometry.inner_cone_distance, geometry.outer_cone_distance])[int(v)]
        delta = (geometry.root_angle + geometry.pitch_angle) / 2
        rho = float(geometry.cone_distance(rho_u, delta))
        assert face_name(theory, "end", rho * np.array([np.sin(delta), 0.0, np.cos(delta)])) == name
    middles = (outline[:-1] + outline[1:]) / 2
    names = [face_name(theory, "body", np.array([0.0, r, z])) for r, z in middles]
    bore = [r for (r, _), name in zip(middles, names, strict=True) if name == "bore"]
    assert len(bore) == 1 and bore[0] == outline[:, 0].min()
    assert "back face" in names and "front face" in names
    assert face_name(theory, "concave", np.ones(3)) == "concave flank"
