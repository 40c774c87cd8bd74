"""Drafts judged in a thread: the window waits for none, the newest counts, and what is written has been judged."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

import ui.judging
import ui.session
from gearstudio.design import Design, with_field
from tests.ui.stand_ins import result
from ui.judging import AT_ONCE_S, Judging, Verdict
from ui.session import Key, Session

TEETH = "pair.pinion_teeth"
SLOW = 21
KEY = Key("wheel", "point_cloud", "optimised")


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> threading.Event:
    """Drafts with 21 pinion teeth are judged in the thread when the gate is open, not before."""
    opened, judge = threading.Event(), ui.judging.judge

    def at_the_gate(draft: Mapping[str, Any]) -> Verdict:
        if draft["pair"]["pinion_teeth"] == SLOW and threading.current_thread() is not threading.main_thread():
            assert opened.wait(10)
        return judge(draft)

    monkeypatch.setattr(ui.judging, "judge", at_the_gate)
    return opened


@pytest.fixture
def session(qapp, gate: threading.Event) -> Iterator[Session]:
    judging = Judging()
    made = Session(judging=judging)
    made.load(Design())
    made.settle()
    yield made
    gate.set()
    judging.close()


def teeth(session: Session) -> int:
    return session.design.pair.pinion_teeth


def until(qtbot, condition: Callable[[], bool]) -> None:
    qtbot.waitUntil(condition, timeout=10_000)


def test_a_slow_draft_holds_nothing_up_and_comes_later(session: Session, gate: threading.Event, qtbot) -> None:
    start = time.perf_counter()
    session.edit(TEETH, SLOW)
    assert time.perf_counter() - start < AT_ONCE_S + 1
    assert session.draft[TEETH] == SLOW and teeth(session) == 17 and session.unsaved
    gate.set()
    until(qtbot, lambda: teeth(session) == SLOW)
    assert session.pair.pinion.teeth == SLOW


def test_the_newest_draft_counts(session: Session, gate: threading.Event, qtbot) -> None:
    seen = []
    session.design_changed.connect(lambda design: seen.append(design.pair.pinion_teeth))
    session.edit(TEETH, SLOW)
    session.edit(TEETH, 19)
    session.edit(TEETH, "many")
    session.edit(TEETH, 20)
    gate.set()
    until(qtbot, lambda: teeth(session) == 20)
    qtbot.wait(100)
    assert seen == [20] and session.issues == ()


def test_problems_come_later_too_and_go(session: Session, gate: threading.Event, qtbot) -> None:
    session.edit(TEETH, SLOW)
    session.edit("pair.outer_module", -1)
    gate.set()
    until(qtbot, lambda: [issue.field for issue in session.issues] == ["pair.outer_module"])
    assert teeth(session) == 17
    session.edit("pair.outer_module", 4.0)
    until(qtbot, lambda: teeth(session) == SLOW)
    assert session.issues == ()


def test_to_settle_is_to_have_judged_what_was_typed(session: Session, qtbot) -> None:
    session.edit(TEETH, SLOW)
    session.settle()
    assert teeth(session) == SLOW


def test_an_undo_while_judging_is_not_overtaken(session: Session, gate: threading.Event, qtbot) -> None:
    before = dict(session.draft)
    session.edit(TEETH, SLOW)
    session.restore(before)
    gate.set()
    qtbot.wait(200)
    assert teeth(session) == 17 and not session.unsaved


def test_a_judge_that_breaks_down_does_so_where_it_is_told(session: Session, gate, qtbot, monkeypatch) -> None:
    def broken(draft: Mapping[str, Any]) -> Verdict:
        raise ZeroDivisionError("a fault of the program")

    monkeypatch.setattr(ui.judging, "judge", broken)
    monkeypatch.setattr(ui.session, "judge", broken)
    with qtbot.captureExceptions() as caught:
        session.edit(TEETH, 23)
        until(qtbot, lambda: bool(caught))
    assert caught[0][0] is ZeroDivisionError and session.draft[TEETH] == 23


def test_what_is_opened_is_judged_in_the_thread_and_the_last_good_model_stays(session, gate, qtbot) -> None:
    session.put_result(session.design, result(KEY))
    slow = with_field(Design(), TEETH, SLOW)
    session.load(slow, Path("slow.gear.toml"))
    assert session.title == "slow.gear.toml" and not session.unsaved and session.draft[TEETH] == SLOW
    assert teeth(session) == session.pair.pinion.teeth == 17 and KEY in session.current
    gate.set()
    until(qtbot, lambda: teeth(session) == SLOW)
    assert session.pair.pinion.teeth == SLOW and not session.results and not session.current


def test_of_two_that_are_opened_the_newer_one_counts(session: Session, gate: threading.Event, qtbot) -> None:
    seen = []
    session.design_changed.connect(lambda design: seen.append(design.pair.pinion_teeth))
    session.load(with_field(Design(), TEETH, SLOW))
    session.load(with_field(Design(), TEETH, 19))
    gate.set()
    until(qtbot, lambda: teeth(session) == 19)
    qtbot.wait(100)
    assert seen == [19] and not session.unsaved


def test_the_same_design_opened_again_is_built_again(session: Session) -> None:
    session.put_result(session.design, result(KEY))
    session.load(Design())
    session.settle()
    assert not session.results and KEY in session.missing_keys()
