# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worm of one dimension against closed forms and against three dimensions."""
import numpy as np
import pytest

from lumbricus.worm1d import Ground, Layer, Tube, Worm, wave

LAYERS = (Layer(0.15, 0.23, "longitudinal"), Layer(0.15, 0.23, "circular"))


@pytest.mark.parametrize("radius, layers, longitudinal, circular, length, pressure", [
    (3, (Layer(0.3, 0.23, "circular"),), 1, 0.5, 1.6509636244, 4.6472674265e-2),
    (2, LAYERS, 1, 0.8, 1.0685434565, 1.1068819474e-2),
    (2, LAYERS, 0.7, 0.8, 0.8787053330, 1.3460160279e-2),
    (2, LAYERS, 0.8, 1, 0.8923646370, 0)])
def test_closed_forms(radius, layers, longitudinal, circular, length, pressure):
    """Those of tests/physics/test_pistons.py, computed elsewhere."""
    tube = Tube(radius, layers)
    active = {"longitudinal": np.array([longitudinal], float),
              "circular": np.array([circular], float)}
    stretch = tube.free_stretch(active)
    assert stretch[0] == pytest.approx(length, rel=1e-9)
    assert tube.pressure(stretch, active)[0] == pytest.approx(pressure, rel=1e-9,
                                                              abs=1e-12)
    force, slope = tube.force(stretch, active)
    assert abs(force[0]) < 1e-12
    assert (tube.force(stretch + 1e-6, active)[0][0] - force[0]) / 1e-6 == \
        pytest.approx(slope[0], rel=1e-4)


def crawl(segments, wavelength, forward, backward, **options):
    gait = {"circular": wave(0.3, wavelength, **options),
            "longitudinal": wave(0.3, wavelength, phase=0.5, **options)}
    worm = Worm(segments, 2.0, Tube(2.0, LAYERS), elements=16)
    return worm, gait, Ground(forward, backward, elastic_slip=0.01)


@pytest.mark.parametrize("forward, backward, expected", [
    (0.001, 0.004, 0.40653519), (0.004, 0.001, -0.37955571)])
def test_the_worm_of_the_benchmark(forward, backward, expected):
    """What benchmarks/peristaltic_tube computes, and the program to 3 %, see
    test_peristaltic_tube in tests/physics/test_contact.py."""
    worm, gait, ground = crawl(5, 5, forward, backward, ramp_in=0.25)
    path = worm.crawl(gait, ground, end=0.75, dt=1 / 16)
    assert path.stride(0.25, 0.75) == pytest.approx(expected, rel=1e-7)
    assert path.lengths.shape == (13, 5)


@pytest.mark.parametrize("backward, of_tube", [
    (0.002, 0.5780), (0.004, 1.7877), (0.01, 2.5857)])
def test_thin_tubes_of_three_dimensions(backward, of_tube):
    """The table in doc/performance.md: strides of the program."""
    worm, gait, ground = crawl(20, 10, 0.001, backward)
    path = worm.crawl(gait, ground, end=2.0, dt=0.04)
    assert path.stride(1, 2) == pytest.approx(of_tube, rel=0.02)


@pytest.mark.parametrize("wavelength, of_worm, error", [(5, 0.73888, 0.04),
                                                        (10, 1.712, 0.07)])
def test_crawling(wavelength, of_worm, error):
    """The second period of parameters/crawling, whose README has the program's
    strides: as if all segments carried the same weight."""
    weight = 3.6e-3 / 21
    tube = Tube(2.0, tuple(Layer(0.15, 0.01, layer.muscle) for layer in LAYERS))
    gait = {"circular": wave(0.25, wavelength, ramp_in=0.25),
            "longitudinal": wave(0.25, wavelength, phase=0.5, ramp_in=0.25)}

    def setae(t, s):
        return 0.3 * weight * (1 + 5 * np.maximum(0, np.sin(
            2 * np.pi * (t + 0.5 - (s - 1) / wavelength))))
    path = Worm(10, 2.1, tube, elements=16).crawl(
        gait, Ground(0.3 * weight, setae, elastic_slip=0.02), end=2.25, dt=0.05)
    stride = path.stride(1.25, 2.25)
    print(f"one dimension {stride:.4f} mm, three {of_worm} mm: "
          f"{100 * (stride / of_worm - 1):+.1f} %")
    assert stride == pytest.approx(of_worm, rel=error)


def test_without_slip_the_stride_has_a_closed_form():
    """A wave of segments comes ahead by what they are longer on average than where they
    are anchored: the longest strides on ground that lets nothing back."""
    worm, gait, _ = crawl(20, 10, 0, 0)
    path = worm.crawl(gait, Ground(1e-4, 1e-2, elastic_slip=1e-3), end=2.0)
    lengths = path.lengths[path.t > 1]
    most = 10 * (lengths.mean() - lengths.min())
    assert 0.7 * most < path.stride(1, 2) < most
