"""Settings that may be damaged, the log panel, memory, displays and graphics."""

from __future__ import annotations

import logging
import os
import subprocess
import sys
import threading
from pathlib import Path

import psutil
import pytest
from PySide6.QtCore import QByteArray, QObject, QRect, QSettings, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMessageBox

from tests.ui.runner_watch import Watch
from tests.ui.stand_ins import Bench
from tests.worker import fake_jobs as fake
from ui import graphics
from ui.diagnostics import CrashCatcher, note_fact, versions
from ui.log_panel import LogDock
from ui.memory import DEFAULT_LIMIT_MB, LIMIT_KEY, MemoryGuard, memory_limit, resident_megabytes
from ui.runner import JobRunner
from ui.screens import fitted
from ui.settings_file import open_settings, reset_settings, settings_path
from ui.upkeep import Upkeep

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.ui


# --- settings


def test_good_settings_are_kept() -> None:
    opened = open_settings()
    assert not opened.complaint, "a first start has no settings, and that is no damage"
    settings = opened.settings
    settings.setValue("geometry", QByteArray(bytes(range(256))))
    settings.setValue("files/recent", ["/a = b/ü.gear.toml", "/c [d];x.gear.toml"])
    settings.setValue("odd key/ä=1", {"a": 1.5})
    settings.sync()
    opened = open_settings()
    assert not opened.complaint and opened.settings.value("geometry") == QByteArray(bytes(range(256)))
    assert opened.settings.value("files/recent")[0] == "/a = b/ü.gear.toml"


@pytest.mark.parametrize("content", [b"\0" * 4000, b"\x89PNG\r\n\xff\xfe", b"no section, no value\n", b"[General\nx"])
def test_a_damaged_settings_file_is_put_aside(content: bytes) -> None:
    path = settings_path()
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    opened = open_settings()
    kept = path.with_name(f"{path.name}.bak")
    assert str(kept) in opened.complaint and kept.read_bytes() == content
    opened.settings.setValue("a", 1)
    opened.settings.sync()
    assert not open_settings().complaint


@pytest.mark.parametrize("value", ["x", [1, 2], QByteArray(b"junk"), None, {"a": 1}])
def test_nonsense_in_good_settings_does_not_keep_the_window_shut(qtbot, theme, value: object) -> None:
    from ui.main_window import MainWindow
    from ui.session import Session

    settings = open_settings().settings
    for key in ("geometry", "layout", LIMIT_KEY, graphics.KEY, "files/recent"):
        settings.setValue(key, value)
    window = MainWindow(Session(), settings)
    upkeep = Upkeep(window)
    window.restore_layout()
    window.show()
    assert upkeep.memory._limit_mb == DEFAULT_LIMIT_MB and graphics.graphics_mode(settings) == "auto"
    window.close()


def test_settings_are_reset_by_a_command(tmp_path) -> None:
    environment = os.environ | {"XDG_CONFIG_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    file = tmp_path / "GearStudio" / "GearStudio.ini"
    file.parent.mkdir()
    file.write_text("[General]\na=1\n")

    def run() -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "main.py", "--reset-settings"]
        return subprocess.run(
            command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=60, check=True
        )

    assert str(file) in run().stdout and not file.exists()
    assert file.with_name("GearStudio.ini.bak").read_text() == "[General]\na=1\n"
    assert "no settings" in run().stdout


def test_settings_are_reset_from_the_menu_after_a_question(qtbot, theme, monkeypatch) -> None:
    from ui.main_window import MainWindow
    from ui.session import Session

    settings = open_settings().settings
    settings.setValue("a", 1)
    window = MainWindow(Session(), settings)
    upkeep = Upkeep(window)
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: QMessageBox.StandardButton.Cancel)
    assert not upkeep.reset_settings() and settings.value("a") is not None
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: QMessageBox.StandardButton.Reset)
    window.commands["reset_settings"].trigger()
    assert settings.allKeys() == [] and ".bak" in window.messages._full
    window.close()
    assert reset_settings() is not None or not settings_path().exists()


# --- log and crashes


def test_the_log_panel_shows_what_any_thread_notes(bench: Bench, qtbot) -> None:
    dock = LogDock(bench.window)
    log = logging.getLogger("gears")
    log.setLevel(logging.INFO)
    log.info("calm")
    thread = threading.Thread(target=lambda: log.error("loud"))
    thread.start()
    thread.join()
    panel = dock.panel
    qtbot.waitUntil(lambda: "loud" in panel.text.toPlainText(), timeout=2000)
    assert "calm" in panel.text.toPlainText() and panel.count.text().startswith("2 entries, 1 ")
    panel.level.setCurrentIndex(2)
    assert "calm" not in panel.text.toPlainText() and "loud" in panel.text.toPlainText()
    log.warning("between")
    qtbot.waitUntil(lambda: panel.count.text().startswith("3"), timeout=2000)
    assert "between" not in panel.text.toPlainText()
    panel.copy.click()
    assert "loud" in QGuiApplication.clipboard().text()
    panel.clear.click()
    assert not panel.text.toPlainText()
    dock.stop()
    log.error("unheard")
    qtbot.wait(20)
    assert not panel.text.toPlainText()


def test_an_error_is_told_once_however_often_it_comes(qtbot) -> None:
    catcher = CrashCatcher()
    told: list[str] = []
    catcher.crashed.connect(told.append)
    note_fact("Graphics", "a test")

    def fail(text: str) -> None:
        try:
            raise ValueError(text)
        except ValueError as error:
            catcher._on_exception(type(error), error, error.__traceback__)

    for text in ("one", "one", "two", "one"):
        fail(text)
    assert [report.partition("ValueError: ")[2][:3] for report in told] == ["one", "two"]
    assert "Graphics: a test" in told[0] and "Graphics: a test" in versions()


# --- memory


class FakeRunner(QObject):
    queue_changed = Signal(int)
    job_started = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.process_id = os.getpid()
        self.restarts = 0
        self.given_up: list[str] = []

    def restart(self) -> None:
        self.restarts += 1

    def give_up(self, text: str) -> None:
        self.given_up.append(text)


def test_memory_is_measured_as_the_system_does() -> None:
    assert resident_megabytes(os.getpid()) == pytest.approx(psutil.Process().memory_info().rss / 2**20, rel=0.05)
    assert resident_megabytes(2**22 + 1) == 0.0


def test_a_process_above_the_limit_is_replaced_when_it_is_at_rest() -> None:
    runner, guard = FakeRunner(), MemoryGuard(10)
    guard.use(runner)
    guard.look()
    assert runner.restarts == 1
    guard.set_limit(100_000)
    guard.set_limit(0)
    assert runner.restarts == 1
    guard.set_limit(10)
    assert runner.restarts == 2
    guard.stop()
    guard.look()
    assert runner.restarts == 2


def test_a_job_begins_again_in_a_fresh_process_before_it_is_given_up() -> None:
    runner, guard = FakeRunner(), MemoryGuard(10)
    guard.use(runner)
    for _ in range(2):
        runner.job_started.emit(object())
    runner.queue_changed.emit(1)
    guard.look()
    assert runner.restarts == 1 and not runner.given_up
    runner.process_id = os.getppid()
    guard.set_limit(1)
    assert runner.restarts == 2 and not runner.given_up  # no job has begun in this one
    runner.job_started.emit(object())
    guard.look()
    assert runner.restarts == 2 and "1 MB" in runner.given_up[0]


def test_a_job_that_takes_too_much_fails_alone_and_the_next_is_carried_out(qtbot) -> None:
    guard, watch = MemoryGuard(0), Watch(qtbot)
    guard.use(watch.runner)
    greedy, modest = fake.Hoard(600), fake.Echo("modest")
    watch.runner.submit((modest,))
    watch.wait(lambda: watch.results == ["modest"])
    try:
        guard.set_limit(400)
        watch.runner.submit((greedy, fake.Echo("after")))
        watch.wait(lambda: watch.results == ["modest", "after"])
        assert [job for job, *_ in watch.of("job_failed")] == [greedy]
        assert "400 MB" in watch.of("job_failed")[0][1]
        assert [job for (job,) in watch.of("job_started")].count(greedy) == 2
    finally:
        guard.stop()
        watch.runner.close()


def test_a_real_process_is_replaced_by_another(qtbot) -> None:
    runner, guard = JobRunner(warm_up=fake.no_warm_up), MemoryGuard(0)
    states: list[str] = []
    runner.worker_state_changed.connect(lambda state, _reason: states.append(state))
    guard.use(runner)
    runner.start()
    try:
        qtbot.waitUntil(lambda: "ready" in states, timeout=60_000)
        before = runner.process_id
        with qtbot.waitSignal(guard.replaced, timeout=5000) as said:
            guard.set_limit(1)
        guard.set_limit(0)
        assert said.args[0] > 1
        qtbot.waitUntil(lambda: states.count("ready") == 2, timeout=60_000)
        assert runner.process_id not in (0, before) and not psutil.pid_exists(before)
    finally:
        guard.stop()
        runner.close()


@pytest.mark.parametrize(
    ("stored", "limit"),
    [(None, DEFAULT_LIMIT_MB), ("2500", 2500), (10, 1000), (0, 0), (-5, 0), ("much", DEFAULT_LIMIT_MB)],
)
def test_the_limit_is_read_from_the_settings(tmp_path, stored: object, limit: int) -> None:
    settings = QSettings(str(tmp_path / "a.ini"), QSettings.Format.IniFormat)
    if stored is not None:
        settings.setValue(LIMIT_KEY, stored)
    assert memory_limit(settings) == limit


# --- displays


def test_a_window_whose_head_is_out_of_reach_is_brought_back() -> None:
    screens = [QRect(0, 0, 1920, 1080), QRect(1920, 0, 1280, 720)]
    for good in (QRect(100, 100, 800, 600), QRect(2000, 50, 1000, 600), QRect(-700, 30, 800, 600)):
        assert fitted(good, screens) == good
    for bad in (
        QRect(4000, 100, 800, 600),
        QRect(100, 1200, 800, 600),
        QRect(-790, 30, 800, 600),
        QRect(0, -500, 900, 600),
    ):
        placed = fitted(bad, screens)
        assert placed != bad and screens[0].contains(placed)
    assert fitted(QRect(5000, 0, 4000, 3000), screens) == screens[0]
    assert fitted(QRect(5000, 0, 10, 10), []) == QRect(5000, 0, 10, 10)


def test_the_window_comes_back_when_its_display_goes(bench: Bench, qtbot) -> None:
    upkeep = Upkeep(bench.window)
    bench.window.setGeometry(9000, 9000, 1000, 700)
    upkeep.screens._on_changed(None)
    available = QGuiApplication.primaryScreen().availableGeometry()
    qtbot.waitUntil(lambda: available.intersects(bench.window.geometry()), timeout=3000)


# --- graphics


def test_the_mode_of_the_command_line_wins(tmp_path) -> None:
    settings = QSettings(str(tmp_path / "a.ini"), QSettings.Format.IniFormat)
    assert graphics.graphics_mode(None) == "auto" and graphics.graphics_mode(settings) == "auto"
    settings.setValue(graphics.KEY, "software")
    assert graphics.graphics_mode(settings) == "software"
    assert graphics.graphics_mode(settings, "off") == "off"


def test_software_drawing_is_asked_of_the_drivers() -> None:
    environment: dict[str, str] = {}
    graphics.prepare("auto", environment)
    assert not environment
    graphics.prepare("software", environment)
    assert environment["LIBGL_ALWAYS_SOFTWARE"] == "1" and environment["QT_OPENGL"] == "software"


def test_what_helps_is_said() -> None:
    broken = graphics.Graphics(problem="This display offers no OpenGL.")
    assert "--graphics software" in graphics.advice(broken, "auto")
    assert "Mesa" in graphics.advice(broken, "software")
    assert graphics.advice(graphics.probe("off"), "off") == graphics.probe("off").problem


WITHOUT_OPENGL = """
import sys
from PySide6.QtCore import QTimer
from ui.app import Studio, make_application
from ui.theme import Theme
application = make_application(["gearstudio"])
studio = Studio(Theme(application))
studio.window.may_close = lambda: True
studio.controller.settled.connect(lambda: QTimer.singleShot(500, finish))
def finish():
    print(studio.window.area.placeholder._text.replace(chr(10), " "), len(studio.session.current), flush=True)
    studio.window.close()
    application.quit()
studio.window.show()
QTimer.singleShot(60000, application.quit)
application.exec()
"""


@pytest.mark.gl
@pytest.mark.skipif(not sys.platform.startswith("linux") or not os.environ.get("DISPLAY"), reason="needs X")
def test_without_opengl_the_window_says_so_and_everything_else_works() -> None:
    environment = os.environ | {"QT_QPA_PLATFORM": "xcb", "QT_XCB_GL_INTEGRATION": "none"}
    command = [sys.executable, "-c", WITHOUT_OPENGL]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert "no OpenGL" in done.stdout and "--graphics software" in done.stdout and done.stdout.strip().endswith(" 6")
