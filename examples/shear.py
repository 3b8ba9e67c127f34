# SPDX-License-Identifier: GPL-3.0-or-later
"""Shears a foam: its modulus, how it yields and flows, and where its T1s are.

    pvpython examples/shear.py [--bubbles 400] [--strain 3] [--step 0.02] [--amplitude 0]

A periodic foam is sheared quasi-statically, steadily or, with an amplitude, to and fro. Stresses are in units of the
films' tension over √⟨A⟩. The picture has the foam at the end, its bubbles coloured by their shear stress, and a dot
for each T1 of the last tenth of the way.
"""
from foam_plugin import *


def main():
    options = read_options(__doc__, "output/shear", bubbles=400, strain=3.0, step=0.02, amplitude=0.0)
    foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=options.bubbles), Boundary="Periodic", TargetAreas="Uniform")
    frames = round(options.strain / options.step)
    deform = FoamDeform(Input=foam, StrainStep=options.step, NumberOfFrames=frames, Amplitude=options.amplitude)
    modulus = first_row(FoamStatistics(Input=foam, ShearModulus=1))["ShearModulus"]
    statistics = FoamStatistics(Input=deform)
    rows = [first_row(statistics, time) for time in deform.TimestepValues]

    unit = 2 * foam.SurfaceTension / np.sqrt(rows[0]["MeanArea"])
    way, strain, stress, normal, energy, swaps = np.array([
        (row["Time"], row["Strain"], row["StressXY"], row["NormalStressDifference"], row["Energy"], row["T1Count"])
        for row in rows]).T
    flowing = way > way[-1] / 2
    rate = np.ptp(swaps[flowing]) / np.ptp(way[flowing]) / options.bubbles
    print(f"modulus {modulus / unit:.3f}; in the second half of the way: shear stress "
          f"{stress[flowing].mean() / unit:.3f}, normal stress difference {normal[flowing].mean() / unit:.3f}, "
          f"{rate:.2f} T1s a bubble and unit of strain")

    figure, (curve, film) = plt.subplots(2, 1, figsize=(6.4, 6), dpi=150, layout="constrained", sharex=True)
    curve.axline((strain[0], stress[0] / unit), slope=modulus / unit, color="0.75", lw=1, zorder=0)
    curve.plot(strain, stress / unit, color="#1f4e8c", label="shear stress")
    curve.plot(strain, normal / unit, color="#c8553d", label="normal stress difference")
    curve.set(ylabel="stress / (T/√⟨A⟩)", ylim=(min(0, *stress / unit) - 0.05, 1.25 * max(*stress, *normal) / unit))
    curve.legend(frameon=False, loc="upper left", ncols=2)
    film.plot(strain, energy / energy[0], color="#1f4e8c")
    film.set(xlabel="strain", ylabel="energy / its first")
    for axes in (curve, film):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(options.output / "stress.png")
    write_table(options.output / "shear.csv", rows)

    view = view_of(deform, 900)
    view.ViewTime = way[-1]
    bubbles = Show(OutputPort(deform, 1), view)
    ColorBy(bubbles, ("CELLS", "Stress", "XY"))
    late = Threshold(Input=OutputPort(deform, 2), Scalars=["POINTS", "Time"], LowerThreshold=0.9 * way[-1],
                     UpperThreshold=way[-1])
    Show(late, view, Representation="Point Gaussian", GaussianRadius=0.1, ShaderPreset="Plain circle",
         ColorArrayName=[None, ""], AmbientColor=[0.1, 0.6, 0.2], DiffuseColor=[0.1, 0.6, 0.2])
    ResetCamera(view)
    SaveScreenshot(str(options.output / "foam.png"), view)
    print(f"Curves, table and picture are in {options.output}/")


if __name__ == "__main__":
    run(main)
