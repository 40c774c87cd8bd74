"""Translations: complete and up to date, sentences of the core among them, and nothing in the window left out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QTranslator
from PySide6.QtWidgets import QApplication, QColorDialog, QFileDialog, QLineEdit, QMessageBox

from gearstudio.design import Design, field_specs, with_field
from gearstudio.errors import FileError, ModellingError
from gearstudio.validation import read_design
from gearstudio.words import DECIMALS, POINT, Speaker, compiled, in_order
from tests.ui.reading import texts_of
from tests.ui.stand_ins import Bench
from tools import translations
from ui.language import Language, language_of_system
from ui.sentences import templates, translated
from ui.words import inline, told, tr

HOLE = re.compile(r"\{[^}]*\}")
DROPPED = {"{0} {1} of at {2} {3}{4}", "{0} {1}solid{2}, {3} faces, {4} mm³ (relative difference {5})"}
"""Sentences with articles and plural endings, which other languages have not."""


class Marking(QTranslator):
    """Puts marks around every text that is translated."""

    def isEmpty(self) -> bool:
        return False

    def translate(self, context: str, text: str, hint: str | None = None, n: int = -1) -> str | None:
        return f"⟦{text}⟧" if context in (translations.WORDS, translations.SENTENCES) else None


@pytest.fixture(params=["de", "zh"])
def speaking(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[str]:
    before = set(qapp.findChildren(QTranslator))
    language = Language(qapp, request.param)
    made = len(set(qapp.findChildren(QTranslator)) - before)
    assert made == (3 if request.param == "zh" else 2), "Qt's own texts, what they lack, and the window's"
    yield request.param
    language.speak("en")


@pytest.fixture(scope="module")
def texts() -> dict[str, list[str]]:
    return translations.collected()


@pytest.mark.parametrize("language", translations.LANGUAGES)
def test_every_text_of_the_source_is_translated_and_no_other_is_kept(
    language: str, texts: dict[str, list[str]]
) -> None:
    known = translations.read_ts(translations.ts_path(language))
    assert {name: set(said) for name, said in known.items()} == {name: set(said) for name, said in texts.items()}
    assert translations.missing(language) == []


@pytest.mark.parametrize("language", translations.LANGUAGES)
def test_translations_keep_holes_and_mnemonics(language: str) -> None:
    for said in translations.read_ts(translations.ts_path(language)).values():
        for text, translation in said.items():
            lost = set(HOLE.findall(text)) ^ set(HOLE.findall(translation))
            assert not lost or text in DROPPED or "column{2}" in text, text
            assert text.count("&") == translation.count("&"), text


def test_the_files_that_the_window_loads_are_made_of_the_present_ones(tmp_path: Path) -> None:
    translations.release(tmp_path, tmp_path)
    for language in translations.LANGUAGES:
        name, catalogue = f"gearstudio_{language}.qm", f"{language}.json"
        assert (tmp_path / name).read_bytes() == (translations.FOLDER / name).read_bytes()
        assert (tmp_path / catalogue).read_bytes() == (translations.CATALOGUES / catalogue).read_bytes()
    assert (tmp_path / "qt_zh.qm").read_bytes() == (translations.FOLDER / "qt_zh.qm").read_bytes()
    assert {template.text for template in templates()} == set(translations.collected()[translations.SENTENCES])


def test_words_of_the_window_and_of_its_tables(speaking: str) -> None:
    assert tr("Pinion") == {"de": "Ritzel", "zh": "小轮"}[speaking]
    assert tr("{name} (missing)", name="a.toml").startswith("a.toml")
    assert inline("Rotating line") == {"de": "Rollende Gerade", "zh": "滚动直线"}[speaking]
    assert tr("Nobody ever wrote this") == "Nobody ever wrote this"


def test_every_message_about_a_wrong_value_is_translated(speaking: str) -> None:
    seen = set()
    for spec in field_specs():
        for value in (None, "abc", -1e6, 1e6, 0.3, [], 10**50):
            table, key = spec.path.rsplit(".", 1) if "." in spec.path else ("", spec.path)
            nested: dict[str, object] = {key: value}
            for part in reversed(table.split(".") if table else []):
                nested = {part: nested}
            seen |= {issue.message for issue in read_design({"format": 1, **nested})[1]}
    assert len(seen) > 50
    for message in seen:
        said = told(message)
        assert said != message
        numbers = {number.replace(DECIMALS.get(speaking, POINT), POINT) for number in re.findall(r"\d+[.,]\d+", said)}
        assert numbers == set(re.findall(r"\d+\.\d+", message)), "numbers stay"
        plain = re.sub(
            r"\"[^\"]*\"|[a-z_]+\.[a-z_.]+|\b(format|mm|rms|true|false|list|NoneType|archimedean)\b", "", said
        )
        assert not re.search(r"\b(the|and|use|with|least|most|must|than|not)\b", plain), said


def test_sentences_with_words_in_their_holes(speaking: str) -> None:
    issues = read_design(with_field(Design(), "pair.face_width_factor", 0.45).model_dump() | {"format": 1})[1]
    assert all(told(issue.message) != issue.message for issue in issues)
    failed = told(ModellingError("rotating_line", "best fit", "the solid is not valid"))
    assert "failed" not in failed and "the solid" not in failed
    assert "no permission" not in told(FileError("/tmp/x.toml", "no permission"))
    assert told("/tmp/x.toml") == "/tmp/x.toml"
    assert told("Nothing of this kind is known") == "Nothing of this kind is known"


def test_a_template_matches_whole_sentences_only() -> None:
    template = compiled("use {0} or {1}")
    assert template.start == "use "
    assert template.pattern.fullmatch("use a or b").groups() == ("a", "b")  # type: ignore[union-attr]
    assert not template.pattern.fullmatch("use a")
    assert compiled("{0} to {1}").pattern.fullmatch("0.5 to 55")
    assert not compiled("{0} to {1}").pattern.fullmatch("unable to open it")
    assert translated("12.5") == "12.5"


def test_what_stands_in_quotes_is_left_as_somebody_wrote_it() -> None:
    said = {"write “{0} = {1}”; {2}": "schreiben „{0} = {1}“; {2}", "left": "links"}
    speaker = Speaker(in_order(said), lambda text: said.get(text, text), lambda text: said.get(text, text))
    assert speaker.told("write “hand = left”; left") == "schreiben „hand = left“; links"


@pytest.mark.parametrize(
    ("names", "language"), [(["de-AT", "en"], "de"), (["zh-Hans-CN"], "zh"), (["fr", "de"], "de"), ([], "en")]
)
def test_the_language_of_the_system(names: list[str], language: str) -> None:
    assert language_of_system(names) == language


@pytest.mark.ui
def test_no_text_of_the_window_is_left_out(qapp: QApplication) -> None:
    marking = Marking(qapp)
    qapp.installTranslator(marking)
    bench = Bench()
    try:
        qapp.processEvents()
        left = [f"{where}: {text}" for where, text in texts_of(bench.window) if _is_left(text)]
    finally:
        bench.close()
        qapp.removeTranslator(marking)
    assert not left, "\n".join(left)


def _is_left(text: str) -> bool:
    """Whether something reads like English outside the marks; keys, units and rich text do not."""
    bare = re.sub(r"<[^>]*>|&nbsp;|&quot;|&#x27;", " ", text)
    while "⟦" in bare:
        shorter = re.sub(r"⟦[^⟦⟧]*⟧", " ", bare)
        if shorter == bare:
            break
        bare = shorter
    bare = re.sub(r"\((Ctrl|Shift|Alt|Esc|F\d)[^)]*\)|\([A-Z]\w*\)", " ", bare)
    bare = re.sub(
        r"GearStudio|Deutsch|English|\b[a-z_]+\.[a-z_.]+\b|\b(cos|sin|tan|atan2|arctan|arcsin|ISO|hand\w?|half|share|lim)\b",
        " ",
        bare,
    )
    return bool(re.search(r"[A-Za-z]{3,}", bare))


def test_the_dialogs_that_are_qts_own_speak_the_language_too(speaking: str, qtbot) -> None:
    asked: set[tuple[str, str, str | None]] = set()

    class Listening(QTranslator):
        def isEmpty(self) -> bool:
            return False

        def translate(self, context: str, text: str, hint: str | None = None, n: int = -1) -> str | None:
            asked.add((context, text, hint))
            return None

    listening = Listening()
    QApplication.installTranslator(listening)
    try:
        files, colours, box = QFileDialog(), QColorDialog(), QMessageBox()
        files.setOption(QFileDialog.Option.DontUseNativeDialog)
        files.setViewMode(QFileDialog.ViewMode.Detail)
        colours.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        for answer in QMessageBox.StandardButton.Save, *list(QMessageBox.StandardButton)[2:18]:
            box.addButton(answer)
        box.setDetailedText("details")
        for dialog in (files, colours, box):
            qtbot.addWidget(dialog)
            dialog.show()
            qtbot.waitExposed(dialog)
        edit = QLineEdit("words")
        qtbot.addWidget(edit)
        edit.createStandardContextMenu()
    finally:
        QApplication.removeTranslator(listening)
    assert {context for context, _, _ in asked} >= {"QFileDialog", "QColorDialog", "QPlatformTheme", "QLineEdit"}
    ours = _installed()
    english = sorted(one for one in asked if not any(known.translate(*one) for known in ours))
    assert not english, english


def _installed() -> list[QTranslator]:
    return [one for one in QApplication.instance().findChildren(QTranslator) if not isinstance(one, Marking)]
