#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A dump of Surface Evolver 2.70 does not keep DISPLAY_ORIGIN, which says where the cell of a torus lies.
#
# Seen: a datafile with DISPLAY_ORIGIN 3.5 4.25 is read, and `print display_origin[1]` gives 3.5 then; its dump has no
# display_origin, and once that is read back it is an identifier that Evolver does not know. Lengths, areas and wraps are as before. Whoever
# exchanges tori as dumps finds them shifted against what they came from, and in other images of the cell.
#
# Debian 12's package, pinned (evolver 2.70+ds-8), unpacked in a temporary folder. Fails if the behaviour is another.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

mkdir -p apt/{lists,archives}/partial
: >apt/status
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm main" >apt/sources
cat >apt/conf <<CONF
Dir { State "$folder/apt"; State::status "$folder/apt/status"; Cache "$folder/apt"; Etc { main "/dev/null";
  parts "/dev/null"; preferences "/dev/null"; preferencesparts "/dev/null"; sourcelist "$folder/apt/sources";
  sourceparts "/dev/null"; }; };
APT { Sandbox::User "root"; Install-Recommends "false"; };
CONF
APT_CONFIG=$folder/apt/conf apt-get -qq update
APT_CONFIG=$folder/apt/conf apt-get -qq -y install --download-only evolver=2.70+ds-8 >/dev/null
for archive in apt/archives/*.deb; do
  dpkg-deb --extract "$archive" root
done

cat >torus.fe <<'DATAFILE'
STRING
SPACE_DIMENSION 2
TORUS
DISPLAY_ORIGIN 3.5 4.25
PERIODS
2 0
0 2

vertices
1 4 5
2 5 5.5

edges
1 1 2 * *
2 2 1 + *
3 2 1 * +
DATAFILE

# What Evolver prints for the first coordinate of the origin of a file, which it dumps then.
origin() {
  printf 'print display_origin[1]\ndump "%s.dmp"\nq\nq\n' "$1" |
    LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu:root/lib/x86_64-linux-gnu root/usr/bin/evolver-nox-d "$1" 2>&1 |
    grep --extended-regexp '^ +[-0-9.e]+$' | head -n 1 | tr -d ' '
}

first=$(origin torus.fe)
again=$(origin torus.fe.dmp || true)
kept=$(grep --ignore-case --count display_origin torus.fe.dmp || true)
echo "Surface Evolver 2.70: display_origin $first, in the dump $kept times, after reading it back ${again:-not known}"
[[ $first == 3.5 && $kept == 0 && -z $again ]]
