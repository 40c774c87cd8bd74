#!/usr/bin/env bash
# Opens the window on the default design; without a display it makes a picture and the comparison in out/.
set -eu
cd "$(dirname "$0")/.."
python=.venv/bin/python

if [ "$(uname)" != Linux ] || [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec $python main.py
fi

echo "There is no display here: GearStudio opens its window on a virtual one, takes a picture and closes."
mkdir -p out
tools/screen.sh $python main.py --demo out
$python main.py compare preset:default --member both --json out/compare.json >out/compare.txt
cat out/compare.txt
echo
printf 'The window:      %s\nThe comparison:  %s\nThe same, JSON:  %s\n' \
    "$PWD/out/gearstudio.png" "$PWD/out/compare.txt" "$PWD/out/compare.json"
