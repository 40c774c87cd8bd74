"""Help in the window: the guide's pages, the glossary, the equations with the numbers of the design."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QObject, QRect, QSettings, Qt, QTranslator, QUrl
from PySide6.QtGui import QImage, QTextCharFormat, QTextDocument
from PySide6.QtWidgets import QApplication, QDialog
from pytestqt.qtbot import QtBot

from gearstudio.equations import EQUATIONS, equation, numbers_of
from gearstudio.theory.cones import pair_geometry
from ui import units
from ui.help import typeset
from ui.help.equations import EquationBrowser
from ui.help.guide import GuideWindow
from ui.help.pages_of import PAGES, page_path, pages_folder, slug, term_of
from ui.help.tour import SEEN, STEPS, Tour, card_place
from ui.help.typeset import drawing
from ui.main_window import MainWindow
from ui.session import Session
from ui.theme import DARK, LIGHT, Theme

pytestmark = pytest.mark.ui


@pytest.fixture
def session(qtbot: QtBot) -> Session:
    made = Session()
    made.load(made.design)
    return made


class Speaking(QTranslator):
    """Says which language the window speaks, and a few of its words."""

    def __init__(self, words: dict[str, str], parent: QObject) -> None:
        super().__init__(parent)
        self._words = words

    def isEmpty(self) -> bool:
        return False

    def translate(self, context: str, text: str, hint: str | None = None, n: int = -1) -> str | None:
        return self._words.get(text)


@pytest.fixture(params=["en", "de", "zh"])
def language(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[str]:
    words = {"de": {"en": "de", "Backlash": "Flankenspiel"}, "zh": {"en": "zh", "Backlash": "侧隙"}}
    translator = Speaking(words.get(request.param, {}), qapp)
    qapp.installTranslator(translator)
    yield request.param
    qapp.removeTranslator(translator)


def test_every_page_is_there_in_every_language_with_its_headings_and_pictures(qtbot: QtBot, language: str) -> None:
    guide = GuideWindow()
    qtbot.addWidget(guide)
    for key, _ in PAGES:
        guide.show_page(key)
        assert page_path(key).parent == (pages_folder() if language == "en" else pages_folder() / language)
        text = page_path(key).read_text(encoding="utf-8")
        assert guide.headings.count() == len(re.findall(r"^#+ ", text, flags=re.MULTILINE))
        assert guide.view.verticalScrollBar().value() == 0
        assert guide.view.toPlainText().count("\ufffc") == text.count("![")
    loaded = guide.view.loadResource(
        QTextDocument.ResourceType.ImageResource.value, QUrl(("" if language == "en" else "../") + "images/zebra.png")
    )
    assert isinstance(loaded, QImage) and not loaded.isNull()


@pytest.mark.parametrize("width", [800, 1200])
def test_pages_fit_the_width_of_the_window(qtbot: QtBot, language: str, width: int) -> None:
    guide = GuideWindow()
    qtbot.addWidget(guide)
    guide.resize(width, 640)
    guide.show()
    qtbot.waitUntil(lambda: guide.view._fitted == max(guide.view.viewport().width() - 60, 200))
    assert guide.view.horizontalScrollBar().maximum() == 0
    assert guide.view.verticalScrollBar().value() == 0
    guide.close()


def test_indices_stand_below_the_line_and_code_stays(qtbot: QtBot, language: str) -> None:
    guide = GuideWindow(page="glossary")
    qtbot.addWidget(guide)
    text = guide.view.toPlainText()
    assert "δb" in text and "εα" in text and not re.search("[A-Zα-ω]_[a-zα-ω]", text)
    cursor = guide.view.document().find("δb")
    assert cursor.charFormat().verticalAlignment() == QTextCharFormat.VerticalAlignment.AlignSubScript
    guide.show_page("guide")
    assert "spiral_angle_deg" in guide.view.toPlainText() and "own_cone" in guide.view.toPlainText()


def test_the_contents_lead_to_the_headings(qtbot: QtBot, language: str) -> None:
    guide = GuideWindow()
    qtbot.addWidget(guide)
    guide.show()
    headings = [guide.headings.item(row).text().strip() for row in range(guide.headings.count())]
    links = re.findall(r"\]\((#[^)]+)\)", page_path("guide").read_text(encoding="utf-8"))
    assert len(links) > 15
    for link in links:
        guide.view.anchorClicked.emit(QUrl(link))
        assert slug(headings[guide.headings.currentRow()]) == link[1:]


def test_search_goes_on_in_the_other_page_and_round(qtbot: QtBot, language: str) -> None:
    guide = GuideWindow()
    qtbot.addWidget(guide)
    guide.show()
    guide.search.setText({"en": "zerol", "de": "zerol", "zh": "零度齿"}[language])
    guide.find_next()
    assert guide.pages.currentData() == "glossary" and guide.view.textCursor().hasSelection()
    first = guide.view.textCursor().position()
    guide.find_next()
    assert guide.view.textCursor().position() == first and not guide.nothing.isVisible()
    guide.search.setText("qqqq")
    guide.find_next()
    assert guide.nothing.isVisible()
    guide.search.setText({"en": "toe-heel", "de": "rückenkegel", "zh": "背锥"}[language])
    guide.find_next()
    assert guide.nothing.isVisible() == (language == "en")


def test_a_word_of_the_window_leads_to_the_glossary(qtbot: QtBot, language: str) -> None:
    term = term_of("Backlash")
    assert term == {"en": "Backlash", "de": "Flankenspiel", "zh": "侧隙"}[language]
    guide = GuideWindow()
    qtbot.addWidget(guide)
    guide.show()
    guide.show_term(term)
    assert guide.view.textCursor().block().text().startswith(term)
    assert term_of("Bore diameter") == ""


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


def test_numbers_are_shown_in_the_unit_chosen(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    put = numbers_of(equation("cone_distance"), pair_geometry(session.design), "wheel")
    assert put is not None
    assert "86.925255" in typeset._values(put.outputs) and '"mm"' in typeset._values(put.outputs)
    monkeypatch.setattr(units, "_shown", units.Display("in"))
    assert "3.4222541" in typeset._values(put.outputs) and '"in"' in typeset._values(put.outputs)
    assert typeset._values(put.inputs).count('"°"') == 1


@pytest.fixture
def window(qtbot: QtBot, session: Session, theme: Theme, tmp_path: Path) -> MainWindow:
    made = MainWindow(session, QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))
    qtbot.addWidget(made)
    made.resize(1280, 720)
    made.show()
    made.layer_panel.window().show()
    return made


def test_the_tour_leads_through_the_window_and_is_offered_once(qtbot: QtBot, window: MainWindow) -> None:
    tour = Tour(window)
    tour.offer()
    titles = []
    while tour.card is not None:
        assert tour.ring is not None and window.rect().contains(tour.card.geometry())
        assert window.rect().contains(tour.ring.geometry())
        titles.append(tour.card.title.text())
        qtbot.mouseClick(tour.card.next, Qt.MouseButton.LeftButton)
    assert titles == [step.title for step in STEPS if step.part(window).isVisible()] and len(titles) >= 5
    assert window.settings is not None and window.settings.value(SEEN)
    tour.offer()
    assert not tour.running
    tour.start()
    assert tour.running and tour.card is not None
    qtbot.mouseClick(tour.card.skip, Qt.MouseButton.LeftButton)
    assert not tour.running


def test_the_tour_waits_for_a_question_that_is_open(qtbot: QtBot, window: MainWindow) -> None:
    tour, question = Tour(window), QDialog(window)
    question.open()
    tour.offer()
    assert not tour.running
    question.reject()
    tour.offer()
    assert tour.running
    tour.end()


def test_the_tour_is_not_offered_where_nothing_is_remembered(qtbot: QtBot, session: Session, theme: Theme) -> None:
    window = MainWindow(session)
    qtbot.addWidget(window)
    window.show()
    tour = Tour(window)
    tour.offer()
    assert not tour.running


def test_the_card_follows_a_smaller_window(qtbot: QtBot, window: MainWindow) -> None:
    window.resize(1500, 900)
    tour = Tour(window)
    tour.start()
    least = window.minimumSize()
    window.resize(least)
    qtbot.waitUntil(lambda: window.size() == least)
    assert tour.card is not None and window.rect().contains(tour.card.geometry())
    tour.end()


@pytest.mark.parametrize(
    "part", [QRect(0, 0, 300, 700), QRect(900, 0, 380, 700), QRect(0, 0, 1280, 40), QRect(0, 500, 1280, 220)]
)
def test_a_card_stands_beside_what_it_points_at(part: QRect) -> None:
    inside, card = QRect(0, 0, 1280, 720), QRect(0, 0, 330, 140)
    place = QRect(card_place(part, card, inside), card.size())
    assert inside.contains(place) and not place.intersects(part)
    assert inside.contains(QRect(card_place(inside, card, inside), card.size()))


def test_every_page_of_help_is_in_the_menu(window: MainWindow) -> None:
    menu = next(action.menu() for action in window.menuBar().actions() if "Help" in action.text())
    names = {action.objectName() for action in menu.actions()}
    assert {"guide", "tour", "glossary", "equations"} <= names
