"""Pictures of the views for the report, painted piece by piece so that the window stays awake."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QObject, QSize, QTimer, Signal
from PySide6.QtGui import QImage

from gearstudio.words import ENGLISH
from ui.language import spoken
from ui.words import noted

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.session import Session
    from ui.solid_mode import SolidMode
    from ui.view_grid import ViewGrid
    from ui.views.pictures import Steps

_VIEWS, _PAIR = QSize(710, 300), QSize(860, 520)
_VIEWS_SCALE, _PAIR_SCALE = 3, 2


class ReportPictures(QObject):
    """Takes the pictures that the window can show now.

    Signals
    -------
    taken(object, object)
        Pictures as pairs of name and PNG, and why others are missing.
    """

    taken = Signal(object, object)

    def __init__(self, session: Session, window: MainWindow, solid_mode: SolidMode, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._window, self._solid_mode = session, window, solid_mode
        self._steps: Iterator[None] | None = None
        self._timer = QTimer(self, interval=0)
        self._timer.timeout.connect(self._advance)
        self._pictures: list[tuple[str, bytes]] = []
        self._missing: list[str] = []
        self._language = ENGLISH

    @property
    def at_work(self) -> bool:
        """Whether some are being taken."""
        return self._steps is not None

    def take(self, language: str) -> None:
        """Begin, with titles in a language; `taken` comes when all are there."""
        self.stop()
        self._language = language
        self._pictures, self._missing = [], []
        self._steps = self._all()
        self._timer.start()

    def stop(self) -> None:
        """Give up what is being painted."""
        self._timer.stop()
        if self._steps is not None:
            self._steps.close()  # type: ignore[attr-defined]
        self._steps = None

    def _advance(self) -> None:
        assert self._steps is not None
        try:
            next(self._steps)
        except StopIteration:
            self.stop()
            self.taken.emit(tuple(self._pictures), tuple(self._missing))

    def _all(self) -> Iterator[None]:
        from ui.views.appearance import Appearance
        from ui.views.pictures import PictureOptions, painted, stand_in

        grid, bar = self._window.area.grid, self._window.area.color_bar
        if grid is None:
            self._missing.append(noted("the views are not there yet"))
            return
        if self._solid_mode.mode == "flanks":
            copy = stand_in(grid, _VIEWS)
            copy.show_appearance(replace(copy.appearance, ground=Appearance().ground))
            copy.set_theme(False)
            copy.set_titles(self._titles(copy))
            yield from self._one("views", copy, painted(copy, bar, PictureOptions(_VIEWS_SCALE)))
        else:
            self._missing.append(noted("the window shows solids and not the flanks"))
        pair = self._pair()
        if pair is not None:
            options = PictureOptions(_PAIR_SCALE, transparent=True, labels=False, scale_bar=False)
            yield from self._one("pair", pair, painted(pair, None, options))

    def _titles(self, grid: ViewGrid) -> dict[str, tuple[str, str]]:
        """What stands over the views; in another language than the window's titles and deviations alone."""
        from gearstudio.report.language import language, speaking
        from gearstudio.report.view_words import deviation_words, view_title
        from ui.session import Key
        from ui.views.quantities import quantity_of

        session, titles = self._session, {panel.key: (panel.title, panel.subtitle) for panel in grid.panels}
        if self._language == spoken():
            return titles
        is_deviation = quantity_of(grid.appearance).is_deviation
        with speaking(language(self._language)):
            for method in titles:
                result = session.results.get(Key(session.member, method, session.variant))
                words = "" if result is None or not is_deviation else deviation_words(result)
                titles[method] = (view_title(method, session.variant), words)
        return titles

    def _one(self, name: str, copy: ViewGrid, steps: Steps) -> Iterator[None]:
        try:
            while True:
                next(steps)
                yield
        except StopIteration as end:
            self._pictures.append((name, png(end.value)))
        except RuntimeError as error:
            self._missing.append(f"{name}: {error}")
        finally:
            steps.close()
            copy.close_views()
            copy.deleteLater()

    def _pair(self) -> ViewGrid | None:
        """A grid with the pair in mesh, when both solids are there and of this design."""
        from ui.session import Key
        from ui.solid_layers import SolidOptions
        from ui.solid_view import PAIR, SolidView
        from ui.view_grid import ViewGrid
        from ui.views.pictures import lay_out
        from ui.views.still import StillViewport

        session, solids = self._session, self._solid_mode.solids
        keys = [Key(member, session.visible_methods[0], session.variant) for member in PAIR]
        if session.pair is None or not all(solids.is_current(key) for key in keys):
            return None
        made = ViewGrid(make_viewport=StillViewport)
        lay_out(made, _PAIR)
        made.set_theme(False)
        SolidView(made).show(session.pair, keys, solids.built, SolidOptions(), ("", ""))
        made.set_view("pair")
        return made


def png(image: QImage) -> bytes:
    """A picture as PNG."""
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(buffer.data().data())
