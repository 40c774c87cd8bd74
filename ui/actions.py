"""Every command of the window with its words, shortcut and icon; the menus and the toolbar made of them."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QToolBar

from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS
from ui.formatting import MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES
from ui.mnemonics import separate
from ui.session import ALL
from ui.theme import icon
from ui.words import noted, tr

Keys = QKeySequence.StandardKey
TIP = "gearstudio_tip"
MODES = (
    ("flanks", "Flanks of one tooth", "Alt+1", "view-flank"),
    ("gear", "Whole gear", "Alt+2", "gear"),
    ("pair", "Pair in mesh", "Alt+3", "pair"),
)
VIEW_NAMES = (
    ("tooth", "Tooth", "F2"),
    ("concave", "Concave flank", "F3"),
    ("convex", "Convex flank", "F4"),
    ("iso", "Isometric", "F6"),
    ("front", "Front", "F7"),
    ("back", "Back", "Shift+F7"),
    ("left", "Left", ""),
    ("right", "Right", ""),
    ("top", "From the apex", "F8"),
    ("bottom", "From the heel", "Shift+F8"),
    ("fit", "Fit all", "F9"),
)


@dataclass(frozen=True)
class Command:
    """Words, icon and shortcut of an action."""

    name: str
    text: str
    tip: str = ""
    keys: QKeySequence.StandardKey | str = ""
    icon: str = ""


EDIT = (
    "copy", "copy_any_table", "copy_table", "copy_derived", "",
    "reset_field", "reset_all", "find_field", "", "palette", "preferences",
)  # fmt: skip
COMMANDS = (
    Command("new", "&New", "Start from the default design", Keys.New, "new"),
    Command("new_window", "New &window", "Open another window, with a CAD process of its own", "Ctrl+Shift+N"),
    Command("open", "&Open design…", "Open a design file (.gear.toml)", Keys.Open, "open"),
    Command("save", "&Save", "Save the design", Keys.Save, "save"),
    Command("save_as", "Save &as…", "Save the design under another name", "Ctrl+Shift+S"),
    Command("backups", "&Backups…", "Go back to one of the last saves"),
    Command("recover", "Reco&ver unsaved work…", "Look for edits that a window which ended unexpectedly had not saved"),
    Command("compare_design", "Co&mpare with design…", "Parameters and derived values beside those of another design"),
    Command("export", "&Export…", "Write flanks, teeth, gears or the pair for other programs", "Ctrl+E", "export"),
    Command("report", "&Report…", "Design, data sheets, comparison, maps, contact and equations as a PDF", "Ctrl+P"),
    Command("screenshot", "Pi&cture…", "Save or copy a picture of the views or the window", "F12", "camera"),
    Command("film", "&Film…", "Save a turntable, the pair in mesh or the rolling plane as MP4 or GIF", "Shift+F12"),
    Command(
        "display", "&Display panel", "Colours, surface quality, cameras and ground of the views", "Ctrl+D", "sliders"
    ),
    Command("full_screen", "&Full screen", "The window alone on the screen, and back", "F11"),
    Command("quit", "&Quit", "", Keys.Quit),
    Command("undo", "&Undo", "Take back the last edit", Keys.Undo, "undo"),
    Command("redo", "&Redo", "Do again what was taken back", Keys.Redo, "redo"),
    Command("copy", "&Copy", "Copy what is chosen in a table or text", Keys.Copy),
    Command("copy_any_table", "Copy &table", "Copy the table with the focus, for a spreadsheet", "Ctrl+Shift+C"),
    Command("reset_field", "Reset &field", "Give the field with the cursor its default back", "Ctrl+R"),
    Command("reset_all", "Reset a&ll parameters", "Give every parameter its default back; can be undone"),
    Command("find_field", "&Find a parameter", "Search the parameters by title, symbol or description", Keys.Find),
    Command("copy_table", "Copy co&mparison", "Copy the comparison table as text"),
    Command("copy_derived", "Copy &derived values", "Copy the derived values as text"),
    Command("preferences", "&Preferences…", "Units, theme, language, memory and keys", "Ctrl+,"),
    Command("palette", "Command &palette…", "Find any command or parameter by a few letters", "Ctrl+Shift+P"),
    Command("keys", "&Keys…", "List and change the keys of all commands"),
    Command("what_is_this", "&What is this?", "Explain the parameter with the cursor, or what is clicked", "Shift+F1"),
    Command("show_equation", "&Show equation", "The equation of the parameter or row with the cursor", "Ctrl+F1"),
    Command("build_gear", "Build &gear", "Build the whole gear as a solid and show it", "Ctrl+G"),
    Command("build_pair", "Build &pair", "Build both gears and show them in mesh", "Ctrl+Shift+G"),
    Command("rebuild", "&Rebuild", "Build every variant again", "F5", "rebuild"),
    Command("cancel", "&Cancel", "Stop the work in progress", "Esc", "cancel"),
    Command("restart", "Re&start CAD kernel", "End the CAD process and start a new one"),
    Command("reset_layout", "&Reset layout", "Put every panel back in its place"),
    Command("reset_settings", "&Reset settings…", "Forget layout, lists and preferences; designs stay"),
    Command("guide", "&Guide", "How to use the studio", Keys.HelpContents),
    Command("tour", "&Tour", "Where things are in the window, step by step"),
    Command("glossary", "G&lossary", "The words of the field, as they are used here"),
    Command("equations", "&Equations", "Every formula, what the paper prints, and this design's numbers", "Shift+F2"),
    Command("about", "&About GearStudio", "What this is, and the versions of its parts"),
    Command("diagnostics", "Copy &diagnostics", "Copy versions, design and log for a report"),
)


class Actions(QObject):
    """The window's actions by name, its groups of choices, and its menus."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self._icons: dict[QAction, str] = {}
        self.by_name: dict[str, QAction] = {}
        for command in COMMANDS:
            self.by_name[command.name] = self._make(command)
        self.members = self._choices([(m, MEMBER_TITLES[m], f"Ctrl+Alt+{i}") for i, m in enumerate(MEMBERS, 1)])
        methods = [(ALL, noted("All three"), "Ctrl+1"), *_numbered(METHOD_IDS, METHOD_TITLES)]
        self.methods = self._choices(methods)
        self.variants = self._choices([(v, VARIANT_TITLES[v], f"Ctrl+Shift+{i}") for i, v in enumerate(VARIANTS, 1)])
        self.flanks = self._choices([(f, f"{f.capitalize()} flank", "") for f in ("concave", "convex")])
        self.modes = self._choices([mode[:3] for mode in MODES])
        for action, (_, _, _, name) in zip(self.modes.actions(), MODES, strict=True):
            self._icons[action] = name
            action.setIcon(icon(name))
            show_keys(action)
            action.setIconVisibleInMenu(False)
        check(self.modes, "flanks")
        self.schemes = self._choices(
            [("system", noted("As the system"), ""), ("light", noted("Light"), ""), ("dark", noted("Dark"), "")]
        )
        check(self.flanks, "concave")
        check(self.schemes, "system")
        self.views = self._choices(list(VIEW_NAMES), checkable=False)
        self._name_choices()
        self.presets = QMenu(tr("&Samples"), window)
        self.resets = QMenu(tr("Reset to &sample"), window)
        self.recent = QMenu(tr("Open &recent"), window)
        self.layers = QMenu(tr("&Layers"), window)
        self._build_menus(window)
        for menu in (window.menuBar(), *window.findChildren(QMenu)):
            separate(menu.actions())
        window.addActions(list(self.by_name.values()))
        for group in (self.members, self.methods, self.variants, self.views, self.modes):
            window.addActions(group.actions())

    def __getitem__(self, name: str) -> QAction:
        return self.by_name[name]

    def refresh_icons(self) -> None:
        """Draw the icons in the theme's colours."""
        for action, name in self._icons.items():
            action.setIcon(icon(name))

    def show_selection(self, member: str, method: str, variant: str) -> None:
        """Tick what is shown, without announcing it."""
        for group, chosen in ((self.members, member), (self.methods, method), (self.variants, variant)):
            check(group, chosen)

    def show_mode(self, mode: str) -> None:
        """Tick the mode, without announcing it."""
        check(self.modes, mode)

    def name_step(self, name: str, step: str) -> None:
        """Say which edit would be taken back (`undo`) or done again (`redo`); without one, switch it off."""
        action = self[name]
        word = tr("&Undo") if name == "undo" else tr("&Redo")
        action.setText(f"{word} {step.replace('&', '&&')}" if step else word)
        action.setIconText(word.replace("&", ""))
        show_keys(action, action.text().replace("&&", "&").replace("&", "", 1) if step else "")
        action.setEnabled(bool(step))

    def fill_layers(self) -> None:
        """Make the list of layers, once the views are loaded."""
        from ui.layers import LAYERS

        for info in LAYERS:
            action = self.layers.addAction(tr(info.title))
            action.setData(info.id)
            action.setObjectName(f"layers.{info.id}")
            action.setCheckable(True)

    def show_layers(self, layer_ids: Collection[str]) -> None:
        """Tick the layers that are on, without announcing it."""
        for action in self.layers.actions():
            action.setChecked(action.data() in layer_ids)

    def fill_toolbar(self, toolbar: QToolBar) -> None:
        """Put the usual commands on a toolbar."""
        for name in ("new", "open", "save", "", "undo", "redo", "", "rebuild", "cancel", "", "screenshot", "display"):
            toolbar.addAction(self[name]) if name else toolbar.addSeparator()
        toolbar.addSeparator()
        toolbar.addActions(self.modes.actions())

    def _make(self, command: Command) -> QAction:
        action = QAction(tr(command.text), self)
        if command.keys:
            action.setShortcut(QKeySequence(command.keys))
        action.setObjectName(command.name)
        show_keys(action, tr(command.tip))
        if command.icon:
            self._icons[action] = command.icon
            action.setIcon(icon(command.icon))
        action.setIconVisibleInMenu(False)
        return action

    def _choices(self, rows: list[tuple[str, str, str]], *, checkable: bool = True) -> QActionGroup:
        group = QActionGroup(self)
        for identifier, text, keys in rows:
            action = group.addAction(tr(text))
            action.setData(identifier)
            action.setCheckable(checkable)
            if keys:
                action.setShortcut(QKeySequence(keys))
        return group

    def _name_choices(self) -> None:
        for prefix in ("members", "methods", "variants", "flanks", "modes", "schemes", "views"):
            for action in getattr(self, prefix).actions():
                action.setObjectName(f"{prefix}.{action.data()}")

    def _build_menus(self, window: QMainWindow) -> None:
        bar = window.menuBar()
        start = ("new", "new_window", "open")
        keep = ("", "save", "save_as", "backups", "recover", "", "compare_design", "")
        plan: tuple[tuple[str, tuple[str | QMenu, ...]], ...] = (
            (
                tr("&File"),
                (*start, self.recent, self.presets, *keep, "export", "report", "screenshot", "film", "", "quit"),
            ),
            (tr("&Edit"), ("undo", "redo", "", *EDIT)),
        )
        for title, items in plan:
            _fill(bar.addMenu(title), items, self)
        edit = bar.actions()[1].menu()
        edit.insertMenu(self["find_field"], self.resets)
        view = bar.addMenu(tr("&View"))
        view.addActions(self.modes.actions())
        view.addSeparator()
        view.addMenu(self.layers)
        view.addAction(self["display"])
        _submenu(view, tr("&Generating line on"), self.flanks)
        view.addSeparator()
        view.addActions(self.views.actions())
        view.addSeparator()
        self.panels = view.addMenu(tr("&Panels"))
        _submenu(view, tr("&Theme"), self.schemes)
        view.addAction(self["reset_layout"])
        view.addAction(self["full_screen"])
        model = bar.addMenu(tr("&Model"))
        _fill(model, ("build_gear", "build_pair", "", "rebuild", "cancel", "restart"), self)
        for group in (self.members, self.methods, self.variants):
            model.addSeparator()
            model.addActions(group.actions())
        learn = ("guide", "tour", "glossary", "equations", "", "what_is_this", "show_equation", "keys")
        _fill(bar.addMenu(tr("&Help")), (*learn, "", "about", "diagnostics", "", "reset_settings"), self)


def check(group: QActionGroup, identifier: str) -> None:
    """Tick the choice of a group without announcing it."""
    for action in group.actions():
        if action.data() == identifier:
            action.setChecked(True)


def show_keys(action: QAction, tip: str = "") -> None:
    """Tooltip of an action: what it does (`tip`, or what it said before) and its key."""
    said = tip or action.property(TIP) or action.text().replace("&", "")
    action.setProperty(TIP, said)
    keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
    action.setToolTip(f"{said} ({keys})" if keys else said)
    action.setStatusTip(said)


def _numbered(identifiers: tuple[str, ...], titles: dict[str, str]) -> list[tuple[str, str, str]]:
    return [(identifier, titles[identifier], f"Ctrl+{number}") for number, identifier in enumerate(identifiers, 2)]


def _submenu(menu: QMenu, title: str, group: QActionGroup) -> None:
    menu.addMenu(title).addActions(group.actions())


def _fill(menu: QMenu, items: tuple[str | QMenu, ...], actions: Actions) -> None:
    for item in items:
        if isinstance(item, QMenu):
            menu.addMenu(item)
        elif item:
            menu.addAction(actions[item])
        else:
            menu.addSeparator()
