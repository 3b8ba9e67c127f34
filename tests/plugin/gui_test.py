# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView's windows, driven as with the mouse by ParaView's own test player: menus, Apply, charts, time,
Save Data, Save State; and Load State of what was saved."""

import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from paraview import servermanager, simple, smtrace

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())


def tearDownModule():
    simple.Disconnect()  # closes the views before Python ends


MAIN = "pqClientMainWindow"
APPLY = (f"{MAIN}/propertiesDock/propertiesPanel/Accept", "activate", "")
SETTINGS = f"""{{"sources": {{"FoamPoints": {{"NumberOfPoints": 60}}}},
"filters": {{"FoamCoarsen": {{"NumberOfFrames": 5, "TimeStep": {1 / 30!r}}}}}}}"""
NO_WELCOME = "[General]\nGeneralSettings.ShowWelcomeDialog=false\n"


def menu(name, *entries):
    return [(f"{MAIN}/menubar/{name}", "activate", entry) for entry in entries]


def create(name, proxy):
    """Opens the menu first, since from ParaView 5.13 on it is filled only then."""
    return [(f"{MAIN}/menubar", "activate", name), *menu(f"{name}/Foam", proxy), APPLY]


def file_dialog(name, path):
    return (f"{MAIN}/{name}", "filesSelected", str(path))


def play(steps, folder):
    """Starts ParaView with settings of its own and lets it take the steps."""
    settings = folder / ".config/ParaView"
    settings.mkdir(parents=True)
    (settings / "ParaView-UserSettings.json").write_text(SETTINGS)
    version = servermanager.vtkSMProxyManager.GetParaViewSourceVersion().split()[-1]
    for name in (f"ParaView{version}.ini", "ParaView.ini"):  # the second from ParaView 6 on
        (settings / name).write_text(NO_WELCOME)
    events = ElementTree.Element("pqevents")
    for widget, command, arguments in steps:
        ElementTree.SubElement(events, "pqevent", object=widget, command=command, arguments=arguments)
    script = folder / "steps.xml"
    ElementTree.ElementTree(events).write(script)
    environment = {**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / ".config"),
                   "PV_PLUGIN_PATH": str(Path(os.environ["FOAM_PLUGIN"]).parent)}
    return subprocess.run(["paraview", f"--test-script={script}", f"--test-directory={folder}", "--exit"],
                          env=environment, capture_output=True, text=True, check=False, timeout=150)


@unittest.skipIf(servermanager.vtkSMProxyManager.GetVersionMajor() >= 6,
                 "the test player of ParaView 6.1 crashes when it opens these menus")
class Windows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.done = play([
            *create("menuSources", "FoamPoints"),
            *create("menuFilters", "FoamFromPoints"),
            *create("menuFilters", "FoamCoarsen"),
            *menu("menu_File", "actionFileSaveData"),
            file_dialog("FileSaveDialog", cls.folder / "films.pvd"),
            (f"{MAIN}/WriterSettingsDialog/widget/OKButton", "activate", ""),
            *create("menuFilters", "FoamStatistics"),
            (f"{MAIN}/VCRToolbar/actionVCRLastFrame", "activate", ""),
            (f"{MAIN}/VCRToolbar/actionVCRPreviousFrame", "activate", ""),
            *menu("menu_File", "actionFileSaveServerState"),
            file_dialog("FileSaveServerStateDialog", cls.folder / "state.pvsm"),
        ], cls.folder)
        state = cls.folder / "state.pvsm"
        cls.state = ElementTree.parse(state).getroot() if state.exists() else None

    def proxies(self, kind):
        return self.state.findall(f".//Proxy[@type='{kind}']")

    def value(self, proxy, name):
        return float(proxy.find(f"./Property[@name='{name}']/Element").get("value"))

    def test_every_step_was_taken(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_saved_series(self):
        times = [float(e.get("timestep")) for e in
                 ElementTree.parse(self.folder / "films.pvd").getroot().iter("DataSet")]
        self.assertEqual(times, [k * (1 / 30) for k in range(6)])
        self.assertEqual(len(list((self.folder / "films").glob("*.vtp"))), 6)

    def test_pipeline(self):
        for name in ("FoamPoints", "FoamFromPoints", "FoamCoarsen", "FoamStatistics"):
            self.assertEqual(len(self.proxies(name)), 1, name)
        self.assertEqual(self.value(self.proxies("FoamPoints")[0], "NumberOfPoints"), 60)

    def test_charts_and_table_have_opened(self):
        for view in ("FoamDistributionView", "FoamAboavWeaireView", "SpreadSheetView", "RenderView"):
            self.assertEqual(len(self.proxies(view)), 1, view)
        for chart in ("FoamDistributionRepresentation", "FoamAboavWeaireRepresentation"):
            (proxy,) = self.proxies(chart)
            self.assertEqual(self.value(proxy, "Visibility"), 1)

    def test_only_the_last_bubbles_are_shown(self):
        shown = [self.value(proxy, "Visibility") for proxy in self.proxies("FoamBubblesRepresentation")]
        self.assertEqual(shown, [0, 1])

    def test_time(self):
        (keeper,) = self.proxies("TimeKeeper")
        self.assertEqual(self.value(keeper, "Time"), 4 * (1 / 30))

    def test_load_state(self):
        simple.ResetSession()
        simple.LoadState(str(self.folder / "state.pvsm"))
        simple.RenderAllViews()
        (coarsen,) = (source for source in simple.GetSources().values()
                      if source.SMProxy.GetXMLName() == "FoamCoarsen")
        films = coarsen.GetClientSideObject().GetOutputDataObject(0)
        self.assertEqual(films.GetFieldData().GetArray("TimeValue").GetValue(0),
                         simple.GetTimeKeeper().Time)
        self.assertEqual(coarsen.NumberOfFrames, 5)
        simple.ResetSession()


class Trace(unittest.TestCase):
    def test_recorded_script_runs(self):
        """The trace of a session is a script that makes the same foam and shows it the same way."""
        simple.ResetSession()
        smtrace.start_trace()
        points = FoamPoints(NumberOfPoints=40)
        foam = FoamFromPoints(Input=points, Boundary="Periodic")
        coarsen = FoamCoarsen(Input=foam, NumberOfFrames=3, Thresholds="Relative")
        view = simple.CreateRenderView()
        simple.Show(simple.OutputPort(coarsen, 1), view)
        script = smtrace.stop_trace()
        simple.ResetSession()

        found = {}
        exec(script, found)  # names are those that the trace gives
        self.assertEqual(found["foamFromPoints1"].Boundary, "Periodic")
        self.assertEqual(found["foamCoarsen1"].Thresholds, "Relative")
        found["foamCoarsen1"].UpdatePipeline(0.1)
        self.assertEqual(found["foamCoarsen1"].GetDataInformation(1).GetNumberOfCells(), 40)
        (display,) = found["renderView1"].Representations
        self.assertEqual(display.SMProxy.GetXMLName(), "FoamBubblesRepresentation")
        self.assertEqual(list(display.ColorArrayName), ["CELLS", "Sides"])
        simple.ResetSession()


if __name__ == "__main__":
    unittest.main()
