# SPDX-License-Identifier: LGPL-2.1-or-later
"""lumbricus-plot draws a shape that it has never heard of: from run.json it
knows how the whole body comes from a quarter, and which tissue is no liquid."""
import importlib.util
import sys

from lumbricus_run import SOURCE

sys.path.insert(0, str(SOURCE / "python" / "src"))


def check_pictures(folder):
    """Of the runs of twitch.prm in twitch/ and, of a quarter of it, quarter/."""
    if importlib.util.find_spec("pyvista") is None:
        print("The bar is not drawn: pyvista is missing.")
        return
    # They need packages that a machine without pictures does not have.
    import numpy as np
    from PIL import Image
    from lumbricus.plot.command import main
    from lumbricus.plot.fields import read_grid
    from lumbricus.plot.run_folder import RunFolder

    images = []
    for name, n_mirrors in (("twitch", 0), ("quarter", 2)):
        run = RunFolder(folder / name)
        assert len(run.body.mirrors) == n_mirrors
        assert not run.body.liquid_tissues
        grid = read_grid(run.series[0][1])
        points, nodes, _ = run.body.whole(grid)
        assert len(nodes) == 8 * 2 * 2
        # Half as wide as the head on all sides, as long as it is.
        assert np.allclose(points.min(axis=0), [0, -1, -1])
        assert np.allclose(points.max(axis=0), [10, 1, 1])
        # The quarter that faces the viewer is left out, and nothing else.
        opened, planes = run.body.opened(grid)
        assert planes == [(1, 0), (2, 0)]
        assert opened.n_cells == 3 * len(nodes) // 4
        assert np.allclose(opened.bounds, [0, 10, -1, 1, -1, 1])

        assert main([str(run.path), "--frames", "2"]) == 0
        for picture in ("picture.png", "kymograph.png", "report.html"):
            assert (run.path / picture).stat().st_size > 10000
        assert main([str(run.path), "--thumbnail", "0.5"]) == 0
        with Image.open(run.path / "thumbnail.png") as image:
            images.append(np.asarray(image.convert("RGB")).astype(int))
    # Both look alike, and are no empty paper.
    assert np.abs(images[0] - images[1]).mean() < 1
    assert (images[0] < 250).any(axis=2).mean() > 0.1
