# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, choices and ports of the proxies: the public contract, written out. Defaults: see filters/contract_test.py."""

import os
import pydoc
import unittest
from pathlib import Path

from paraview import servermanager, simple

import foam.vtkFoamFilters  # lets Python see the filters behind the proxies

REFERENCE = Path(__file__).resolve().parents[1] / "data/evolver-100/foam100_arc.fe"
simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

EQUILIBRATOR = {
    "Equilibrator", "Device", "Tolerance", "MaximumIterations", "LinearSolver", "Sweep", "RootSearch", "EnergyTarget",
    "EnergyDecay", "OrientationInvariant", "Damping", "FiniteDifferenceStep", "JacobianTolerance",
    "PressureTolerance", "PositionTolerance", "MinimumScale", "ChordError",
}
EQUILIBRATOR_CHOICES = {
    "Equilibrator": ["Newton", "Junction"], "Device": ["Auto", "CPU", "CUDA"],
    "LinearSolver": ["Iterative", "Direct"],
    "Sweep": ["Jacobi", "GaussSeidel"], "RootSearch": ["Angles", "Energies"],
    "EnergyTarget": ["Zero", "Straight"],
}
PROXIES = {
    "FoamPoints": {"NumberOfPoints", "Spacing", "Jitter", "Seed"},
    "FoamFromPoints": {"Boundary", "PeriodicBounds", "PeriodVectors", "TargetAreas", "SurfaceTension", "FinSize",
                       "FitAreas", "FoldPoints", "Equilibrate", "Container", "ContainerBounds", "InnerRadius", "WallContact",
                       *EQUILIBRATOR},
    "FoamCoarsen": {"StartFrom", "TargetAreas", "TimeStep", "NumberOfFrames", "Permeability", "T1Length", "T2Area",
                    "Thresholds", "Alpha", "TwoSidedBubbles", "Stepping", "TopologicalAlgorithm", "KeyframeInterval", "KeyframeMemory",
                    *EQUILIBRATOR},
    "FoamDeform": {"StartFrom", "TargetAreas", "Deformation", "StrainStep", "Amplitude", "NumberOfFrames",
                   "KeyframeInterval", "KeyframeMemory", *EQUILIBRATOR},
    "FoamFromLabels": {"Background", "Boundary", "SurfaceTension", "Equilibrate", *EQUILIBRATOR},
    "FoamFromPolygons": {"Boundary", "SurfaceTension", "Equilibrate", *EQUILIBRATOR},
    "FoamEvolverReader": {"Equilibrate", *EQUILIBRATOR},
    "FoamStatistics": {"IncludeBoundary", "ShearModulus"},
    "FoamEnsembleStatistics": {"IncludeBoundary"},
}
OTHER_PROPERTIES = {
    "FoamPoints": set(), "FoamFromPoints": {"Input", "TargetAreaArray", "Walls"},
    "FoamCoarsen": {"Input", "TimestepValues", "StartTime", "StartTimeInForce"}, "FoamStatistics": {"Input"}, "FoamEvolverReader": {"FileName"},
    "FoamDeform": {"Input", "TimestepValues", "StartTime", "StartTimeInForce"},
    "FoamFromLabels": {"Input", "LabelArray"}, "FoamFromPolygons": {"Input"},
    "FoamEnsembleStatistics": {"Input"},
}
CHOICES = {
    "FoamPoints": {},
    "FoamFromPoints": {"Boundary": ["Free", "Periodic", "Fixed", "Container"],
                       "Container": ["Rectangle", "Disc", "Annulus", "Channel", "Outline"],
                       "WallContact": ["Slip", "Pinned"],
                       "TargetAreas": ["Initial", "Uniform", "Array"], **EQUILIBRATOR_CHOICES},
    "FoamCoarsen": {"StartFrom": ["First", "Last"], "TargetAreas": ["FromFilms", "Measured"],
                    "Thresholds": ["Automatic", "Absolute", "Relative"], "TwoSidedBubbles": ["Remove", "Slide"],
                    "Stepping": ["Events", "FixedSteps"],
                    "TopologicalAlgorithm": ["Final", "Original", "Improved", "Simultaneous"],
                    **EQUILIBRATOR_CHOICES},
    "FoamDeform": {"StartFrom": ["First", "Last"], "TargetAreas": ["FromFilms", "Measured"],
                   "Deformation": ["SimpleShear", "PureShear"], **EQUILIBRATOR_CHOICES},
    "FoamEvolverReader": EQUILIBRATOR_CHOICES,
    "FoamFromLabels": {"Boundary": ["Free", "Inner", "Container", "Periodic"], **EQUILIBRATOR_CHOICES},
    "FoamFromPolygons": {"Boundary": ["Free", "Container"], **EQUILIBRATOR_CHOICES},
    "FoamStatistics": {},
    "FoamEnsembleStatistics": {},
}
PORTS = {"FoamPoints": None, "FoamFromPoints": ["Films", "Bubbles"],
         "FoamCoarsen": ["Films", "Bubbles", "Events"], "FoamDeform": ["Films", "Bubbles", "Events"],
         "FoamEvolverReader": ["Films", "Bubbles"],
         "FoamFromLabels": ["Films", "Bubbles"], "FoamFromPolygons": ["Films", "Bubbles"],
         "FoamStatistics": ["Summary", "BySides", "Bubbles", "Distribution"],
         "FoamEnsembleStatistics": None}
SOURCES = {"FoamPoints", "FoamEvolverReader"}
JUNCTION_ONLY = {"TopologicalAlgorithm", "Sweep", "RootSearch", "EnergyDecay", "OrientationInvariant",
                 "Damping", "FiniteDifferenceStep", "JacobianTolerance", "PressureTolerance",
                 "PositionTolerance", "MinimumScale"}


class Proxies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        points = FoamPoints(NumberOfPoints=30)
        foam = FoamFromPoints(Input=points)
        coarsen = FoamCoarsen(Input=foam)
        statistics = FoamStatistics(Input=coarsen)
        members = simple.GroupDatasets(Input=[statistics], OutputType="vtkPartitionedDataSet")
        cls.proxies = {"FoamPoints": points, "FoamFromPoints": foam, "FoamCoarsen": coarsen,
                       "FoamStatistics": statistics, "FoamEnsembleStatistics": FoamEnsembleStatistics(Input=members)}
        cls.proxies["FoamDeform"] = FoamDeform(Input=FoamFromPoints(Input=points, Boundary="Periodic"))
        picture = simple.Wavelet(WholeExtent=[0, 9, 0, 9, 0, 0])
        cls.proxies["FoamFromLabels"] = FoamFromLabels(Input=picture)
        cls.proxies["FoamFromPolygons"] = FoamFromPolygons(Input=simple.Plane(XResolution=3, YResolution=3))
        cls.proxies["FoamEvolverReader"] = simple.OpenDataFile(str(REFERENCE))
        cls.writers = {"FoamSeriesWriter": simple.CreateWriter("series.pvd", coarsen),
                       "FoamEvolverWriter": simple.CreateWriter("foam.fe", coarsen)}

    def test_no_other_properties(self):
        for name, properties in PROXIES.items():
            self.assertEqual(set(self.proxies[name].ListProperties()), properties | OTHER_PROPERTIES[name], name)

    def test_choices(self):
        for name, choices in CHOICES.items():
            for key, entries in choices.items():
                domain = self.proxies[name].GetProperty(key).SMProperty.FindDomain(
                    "vtkSMEnumerationDomain")
                found = [domain.GetEntryText(i) for i in range(domain.GetNumberOfEntries())]
                self.assertEqual(found, entries, (name, key))
                values = [domain.GetEntryValue(i) for i in range(domain.GetNumberOfEntries())]
                filter_class = getattr(foam.vtkFoamFilters, "vtk" + name)
                self.assertEqual(values, [getattr(filter_class, entry) for entry in entries], (name, key))

    def test_series_writer(self):
        writer = self.writers["FoamSeriesWriter"]
        self.assertEqual({name: writer.GetPropertyValue(name) for name in writer.ListProperties()
                          if name not in ("Input", "FileName")}, {"WriteTimeSteps": 1, "Append": 0})

    def test_files_open_and_save_by_their_extensions(self):
        for kind, proxies in (("Reader", self.proxies), ("Writer", self.writers)):
            self.assertEqual(proxies[f"FoamEvolver{kind}"].SMProxy.GetXMLName(), f"FoamEvolver{kind}")
        writers = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
        coarsen = self.proxies["FoamCoarsen"].SMProxy
        types = [writers.GetSupportedFileTypes(coarsen, port) for port in (0, 1)]
        self.assertEqual(["Surface Evolver(*.fe )" in found for found in types], [True, False])

    def test_ports(self):
        for name, ports in PORTS.items():
            proxy = self.proxies[name].SMProxy
            if ports:
                found = [proxy.GetOutputPortName(i) for i in range(proxy.GetNumberOfOutputPorts())]
                self.assertEqual(found, ports, name)

    def test_documentation(self):
        for name, proxy in {**self.proxies, **self.writers}.items():
            text = proxy.SMProxy.GetDocumentation()
            for words in (text.GetDescription(), text.GetShortHelp(), text.GetLongHelp()):
                self.assertGreater(len(words or ""), 15, name)
            for key in proxy.ListProperties():
                documentation = proxy.GetProperty(key).SMProperty.GetDocumentation()
                self.assertGreater(len(documentation.GetDescription() or ""), 15, (name, key))

    def test_ranges_refuse_what_the_filters_refuse(self):
        for name, key in [("FoamPoints", "Spacing"), ("FoamFromPoints", "SurfaceTension"),
                          ("FoamFromPoints", "Tolerance"),
                          ("FoamCoarsen", "Alpha"), ("FoamPoints", "NumberOfPoints"),
                          ("FoamCoarsen", "KeyframeInterval"), ("FoamCoarsen", "MaximumIterations")]:
            prop = self.proxies[name].GetProperty(key).SMProperty
            kind = "vtkSMIntRangeDomain" if prop.IsA("vtkSMIntVectorProperty") else "vtkSMDoubleRangeDomain"
            domain = prop.FindDomain(kind)
            self.assertTrue(domain.GetMinimumExists(0), key)
            self.assertGreater(domain.GetMinimum(0), 0, key)

    def test_inputs_that_make_no_sense_are_greyed_out(self):
        coarsen, points = self.proxies["FoamCoarsen"], self.proxies["FoamPoints"]
        coarsen.UpdatePipeline()
        bubbles = servermanager.OutputPort(coarsen, 1)
        centres = simple.CellCenters(Input=bubbles, VertexCells=1)
        inputs = {"points": points, "sphere": simple.Sphere(), "films": coarsen, "bubbles": bubbles,
                  "centres": centres, "lines": simple.Line()}
        for name, accepted in (("FoamFromPoints", {"points", "sphere", "centres", "lines"}), ("FoamCoarsen", {"films"}),
                               ("FoamDeform", {"films"}),
                               ("FoamStatistics", {"films"})):
            prop = self.proxies[name].GetProperty("Input").SMProperty
            found = set()
            for kind, source in inputs.items():
                source.UpdatePipeline()
                prop.RemoveAllUncheckedProxies()
                prop.AddUncheckedInputConnection(source.SMProxy, source.Port)
                if prop.IsInDomains():
                    found.add(kind)
            prop.RemoveAllUncheckedProxies()
            self.assertEqual(found, accepted, name)

    def test_help(self):
        """Python's help tells of every property."""
        for name, proxy in self.proxies.items():
            text = pydoc.render_doc(type(proxy), renderer=pydoc.plaintext)
            for key in proxy.ListProperties():
                documentation = proxy.GetProperty(key).SMProperty.GetDocumentation().GetDescription()
                self.assertIn(" ".join(documentation.split())[:60], " ".join(text.split()), (name, key))

    def test_menu(self):
        for name, proxy in self.proxies.items():
            if name == "FoamEvolverReader":
                continue  # File > Open has it
            menu = proxy.SMProxy.GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Foam", name)

    def test_properties_that_only_sometimes_matter_are_hidden(self):
        for name in ("FoamFromPoints", "FoamFromLabels", "FoamFromPolygons", "FoamCoarsen", "FoamDeform",
                     "FoamEvolverReader"):
            for key in PROXIES[name]:
                hints = self.proxies[name].GetProperty(key).SMProperty.GetHints()
                decorators = [hints.GetNestedElement(i) for i in range(
                    hints.GetNumberOfNestedElements() if hints else 0)]
                depends = [(d.GetAttribute("property"), d.GetAttribute("value"))
                           for d in decorators if d.GetName() == "PropertyWidgetDecorator"]
                if key in JUNCTION_ONLY:
                    self.assertEqual(depends, [("Equilibrator", "1")], key)
                elif key == "EnergyTarget":
                    self.assertEqual(depends, [("Equilibrator", "1"), ("RootSearch", "1")])
                elif key == "Stepping":
                    self.assertEqual(depends, [("Equilibrator", "0")])
                elif key == "LinearSolver":
                    self.assertEqual(depends, [("Equilibrator", "0"), ("Device", "2")])
                elif key == "Alpha":
                    self.assertEqual(depends, [("Thresholds", "1")])
                elif key in ("T1Length", "T2Area"):
                    self.assertEqual(depends, [("Thresholds", "0")])

    def test_properties_reach_the_filters(self):
        """Every property, set to another value, is there in the VTK object."""
        for name, properties in PROXIES.items():
            proxy = servermanager.CreateProxy("sources" if name in SOURCES else "filters", name)
            proxy.UpdateVTKObjects()
            vtk_object = proxy.GetClientSideObject()
            for key in properties:
                prop = proxy.GetProperty(key)
                value = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
                other = [1 - v if v in (0, 1) else 2 * v for v in value] if key != "Thresholds" else [0]
                for i, v in enumerate(other):
                    prop.SetElement(i, v)
                proxy.UpdateVTKObjects()
                found = getattr(vtk_object, "Get" + key)()
                self.assertEqual(list(found) if isinstance(found, tuple) else [found], other, (name, key))


if __name__ == "__main__":
    unittest.main()
