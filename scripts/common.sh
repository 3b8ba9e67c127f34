# SPDX-License-Identifier: GPL-3.0-or-later
# What run and test share; sourced by them. FOAM_PRESET chooses another preset than release.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${FOAM_PRESET:-release}
build=$root/build/$preset

# build_foam [TARGET…]: configures only if there is no build yet, since ninja configures again when a
# CMake file has changed.
build_foam() {
  if [[ ! -e $build/build.ninja ]]; then
    (cd "$root" && cmake --preset "$preset")
  fi
  cmake --build "$build" --parallel "$(nproc)" --target "${@:-all}"
}

# Runs a command with a display of its own: rendering needs one, and one that is there may not do (ssh,
# no OpenGL). Xvfb chooses the number itself, which xvfb-run's way of looking for a free one does not
# get right when several start at once.
with_display() (
  number=$(mktemp)
  Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset 3>"$number" >/dev/null 2>&1 &
  server=$!
  trap 'kill "$server" 2>/dev/null; rm "$number"' EXIT
  while [[ ! -s $number ]]; do
    if ! kill -0 "$server" 2>/dev/null; then
      echo "Xvfb, the display to render on, does not start" >&2
      exit 1
    fi
    sleep 0.05
  done
  DISPLAY=:$(<"$number") "$@"
)
