"""Numbers follow the language of the window, and what it shows it reads; files keep the point."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QPainter, QTextDocument
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QGraphicsTextItem,
    QGraphicsView,
    QGridLayout,
    QLineEdit,
    QPlainTextEdit,
    QWidget,
)

from docs.scenes import dialogs, pages, panels
from docs.scenes.stage import Stage
from gearstudio import cli
from gearstudio.analysis.datasheet import data_sheet, sheet_text
from gearstudio.design import Design, FieldSpec, all_field_specs, field_specs
from gearstudio.equations import equation, numbers_of
from gearstudio.formats import OPTIONS
from gearstudio.project import load_design, save_design
from gearstudio.theory.cones import pair_geometry
from gearstudio.validation.messages import field_issue
from gearstudio.words import with_decimal
from tests.ui.made_up import member_of
from tests.ui.reading import texts_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.stand_ins import Bench
from tests.ui.test_layout import SYSTEM, with_results
from ui import app, formatting, units
from ui.analysis.datasheet_page import DatasheetPage
from ui.analysis.number_slider import NumberSlider
from ui.charts.records import Table
from ui.derived_panel import QUANTITIES
from ui.explain import field_value_text, problem_text
from ui.export_options import OptionsPanel
from ui.expressions import ExpressionError, evaluate
from ui.fields import NumberField, read_number
from ui.help.typeset import drawing
from ui.language import Language
from ui.loading import STAGES, Loader
from ui.properties_table import PropertiesTable
from ui.tables import copy_text
from ui.theme import LIGHT
from ui.words import tr

NUMBERS = [spec for spec in field_specs() if spec.kind in ("int", "float")]
MODULE = all_field_specs()["pair.outer_module"]
FOREIGN = {"de": re.compile(r"\d\.\d"), "en": re.compile(r"\d,\d"), "zh": re.compile(r"\d,\d")}
OWN = {"de": re.compile(r"\d,\d"), "en": re.compile(r"\d\.\d"), "zh": re.compile(r"\d\.\d")}


@pytest.fixture
def speak(qapp: QApplication) -> Iterator[Callable[[str], None]]:
    language = Language(qapp, "en")
    yield language.speak
    language.speak("en")


@pytest.fixture
def german(speak) -> None:
    speak("de")


@pytest.fixture
def painted(monkeypatch) -> list[str]:
    """What painters have written."""
    found: list[str] = []
    draw = QPainter.drawText

    def noting(painter: QPainter, *given: object) -> object:
        found.extend(text for text in given if isinstance(text, str))
        return draw(painter, *given)

    monkeypatch.setattr(QPainter, "drawText", noting)
    return found


def plain(text: str) -> str:
    if not Qt.mightBeRichText(text):
        return text
    document = QTextDocument()
    document.setHtml(text)
    return document.toPlainText()


def shown_in(top: QWidget) -> Iterator[tuple[str, str]]:
    """Texts of a window, those that stand in its fields and its charts too."""
    yield from texts_of(top)
    for widget in (top, *top.findChildren(QWidget)):
        name = type(widget).__name__
        if isinstance(widget, QLineEdit | QAbstractSpinBox):
            yield name, widget.text()
        elif isinstance(widget, QPlainTextEdit):
            yield name, widget.toPlainText()
        elif isinstance(widget, QGraphicsView):
            items = widget.scene().items()
            yield from ((f"{name} item", item.toPlainText()) for item in items if isinstance(item, QGraphicsTextItem))


def preferences(stage: Stage) -> None:
    """Its pages; what stands beside them tells versions."""
    for page in range(3):
        stage.dialog(f"preferences-{page}", lambda page=page: stage.studio.habits.open_preferences(page))


def numbers_in(texts: list[tuple[str, str]], sign: re.Pattern[str]) -> list[str]:
    return [f"{where}: {text[:200]}" for where, text in texts if sign.search(text)]


class Reader:
    """Looks at every scene and notes numbers of another language."""

    def __init__(self, language: str, painted: list[str]) -> None:
        self.language, self._painted = language, painted
        self.foreign: list[str] = []
        self.own = 0

    def __call__(self, scene: str) -> None:
        for _ in range(3):
            QApplication.processEvents()
        tops = [one for one in QApplication.topLevelWidgets() if one.isVisible() and not one.inherits(SYSTEM)]
        texts = [(where, plain(text)) for top in tops for where, text in shown_in(top)]
        texts += [("painted", text) for text in self._painted]
        self._painted.clear()
        self.own += len(numbers_in(texts, OWN[self.language]))
        self.foreign += [f"{scene}: {one}" for one in numbers_in(texts, FOREIGN[self.language])]


class TestTheWindow:
    pytestmark = NEEDS_SCREEN

    @pytest.fixture
    def open_stage(self, theme, tmp_path: Path, monkeypatch, painted) -> Iterator[Callable[[str], Stage]]:
        without_kernel = {name: modules for name, modules in STAGES.items() if name != "worker"}
        monkeypatch.setattr(app, "Loader", partial(Loader, without_kernel))
        opened: list[Stage] = []

        def make(language: str) -> Stage:
            stage = Stage(theme, tmp_path, Reader(language, painted), built=False, rest=0.03)
            opened.append(stage)
            stage.open()
            with_results(stage)
            stage.resize(1280, 720)
            return stage

        yield make
        for stage in opened:
            stage.window = stage.studio.window
            stage.leave()

    @pytest.mark.slow
    @pytest.mark.parametrize("language", ["de", "en"])
    def test_no_number_is_written_as_in_another_language(self, language: str, open_stage, speak) -> None:
        speak(language)
        stage = open_stage(language)
        scenes = (
            panels.views, panels.picked, panels.form, panels.derived_and_log, panels.solids, pages.charts,
            pages.contact, pages.data_sheet, pages.measurement, dialogs.exports, dialogs.projects, preferences,
        )  # fmt: skip
        for scene in scenes:
            scene(stage)
            stage.close_all()
        assert stage.look.own > 1000, "the sweep has seen numbers"
        assert not stage.look.foreign, "\n".join(dict.fromkeys(stage.look.foreign))

    def test_numbers_follow_while_the_window_is_open(self, open_stage, speak, qtbot) -> None:
        stage = open_stage("en")
        studio, session = stage.studio, stage.session
        typed = {"pair.outer_module": 4.25, "tooth.profile_shift": "1x", "lengthwise.spiral_angle_deg": 33.3}
        for path, value in typed.items():
            studio.window.form.field_edited.emit(path, value)
        studio.window.analysis.show_tab("contact")
        studio.window.analysis.page.controls.rows["offset"].box.setValue(0.125)
        draft = dict(session.draft)
        for language in ("de", "en", "de"):
            studio.speak(language)
            qtbot.waitUntil(lambda: studio.window.area.grid is not None, timeout=20_000)
            window, look = studio.window, Reader(language, [])
            assert session.draft == draft
            sign = "," if language == "de" else "."
            rows = window.form.rows
            assert rows["pair.outer_module"].field.text() == f"4{sign}25"
            assert rows["tooth.profile_shift"].field.text() == "1x", "what is no number stays as typed"
            assert {path: rows[path].field.value() for path in typed} == typed
            assert f"33{sign}3°" in window.commands["undo"].text().replace(" ", "")
            assert window.analysis.page.controls.rows["offset"].box.text().startswith(f"0{sign}125")
            look("switched")
            assert look.own > 100 and not look.foreign, "\n".join(look.foreign)


@pytest.mark.ui
@pytest.mark.parametrize("language", ["de", "en", "zh"])
def test_every_field_reads_what_it_shows(language: str, speak, qtbot, theme) -> None:
    speak(language)
    bench = Bench()
    try:
        for spec in NUMBERS:
            row = bench.window.form.rows[spec.path]
            for value in some_values(spec):
                row.field.set_value(value)
                text = row.field.text()
                assert not FOREIGN[language].search(text)
                pasted_all_ways(row.field, spec, text, value)
            row.field.set_value(None if spec.optional else spec.default)
            hint = row.field.placeholderText()
            assert not hint or not isinstance(read_number(hint, spec)[0], str)
    finally:
        bench.close()


def some_values(spec: FieldSpec) -> list[int | float]:
    if spec.kind == "int":
        return [int(spec.default or 17)]
    return [float(spec.default or 1.5), 0.125, -2.5e-7, 1234.5678, 100_000.25]


def pasted_all_ways(field: NumberField, spec: FieldSpec, text: str, value: float) -> None:
    """As it stands, with its unit, with a true minus sign, in a sum."""
    unit = units.unit_shown(spec.unit) if spec.unit in ("mm", "°") else ""
    for way in (text, f" {text}\n", f"{text} {unit}".strip(), text.replace("-", formatting.MINUS), f"({text})*1"):
        field.clear()
        field.insert(way)
        assert field.value() == pytest.approx(value, rel=1e-11), way


@given(value=st.floats(-1e6, 1e6), length=st.sampled_from(["mm", "in"]), language=st.sampled_from(["de", "en", "zh"]))
def test_shown_lengths_read_back(qapp, value: float, length: str, language: str) -> None:
    spoken = Language(qapp, language)
    try:
        units.use(units.Display(length))
        read = read_number(units.shown_text(value, "mm"), MODULE)[0]
        assert read == pytest.approx(value, rel=1e-7)
        assert read_number(units.with_unit(value, "mm", 6), MODULE)[0] == pytest.approx(value, abs=1e-5)
        assert read_number(formatting.number(value, ".12g"), all_field_specs()["tooth.profile_shift"])[0] == (
            pytest.approx(value, rel=1e-11)
        )
    finally:
        units.use(units.Display())
        spoken.speak("en")


def test_derived_values_can_be_pasted_into_a_field(german) -> None:
    wheel = member_of("default")
    shown = {q.title: (q.text(wheel), q.unit, q.read(wheel)) for q in QUANTITIES if q.unit}
    assert all("," in text for text, *_ in shown.values())
    for text, unit, value in shown.values():
        spec = MODULE if unit == "mm" else all_field_specs()["lengthwise.spiral_angle_deg"]
        for pasted in (text, text + units.spaced(unit)):
            assert read_number(pasted, spec)[0] == pytest.approx(value, abs=5e-4)


class TestSums:
    @pytest.mark.parametrize(
        ("text", "value"),
        [("max(1,5; 2)", 2.0), ("min(1,5;2)", 1.5), ("pow(3,2)", 9.0), ("1,5 + 2.5", 4.0),
         ("hypot(3,4)", 5.0), ("max(1.5, 2)", 2.0), ("max(hypot(3,4), 2)", 5.0), ("max(1, 2, 3)", 3.0)],
    )  # fmt: skip
    def test_in_german(self, text: str, value: float, german) -> None:
        assert evaluate(text, "") == pytest.approx(value)

    @pytest.mark.parametrize("text", ["max(1,5, 2)", "min(1,5,2)", "1 + hypot(1,5, (2+1))", "max(hypot(3,4), 1,5)"])
    def test_what_could_be_read_in_two_ways_is_refused_in_german(self, text: str, speak) -> None:
        assert evaluate(text, "") > 0
        speak("de")
        with pytest.raises(ExpressionError, match=";"):
            evaluate(text, "")


def test_numbers_as_they_are_written(german) -> None:
    assert formatting.significant(-0.0123) == "−0,0123" and formatting.fixed(-1e-9, 3) == "0,000"
    assert formatting.micrometres(54.63) == "54,6 µm" and formatting.micrometres(1e-9) == "< 0,001 nm"
    assert formatting.number_text(0.5) == "0,5" and formatting.number_text(17) == "17"
    assert tr("{size:.1f} MB", size=1.25) == "1,2 MB"
    settings = {"grid": [12, 14], "step": 0.25}
    assert ";" in formatting.settings_text(settings) and "0,25" in formatting.settings_text(settings)
    assert formatting.listed(["1,5", "2"]) == "1,5; 2"


def test_problems_at_fields_and_undo_texts(german) -> None:
    said = problem_text(field_issue(MODULE, 254.5).message, MODULE)
    assert said.startswith("254,5 ") and "0,1" in said and "." not in said
    assert field_value_text(MODULE, 4.5) == "4,5 mm"
    units.use(units.Display("in"))
    try:
        said = problem_text(field_issue(MODULE, 254.5).message, MODULE)
        assert said.startswith("10,019685 in") and not FOREIGN["de"].search(said)
    finally:
        units.use(units.Display())


@pytest.mark.parametrize(
    ("text", "written"),
    [("12.5 mm, -3.25° and 1.2e-05", "12,5 mm, -3,25° and 1,2e-05"), ("use 1.5.", "use 1,5."),
     ("/a/my 1.5 gears/b 2.5.gear.toml: 3.5", "/a/my 1.5 gears/b 2.5.gear.toml: 3,5"),
     ("PySide 6.11.3", "PySide 6.11.3"),
     ("C:\\g 1.5\\a.csv (2.5 MB)", "C:\\g 1.5\\a.csv (2,5 MB)"), ("“1.5x” is none", "“1.5x” is none"),
     ("gear 1.5.step", "gear 1.5.step"), ('"1.5" is 2.5', '"1.5" is 2,5'), ("0.5/mm", "0,5/mm")],
)  # fmt: skip
def test_names_versions_and_quotations_stay(text: str, written: str) -> None:
    assert with_decimal(text, ",") == written and with_decimal(text, ".") == text


@pytest.mark.ui
class TestTheBoxOfANumber:
    @pytest.fixture
    def row(self, qtbot) -> Iterator[NumberSlider]:
        holder = QWidget()
        qtbot.addWidget(holder)
        made = NumberSlider(QGridLayout(holder), 0, "Offset", "A tip", "mm", 3)
        made.set_range(-1.0, 1.0, most=10.0)
        holder.show()
        yield made
        holder.hide()

    @pytest.mark.parametrize("text", ["1,5", "1.5", "1,5 mm", "+1.5"])
    @pytest.mark.parametrize("language", ["de", "en"])
    def test_point_and_comma_are_typed(self, text: str, language: str, speak, row: NumberSlider) -> None:
        speak(language)
        row.box.selectAll()
        QTest.keyClicks(row.box, text)
        QTest.keyClick(row.box, Qt.Key.Key_Return)
        assert row.value == 1.5 and row.box.text() == ("1,500 mm" if language == "de" else "1.500 mm")
        QTest.keyClick(row.box, Qt.Key.Key_Up)
        assert row.value == pytest.approx(1.51)

    @pytest.mark.parametrize("text", ["abc", "1,5,5", "99", ""])
    def test_what_is_no_number_in_its_range_leaves_the_one_before(self, text: str, german, row: NumberSlider) -> None:
        row.set_value(-0.25)
        row.box.selectAll()
        QTest.keyClicks(row.box, text)
        QTest.keyClick(row.box, Qt.Key.Key_Return)
        assert row.value == -0.25 and row.box.text() == "−0,250 mm"


@pytest.mark.ui
def test_tables_are_copied_as_shown_and_files_have_points(german, qtbot, tmp_path: Path, theme) -> None:
    table = Table(("series", "x [mm]"), [("pinion", 1.25), ("wheel", -0.5)])
    assert "1,25" in table.shown().text("\t") and "-0,5" in table.shown().text("\t")
    assert table.text() == "series,x [mm]\npinion,1.25\nwheel,-0.5\n"
    page = DatasheetPage()
    qtbot.addWidget(page)
    bench = Bench()
    try:
        page.show_session(bench.session)
        page.copy("text")
        assert "23,02549" in QGuiApplication.clipboard().text()
        page.copy("csv")
        assert QGuiApplication.clipboard().text() == sheet_text(data_sheet(bench.session.design), "csv")
        for format_ in ("text", "csv", "latex"):
            page.save(tmp_path / format_, format_)
            assert (tmp_path / format_).read_text() == sheet_text(data_sheet(bench.session.design), format_)
            assert "23.0254" in (tmp_path / format_).read_text()
        page.table.table.selectAll()
        assert "23,02549" in copy_text(page.table.table) and "23.0" not in copy_text(page.table.table)
        assert not FOREIGN["de"].search(bench.window.derived.text_table())
        page.show_view("published")
        page.copy("text")
        assert not FOREIGN["de"].search(QGuiApplication.clipboard().text())
        page.save(tmp_path / "published.txt", "text")
        assert not re.search(r"\d,\d", (tmp_path / "published.txt").read_text())
    finally:
        bench.close()


@pytest.mark.ui
def test_remembered_options_of_an_export_follow_the_language(german, qtbot) -> None:
    page = OptionsPanel(0.0123)
    qtbot.addWidget(page)
    number = next(spec.name for spec in OPTIONS.values() if spec.kind == "number")
    page.set_choices({number: "0.25"})
    assert page.editor(number).text() == "0,25" and page._value(OPTIONS[number]) == 0.25
    assert page.editor("chord").placeholderText() == "0,0123"


@pytest.mark.ui
def test_design_files_and_the_command_line_keep_the_point(german, tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.setenv("LANG", "de_DE.UTF-8")
    path, design = tmp_path / "a.gear.toml", Design.model_validate({"pair": {"outer_module": 4.25}})
    save_design(path, design)
    assert "outer_module = 4.25" in path.read_text() and load_design(path) == design
    assert cli.main(["info", str(path), "--json", str(tmp_path / "info.json")]) == 0
    printed = capsys.readouterr().out + (tmp_path / "info.json").read_text()
    assert re.search(r"\d\.\d", printed) and not re.search(r"\d,\d", printed)


def test_equations_have_the_numbers_of_the_language(speak, monkeypatch) -> None:
    import typst

    sources: list[str] = []
    monkeypatch.setattr(typst, "compile", lambda source, **_: sources.append(source.decode()) or b"")
    pair = pair_geometry(Design())
    one = equation("fillet")
    for language in ("en", "de"):
        speak(language)
        drawing(one, {"wheel": numbers_of(one, pair, "wheel")}, LIGHT, 400.0)
    shown = [re.sub(r"#let fit.*|\d+(\.\d+)?pt|size\.\w+|calc\.\w+", "", source) for source in sources]
    assert re.search(r"\d\.\d", shown[0]) and not re.search(r"\d,\d", shown[0])
    assert re.search(r"\d,\d", shown[1]) and not re.search(r"\d\.\d", shown[1])


@pytest.mark.ui
def test_a_density_stays_when_the_language_changes(speak, qtbot) -> None:
    before = PropertiesTable()
    qtbot.addWidget(before)
    before.density_field.setText("7123.5")
    before.density_field.textEdited.emit("7123.5")
    speak("de")
    after = PropertiesTable()
    qtbot.addWidget(after)
    after.take_state(before.keep_state())
    assert after.density == 7123.5 and after.density_field.text() == "7123,5"
