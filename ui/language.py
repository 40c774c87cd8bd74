"""Which language the window speaks, and the translators of its words and of Qt's own."""

from __future__ import annotations

import logging
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QSettings, QTranslator

from gearstudio.words import DECIMALS, POINT
from ui.preferences import LANGUAGES, NAMES

FOLDER = Path(__file__).parent / "translations"
ENGLISH = "en"
_QT = {"de": "qtbase_de", "zh": "qtbase_zh_CN"}
_QT_LACKS = {"zh": "qt_zh"}
"""Words that Qt's own translations leave in English."""
_SPOKEN = "spoken_language"
log = logging.getLogger(__name__)


def language_of_system(names: list[str]) -> str:
    """The first of the languages offered among those that the user reads (``"de-AT"``), or English."""
    offered = [code for code, _ in LANGUAGES if code]
    return next((code for name in names for code in offered if name.lower().split("-")[0] == code), ENGLISH)


def chosen_language(settings: QSettings | None, asked: str | None = None) -> str:
    """What was asked for on the command line, else what the preferences say, else the system's language."""
    choice = asked or (str(settings.value(NAMES["language"], "")) if settings is not None else "")
    return meant(choice if choice in dict(LANGUAGES) else "")


def meant(choice: str) -> str:
    """The language that a choice in the preferences stands for; empty is the system's."""
    return choice or language_of_system(QLocale.system().uiLanguages())


def spoken() -> str:
    """The language that the application speaks now."""
    application = QCoreApplication.instance()
    return str((application.property(_SPOKEN) if application is not None else None) or ENGLISH)


def decimal() -> str:
    """The decimal sign of the language that the application speaks now."""
    return DECIMALS.get(spoken(), POINT)


class Language:
    """The language that an application speaks; `speak` changes it. Without one given it is the one spoken already."""

    def __init__(self, application: QCoreApplication, language: str = "") -> None:
        self._application = application
        if language:
            install(application, language)
        self.spoken = spoken()

    def speak(self, language: str) -> None:
        """Take the words of another language; windows that exist keep theirs."""
        install(self._application, language)
        self.spoken = language


def install(application: QCoreApplication, language: str) -> None:
    """Let the application speak this language alone (``"de"``, ``"zh"``; ``"en"`` needs no translator)."""
    for translator in application.findChildren(QTranslator):
        application.removeTranslator(translator)
        translator.deleteLater()
    application.setProperty(_SPOKEN, language)
    if language == ENGLISH:
        return
    qt_folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
    ours = [name for name in (_QT_LACKS.get(language), f"gearstudio_{language}") if name is not None]
    for name, folder in ((_QT[language], qt_folder), *((name, str(FOLDER)) for name in ours)):
        translator = QTranslator(application)
        if translator.load(name, folder):
            application.installTranslator(translator)
        else:
            log.warning("no translation %s in %s", name, folder)
