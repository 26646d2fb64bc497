# %% [markdown]
# # How long a wave carries a worm how far
#
# A sweep of the wavelength of the worm that crawls, here with six segments and large
# cells. Run this from the root of the checkout, as a script or, with jupytext, as a
# notebook.

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt

import lumbricus

folder = pathlib.Path(tempfile.mkdtemp())
BEGIN, END = 0.25, 1.25  # one period after the ramp
chain = "Geometry/segment chain/"
case = lumbricus.Case("parameters/crawling/case.prm", {
    f"{chain}Number of segments": 6, f"{chain}Cells along a segment": 2,
    f"{chain}Cells across the liquid": 1, "Time/End": END, "Output/Every": 0})

# %% [markdown]
# ## The sweep
# A wavelength [segments] is set in three muscles, and the setae hold on where it has
# made segments thick. What is asked of each run is the stride in the period [mm] and
# the largest pressure [N/mm²].


# %%
def wave_of(wavelength):
    settings = {f"Muscles/{muscle}/wave/Wavelength": wavelength
                for muscle in ("circular", "longitudinal", "septal")}
    settings["Boundary conditions/ground/contact/Setae"] = (
        f"1 + 5*max(0, sin(2*pi*(t + 0.5 - (s - 1)/{wavelength})))")
    return settings


def outcome(run):
    stride = run.body.set_index("t")["stride"]
    return {"stride": stride[END] - stride[BEGIN],
            "pressure": run.segments["fluid_pressure"].max()}


wavelengths = [3, 6, 9]
table = lumbricus.sweep(case, [wave_of(n) for n in wavelengths], folder / "waves",
                        workers=2, outcome=outcome)
table["wavelength"] = wavelengths
print(table[["wavelength", "stride", "pressure"]])

# %%
axes = table.plot("wavelength", "stride", style="o-", legend=False)
axes.set_xlabel("wavelength [segments]")
axes.set_ylabel("stride in a period [mm]")
plt.savefig(folder / "stride.png")

# %% [markdown]
# The longer the wave the longer the stride, of these six segments at least; what larger
# cells make of it `Output/Errors` says.

# %%
best = table.loc[table["stride"].idxmax()]
print(f"Found the longest stride, {best['stride']:.2f} mm, with {best['wavelength']:.0f} "
      "segments a wave.")
assert best["stride"] > 1.3 * table["stride"][0]
