#!/usr/bin/env bash
# Makes this folder ready to run: a Python, the pinned packages in .venv, compiled bytecode, system libraries.
# Usage: tools/bootstrap.sh run|dev|bench|bundle.  Set PYTHON to choose the interpreter. The second time it does nothing.
set -eu
cd "$(dirname "$0")/.."
unset PYTHONDONTWRITEBYTECODE PYTHONHOME PYTHONPATH VIRTUAL_ENV PIP_USER PIP_TARGET PIP_PREFIX PIP_ROOT

kind=${1:-run}
case $kind in
    run) requirements=requirements.txt ;;
    dev | bench | bundle) requirements=requirements-$kind.txt ;;
    *) echo "usage: tools/bootstrap.sh run|dev|bench|bundle" >&2; exit 2 ;;
esac
python=.venv/bin/python
under_way=.venv/under-way # the process that installs; left behind by one that was killed

say() { echo "==> $*"; }
stop() { echo "gearstudio: $*" >&2; exit 1; }
is_root() { [ "${GEARSTUDIO_NO_ROOT:-}" != 1 ] && [ "$(id -u)" = 0 ]; }

apt_install() {
    say "installing system packages: $*"
    apt-get update -qq || say "the package lists could not be refreshed; trying with those at hand"
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null ||
        stop "apt-get could not install them; try by hand: apt-get install $*"
}

# Installs Debian packages as root; otherwise says what to type and stops.
need() {
    local why=$1
    shift
    if ! command -v apt-get >/dev/null 2>&1; then
        stop "$why. On Debian these packages have it: $*. Install what your system calls them, then run make again."
    fi
    is_root || stop "$why. Type this, then run make again:

    sudo apt-get install --no-install-recommends $*
"
    apt_install "$@"
}

usable() { "$1" -c 'import sys; sys.exit(not sys.version_info >= (3, 11))' >/dev/null 2>&1; }
has_venv() { "$1" -c 'import venv, ensurepip' >/dev/null 2>&1; }

interpreters() {
    [ -z "${PYTHON:-}" ] || { echo "$PYTHON"; return; }
    printf '%s\n' python3.11 python3.12 python3.13 python3.14 python3 /usr/bin/python3
    ls -d "${PYENV_ROOT:-${HOME:-}/.pyenv}"/versions/3.1[1-4]*/bin/python3 2>/dev/null || true
    ! command -v uv >/dev/null 2>&1 || uv python find '>=3.11' 2>/dev/null || true
}

# Sets `found` to the first Python 3.11 or later that can make environments.
find_python() {
    local candidate bare=
    found=
    while read -r candidate; do
        usable "$candidate" || continue
        if has_venv "$candidate"; then
            found=$candidate
            return 0
        fi
        bare=${bare:-$candidate}
    done < <(interpreters)
    [ -z "$bare" ] || missing_venv=python$("$bare" -c 'import sys; print("%d.%d" % sys.version_info[:2])')-venv
    return 1
}

choose_python() {
    local missing_venv=
    find_python && return
    [ -z "${PYTHON:-}" ] || [ -n "$missing_venv" ] || stop "PYTHON=$PYTHON is not a Python 3.11 or later"
    if [ -n "$missing_venv" ]; then
        need "this Python cannot make environments" "$missing_venv"
    elif [ "$(uname)" = Darwin ]; then
        stop "Python 3.11 or later is needed. Type this, then run make again:

    brew install python@3.12
"
    else
        need "Python 3.11 or later is needed" python3 python3-venv
    fi
    find_python || stop "this system's Python is older than 3.11. Install a later one, for example with pyenv:

    pyenv install 3.12

then run make again."
}

# Whether the packages of a file (all of them take in requirements.txt) were installed as they are pinned now.
checksum() { cat requirements.txt "$1" tools/bootstrap.sh | cksum; }
installed() { [ "$(cat ".venv/$1.installed" 2>/dev/null)" = "$(checksum "$1")" ]; }

# Whether .venv can be used as it is: its Python runs, nothing stopped half way, and it has pip where that is needed.
works() {
    usable $python && [ ! -e $under_way ] || return 1
    installed $requirements || has_pip || { $python -m ensurepip >/dev/null 2>&1 && has_pip; }
}
has_pip() { $python -m pip --version >/dev/null 2>&1; }

make_environment() {
    local other
    other=$(cat $under_way 2>/dev/null || true)
    if [ -n "$other" ] && kill -0 "$other" 2>/dev/null; then
        stop "process $other is setting up this folder; wait for it. If there is no such set-up, delete .venv."
    fi
    if [ -e .venv ] && ! works; then
        say "removing an environment that does not work, or was left half made"
        rm -rf .venv
    fi
    if [ ! -e .venv ]; then
        choose_python
        say "making .venv with $("$found" --version)"
        mkdir .venv
        echo $$ >$under_way
        "$found" -m venv .venv || stop "the environment could not be made; see above"
        rm $under_way
    fi
}

install_packages() {
    local file=$1
    say "installing the pinned packages of $file into .venv (once, some minutes)"
    echo $$ >$under_way
    trap 'exit 130' INT # before what follows a failure
    $python -m pip install -qq --disable-pip-version-check --no-input --no-compile -r "$file" || {
        rm $under_way
        stop "the packages could not be installed; see above (a network is needed this once)"
    }
    rm $under_way
    say "compiling bytecode"
    $python -m compileall -q -j 0 .venv/lib >/dev/null 2>&1 || true
    checksum "$file" >".venv/$file.installed"
    checksum requirements.txt >.venv/requirements.txt.installed
}

system_libraries() {
    [ "$(uname)" = Linux ] || return 0
    local screen= missing
    if [ "$kind" != run ] || [ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then screen=--screen; fi
    missing=$($python tools/system_libraries.py $screen)
    # shellcheck disable=SC2086 # one word each
    [ -z "$missing" ] || need "the window needs some system libraries" $missing
}

make_environment
system_libraries
installed $requirements || install_packages $requirements
$python -m compileall -q gearstudio ui main.py || true
