# SPDX-License-Identifier: LGPL-2.1-or-later
"""A septum in a ring that contracts buckles as a clamped plate does, and the run goes on
along that branch."""
import re
import sys

import numpy as np
import pytest
from lumbricus_run import SOURCE, run_well

CASE = SOURCE / "parameters" / "septum_buckles"
sys.path.insert(0, str(CASE))

from plate import THICKNESS, amplitude, critical_strain, steps  # noqa: E402
from septum import make_septum, write_msh  # noqa: E402

SETTINGS = [f"Geometry/mesh file/File={CASE / 'septum.msh'}", "Output/Every=0"]


def test_the_mesh_is_what_its_script_makes(tmp_path):
    write_msh(tmp_path / "septum.msh", *make_septum())
    assert (tmp_path / "septum.msh").read_text() == (CASE / "septum.msh").read_text()


def test_it_buckles_as_a_clamped_plate(tmp_path):
    result = run_well(CASE / "case.prm", tmp_path, SETTINGS)
    times = re.findall(r"another branch begins at the time ([0-9.]+)", result.log)
    time, strain, aside = steps(tmp_path)
    found = np.interp(float(times[0]), time, strain)
    assert len(times) == 1
    # 14.68 D/a^2, with shear and without.
    assert 1.5 * critical_strain(False) == pytest.approx(
        14.682 / 12 * (THICKNESS / 2)**2, rel=1e-4)
    assert found == pytest.approx(critical_strain(), rel=4e-3)
    assert found == pytest.approx(critical_strain(False), rel=0.02)
    on_it = strain > 1.1 * critical_strain()
    assert on_it.sum() > 4 and aside[on_it][-1] > 3 * THICKNESS
    assert aside[strain < 0.95 * found].max() < 1e-9
    assert aside[on_it] == pytest.approx(amplitude(strain[on_it]), rel=0.02)
