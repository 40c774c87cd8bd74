"""A window with the desk of its designs, and what a killed program leaves on it."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

from gearstudio.design import Design
from tests.ui.stand_ins import Bench
from ui.projects.desk import Desk
from ui.projects.snapshot import Snapshot, write_snapshot
from ui.session import flatten


class Place:
    """A bench with its desk and the folder of both."""

    def __init__(self, folder: Path) -> None:
        self.bench = Bench()
        self.folder = folder
        self.desk = Desk(
            self.bench.session,
            self.bench.window,
            self.bench.files,
            self.bench.controller.edits,
            folder,
            self.bench.files,
        )
        self.bench.window.show()

    def edit(self, field: str, value: object) -> None:
        self.bench.controller.edits.change(field, value)

    def snapshots(self) -> list[Path]:
        return list((self.folder / "recovery").glob("*.json"))


def left_behind(folder: Path, path: Path | None, title: str = "axle", **changes: object) -> Path:
    """A snapshot as a killed program leaves it."""
    draft = {**flatten(Design()), **changes}
    file = folder / "recovery" / f"{title}.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    write_snapshot(file, Snapshot(title, path, datetime.now().astimezone(), draft))
    return file
