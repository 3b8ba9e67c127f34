#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A representation with Triangulate on warns at every update of poly data, in ParaView 5.13.2.
#
# Seen: a Sphere, or any source of poly data, whose display has Triangulate = 1 makes vtkRecoverGeometryWireframe warn
# "Couldn't find any cell attribute, passing through the input." when the view updates, and again whenever the source
# has changed. With Triangulate = 0 nothing is said, nor is it for a Wavelet, whose data are an image. Nothing is amiss
# in the sphere: what is looked for are the ids of the cells that facets were made of, which ParaView adds by itself.
# So it was in ParaView 6.1.1 too; 5.11.0 was silent.
#
# Debian 13's packages, pinned and unpacked in a temporary folder (460 MB to fetch); nothing is drawn, and no display
# is needed. Fails if the behaviour is another.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The package and all that it needs, unpacked.
unpack() {
  local package=$1 apt=$folder/apt
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
    dpkg-deb --extract "$archive" "$folder/root"
  done
}

cat >"$folder/triangulate.py" <<'PYTHON'
from paraview import simple

print("ParaView", simple.GetParaViewVersion(), flush=True)
view = simple.CreateView("RenderView")


def update(what):
    print(what, flush=True)
    view.SMProxy.Update()


sphere = simple.Sphere()
display = simple.Show(sphere, view)
display.Representation = "Surface"
update("sphere, Triangulate off")
display.Triangulate = 1
update("sphere, Triangulate on")
sphere.ThetaResolution = 9
update("sphere, changed")
simple.Hide(sphere, view)

wavelet = simple.Wavelet()
display = simple.Show(wavelet, view)
display.Representation = "Surface"
display.Triangulate = 1
update("image, Triangulate on")
PYTHON

# Python and ParaView by the unpacked libraries, the dynamic loader's among them; warnings without when and where.
seen() {
  local root=$folder/root libraries
  libraries=$(find "$root" -name '*.so*' -printf '%h\n' | sort -u | tr '\n' ':')
  HOME=$folder PYTHONHOME=$root/usr PYTHONPATH=$root/usr/lib/python3/dist-packages \
    "$(find "$root" -type f -name 'ld-linux-x86-64.so.2')" --library-path "$libraries" "$root/usr/bin/python3" \
    "$folder/triangulate.py" 2>&1 |
    sed -E "s/.*WARN\| (vtk\w+) \(0x[0-9a-f]+\)(: .*\.).*/\1\2/" | tee "$folder/seen"
}

unpack python3-paraview=5.13.2+dfsg-3
seen
diff "$folder/seen" - <<'EXPECTED'
ParaView (5, 13)
sphere, Triangulate off
sphere, Triangulate on
vtkRecoverGeometryWireframe: Couldn't find any cell attribute, passing through the input.
sphere, changed
vtkRecoverGeometryWireframe: Couldn't find any cell attribute, passing through the input.
image, Triangulate on
EXPECTED
echo "as described"
