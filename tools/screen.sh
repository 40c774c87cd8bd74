#!/usr/bin/env bash
# Runs a command on a virtual screen of its own with software drawing; where there is no X, on the real one.
set -eu
if ! command -v xvfb-run >/dev/null 2>&1; then exec "$@"; fi
unset WAYLAND_DISPLAY
export QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
exec xvfb-run --auto-servernum --server-args="-screen 0 1600x1000x24 -nolisten tcp" "$@"
