"""The display of the views: remembers how they show things, and connects the panel, the layers and the views."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QStandardPaths, QTimer
from PySide6.QtWidgets import QDockWidget

from ui.views.picks import Picks
from ui.words import tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.presenter import Presenter
    from ui.session import Session
    from ui.solid_mode import SolidMode
    from ui.view_grid import ViewGrid
    from ui.views.appearance import Appearance, LayerLook
    from ui.views.display_panel import DisplayPanel
    from ui.views.motions import Motion

SETTING, OPEN_SETTING = "views/appearance", "views/panel"
_REMEMBER_MS = 400


class Display(QObject):
    """Everything about the views that is no matter of the design."""

    def __init__(
        self, session: Session, window: MainWindow, presenter: Presenter, solid_mode: SolidMode, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._session, self._window = session, window
        self._presenter, self._solid_mode = presenter, solid_mode
        self.panel: DisplayPanel | None = None
        self._grid: ViewGrid | None = None
        self._remember = QTimer(self, singleShot=True, interval=_REMEMBER_MS)
        self._remember.timeout.connect(self._save)
        self.picks = Picks(session, window, solid_mode, self)
        self._action = window.commands["display"]
        self._action.setCheckable(True)
        self._action.setEnabled(False)
        self._action.toggled.connect(self._show_panel)
        window.commands["full_screen"].setCheckable(True)
        window.commands["full_screen"].toggled.connect(self._show_full_screen)
        window.layer_panel.look_changed.connect(self._on_look_changed)
        window.closing.connect(self._save)
        solid_mode.mode_changed.connect(lambda _mode: self._show_scale())

    def views_ready(self) -> None:
        """The window has its views now."""
        from ui.views.appearance import from_text
        from ui.views.display_panel import DisplayPanel

        area, settings = self._window.area, self._window.settings
        assert area.grid is not None and area.color_bar is not None
        self._grid = area.grid
        self.panel = DisplayPanel()
        self.panel.changed.connect(self.show_appearance)
        self.panel.close_wanted.connect(lambda: self._action.setChecked(False))
        self._window.sharing.adopt(self.panel)
        area.grid.visible_changed.connect(self._presenter.redraw_soon)
        self.picks.views_ready()
        self._fill_undock_menu()
        self._action.setEnabled(True)
        if settings is not None:
            self._action.setChecked(settings.value(OPEN_SETTING) in (True, "true"))
            self.show_appearance(from_text(settings.value(SETTING)))

    def _fill_undock_menu(self) -> None:
        """Every panel can stand by itself; where it stands is remembered with the layout."""
        menu = self._window.commands.panels.addMenu(tr("&Undock"))
        for dock in self._window.findChildren(QDockWidget):
            if dock.features() & QDockWidget.DockWidgetFeature.DockWidgetFloatable:
                action = menu.addAction(dock.windowTitle())
                action.setObjectName(f"undock.{dock.objectName()}")
                action.setCheckable(True)
                action.setChecked(dock.isFloating())
                action.toggled.connect(dock.setFloating)
                dock.topLevelChanged.connect(action.setChecked)

    def show_appearance(self, appearance: Appearance) -> None:
        """Show everything so from now on."""
        assert self._grid is not None and self.panel is not None
        self.panel.show_appearance(appearance)
        self._grid.show_appearance(appearance)
        self._show_scale()
        self._window.layer_panel.show_looks(appearance.looks)
        self._presenter.redraw_soon()
        self.picks.show_appearance(appearance)
        self._remember.start()

    def _show_scale(self) -> None:
        """Colours and their scale; those of solids are of the deviation, whatever colours the flanks."""
        from ui import colormap
        from ui.views.quantities import DEVIATION, quantity_of

        bar, grid = self._window.area.color_bar, self._grid
        if bar is None or grid is None:
            return
        looks = grid.appearance
        quantity = quantity_of(looks) if self._solid_mode.mode == "flanks" else DEVIATION
        grid.store.set_colors(colormap.suited(looks.colors, quantity.symmetric), looks.steps)
        bar.show_scale(quantity, looks.colors, looks.steps, looks.unit)

    def take_picture(self) -> None:
        """Ask what kind of picture, and take it."""
        if self._grid is not None:
            from ui.views.picture_dialog import PictureDialog

            PictureDialog(self._window, self._folder()).open()

    def make_film(self) -> None:
        """Ask what moves, and film it."""
        if self._grid is not None:
            from ui.views.film_dialog import FilmDialog

            FilmDialog(self._window, self._folder(), self._motions()).open()

    def _folder(self) -> str:
        return QStandardPaths.writableLocation(QStandardPaths.StandardLocation.PicturesLocation)

    def _motions(self) -> tuple[Motion, ...]:
        from ui.views.motions import meshing, rolling, turntable

        solid, session = self._solid_mode, self._session
        found = [turntable()]
        if solid.mode == "pair" and solid.sight is not None and session.pair is not None and solid.sight.view.gears:
            found.append(meshing(session.pair, solid.sight.view))
        if solid.mode == "flanks" and session.pair is not None:
            found.append(rolling(session.pair.member(session.member), self._presenter.flank))
        return tuple(found)

    def _on_look_changed(self, layer_id: str, look: LayerLook) -> None:
        if self._grid is not None:
            self.show_appearance(self._grid.appearance.with_look(layer_id, look))

    def _show_panel(self, on: bool) -> None:
        self._window.sharing.set_open(on)
        self._remember.start()

    def _show_full_screen(self, on: bool) -> None:
        self._window.showFullScreen() if on else self._window.showNormal()

    def _save(self) -> None:
        self._remember.stop()
        settings = self._window.settings
        if settings is None or self._grid is None:
            return
        from ui.views.appearance import to_text

        settings.setValue(SETTING, to_text(self._grid.appearance))
        settings.setValue(OPEN_SETTING, self._action.isChecked())
