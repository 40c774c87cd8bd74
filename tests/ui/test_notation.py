"""Texts, equations and copied tables have the decimal sign of the language; files keep the point."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest
from PySide6.QtGui import QGuiApplication

from gearstudio import cli
from gearstudio.analysis.datasheet import data_sheet, sheet_text
from gearstudio.design import Design, all_field_specs
from gearstudio.equations import equation, numbers_of
from gearstudio.project import load_design, save_design
from gearstudio.theory.cones import pair_geometry
from gearstudio.validation.messages import field_issue
from gearstudio.words import with_decimal
from tests.ui.stand_ins import Bench
from ui import formatting, units
from ui.analysis.datasheet_page import DatasheetPage
from ui.charts.records import Table
from ui.explain import field_value_text, problem_text
from ui.help.typeset import drawing
from ui.tables import copy_text
from ui.theme import LIGHT
from ui.words import tr

MODULE = all_field_specs()["pair.outer_module"]
POINT = re.compile(r"\d\.\d")


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
        assert said.startswith("10,019685 in") and not POINT.search(said)
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
        assert not POINT.search(bench.window.derived.text_table())
        page.show_view("published")
        page.copy("text")
        assert not POINT.search(QGuiApplication.clipboard().text())
        page.save(tmp_path / "published.txt", "text")
        assert not re.search(r"\d,\d", (tmp_path / "published.txt").read_text())
    finally:
        bench.close()


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


ELSEWHERE = {
    "formatting.py": "the place",
    "units.py": "twelve digits and a sentence, written later",
    "curvature_view.py": "taken apart",
    "records.py": "a cell of a file",
}


def test_numbers_are_written_in_one_place() -> None:
    """Elsewhere no decimals are put into a text but by `tr`, or for `float` and `written` to take."""
    found = []
    for file in (Path(__file__).parents[2] / "ui").rglob("*.py"):
        nodes = list(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
        calls = [node for node in nodes if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)]
        takers = [argument for call in calls if call.func.id in ("float", "written") for argument in call.args]
        taken = {id(inner) for argument in takers for inner in ast.walk(argument)}
        for part in nodes:
            if isinstance(part, ast.FormattedValue) and part.format_spec is not None and id(part) not in taken:
                spec = "".join(str(one.value) for one in part.format_spec.values if isinstance(one, ast.Constant))
                if spec[-1:] in ("g", "f", "e") and spec != ".0f" and file.name not in ELSEWHERE:
                    found.append(f"{file.name}:{part.lineno}")
    assert not found


def test_no_values_of_a_list_are_parted_as_a_number_is(german) -> None:
    shown = formatting.settings_text({"step": 0.25, "sizes": [1.5, 2.5], "nested": {"a": 0.5, "b": 2}})
    assert not re.search(r"\d,\d+, ", shown) and shown.count(";") == 3
