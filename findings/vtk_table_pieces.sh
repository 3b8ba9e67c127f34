#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# An algorithm that makes a vtkTable gives the old piece again when it is asked for another one, in the VTK of ParaView
# 5.13 (9.3.20240617).
#
# Seen: a sphere of seven segments has 32 points in piece 1 of 2 and 26 in piece 0. UpdatePiece(1, 2, 0) and then
# UpdatePiece(0, 2, 0) of a vtkDataObjectToTable behind it give 32 rows and 32 rows again; a vtkElevationFilter in its
# place gives 32 points and then 26. In VTK 9.3.0 both do. Another number of pieces is noticed. Whoever writes a table
# piece by piece, or sums one up, gets the first piece every time.
#
# So it was in ParaView 6.1.1 (VTK 9.6.2) too, and not in 5.11.0 (9.2.20230111). VTK's source of August 2026 asks which
# piece the data are only if vtkDataObject::SupportsGhostArray() says yes (vtkStreamingDemandDrivenPipeline), which it
# does not for tables, graphs and selections. The release notes do not speak of it.
#
# Debian 13's packages, pinned and unpacked in a temporary folder (660 MB to fetch). Fails if the behaviour is another.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The package of Debian 13 and all that it needs, unpacked.
unpack() {
  local name=$1 package=$2 apt=$folder/$1/apt
  mkdir -p "$apt"/{lists,archives}/partial
  : >"$apt/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian trixie main" \
    >"$apt/sources"
  cat >"$apt/conf" <<CONF
Dir { State "$apt"; State::status "$apt/status"; Cache "$apt"; Etc { main "/dev/null"; parts "/dev/null";
  preferences "/dev/null"; preferencesparts "/dev/null"; sourcelist "$apt/sources"; sourceparts "/dev/null"; }; };
APT { Sandbox::User "root"; Install-Recommends "false"; };
CONF
  APT_CONFIG=$apt/conf apt-get -qq update
  APT_CONFIG=$apt/conf apt-get -qq -y install --download-only "$package" >/dev/null
  for archive in "$apt"/archives/*.deb; do
    dpkg-deb --extract "$archive" "$folder/$name/root"
  done
}

cat >"$folder/pieces.py" <<'PYTHON'
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkInfovisCore import vtkDataObjectToTable

print("VTK", vtkVersion.GetVTKVersion())


def numbers(algorithm, count, pieces):
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(7)
    algorithm.SetInputConnection(sphere.GetOutputPort())
    for piece, of in pieces:
        algorithm.UpdatePiece(piece, of, 0)
        yield count(algorithm.GetOutput())


to_table = vtkDataObjectToTable()
to_table.SetFieldType(vtkDataObjectToTable.POINT_DATA)
again = [(1, 2), (0, 2)]
print("poly data", *numbers(vtkElevationFilter(), lambda output: output.GetNumberOfPoints(), again))
print("table", *numbers(to_table, lambda output: output.GetNumberOfRows(), again))
print("table of one piece", *numbers(to_table, lambda output: output.GetNumberOfRows(), [(0, 1)]))
PYTHON

# Python and VTK by the unpacked libraries, the dynamic loader's among them.
seen() {
  local root=$folder/$1/root libraries
  libraries=$(find "$root" -name '*.so*' -printf '%h\n' | sort -u | tr '\n' ':')
  PYTHONHOME=$root/usr PYTHONPATH=$root/usr/lib/python3/dist-packages PYTHONWARNINGS=ignore \
    "$(find "$root" -type f -name 'ld-linux-x86-64.so.2')" --library-path "$libraries" "$root/usr/bin/python3" \
    "$folder/pieces.py" | tee "$folder/$1.seen"
}

# What a package is to print: the VTK that it has, and the rows of the second piece.
expect() {
  local name=$1 package=$2 version=$3 rows=$4
  unpack "$name" "$package"
  seen "$name"
  diff "$folder/$name.seen" - <<EXPECTED
VTK $version
poly data 32 26
table 32 $rows
table of one piece 44
EXPECTED
}

expect vtk python3-vtk9=9.3.0+dfsg1-4+b1 9.3.0 26
expect paraview python3-paraview=5.13.2+dfsg-3 9.3.20240617 32
echo "as described"
