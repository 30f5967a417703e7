# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the other scripts: finds the package, the ROS installation and the system's Python.
# shellcheck shell=bash

MBNCC_ROOT="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
MBNCC_BUILD="${MBNCC_BUILD:-$MBNCC_ROOT/build}"

# ROS's Python modules belong to the system's interpreter; another one may precede it on PATH.
export PATH="/usr/bin:$PATH"
export LC_ALL="${LC_ALL:-C.UTF-8}"
# A fresh machine may be unable to resolve its own name.
export ROS_HOSTNAME="${ROS_HOSTNAME:-localhost}"
export ROSCONSOLE_STDOUT_LINE_BUFFERED=1

# Some ROS set-up files read variables that are not set. The caller's options are restored afterwards; a
# subshell that asked for them (set +o) would see errexit as off.
source_leniently() {
  local options="$-"
  set +eu
  # shellcheck disable=SC1090
  . "$1"
  case "$options" in *e*) set -e ;; esac
  case "$options" in *u*) set -u ;; esac
}

if [ -f /opt/ros/noetic/setup.bash ]; then
  source_leniently /opt/ros/noetic/setup.bash
fi

fail() {
  echo "error: $*" >&2
  exit 1
}

# With --help, a script prints the comment at its head and exits.
case " $* " in
  *" -h "* | *" --help "*)
    sed -n '3,/^[^#]/s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
