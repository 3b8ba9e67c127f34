# SPDX-License-Identifier: GPL-3.0-or-later
"""Ensembles: what is pooled is what the members have, with intervals that hold the truth as often as they say."""

import unittest

import numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet, vtkPolyData, vtkTable, vtkUnstructuredGrid

from foam.vtkFoamFilters import vtkFoamEnsembleStatistics, vtkFoamStatistics
from foam_testing import Messages, copy, foam_of_points

T_OF_2 = 4.302653  # Student's t for two degrees of freedom and 95 %, from tables


def table_of(**columns):
    table = vtkTable()
    for name, values in columns.items():
        array = vtkIntArray() if name == "Sides" else vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        table.AddColumn(array)
    return table


def pooled(*members, **properties):
    """The rows of the result, by quantity and sides, and the errors."""
    data = vtkPartitionedDataSet()
    data.SetNumberOfPartitions(len(members))
    for i, member in enumerate(members):
        if member:
            data.SetPartition(i, member)
    ensemble = vtkFoamEnsembleStatistics()
    messages = Messages(ensemble)
    for name, value in properties.items():
        getattr(ensemble, "Set" + name)(value)
    ensemble.SetInputDataObject(data)
    ensemble.Update()
    output = ensemble.GetOutput()
    rows = {}
    for i in range(output.GetNumberOfRows()):
        name, sides, *numbers = [output.GetValue(i, k) for k in range(output.GetNumberOfColumns())]
        rows[name.ToString(), sides.ToInt()] = [number.ToDouble() for number in numbers]
    return rows, messages.errors


def measured(seed, port):
    foam = foam_of_points(60, periodic=True)
    foam.GetInputAlgorithm().SetSeed(seed)
    statistics = vtkFoamStatistics()
    statistics.SetInputConnection(foam.GetOutputPort(0))
    statistics.Update()
    return copy(statistics.GetOutput(port)), copy(foam.GetOutput(0))


class Pooling(unittest.TestCase):
    def test_by_hand(self):
        """1, 2, 6: mean 3, s² = 7, standard error √(7/3)."""
        rows, errors = pooled(*(table_of(Mu2=[x]) for x in (1, 2, 6)))
        self.assertEqual(errors, [])
        error = numpy.sqrt(7 / 3)
        numpy.testing.assert_allclose(
            rows["Mu2", 0], [3, 3, error, 3 - T_OF_2 * error, 3 + T_OF_2 * error], rtol=1e-6)

    def test_numbers_of_sides_that_some_do_not_have(self):
        rows, _ = pooled(table_of(Sides=[5, 6], Count=[2, 2], Fraction=[0.5, 0.5], MeanArea=[0.8, 1.2]),
                         table_of(Sides=[6], Count=[3], Fraction=[1], MeanArea=[1]), table_of(Mu2=[1]))
        self.assertEqual(rows["Fraction", 5][:2], [2, 0.25])  # none of them in one, of two that were asked
        self.assertEqual(rows["Count", 5][:2], [2, 1])
        self.assertEqual(rows["MeanArea", 5][:2], [1, 0.8])  # the other knows nothing of it
        self.assertTrue(numpy.isnan(rows["MeanArea", 5][2:]).all())
        self.assertEqual(rows["Mu2", 0][:2], [1, 1])
        self.assertAlmostEqual(sum(row[1] for (name, _), row in rows.items() if name == "Fraction"), 1, places=15)

    def test_films_are_measured_as_statistics_does(self):
        seeds = range(1, 5)
        films, _ = pooled(*(measured(seed, 0)[1] for seed in seeds))
        summaries, _ = pooled(*(measured(seed, 0)[0] for seed in seeds))
        by_sides, _ = pooled(*(measured(seed, 1)[0] for seed in seeds))
        self.assertEqual(films.keys(), summaries.keys() | by_sides.keys())
        for key, row in films.items():
            numpy.testing.assert_equal(row, {**summaries, **by_sides}[key], str(key))
        mu2 = [measured(seed, 0)[0].GetColumnByName("Mu2").GetValue(0) for seed in seeds]
        self.assertEqual(len(set(mu2)), 4)
        numpy.testing.assert_allclose(films["Mu2", 0][:3], [4, numpy.mean(mu2), numpy.std(mu2, ddof=1) / 2])
        self.assertEqual(films["MeanSides", 0][1:3], [6, 0])

    def test_boundary(self):
        foam = foam_of_points(60)
        foam.Update()
        inner, _ = pooled(foam.GetOutput(0))
        whole, _ = pooled(foam.GetOutput(0), IncludeBoundary=True)
        self.assertEqual(whole["Bubbles", 0][1], 60)
        self.assertLess(inner["Bubbles", 0][1], 60)

    def test_intervals_hold_the_truth_as_often_as_they_say(self):
        random, runs, held = numpy.random.default_rng(1), 400, 0
        for _ in range(runs):
            rows, _ = pooled(*(table_of(X=[x]) for x in random.normal(7, 2, 5)))
            held += rows["X", 0][3] < 7 < rows["X", 0][4]
        self.assertAlmostEqual(held / runs, 0.95, delta=3 * numpy.sqrt(0.95 * 0.05 / runs))

    def test_what_is_empty_is_no_member(self):
        rows, errors = pooled(None, vtkTable(), vtkPolyData(), table_of(Mu2=[2]))
        self.assertEqual(errors, [])
        self.assertEqual(rows["Mu2", 0][:2], [1, 2])
        self.assertEqual(pooled(), ({}, []))

    def test_values_that_are_not_numbers(self):
        words = vtkStringArray()
        words.SetName("Remark")
        words.InsertNextValue("words")
        table = table_of(Mu2=[2], AboavA=[float("nan")])
        table.AddColumn(words)
        self.assertEqual(list(pooled(table)[0]), [("Mu2", 0)])

    def test_bad_members(self):
        for member, words in ((table_of(Mu2=[1, 2]), "2 rows"), (vtkUnstructuredGrid(), "vtkUnstructuredGrid")):
            rows, errors = pooled(table_of(Mu2=[1]), member)
            self.assertEqual(rows, {})
            self.assertEqual(len(errors), 1)
            self.assertIn(words, errors[0])


if __name__ == "__main__":
    unittest.main()
