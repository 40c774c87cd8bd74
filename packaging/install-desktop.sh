#!/bin/sh
# Puts GearStudio into the menu of this user's Linux desktop, and has it open *.gear.toml files.
# Usage: packaging/install-desktop.sh [PROGRAM]    (default: gearstudio, as pipx installs it)
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-gearstudio}
path=$(command -v "$program") || { echo "install-desktop.sh: $program is not installed" >&2; exit 2; }
path=$(cd "$(dirname "$path")" && pwd)/$(basename "$path") # a desktop starts it from elsewhere
share=${XDG_DATA_HOME:-$HOME/.local/share}
mkdir -p "$share/applications" "$share/mime/packages" "$share/icons/hicolor/scalable/apps"
escaped=$(printf '%s' "$path" | sed 's/[\\&|"]/\\&/g')
sed -e "s|^Exec=gearstudio|Exec=\"$escaped\"|" -e "s|^TryExec=gearstudio|TryExec=$escaped|" \
    "$here/gearstudio.desktop" >"$share/applications/gearstudio.desktop"
cp "$here/gearstudio-mime.xml" "$share/mime/packages/gearstudio-mime.xml"
cp "$here/../ui/icons/gearstudio.svg" "$share/icons/hicolor/scalable/apps/gearstudio.svg"
if command -v update-mime-database >/dev/null 2>&1; then update-mime-database "$share/mime"; fi
if command -v update-desktop-database >/dev/null 2>&1; then update-desktop-database "$share/applications"; fi
echo "GearStudio is in the menu and opens *.gear.toml files; to take it out again, delete:
  $share/applications/gearstudio.desktop
  $share/mime/packages/gearstudio-mime.xml
  $share/icons/hicolor/scalable/apps/gearstudio.svg"
