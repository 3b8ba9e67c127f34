# SPDX-License-Identifier: GPL-3.0-or-later
"""What is shown without further clicks: bubbles, charts; selections that pass from tables to bubbles."""

import os
import unittest

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())


def tearDownModule():
    simple.Disconnect()  # closes the views before Python ends


CONTROLLER = servermanager.vtkSMParaViewPipelineControllerWithRendering
ROW = 6  # ParaView's number for rows of tables


def output_of(source, port, time=0.0):
    source.SMProxy.UpdatePipeline(time)
    return source.GetClientSideObject().GetOutputDataObject(port)


def column(data, name):
    attributes = data.GetRowData() if data.IsA("vtkTable") else data.GetCellData()
    return vtk_to_numpy(attributes.GetArray(name))


class Displays(unittest.TestCase):
    def setUp(self):
        self.foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=60))
        self.coarsen = FoamCoarsen(Input=self.foam, NumberOfFrames=20)
        self.statistics = FoamStatistics(Input=self.coarsen)
        self.times = list(self.coarsen.TimestepValues)
        self.addCleanup(simple.ResetSession)

    def show(self, source, port, view=None):
        """Shows an output as Apply does; returns its view and its display."""
        source.SMProxy.UpdatePipeline()
        view = CONTROLLER().ShowInPreferredView(source.SMProxy, port, view.SMProxy if view else None)
        if view is None:
            return None, None
        display = view.FindRepresentation(source.SMProxy, port)
        return servermanager._getPyProxy(view), servermanager._getPyProxy(display)


class Bubbles(Displays):
    def test_coloured_by_sides(self):
        view = simple.CreateRenderView()
        for source in (self.foam, self.coarsen):
            _, display = self.show(source, 1, view)
            self.assertEqual(display.SMProxy.GetXMLName(), "FoamBubblesRepresentation")
            self.assertEqual(list(display.ColorArrayName), ["CELLS", "Sides"])
            points = list(display.LookupTable.RGBPoints)
            self.assertEqual((points[0], points[-4]), (3, 9))
        output = output_of(self.coarsen, 1)
        self.assertEqual(output.GetNumberOfCells(), len(column(output, "BubbleId")))

    def test_earlier_bubbles_are_hidden(self):
        view = simple.CreateRenderView()
        simple.SetActiveView(view)
        _, earlier = self.show(self.foam, 1, view)
        self.assertEqual(earlier.Visibility, 1)
        _, later = self.show(self.coarsen, 1, view)
        self.assertEqual((earlier.Visibility, later.Visibility), (0, 1))


class Charts(Displays):
    def check(self, port, kind, shown, titles):
        view, display = self.show(self.statistics, port)
        self.assertEqual(view.SMProxy.GetXMLName(), kind)
        self.assertEqual((view.LeftAxisTitle, view.BottomAxisTitle), titles)
        self.assertEqual((display.UseIndexForXAxis, display.XArrayName), (0, "Sides"))
        simple.Render(view)
        self.assertEqual(sorted(display.SeriesVisibility), shown)

    def test_distribution(self):
        self.check(3, "FoamDistributionView", ["Fraction", "MeasuredFraction"],
                   ("fraction of bubbles p(n)", "sides n"))

    def test_aboav_weaire(self):
        self.check(1, "FoamAboavWeaireView", ["AboavIdeal", "AboavProduct"], ("n m(n)", "sides n"))

    def test_tables(self):
        self.assertEqual(self.show(self.statistics, 0), (None, None))
        view, _ = self.show(self.statistics, 2)
        self.assertEqual(view.SMProxy.GetXMLName(), "SpreadSheetView")


class Selections(Displays):
    def select(self, port, rows):
        self.statistics.SMProxy.UpdatePipeline(0.0)
        pairs = [number for row in rows for number in (0, row)]
        selection = simple.IDSelectionSource(IDs=pairs, FieldType=ROW)
        self.statistics.SMProxy.SetSelectionInput(port, selection.SMProxy, 0)

    def selected(self, time=0.0):
        extracted = self.coarsen.SMProxy.GetSelectionOutput(1)
        if not extracted or not self.coarsen.SMProxy.GetSelectionInput(1):
            return []
        extracted.UpdatePipeline(time)
        return sorted(column(extracted.GetClientSideObject().GetOutputDataObject(0), "BubbleId"))

    def test_rows(self):
        self.select(2, [3, 7, 20])
        ids = column(output_of(self.statistics, 2), "BubbleId")
        self.assertEqual(self.selected(), list(ids[[3, 7, 20]]))

    def test_bars(self):
        """Also at a later time, when other bubbles have so many sides."""
        first = column(output_of(self.statistics, 3), "Sides")[0]
        self.select(3, [5 - first, 7 - first])
        for time in (0.0, self.times[20]):
            bubbles = output_of(self.coarsen, 1, time)
            sides, inside = column(bubbles, "Sides"), column(bubbles, "OnBoundary") == 0
            wanted = ((sides == 5) | (sides == 7)) & inside
            self.assertGreater(wanted.sum(), 3)
            self.assertEqual(self.selected(time), list(column(bubbles, "BubbleId")[wanted]))

    def test_bars_of_a_chart(self):
        """A chart names block, process and row, once for each of its series."""
        self.statistics.SMProxy.UpdatePipeline(0.0)
        parts = [simple.CompositeDataIDSelectionSource(IDs=[1, 0, 2, 1, 0, 3], FieldType=ROW) for _ in "ab"]
        chosen = simple.AppendSelections(Input=parts, SelectionNames=["a", "b"], Expression="a|b")
        self.statistics.SMProxy.SetSelectionInput(3, chosen.SMProxy, 0)
        first = column(output_of(self.statistics, 3), "Sides")[0]
        bubbles = output_of(self.coarsen, 1)
        sides, inside = column(bubbles, "Sides"), column(bubbles, "OnBoundary") == 0
        wanted = ((sides == first + 2) | (sides == first + 3)) & inside
        self.assertEqual(self.selected(), list(column(bubbles, "BubbleId")[wanted]))

    def test_bars_with_the_boundary(self):
        self.statistics.IncludeBoundary = 1
        table = output_of(self.statistics, 3)
        first = column(table, "Sides")[0]
        self.select(3, [5 - first])
        self.assertEqual(len(self.selected()) / 60, column(table, "Fraction")[5 - first])

    def test_cleared(self):
        self.select(2, [3])
        self.statistics.SMProxy.CleanSelectionInputs(2)
        self.assertEqual(self.selected(), [])

    def test_a_selection_made_since_stays(self):
        self.select(2, [3])
        other = simple.IDSelectionSource(IDs=[0, 8], FieldType=0)
        self.coarsen.SMProxy.SetSelectionInput(1, other.SMProxy, 0)
        self.statistics.SMProxy.CleanSelectionInputs(2)
        self.assertEqual(self.selected(), [column(output_of(self.coarsen, 1), "BubbleId")[8]])

    def test_films_without_bubbles(self):
        self.statistics.Input = simple.ForceTime(Input=self.coarsen)
        self.select(2, [3])
        self.assertEqual(self.selected(), [])


class OverTime(Displays):
    def plotted(self, plot):
        plot.UpdatePipeline()
        return plot.GetClientSideObject().GetOutputDataObject(0).GetBlock(0)

    def test_summary(self):
        plot = simple.PlotDataOverTime(Input=servermanager.OutputPort(self.statistics, 0),
                                       FieldAssociation="Rows")
        table = self.plotted(plot)
        self.assertEqual(list(column(table, "avg(Time)")), self.times)
        counts = [(column(output_of(self.coarsen, 1, t), "OnBoundary") == 0).sum() for t in self.times]
        self.assertEqual(list(column(table, "avg(Bubbles)")), counts)

    def test_the_life_of_a_bubble(self):
        """One that vanishes before the end, told by its id from those that move up in its place."""
        last = column(output_of(self.coarsen, 1, self.times[-1]), "BubbleId")
        gone = next(b for b in range(60) if b not in last)
        query = simple.SelectionQuerySource(QueryString=f"(BubbleId == {gone})", ElementType="Cell Data")
        plot = simple.PlotSelectionOverTime(Input=servermanager.OutputPort(self.coarsen, 1),
                                            Selection=query)
        table = self.plotted(plot)
        areas = []
        for time in self.times:
            bubbles = output_of(self.coarsen, 1, time)
            areas += list(column(bubbles, "Area")[column(bubbles, "BubbleId") == gone])
        self.assertTrue(0 < len(areas) < len(self.times))
        alive = column(table, "N") > 0
        self.assertEqual(list(column(table, "avg(Area)")[alive]), areas)


if __name__ == "__main__":
    unittest.main()
