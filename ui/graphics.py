"""What draws the 3D views: chosen before the application starts, probed before the first view is made."""

from __future__ import annotations

import os
from collections.abc import MutableMapping
from dataclasses import dataclass

from PySide6.QtCore import QSettings
from PySide6.QtGui import QOffscreenSurface, QOpenGLContext, QSurfaceFormat

from ui.words import tr

KEY = "graphics/mode"
MODES = ("auto", "software", "off")
NEEDED = (3, 2)
GL_RENDERER, GL_VERSION = 0x1F01, 0x1F02
SOFTWARE = {
    "LIBGL_ALWAYS_SOFTWARE": "1",
    "GALLIUM_DRIVER": "llvmpipe",
    "QT_OPENGL": "software",
}


@dataclass(frozen=True)
class Graphics:
    """What draws, and in which version; or why nothing does."""

    renderer: str = ""
    version: str = ""
    problem: str = ""

    def __str__(self) -> str:
        return self.problem or f"{self.renderer}, OpenGL {self.version}"


def graphics_mode(settings: QSettings | None, wanted: str | None = None) -> str:
    """The mode asked for on the command line, else the one in the settings, else ``"auto"``."""
    chosen = wanted or (settings.value(KEY, MODES[0]) if settings is not None else MODES[0])
    return str(chosen) if chosen in MODES else MODES[0]


def prepare(mode: str, environment: MutableMapping[str, str] = os.environ) -> None:
    """Make the drivers draw by software, if that is the mode; before there is an application."""
    if mode == "software":
        environment.update(SOFTWARE)


def probe(mode: str = "auto") -> Graphics:
    """Make a context as the views do, and see what comes of it."""
    if mode == "off":
        return Graphics(problem=tr("The 3D views are switched off in the preferences (graphics)."))
    surface, context = QOffscreenSurface(), QOpenGLContext()
    surface.create()
    context.setFormat(QSurfaceFormat.defaultFormat())
    if not context.create() or not context.makeCurrent(surface):
        return Graphics(problem=tr("This display offers no OpenGL."))
    try:
        functions = context.functions()
        renderer = str(functions.glGetString(GL_RENDERER))
        found = context.format().version()
        version = f"{found[0]}.{found[1]}"
        if tuple(found) < NEEDED:
            words = tr(
                "OpenGL {needed} is needed, and {renderer} offers {version}.",
                needed="3.2",
                renderer=renderer,
                version=version,
            )
            return Graphics(renderer, version, words)
        return Graphics(renderer, version)
    finally:
        context.doneCurrent()


def advice(graphics: Graphics, mode: str) -> str:
    """What the user can do about it, in a few lines."""
    if mode == "off":
        return graphics.problem
    lines = [graphics.problem, tr("Everything else works: parameters, comparison, charts, data sheets and exports.")]
    if mode != "software":
        lines.append(tr("To draw without a graphics card, start GearStudio with: --graphics software"))
    else:
        lines.append(tr("Drawing by software failed too; install or update Mesa (libgl1-mesa-dri) or the driver."))
    return "\n".join(lines)
