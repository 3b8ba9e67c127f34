#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ADIOS2 takes the place of some of Tcl's functions in ParaView's Python, in Debian 13 (ADIOS2 2.10.2, ParaView 5.13.2).
#
# Seen: libadios2_mpi_atl.so.2.10 exports six functions of a hash table of its own by the names that Tcl's have,
# Tcl_DeleteHashEntry among them; its tables are not Tcl's. pvpython is linked to it, through libvtkIOADIOS2, and not to
# Tcl, so that these come first where Tcl is loaded later. libtcl8.6.so calls each of the six through its symbol table
# and thus gets ADIOS2's. One pvpython was seen to end in a segmentation fault in libadios2_mpi_atl's
# Tcl_DeleteHashEntry, called by libtcl8.6's TclCleanupVar. What draws by Tcl and Tk cannot be counted on there.
# libadios2_mpi_atl.so.2.12 (unstable, 2.12.1+dfsg1-4+b1, November 2026) exports the six names too.
#
# Nothing is run: pinned packages are unpacked in a temporary folder (100 MB to fetch), and binutils say what they hold.
# Fails if the behaviour is another.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Packages of Debian 13, unpacked without what they need.
unpack() {
  local apt=$folder/apt
  mkdir -p "$apt"/{lists,archives}/partial
  : >"$apt/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian trixie main" \
    >"$apt/sources"
  cat >"$apt/conf" <<CONF
Dir { State "$apt"; State::status "$apt/status"; Cache "$apt"; Etc { main "/dev/null"; parts "/dev/null";
  preferences "/dev/null"; preferencesparts "/dev/null"; sourcelist "$apt/sources"; sourceparts "/dev/null"; }; };
APT::Sandbox::User "root";
CONF
  APT_CONFIG=$apt/conf apt-get -qq update
  (cd "$apt/archives" && APT_CONFIG=$apt/conf apt-get -qq download "$@")
  for archive in "$apt"/archives/*.deb; do
    dpkg-deb --extract "$archive" "$folder/root"
  done
}

libraries=$folder/root/usr/lib/x86_64-linux-gnu

# The functions with Tcl's names that a library has for others.
exports() {
  nm --dynamic --defined-only "$libraries/$1" | awk '$2 == "T" && $3 ~ /^Tcl_/ { print $3 }' | sort
}

# Those that it calls, though they be its own, as whatever library comes first has them.
calls() {
  readelf --relocs --wide "$libraries/$1" | awk '$3 == "R_X86_64_JUMP_SLOT" && $5 ~ /^Tcl_/ { print $5 }' | sort
}

# How one of the unpacked files comes to need a library: the library, and each file that has the one before loaded.
chain() {
  local needed=$2 file name
  local -a files=("$1")
  local -A by
  while ((${#files[@]})); do
    file=${files[0]}
    files=("${files[@]:1}")
    while read -r name; do
      if [[ ! ${by[$name]+known} ]]; then
        by[$name]=${file##*/}
        [[ ! -e $libraries/$name ]] || files+=("$libraries/$name")
      fi
    done < <(readelf --dynamic --wide "$file" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p')
  done
  echo "$needed"
  while [[ ${by[$needed]+known} ]]; do
    needed=${by[$needed]}
    echo "  for $needed"
  done
}

unpack {paraview,python3-paraview}=5.13.2+dfsg-3 libadios2-mpi-{auxiliary,c++11,core}-2.10=2.10.2+dfsg1-2 \
  libtcl8.6=8.6.16+dfsg-1
{
  chain "$folder/root/usr/bin/pvpython3.13" libadios2_mpi_atl.so.2.10
  comm -12 <(exports libadios2_mpi_atl.so.2.10) <(comm -12 <(exports libtcl8.6.so) <(calls libtcl8.6.so))
} | tee "$folder/seen"
diff "$folder/seen" - <<'EXPECTED'
libadios2_mpi_atl.so.2.10
  for libadios2_mpi_core.so.2.10
  for libadios2_mpi_cxx11_mpi.so.2.10
  for libvtkIOADIOS2-pv5.13.so.1
  for libvtkRemotingApplication-pv5.13.so.1
  for pvpython3.13
Tcl_DeleteHashEntry
Tcl_DeleteHashTable
Tcl_FirstHashEntry
Tcl_HashStats
Tcl_InitHashTable
Tcl_NextHashEntry
EXPECTED
echo "as described"
