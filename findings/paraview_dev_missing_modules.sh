#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Debian 13's paraview-dev (5.13.2+dfsg-3) names Python modules that no package has: find_package(ParaView) fails.
#
# Seen: its CMake files import vtkmodules/vtkCommonCore.so and others, 180 files all told; python3-paraview has each of
# them under another name, vtkCommonCore.cpython-313-x86_64-linux-gnu.so. With both packages and all that they need
# installed find_package(ParaView REQUIRED) ends with CMake's error 'The imported target "VTK::vtkCommonCorePython"
# references the file […] but this file does not exist', also if asked for one component alone, RemotingCore say. In
# Debian 12 (5.11.0) every file is there. In unstable (6.1.1+dfsg1-3, November 2026) VTK's modules are there and
# ParaView's own are not, 45 files, with the same error for vtkRemotingClientServerStreamPython.
#
# Files of pinned packages are compared in a temporary folder (65 MB to fetch). Fails if the behaviour is another.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Packages of a release of Debian, unpacked without what they need.
unpack() {
  local release=$1 apt=$folder/$1/apt
  shift
  mkdir -p "$apt"/{lists,archives}/partial
  : >"$apt/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $release main" \
    >"$apt/sources"
  cat >"$apt/conf" <<CONF
Dir { State "$apt"; State::status "$apt/status"; Cache "$apt"; Etc { main "/dev/null"; parts "/dev/null";
  preferences "/dev/null"; preferencesparts "/dev/null"; sourcelist "$apt/sources"; sourceparts "/dev/null"; }; };
APT::Sandbox::User "root";
CONF
  APT_CONFIG=$apt/conf apt-get -qq update
  (cd "$apt/archives" && APT_CONFIG=$apt/conf apt-get -qq download "$@")
  for archive in "$apt"/archives/*.deb; do
    dpkg-deb --extract "$archive" "$folder/$release/root"
  done
}

# What paraview-dev says that there is of Python's, below /usr, and what of it there is.
seen() {
  local root=$folder/$1/root file stem there=0 missing=0 renamed=0
  while read -r file; do
    stem=$root/usr/${file%.so}
    if [[ -e $stem.so ]]; then
      there=$((there + 1))
    else
      missing=$((missing + 1))
      compgen -G "$stem.cpython-*.so" >/dev/null && renamed=$((renamed + 1))
    fi
  done < <(grep -rhoP 'IMPORTED_LOCATION\w* "\$\{_IMPORT_PREFIX\}/\Klib/python3/[^"]+' "$root"/usr/lib/*/cmake |
    sort -u)
  echo "$1: there $there, missing $missing, of these with another name $renamed" | tee "$folder/$1.seen"
}

# What a release is to print.
expect() {
  local release=$1 version=$2 numbers=$3
  unpack "$release" "paraview-dev=$version" "python3-paraview=$version"
  seen "$release"
  diff "$folder/$release.seen" - <<<"$release: $numbers"
}

expect bookworm 5.11.0+dfsg-1+b1 "there 162, missing 0, of these with another name 0"
expect trixie 5.13.2+dfsg-3 "there 0, missing 180, of these with another name 180"
echo "as described"
