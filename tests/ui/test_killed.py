"""Of a program that is killed the last seconds are lost at most, and the next start offers the rest."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic, sleep

import pytest

from gearstudio.design import Design
from gearstudio.project import load_design, save_design
from tests.ui.places import left_behind
from ui.projects.autosave import abandoned
from ui.projects.snapshot import read_snapshot
from ui.projects.versions import recovered_version

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.ui
TEETH = "pair.wheel_teeth"
MOST_LOST_S = 10.0
TYPIST = """
import sys, time
from pathlib import Path
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from ui.projects.autosave import Autosave
from ui.session import Session
application = QApplication([])
session = Session()
session.load(session.design, Path(sys.argv[2]))
keeper = Autosave(session, Path(sys.argv[1]))
log = open(sys.argv[3], "w", buffering=1)
count = 0
def edit():
    global count
    count += 1
    session.edit("name", f"edit {count}")
    log.write(f"{count} {time.monotonic()}\\n")
timer = QTimer(interval=20)
timer.timeout.connect(edit)
timer.start()
application.exec()
"""
HAMMER = """
import sys
from datetime import datetime
from pathlib import Path
from gearstudio.design import Design
from ui.projects.snapshot import Snapshot, write_snapshot
from ui.session import flatten
draft, number = flatten(Design()), 0
print("ready", flush=True)
while True:
    number += 1
    write_snapshot(Path(sys.argv[1]), Snapshot("a", None, datetime.now(), {**draft, "name": "x" * (number % 5000)}))
"""


def start(script: str, *arguments: object, **options: object) -> subprocess.Popen:
    environment = os.environ | {"QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(ROOT)}
    return subprocess.Popen([sys.executable, "-c", script, *map(str, arguments)], cwd=ROOT, env=environment, **options)


@pytest.mark.parametrize("seconds", [0.0, 1.3, 3.1])
def test_a_kill_loses_the_last_seconds_at_most(tmp_path, seconds: float) -> None:
    path, log, folder = tmp_path / "axle.gear.toml", tmp_path / "edits.txt", tmp_path / "recovery"
    save_design(path, Design())
    typist = start(TYPIST, folder, path, log)
    deadline = monotonic() + 30
    while not list(folder.glob("*.json")) and monotonic() < deadline:
        sleep(0.02)
    sleep(seconds)
    typist.send_signal(signal.SIGKILL)
    killed = monotonic()
    typist.wait(10)
    found = abandoned(folder)
    assert len(found) == 1 and found[0].snapshot.path == path
    kept = int(str(found[0].snapshot.draft["name"]).split()[1])
    made = dict(map(float, line.split()) for line in log.read_text().splitlines() if line.count(" ") == 1)
    lost = [moment for number, moment in made.items() if number > kept]
    assert not lost or killed - min(lost) < MOST_LOST_S / 2
    assert load_design(path) == Design(), "the saved version is untouched"
    assert recovered_version(found[0].snapshot).valid
    found[0].discard()
    assert not list(folder.glob("*.json"))


def test_a_kill_while_writing_leaves_a_whole_file(tmp_path) -> None:
    chance = random.Random(7)
    file = tmp_path / "a.json"
    for _ in range(4):
        writer = start(HAMMER, file, stdout=subprocess.PIPE)
        assert writer.stdout is not None and writer.stdout.readline().strip() == b"ready"
        sleep(0.02 + 0.1 * chance.random())
        writer.kill()
        writer.wait(10)
        if file.exists():
            assert read_snapshot(file).draft["pair.pinion_teeth"] == 17
    assert file.exists()


SESSION = """
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
import main, ui.app
from ui.projects.recovery_dialog import RecoveryDialog
make = ui.app.make_application
def make_and_look(argv):
    application = make(argv)
    application.look = QTimer(interval=200)
    application.look.timeout.connect(look)
    application.look.start()
    return application
def look():
    dialog = next((w for w in QApplication.allWidgets() if isinstance(w, RecoveryDialog) and w.isVisible()), None)
    application = QApplication.instance()
    window = getattr(application, "recovering", None)
    if dialog is not None and window is None:
        row, application.recovering = dialog.list.topLevelItem(0), dialog.parent()
        print([row.text(column) for column in range(3)])
        dialog.recover.click()
    elif window is not None and window.isWindowModified():
        print(window.windowTitle(), window.isWindowModified())
        window.may_close = lambda: True
        window.close()
ui.app.make_application = make_and_look
main.main([])
"""


@pytest.mark.gl
@pytest.mark.skipif(not os.environ.get("DISPLAY"), reason="needs a screen")
def test_the_next_start_offers_what_a_killed_program_had(tmp_path) -> None:
    place = {name: str(tmp_path / "home") for name in ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME")}
    path = tmp_path / "axle.gear.toml"
    save_design(path, Design())
    data = tmp_path / "home" / "GearStudio" / "GearStudio"
    left_behind(data, path, "axle.gear.toml", **{TEETH: 47})
    command = [sys.executable, "-c", SESSION]
    done = subprocess.run(
        command, cwd=ROOT, env=os.environ | place, capture_output=True, text=True, timeout=100, check=False
    )
    assert done.returncode == 0, done.stderr
    row, title = done.stdout.strip().splitlines()
    assert "axle.gear.toml" in row and row.count("valid") == 2 and title == "axle.gear.toml[*] – GearStudio True"
    assert not list((data / "recovery").iterdir()), "closed in good order"
