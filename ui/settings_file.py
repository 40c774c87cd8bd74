"""The settings file: opened with care, put aside when it is damaged, forgotten on request."""

from __future__ import annotations

import configparser
import logging
import os
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QSettings

from ui.words import tr

LARGEST = 5_000_000
log = logging.getLogger(__name__)


@dataclass(frozen=True)
class OpenedSettings:
    """The settings, and a line for the user when the file had to be put aside (else empty)."""

    settings: QSettings
    complaint: str = ""


def settings_path() -> Path:
    """Where this user's settings are."""
    return Path(_settings().fileName())


def open_settings() -> OpenedSettings:
    """The settings; those of a damaged file are kept beside it as ``.bak``, and the program starts without."""
    path = settings_path()
    problem = damage(path)
    settings = _settings()
    if not problem and settings.status() == QSettings.Status.NoError:
        return OpenedSettings(settings)
    kept = put_aside(path)
    log.warning("settings were damaged (%s), kept as %s", problem or settings.status(), kept)
    where = tr("It is kept as {file}.", file=kept) if kept else tr("It could not be put aside.")
    words = tr("The settings file was damaged, so the window starts with the usual settings. {where}", where=where)
    return OpenedSettings(_settings(), words)


def reset_settings() -> Path | None:
    """Forget every setting; where the old file is kept, or None when there was none."""
    return put_aside(settings_path())


def put_aside(path: Path) -> Path | None:
    """Rename a file to ``.bak``, in place of an older one; None when there is none or it cannot be done."""
    kept = path.with_name(f"{path.name}.bak")
    try:
        os.replace(path, kept)
    except OSError:
        return None
    return kept


def damage(path: Path) -> str:
    """What makes a settings file unusable; empty when it is good or missing."""
    try:
        if path.stat().st_size > LARGEST:
            return "far too large"
        text = path.read_bytes().decode("utf-8")
    except FileNotFoundError:
        return ""
    except UnicodeDecodeError:
        return "not text"
    except OSError as error:
        return str(error)
    if "\0" in text:
        return "not text"
    parser = configparser.RawConfigParser(strict=False, delimiters=("=",))
    try:
        parser.read_string(text)
    except configparser.Error as error:
        return type(error).__name__
    return ""


def _settings() -> QSettings:
    return QSettings(QSettings.Format.IniFormat, QSettings.Scope.UserScope, "GearStudio", "GearStudio")
