"""Design files read in a thread: the window goes on, the newest wins, and what is wrong is said as ever."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

import ui.reading
from gearstudio.design import Design, with_field
from gearstudio.project import save_design
from tests.ui.stand_ins import Bench
from ui.files import Files
from ui.reading import Found, Reading

pytestmark = pytest.mark.ui
TEETH = "pair.pinion_teeth"
PATIENCE_MS = 10_000


@pytest.fixture
def bench(qtbot, theme) -> Iterator[Bench]:
    made = Bench()
    made.files = Files(made.session, made.window, reading=Reading(made.window))
    yield made
    made.close()


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """Files whose name begins with slow are read when the gate is open, not before."""
    opened, read = threading.Event(), ui.reading.read

    def at_the_gate(path: Path) -> Found:
        assert threading.current_thread() is not threading.main_thread()
        assert not path.name.startswith("slow") or opened.wait(10)
        return read(path)

    monkeypatch.setattr(ui.reading, "read", at_the_gate)
    yield opened
    opened.set()


def design_file(folder: Path, name: str, teeth: int) -> Path:
    path = folder / f"{name}.gear.toml"
    save_design(path, with_field(Design(), TEETH, teeth))
    return path


def teeth(bench: Bench) -> int:
    return bench.session.design.pair.pinion_teeth


def test_a_file_that_takes_long_holds_nothing_up(bench: Bench, gate, tmp_path, qtbot) -> None:
    path = design_file(tmp_path, "slow", 19)
    bench.files.open_path(path)
    assert teeth(bench) == 17 and bench.session.path is None
    gate.set()
    qtbot.waitUntil(lambda: teeth(bench) == 19, timeout=PATIENCE_MS)
    assert bench.session.path == path and not bench.session.unsaved


@pytest.mark.parametrize("newer", ["file", "preset", "new"])
def test_the_newest_wins(bench: Bench, gate, tmp_path, qtbot, newer: str) -> None:
    bench.files.open_path(design_file(tmp_path, "slow", 19))
    if newer == "file":
        bench.files.open_path(design_file(tmp_path, "quick", 23))
    elif newer == "preset":
        bench.files.open_named("preset:automotive")
    else:
        bench.files.new()
    gate.set()
    wanted = {"file": 23, "preset": 9, "new": 17}[newer]
    qtbot.waitUntil(lambda: teeth(bench) == wanted, timeout=PATIENCE_MS)
    qtbot.wait(100)
    assert teeth(bench) == wanted and (bench.session.path is not None) == (newer == "file")


def test_what_is_wrong_is_said_and_the_last_good_model_stays(bench: Bench, tmp_path, qtbot) -> None:
    bench.files.open_path(design_file(tmp_path, "good", 19))
    qtbot.waitUntil(lambda: teeth(bench) == 19, timeout=PATIENCE_MS)
    bad = tmp_path / "bad.gear.toml"
    bad.write_text("format = 1\n[pair]\npinion_teeth = 3\nouter_module = -1\n", encoding="utf-8")
    bench.files.open_path(bad)
    qtbot.waitUntil(lambda: "bad.gear.toml was not opened" in bench.window.messages.text, timeout=PATIENCE_MS)
    bench.files.open_path(tmp_path / "none.gear.toml")
    qtbot.waitUntil(lambda: "none.gear.toml was not opened" in bench.window.messages.text, timeout=PATIENCE_MS)
    assert teeth(bench) == 19 and bench.session.path == tmp_path / "good.gear.toml"


def test_a_window_that_closes_opens_nothing_any_more(bench: Bench, tmp_path, qtbot) -> None:
    bench.files.open_path(design_file(tmp_path, "good", 19))
    bench.window.may_close = lambda: True
    assert bench.window.close()
    qtbot.wait(100)
    assert bench.session.path is None and not list(tmp_path.glob("*.lock")) and not list(tmp_path.glob(".*"))


def test_a_reader_that_breaks_down_does_so_where_it_is_told(bench: Bench, tmp_path, monkeypatch, qtbot) -> None:
    def broken(path: Path) -> Found:
        raise ZeroDivisionError("a fault of the program")

    monkeypatch.setattr(ui.reading, "read", broken)
    with qtbot.captureExceptions() as caught:
        bench.files.open_path(tmp_path / "a.gear.toml")
        qtbot.waitUntil(lambda: bool(caught), timeout=PATIENCE_MS)
    assert caught[0][0] is ZeroDivisionError
