#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# vtkPolyData::RemoveGhostCells() empties the data set's field data, in the VTK of ParaView 5.11 (9.2.20230111).
#
# Seen: a vtkPolyData of three lines, one of them a ghost, and one field array (a time, say). After RemoveGhostCells()
# two lines are left, and no field array. Where no cell is a ghost the array stays; so does it in a vtkUnstructuredGrid
# of the same lines, and in VTK 9.1.0. Nothing in its documentation says so. Whoever gathers the pieces of several
# processes loses what belongs to the data set as a whole, unless it was copied before.
#
# Debian 12's packages, pinned and unpacked in a temporary folder (400 MB to fetch). Fails if the behaviour is another.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The package and all that it needs, unpacked.
unpack() {
  local name=$1 package=$2
  mkdir -p "$folder/$name/archives/partial"
  : >"$folder/$name/status"
  apt-get -qq -y -o Dir::State::status="$folder/$name/status" -o Dir::Cache::archives="$folder/$name/archives" \
    -o APT::Sandbox::User=root install --download-only --no-install-recommends "$package" >/dev/null
  for archive in "$folder/$name"/archives/*.deb; do
    dpkg-deb --extract "$archive" "$folder/$name/root"
  done
}

cat >"$folder/ghosts.py" <<'PYTHON'
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkUnsignedCharArray, vtkVersion
from vtkmodules.vtkCommonDataModel import VTK_LINE, vtkCellArray, vtkPolyData, vtkUnstructuredGrid


def lines(kind, ghosts):
    points, cells, ghost, time = vtkPoints(), vtkCellArray(), vtkUnsignedCharArray(), vtkDoubleArray()
    for i in range(4):
        points.InsertNextPoint(i, 0, 0)
    ghost.SetName("vtkGhostType")
    for i in range(3):
        cells.InsertNextCell(2, [i, i + 1])
        ghost.InsertNextValue(i in ghosts)
    time.SetName("Time")
    time.InsertNextValue(3.5)
    data = kind()
    data.SetPoints(points)
    if kind is vtkPolyData:
        data.SetLines(cells)
    else:
        data.SetCells(VTK_LINE, cells)
    data.GetCellData().AddArray(ghost)
    data.GetFieldData().AddArray(time)
    return data


print("VTK", vtkVersion.GetVTKVersion())
for kind in (vtkPolyData, vtkUnstructuredGrid):
    for ghosts in ([], [2]):
        data = lines(kind, ghosts)
        data.RemoveGhostCells()
        print(kind.__name__, "ghosts", len(ghosts), "cells", data.GetNumberOfCells(),
              "field arrays", data.GetFieldData().GetNumberOfArrays())
PYTHON

seen() {
  local libraries
  libraries=$(find "$folder/$1/root/usr/lib/x86_64-linux-gnu" -name '*.so*' -printf '%h\n' | sort -u | tr '\n' ':')
  LD_LIBRARY_PATH=$libraries PYTHONPATH=$folder/$1/root/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/ghosts.py" | tee "$folder/$1.seen"
}

# What a package is to print: the VTK that it has, and the field arrays that poly data keep.
expect() {
  local name=$1 package=$2 version=$3 arrays=$4
  unpack "$name" "$package"
  seen "$name"
  diff "$folder/$name.seen" - <<EXPECTED
VTK $version
vtkPolyData ghosts 0 cells 3 field arrays 1
vtkPolyData ghosts 1 cells 2 field arrays $arrays
vtkUnstructuredGrid ghosts 0 cells 3 field arrays 1
vtkUnstructuredGrid ghosts 1 cells 2 field arrays 1
EXPECTED
}

expect paraview python3-paraview=5.11.0+dfsg-1+b1 9.2.20230111 0
expect vtk python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 9.1.0 1
echo "as described"
