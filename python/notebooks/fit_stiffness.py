# %% [markdown]
# # From a first run to the stiffness of a muscle
#
# A segment, its circular muscle, and a record of the pressure in it. Run this from the
# root of the checkout, as a script or, with jupytext, as a notebook.

# %%
import pathlib
import tempfile

import numpy as np

import lumbricus
from lumbricus import Target, Unknown

folder = pathlib.Path(tempfile.mkdtemp())

# %% [markdown]
# ## A case
# The gallery's, on fewer cells, until the muscle has contracted halfway.

# %%
STIFFNESS = "Tissues/circular muscle/Neo-Hooke/a"
case = lumbricus.Case("parameters/antagonism/case.prm", {
    "Geometry/segment chain/Cells around a quarter": 2,
    "Geometry/segment chain/Cells along a segment": 4,
    "Time/End": 0.3, "Time/First step": 0.1, "Time/Largest step": 0.1,
    "Output/Every": 0})
case.parameter(STIFFNESS)

# %% [markdown]
# ## A run

# %%
run = case.run(folder / "run")
print(run.segments[["t", "length", "mid_radius", "fluid_pressure"]])

# %% [markdown]
# ## A record
# Made here by a stiffer muscle, with errors of 1 % of the largest pressure.


# %%
def pressures(run):
    return run.segments["fluid_pressure"].iloc[1:]


made = lumbricus.run(case, folder / "made", settings={STIFFNESS: 0.3})
error = 0.01 * pressures(made).max()
record = pressures(made) + error * np.random.default_rng(1).standard_normal(3)

# %% [markdown]
# ## The stiffness with which the case makes that record

# %%
found = lumbricus.fit(case, [Unknown(STIFFNESS, 0.23, 0.01, 10)],
                      [Target("pressure", pressures, record, error)], folder / "fit")
print(found.report())
low, high = found.intervals(0.99).loc[STIFFNESS]
assert low < 0.3 < high
found.plot().savefig(folder / "fit.png")
