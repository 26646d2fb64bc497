# %% [markdown]
# # First steps
#
# One segment of a worm, from its parameter file to a report and a sweep. Run this from
# the root of the checkout, as a script or, with jupytext, as a notebook; it takes some
# seconds.

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt

import lumbricus

folder = pathlib.Path(tempfile.mkdtemp())

# %% [markdown]
# ## A case
# That of the gallery, on fewer cells. Every value is looked at by the program itself, at
# once: what is wrong is an exception, and the case stays as it was.

# %%
case = lumbricus.Case("parameters/antagonism/case.prm", {
    "Geometry/segment chain/Cells around a quarter": 2,
    "Geometry/segment chain/Cells along a segment": 4,
    "Time/First step": 0.1, "Time/Largest step": 0.1, "Output/Every": 1})
print(case.parameter("Geometry/segment chain/Radius"))
try:
    case["Geometry/segment chain/Radus"] = 2.5
except lumbricus.InputError as error:
    print("Found wrong:", error)
case["Time/End"] = 0.5

# %% [markdown]
# ## A run
# Its tables are pandas.DataFrames. The circular muscle contracts until t = 0.5: the
# segment becomes long and thin, and the liquid keeps its volume.

# %%
run = case.run(folder / "run")
table = run.segments
print(run.tables)
print(table[["t", "length", "mid_radius", "fluid_pressure"]])
assert table["length"].is_monotonic_increasing
change = table["fluid_volume"] / table["fluid_volume"].iloc[0] - 1
assert abs(change).max() < 1e-12

# %%
axes = table.plot("t", ["length", "mid_radius"], style="o-", subplots=True,
                  ylabel="mm", figsize=(5, 4))
plt.savefig(folder / "run.png")

# %% [markdown]
# ## Its fields
# A pyvista.UnstructuredGrid: the points are those at rest, and the displacement is one
# of the fields.

# %%
mesh = run.mesh(0.5)
print(sorted(mesh.point_data))
deformed = mesh.warp_by_vector("displacement")
print(f"x goes to {mesh.bounds[1]:.2f} mm at rest and {deformed.bounds[1]:.2f} mm now")

# %% [markdown]
# ## Longer
# A run goes on from its last checkpoint, with another end: then the circular muscle has
# let go, and the longitudinal one is at its peak.

# %%
run = lumbricus.restart(run.folder, {"Time/End": 1.5})
shortest = run.segments.set_index("t")["length"].idxmin()
print(f"Found the shortest length at t = {shortest:g}.")
assert abs(shortest - 1.5) < 1e-9

# %% [markdown]
# ## A report
# Pictures, numbers, and a scene that is turned with the mouse: one file for the browser.

# %%
report = run.report()
print(report.name, f"{report.stat().st_size / 1e6:.1f} MB")

# %% [markdown]
# ## A sweep
# A run for each value, two at a time. Started again it computes only what is missing.

# %%
case["Output/Every"] = 0
waists = lumbricus.sweep(case, {"Geometry/segment chain/Radius": [1.5, 2, 2.5]},
                         folder / "radii", workers=2)
print(waists[["Geometry/segment chain/Radius", "length", "fluid_pressure_1"]])
waists.plot("Geometry/segment chain/Radius", "fluid_pressure_1", style="o-",
            ylabel="pressure [N/mm²]")
plt.savefig(folder / "radii.png")
# The thinner the tube, the more pressure the same muscle makes.
assert waists["fluid_pressure_1"].is_monotonic_decreasing
