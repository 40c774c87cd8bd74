"""What the user prefers, as it is kept in the settings."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any

from PySide6.QtCore import QObject, QSettings, Signal

LANGUAGES = (("", "As the system"), ("en", "English"), ("zh", "中文"), ("de", "Deutsch"))
THEMES = (("system", "As the system"), ("light", "Light"), ("dark", "Dark"))
GRAPHICS = (("auto", "Automatic"), ("software", "Software, without the graphics card"), ("off", "No 3D views"))
MOST_DECIMALS = 8
LEAST_MEMORY_MB, MOST_MEMORY_MB = 1000, 256_000
LEAST_AUTOSAVE_S, MOST_AUTOSAVE_S = 2, 60


@dataclass(frozen=True)
class Choices:
    """Everything that can be preferred; `Choices()` is what a new user has.

    Attributes
    ----------
    length : {"mm", "in"}
        Unit in which lengths are shown and typed; files stay in mm.
    decimals : int
        Of lengths and angles; 0 leaves it to each place.
    theme : {"system", "light", "dark"}
    language : str
        ``"en"``, ``"zh"``, ``"de"``, or empty for that of the system.
    memory_limit_mb : int
        Above it the CAD process at rest is replaced; 0 for no limit.
    graphics : {"auto", "software", "off"}
        What draws the 3D views, from the next start on.
    autosave_seconds : int
        From a change to its copy for recovery.
    """

    length: str = "mm"
    decimals: int = 0
    theme: str = "system"
    language: str = ""
    memory_limit_mb: int = 4000
    graphics: str = "auto"
    autosave_seconds: int = 2


NAMES = {
    "length": "display/length",
    "decimals": "display/decimals",
    "theme": "display/theme",
    "language": "language",
    "memory_limit_mb": "worker/memory_limit_mb",
    "graphics": "graphics/mode",
    "autosave_seconds": "files/autosave_seconds",
}


class Preferences(QObject):
    """The choices, kept in the settings when there are any.

    Signals
    -------
    changed(object, object)
        The `Choices` before and now.
    """

    changed = Signal(object, object)

    def __init__(self, settings: QSettings | None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self.choices = read(settings)

    def set(self, **changes: Any) -> None:
        """Choose otherwise."""
        self.take(replace(self.choices, **changes))

    def take(self, choices: Choices) -> None:
        """Choose all at once."""
        before, self.choices = self.choices, sound(choices)
        if self.choices == before:
            return
        if self._settings is not None:
            usual = Choices()
            for field, name in NAMES.items():
                value = getattr(self.choices, field)
                if value == getattr(usual, field):
                    self._settings.remove(name)
                else:
                    self._settings.setValue(name, value)
        self.changed.emit(before, self.choices)


def read(settings: QSettings | None) -> Choices:
    """The choices in the settings; what is missing or makes no sense there is as for a new user."""
    if settings is None:
        return Choices()
    usual, found = Choices(), {}
    for field in fields(Choices):
        default = getattr(usual, field.name)
        value = settings.value(NAMES[field.name], default)
        try:
            found[field.name] = type(default)(value)
        except (TypeError, ValueError):
            found[field.name] = default
    return sound(Choices(**found))


def sound(choices: Choices) -> Choices:
    """The choices with every value within its range."""
    usual = Choices()
    memory = choices.memory_limit_mb
    return Choices(
        length=choices.length if choices.length in ("mm", "in") else usual.length,
        decimals=min(max(choices.decimals, 0), MOST_DECIMALS),
        theme=choices.theme if choices.theme in dict(THEMES) else usual.theme,
        language=choices.language if choices.language in dict(LANGUAGES) else usual.language,
        memory_limit_mb=min(max(memory, LEAST_MEMORY_MB), MOST_MEMORY_MB) if memory > 0 else 0,
        graphics=choices.graphics if choices.graphics in dict(GRAPHICS) else usual.graphics,
        autosave_seconds=min(max(choices.autosave_seconds, LEAST_AUTOSAVE_S), MOST_AUTOSAVE_S),
    )
