"""Layers for the views: made in a thread, only what is new, and what is wanted last is there last."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

import ui.scene
from gearstudio.results import VariantResult
from gearstudio.theory.cones import MemberGeometry
from tests.ui.made_up import member_of, result_of
from ui.scenery import Scenery, Sight
from ui.session import Key

KEY = Key("wheel", "point_cloud", "published")
PATIENCE_MS = 20_000


def sight(member: MemberGeometry, result: VariantResult | None = None, roll: float = 1.0) -> Sight:
    return Sight((KEY,), member, {} if result is None else {KEY: result}, roll, "concave")


@pytest.fixture
def scenery(qapp) -> Iterator[Scenery]:
    made = Scenery()
    yield made
    made.close()


@pytest.fixture
def makers(monkeypatch: pytest.MonkeyPatch) -> list[threading.Thread]:
    """The threads in which layers of a member were made."""
    threads: list[threading.Thread] = []
    make = ui.scene.member_layers

    def noted(member: MemberGeometry) -> object:
        threads.append(threading.current_thread())
        return make(member)

    monkeypatch.setattr(ui.scene, "member_layers", noted)
    return threads


def wait_for(scenery: Scenery, wanted: Sight, qtbot) -> None:
    qtbot.waitUntil(lambda: scenery.scene is not None and scenery.scene.sight is wanted, timeout=PATIENCE_MS)


def test_scenes_are_made_in_a_thread_once(scenery: Scenery, makers, qtbot) -> None:
    wanted = sight(member_of("default"))
    assert scenery.soon(wanted) is None and scenery.soon(sight(member_of("default"))) is None
    wait_for(scenery, wanted, qtbot)
    assert scenery.soon(sight(member_of("default"), roll=0.3)) is scenery.scene, "the plane rolls on by itself"
    assert scenery.now(sight(member_of("default"))) is scenery.scene
    assert len(makers) == 1 and makers[0] is not threading.main_thread()
    assert scenery.scene.rolled.is_at(member_of("default"), 1.0, "concave") and scenery.scene.rolled.layers
    everything = (*scenery.scene.shared, *scenery.scene.rolled.layers)
    assert all({"single", "bounds"} <= vars(layer).keys() for layer in everything if len(layer.points))


def test_what_did_not_change_stays_the_same_object(scenery: Scenery) -> None:
    member = member_of("default")
    first = scenery.now(sight(member))
    result = result_of(member, lambda u, v: u)
    second = scenery.now(sight(member, result))
    assert second.shared is first.shared and second.rolled is first.rolled and not first.made
    third = scenery.now(sight(member_of("straight"), result))
    assert third.made[KEY][1] is second.made[KEY][1] and third.shared is not second.shared


def test_the_newest_sight_is_there_in_the_end(scenery: Scenery, qtbot) -> None:
    wanted = [sight(member_of(name)) for name in ("tiny", "straight", "huge", "default")]
    for one in wanted:
        scenery.soon(one)
    wait_for(scenery, wanted[-1], qtbot)
    qtbot.wait(50)
    assert scenery.scene.sight is wanted[-1]


def test_what_was_ordered_before_does_not_replace_what_was_wanted_at_once(scenery: Scenery, qtbot) -> None:
    scenery.soon(sight(member_of("tiny")))
    scene = scenery.now(sight(member_of("default")))
    qtbot.wait(300)
    assert scenery.scene is scene
    again = sight(member_of("tiny"))
    assert scenery.soon(again) is None, "it is ordered anew"
    wait_for(scenery, again, qtbot)


def test_a_scene_that_cannot_be_made_is_told(scenery: Scenery, monkeypatch, qtbot) -> None:
    def broken(member: MemberGeometry) -> object:
        raise ZeroDivisionError

    monkeypatch.setattr(ui.scene, "member_layers", broken)
    with qtbot.waitSignal(scenery.failed, timeout=PATIENCE_MS):
        scenery.soon(sight(member_of("default")))
    with pytest.raises(ZeroDivisionError):
        scenery.now(sight(member_of("default")))
