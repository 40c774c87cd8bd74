"""Pictures of the views for the report, painted piece by piece so that the window stays awake."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QObject, QSize, QTimer, Signal
from PySide6.QtGui import QImage

from ui.words import tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.session import Session
    from ui.solid_mode import SolidMode
    from ui.view_grid import ViewGrid
    from ui.views.pictures import Steps

_VIEWS, _PAIR = QSize(980, 460), QSize(860, 520)
_SCALE = 2


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

    def take(self) -> None:
        """Begin; `taken` comes when all are there."""
        self.stop()
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
        from ui.views.pictures import PictureOptions, painted, stand_in

        grid, bar = self._window.area.grid, self._window.area.color_bar
        if grid is None:
            self._missing.append(tr("the views are not there yet"))
            return
        if self._solid_mode.mode == "flanks":
            copy = stand_in(grid, _VIEWS)
            yield from self._one("views", copy, painted(copy, bar, PictureOptions(_SCALE)))
        else:
            self._missing.append(tr("views: the window shows solids and not the flanks"))
        pair = self._pair()
        if pair is not None:
            options = PictureOptions(_SCALE, transparent=True, labels=False, scale_bar=False)
            yield from self._one("pair", pair, painted(pair, None, options))

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
