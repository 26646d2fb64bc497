# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scene of a report in Chromium, without a screen or a network: it is turned,
moved, played and coloured, and what is on the screen changes."""
import base64
import io
import json
import re
import shutil
import sys
import time
import zlib

import numpy as np
import pytest
from lumbricus_run import SOURCE, run_well
from PIL import Image
from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select, WebDriverWait

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.command import main  # noqa: E402
from lumbricus.plot.fields import read_grid, read_series  # noqa: E402
from lumbricus.plot.viewer.frames import Recording  # noqa: E402

FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
         "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
         "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--window-size=900,900", "--proxy-server=127.0.0.1:9"]
TIMES = [0, 0.1, 0.2]


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return run_well(
        SOURCE / "tests" / "physics" / "chain.prm", tmp_path_factory.mktemp("run"),
        ["Output/Every=1", f"Time/End={TIMES[-1]}", "Title=A </script> <b>worm</b>"])


@pytest.fixture(scope="module")
def drawn(run):
    assert main([str(run.folder), "--only", "scene", "report"]) == 0
    return run.folder


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for flag in [*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('browser')}"]:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(options, webdriver.ChromeService(
        shutil.which("chromedriver")))
    yield driver
    driver.quit()


@pytest.fixture
def page(browser, drawn, request):
    """The scene, alone or in the report. No page says anything on the console."""
    name = getattr(request, "param", "scene.html")
    browser.get((drawn / name).as_uri())
    if name == "report.html":
        frame = browser.find_element(By.TAG_NAME, "iframe")
        browser.execute_script("arguments[0].scrollIntoView()", frame)
        browser.switch_to.frame(frame)
    WebDriverWait(browser, 60).until(lambda driver: driver.find_element(
        By.TAG_NAME, "body").get_attribute("data-state"))
    message = browser.find_element(By.ID, "message").get_attribute("textContent")
    assert message == ""
    yield browser
    browser.switch_to.default_content()
    assert browser.get_log("browser") == []


def find(page, name):
    return page.find_element(By.ID, name)


def image(page):
    time.sleep(0.2)
    return np.asarray(Image.open(io.BytesIO(
        find(page, "scene").screenshot_as_png)).convert("RGB")).astype(int)


def part_that_differs(one, other):
    return (np.abs(one - other) > 24).any(axis=2).mean()


def drag(page, right, up):
    ActionChains(page).move_to_element(find(page, "scene")).click_and_hold() \
        .move_by_offset(right, -up).release().perform()


@pytest.mark.parametrize("page", ["scene.html", "report.html"], indirect=True)
def test_a_drag_turns_the_body(page):
    before = image(page)
    # There is something in colour, on white.
    coloured = np.ptp(before, axis=2) > 40
    assert 0.05 < coloured.mean() < 0.9
    assert part_that_differs(before, image(page)) == 0
    drag(page, 160, 60)
    turned = image(page)
    assert part_that_differs(before, turned) > 0.05
    find(page, "home").click()
    assert part_that_differs(before, image(page)) == 0


def test_it_plays_and_stops(page):
    before = image(page)
    find(page, "play").click()
    WebDriverWait(page, 20).until(
        lambda _: find(page, "slider").get_attribute("value") == "2")
    find(page, "play").click()
    stopped = find(page, "slider").get_attribute("value")
    there = image(page)
    time.sleep(1.5)
    assert find(page, "slider").get_attribute("value") == stopped
    assert part_that_differs(there, image(page)) == 0
    page.execute_script("arguments[0].value = 2; arguments[0].oninput()",
                        find(page, "slider"))
    assert find(page, "time").get_attribute("value") == "t = 0.2"
    assert part_that_differs(before, image(page)) > 0.01


def test_it_is_coloured_by_another_field(page):
    page.execute_script("arguments[0].value = 2; arguments[0].oninput()",
                        find(page, "slider"))
    before, words = image(page), find(page, "bars").text
    assert "contraction" in words and "pressure" in words
    menu = Select(find(page, "colouring"))
    menu.select_by_visible_text("displacement [mm]")
    assert part_that_differs(before, image(page)) > 0.05
    assert find(page, "bars").text.endswith("displacement [mm]")


def test_keys_and_wheel(page):
    before = image(page)
    ActionChains(page).scroll_from_origin(
        webdriver.common.actions.wheel_input.ScrollOrigin.from_element(
            find(page, "scene")), 0, 200).perform()
    smaller = image(page)
    assert (smaller < 250).any(axis=2).sum() < 0.7 * (before < 250).any(axis=2).sum()
    find(page, "scene").click()
    ActionChains(page).send_keys(" ").perform()
    WebDriverWait(page, 20).until(
        lambda _: find(page, "slider").get_attribute("value") == "1")
    ActionChains(page).send_keys(" ").perform()


def test_one_file_without_a_network(drawn):
    """Chromium has no network in these tests; and there is nothing to fetch."""
    source = (drawn / "scene.html").read_text()
    assert not re.search(r"https?:|file:|url\(|@import|import\(|fetch\(|src=", source)
    assert (drawn / "scene.html").stat().st_size < 2_000_000
    assert "A &lt;/script&gt; &lt;b&gt;worm&lt;/b&gt;" in source


def unpacked(file):
    source = file.read_text()
    words, numbers = (re.search(f'id="{name}">(.*?)</script>', source, re.S)[1]
                      for name in ("words", "numbers"))
    return json.loads(words), zlib.decompress(base64.b64decode(numbers))


def test_the_body_in_it_is_that_of_the_run(drawn):
    """Its box at every time, to 16 bits of the box around all; what is packed has no
    byte more than is said."""
    words, numbers = unpacked(drawn / "scene.html")
    mesh, = words["meshes"]
    assert [frame["time"] for frame in words["frames"]] == pytest.approx(TIMES)
    n, skin = mesh["vertices"], mesh["skin"]
    fixed = 12 * mesh["triangles"] + 8 * mesh["lines"] + skin
    a_frame = 6 * n + skin * len(words["colourings"])
    assert len(numbers) == fixed + a_frame * len(TIMES)
    places = np.zeros((3, n), dtype=np.uint16)
    for i, (_, file) in enumerate(read_series(drawn)):
        at = fixed + i * a_frame
        low, high = np.frombuffer(numbers, np.uint8, 6 * n, at).reshape(2, 3, n)
        places += low + 256 * high.astype(np.uint16)
        x = np.array(words["low"])[:, None] + (
            places / 65535 * np.array(words["size"])[:, None])
        grid = read_grid(file)
        there = grid.points + grid["displacement"]
        # Along the axis the body is not mirrored.
        assert x[0, :skin].min() == pytest.approx(there[:, 0].min(), abs=1e-4)
        assert x[0, :skin].max() == pytest.approx(there[:, 0].max(), abs=1e-4)
        # Between the nodes a parabola goes a little beyond the circle.
        for d in (1, 2):
            assert np.abs(x[d, :skin]).max() == pytest.approx(
                np.abs(there[:, d]).max(), rel=2e-3)
    top = words["colourings"][1]["scales"][0]["high"]
    assert top == pytest.approx(max(
        np.linalg.norm(read_grid(file)["displacement"], axis=1).max()
        for _, file in read_series(drawn)), rel=0.02)


def test_large_runs_are_thinned(drawn, monkeypatch, tmp_path):
    """First to fewer triangles, then to fewer times; the caption says so."""
    sizes = []
    for most in (24_000_000, 50_000, 1000):
        monkeypatch.setattr("lumbricus.plot.viewer.frames.MOST_BYTES", most)
        monkeypatch.setattr("lumbricus.plot.viewer.frames.FEWEST_FRAMES", 2)
        assert main([str(drawn), "--only", "scene", "report",
                     "--output", str(tmp_path)]) == 0
        words, _ = unpacked(tmp_path / "scene.html")
        sizes.append((words["meshes"][0]["triangles"], len(words["frames"])))
    assert sizes[0][0] > sizes[1][0] >= sizes[2][0]
    assert [n for _, n in sizes] == [3, 3, 2]
    report = (tmp_path / "report.html").read_text()
    assert "Left out for the size of the file: 1 times." in report


def test_meshes_that_change(tmp_path, browser):
    """A mesh is there once for all times that have it."""
    run = run_well(SOURCE / "tests" / "physics" / "chain.prm", tmp_path, [
        "Output/Every=1", "Time/End=0.2", "Adaptivity/Every=2",
        "Adaptivity/Finest level=1"])
    cells = [row["cells"] for row in run.table("mesh.csv")]
    assert len(set(cells)) == 2
    assert main([str(run.folder), "--only", "scene"]) == 0
    words, _ = unpacked(run.folder / "scene.html")
    assert [frame["mesh"] for frame in words["frames"]] == [0, 0, 1]
    assert words["meshes"][1]["triangles"] > words["meshes"][0]["triangles"]
    assert words["obstacles"] == []
    browser.get((run.folder / "scene.html").as_uri())
    WebDriverWait(browser, 60).until(lambda driver: driver.find_element(
        By.TAG_NAME, "body").get_attribute("data-state") == "ready")
    before = image(browser)
    browser.execute_script("arguments[0].value = 2; arguments[0].oninput()",
                           find(browser, "slider"))
    assert part_that_differs(before, image(browser)) > 0.01
    assert browser.get_log("browser") == []


def test_obstacles(tmp_path, browser):
    """Their grid goes with the body; one that does not is there once."""
    run = run_well(SOURCE / "tests" / "physics" / "ground.prm", tmp_path, [
        "Output/Every=1", "Time/First step=0.5", "Time/Largest step=0.5"])
    assert main([str(run.folder), "--only", "scene"]) == 0
    words, _ = unpacked(run.folder / "scene.html")
    assert len(words["frames"]) == 3
    assert [frame["obstacle"] for frame in words["frames"]] == [0, 1, 2]
    recording = Recording.__new__(Recording)
    recording.obstacles = []
    files = [file for _, file in read_series(run.folder, "obstacles.pvd")]
    assert [recording.number_of_obstacle(file) for file in
            (files[0], files[0], None, files[1])] == [0, 0, -1, 1]
    assert "contact pressure [N/mm²]" in [c["name"] for c in words["colourings"]]
    browser.get((run.folder / "scene.html").as_uri())
    WebDriverWait(browser, 60).until(lambda driver: driver.find_element(
        By.TAG_NAME, "body").get_attribute("data-state") == "ready")
    # Lines in the colour of obstacles, which nothing else has.
    colour = [int(words["obstacle"][i:i + 2], 16) for i in (1, 3, 5)]
    assert (np.abs(image(browser) - colour).max(axis=2) < 8).sum() > 100
    assert browser.get_log("browser") == []
