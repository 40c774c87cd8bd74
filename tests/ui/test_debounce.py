"""The newest value, once they have come to rest."""

from __future__ import annotations

from pytestqt.qtbot import QtBot

from ui.debounce import Debounce


def watched(interval_ms: int) -> tuple[Debounce, list[object]]:
    debounce, settled = Debounce(interval_ms), []
    debounce.settled.connect(settled.append)
    return debounce, settled


def test_only_the_newest_of_a_burst_is_passed_on(qtbot: QtBot) -> None:
    debounce, settled = watched(20)
    for value in range(5):
        debounce.push(value)
    assert settled == []
    qtbot.waitUntil(lambda: settled == [4])
    qtbot.wait(60)
    assert settled == [4]


def test_flushing_passes_on_at_once_and_only_what_waits(qtbot: QtBot) -> None:
    debounce, settled = watched(60_000)
    debounce.flush()
    debounce.push("value")
    debounce.flush()
    debounce.flush()
    assert settled == ["value"]


def test_cancelling_forgets(qtbot: QtBot) -> None:
    debounce, settled = watched(10)
    debounce.push("value")
    debounce.cancel()
    qtbot.wait(50)
    debounce.flush()
    assert settled == []
