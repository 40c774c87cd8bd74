"""What a window leaves to the one that takes its place, as when the language changes: all that is no widget."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ui.app import Studio
    from ui.builds import Builds
    from ui.preferences import Preferences
    from ui.projects.autosave import Autosave
    from ui.projects.lock import ProjectLock
    from ui.runner import JobRunner
    from ui.solids import Solids
    from ui.undo import History


@dataclass(frozen=True)
class Inheritance:
    """Works on while there is no window, and is taken over as it is.

    Attributes
    ----------
    folder : str
        Where dialogs of files begin.
    worker_state : (str, str)
        What was last heard of the CAD process, and why.
    """

    lock: ProjectLock
    folder: str
    history: History
    builds: Builds
    solids: Solids
    runner: JobRunner | None
    worker_state: tuple[str, str]
    autosave: Autosave | None
    preferences: Preferences


def inheritance_of(studio: Studio) -> Inheritance:
    """Take everything out of a window that may outlive it; to close that window ends nothing of this any more."""
    files, desk, controller, closing = studio.files, studio.desk, studio.controller, studio.window.closing
    solids, preferences = controller.solid_mode.solids, studio.habits.preferences
    controller.succeeded = True
    controller.reporting.let_go()
    closing.disconnect(files.lock.release)
    if desk.autosave is not None:
        closing.disconnect(desk.autosave.close)
        desk.autosave.setParent(None)
    for one in (controller.builds, solids, preferences):
        one.setParent(None)
    return Inheritance(
        files.lock,
        files.folder,
        controller.edits.history,
        controller.builds,
        solids,
        controller.runner,
        controller.worker_state,
        desk.autosave,
        preferences,
    )
