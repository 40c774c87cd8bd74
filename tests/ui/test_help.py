"""Help in the window: the guide's pages, the glossary, the equations with the numbers of the design."""

import pytest
from pytestqt.qtbot import QtBot

from gearstudio.equations import EQUATIONS, numbers_of
from gearstudio.theory.cones import pair_geometry
from ui.help.equations import EquationBrowser
from ui.help.guide import PAGES, GuideWindow, pages_folder
from ui.help.typeset import drawing
from ui.session import Session
from ui.theme import DARK, LIGHT

pytestmark = pytest.mark.ui


@pytest.fixture
def session(qtbot: QtBot) -> Session:
    made = Session()
    made.load(made.design)
    return made


def test_every_page_is_there_with_its_headings(qtbot: QtBot) -> None:
    guide = GuideWindow()
    qtbot.addWidget(guide)
    for key, _ in PAGES:
        guide.show_page(key)
        text = (pages_folder() / f"{key}.md").read_text(encoding="utf-8")
        assert guide.headings.count() == sum(line.startswith("#") for line in text.splitlines())
        assert guide.view.verticalScrollBar().value() == 0


def test_search_goes_round(qtbot: QtBot) -> None:
    guide = GuideWindow(page="glossary")
    qtbot.addWidget(guide)
    guide.search.setText("Zerol")
    guide.find_next()
    first = guide.view.textCursor().position()
    guide.find_next()
    assert first > 0 and guide.view.textCursor().position() == first


def test_the_browser_shows_the_numbers_of_the_design(qtbot: QtBot, session: Session) -> None:
    browser = EquationBrowser(session)
    qtbot.addWidget(browser)
    browser.show()
    with qtbot.waitSignal(browser._setter.done):
        browser.choose("base_angle")
    before = browser.sheet.height()
    assert before > 100
    with qtbot.waitSignal(browser._setter.done):
        session.edit("pair.wheel_teeth", 41)
    assert len(browser._items()) == len(EQUATIONS)


def test_the_list_is_filtered_by_number_and_words(qtbot: QtBot, session: Session) -> None:
    browser = EquationBrowser(session)
    qtbot.addWidget(browser)
    browser.search.setText("(20)")
    assert [i.data(0, 256).key for i in browser._items() if not i.isHidden()] == ["trace"]
    browser.search.setText("fillet")
    assert "fillet" in [i.data(0, 256).key for i in browser._items() if not i.isHidden()]


@pytest.mark.parametrize("colors", [LIGHT, DARK])
def test_every_equation_can_be_drawn_in_both_themes(session: Session, colors: object) -> None:
    pair = pair_geometry(session.design)
    for one in EQUATIONS:
        put = numbers_of(one, pair, "wheel")
        assert drawing(one, {} if put is None else {"wheel": put}, colors, 400).startswith(b"<svg")
