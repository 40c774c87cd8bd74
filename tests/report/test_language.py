"""The language of the report: nothing in it is left in English, and numbers are as the language writes them."""

import json
import re
from collections.abc import Iterator
from datetime import UTC, datetime
from importlib import resources
from typing import Any

import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

from gearstudio.design import Design, with_field
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.report import charts as line_charts
from gearstudio.report import contact_charts, document, maps, measured_charts, style
from gearstudio.report.blocks import Pages
from gearstudio.report.document import Order, compose, typeset
from gearstudio.report.language import Language, inline, language, moment, notation, number, speaking, told, tr
from gearstudio.report.sections import SECTION_KEYS
from gearstudio.report.store import Taken
from gearstudio.words import LANGUAGES
from tools.collecting import core_sentences, report_tables, report_words

TRANSLATED = LANGUAGES[1:]
HOLE = re.compile(r"\{[^}]*\}")
NAMES = r"GearStudio|Python|cadquery|ocp|novtk|numpy|scipy|typst|Linux|Darwin|Windows|UTC|ISO|RMS|blank.MEMBER|\w+_\w+"
ENGLISH = re.compile(r"\b(the|of|and|with|from|is|are|flank|tooth|wheel|pinion|deviation|error|not)\b", re.IGNORECASE)
_PROSE = ("meaning", "departure")
MODIFIED = with_field(
    with_field(Design(name=""), "modifications.pinion.concave.lengthwise_crowning_um", 12.5),
    "pair.face_width_factor",
    0.36,
)


class Marks(dict[str, str]):
    """Says everything with marks around it."""

    def get(self, text: str, default: Any = None) -> str:
        return f"⟦{text}⟧"


def test_every_text_of_the_report_is_translated() -> None:
    for code in TRANSLATED:
        text = (resources.files("gearstudio.report") / "words" / f"{code}.json").read_text(encoding="utf-8")
        known = json.loads(text)
        assert (report_words() | report_tables()) - set(known["words"]) == set()
        assert core_sentences() - set(known["sentences"]) == set()
        for english, said in known["words"].items():
            assert set(HOLE.findall(english)) == set(HOLE.findall(said)), english


@pytest.mark.kernel
@pytest.mark.parametrize("design", [MODIFIED, PRESETS_BY_KEY["hypoid-car"].design], ids=["bevel", "hypoid"])
def test_nothing_in_the_report_goes_untranslated(design: Design, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    _collect_texts(monkeypatch, drawn)
    monkeypatch.setattr(document, "language", lambda code: Language("de", Marks(), Marks(), ","))
    pages = _composed(design, "de")
    left = [text for text in (*_words(pages), *drawn) if _is_left(text)]
    assert not left, "\n".join(left)
    assert len(drawn) > 100


@pytest.mark.kernel
@pytest.mark.parametrize("code", TRANSLATED)
def test_no_english_in_a_report_of_another_language(code: str, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    _collect_texts(monkeypatch, drawn)
    pages = _composed(MODIFIED, code)
    left = [text for text in (*_words(pages), *drawn) if ENGLISH.search(re.sub(NAMES, " ", text))]
    assert not left, "\n".join(left)
    assert typeset(pages)[0].startswith(b"%PDF")
    pointed = [text for text in (*_words(pages), *drawn) if re.search(r"(?<![\d.])\d+\.\d+(?![\d.])", text)]
    pointed = [text for text in pointed if not text.startswith("Theorie, Abschnitt")]
    assert (not pointed) == (code == "de"), pointed


def test_a_machine_without_chinese_characters_gets_english_and_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "cjk_family", lambda: None)
    pages = _composed(Design(), "zh", ("design",))
    assert pages.language == "en" and pages.chapters[0].title == "Design"
    assert any("Chinese" in warning for warning in pages.warnings)
    assert not _composed(Design(), "de", ("design",)).warnings


def test_numbers_and_dates_as_the_language_writes_them() -> None:
    when = datetime(2026, 3, 9, 14, 5, tzinfo=UTC)
    assert (number(-1.5), moment(when)) == ("−1.5", "2026-03-09 14:05 UTC")
    with speaking(language("de")):
        assert (number(-1.5), number(0.125, ".2f"), number(17.0)) == ("−1,5", "0,12", "17")
        assert notation("numpy 2.4.6, 0.3 m, R = 222.2 mm.") == "numpy 2.4.6, 0,3 m, R = 222,2 mm."
        assert moment(when) == "09.03.2026, 14:05 UTC"
        assert "0,25" in told("use at most 0.25 mm")
    with speaking(language("zh")):
        assert (number(-1.5), moment(when)) == ("−1.5", "2026年03月09日 14:05 UTC")


def test_words_and_sentences() -> None:
    assert (tr("Pinion"), inline("Rotating line")) == ("Pinion", "rotating line")
    with speaking(language("de")):
        assert (tr("Pinion"), inline("Rotating line")) == ("Ritzel", "Rollende Gerade")
        assert tr("Nobody ever wrote this {x}", x=1) == "Nobody ever wrote this 1"
        assert "failed" not in told("rotating_line: best fit failed: the solid is not valid")
    assert tr("Pinion") == "Pinion", "the language is left again"


def _composed(design: Design, code: str, sections: tuple[str, ...] = SECTION_KEYS) -> Pages:
    return compose(design, Order(sections, "wheel", code), Taken, lambda *_: None)


def _collect_texts(monkeypatch: pytest.MonkeyPatch, into: list[str]) -> None:
    """Keep the words of every figure that is drawn."""

    def kept(drawn: Figure) -> bytes:
        made = style.svg(drawn)
        into.extend(text.get_text() for text in drawn.findobj(Text) if "$" not in text.get_text())
        return made

    for module in (line_charts, maps, contact_charts, measured_charts):
        monkeypatch.setattr(module, "svg", kept)


def _words(pages: Pages) -> Iterator[str]:
    """What is read in a report; no symbols, formulas and keys of files."""
    data = pages.data()
    yield from data["words"].values()
    for name, value in data["facts"]:
        yield from (name, value)
    for chapter in data["chapters"]:
        yield chapter["title"]
        for block in chapter["blocks"]:
            yield from _said(block)


def _said(block: dict[str, Any]) -> Iterator[str]:
    if block["kind"] == "table":
        yield from block["header"]
        for row in block["rows"]:
            plain = zip(row, block["align"], strict=False)
            yield from row if len(row) == 1 else (cell for cell, kind in plain if kind not in "mk")
    elif block["kind"] == "formula":
        yield from (block["title"], block["number"], *(name for name, _ in block["numbers"]))
        yield from ("".join(text if kind == "text" else "x" for kind, text in block[part]) for part in _PROSE)
    else:
        yield block["caption"] if block["kind"] == "picture" else block["text"]


def _is_left(text: str) -> bool:
    """Whether something reads like English outside the marks."""
    bare = text
    while bare != (shorter := re.sub(r"⟦[^⟦⟧]*⟧", " ", bare)):
        bare = shorter
    return bool(re.search(r"[A-Za-z]{3,}", re.sub(NAMES, " ", bare)))
