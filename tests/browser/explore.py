"""Tests of `gearsim explore` in headless Chromium: python tests/browser/explore.py GEARSIM

GEARSIM is the program built with the feature `html`. Needs what tests/browser/page.py needs. Any console message fails its test, except
where a test provokes it.
"""

import contextlib
import csv
import functools
import http.server
import json
import math
import signal
import statistics
import subprocess
import threading

import common
import gears
from common import LAPTOP, PHONE, SCENES

PAIR = SCENES / "oh2005" / "energy_300rpm.toml"


@contextlib.contextmanager
def served(gearsim, scene):
    """Serves a scene; its address. At the end Ctrl-C must end it, with a short line."""
    process = subprocess.Popen([gearsim, "explore", scene], stdout=subprocess.PIPE, text=True)
    try:
        word, url = process.stdout.readline().split()
        assert word == "open" and url.startswith("http://127.0.0.1:"), (word, url)
        yield url
        process.send_signal(signal.SIGINT)
        rest = process.communicate(timeout=20)[0]
        assert process.returncode == 0 and rest.split("\n")[-2] == "ended", (process.returncode, rest)
    finally:
        process.kill()


def opened(browser, url, **settings):
    """The page that is served at `url`."""
    return common.opened(browser, url, allowed=(url,), **settings)


def after(page, change, *arguments):
    """Makes a change, and waits until it is drawn, with what is not seen. The time from input to redraw of what is seen [ms]."""
    page.evaluate("delete document.body.dataset.latency; delete document.body.dataset.whole")
    change(*arguments)
    page.wait_for_selector("body[data-latency][data-whole]")
    return float(page.evaluate("document.body.dataset.latency"))


def slide(page, key, place):
    """Moves the slider of a key to a place between 0 and 1000."""
    page.evaluate(
        """([key, place]) => {
            const { slider } = rows.get(key);
            slider.value = place;
            slider.dispatchEvent(new Event("input", { bubbles: true }));
        }""",
        [key, place],
    )


def shown(page):
    """The end state that the page shows, by name."""
    cells = "Array.from(document.querySelectorAll('#state td[data-value]'), (cell) => [cell.parentElement.cells[0].textContent, Number(cell.dataset.value)])"
    return dict(page.evaluate(cells))


def run(gearsim, scene, folder, *sets):
    """What `gearsim run` says of a scene with values set."""
    arguments = [argument for value in sets for argument in ("--set", value)]
    subprocess.run([gearsim, "run", scene, "-q", "--out", folder, *arguments], check=True)
    return json.loads((folder / "summary.json").read_text())


def value_of(page, key):
    return page.evaluate("(key) => rows.get(key).field.value", key)


def a_slider_gives_what_the_command_line_gives(browser, gearsim, folder):
    """The end state after a slider, a field, an effect and a method, compared with `gearsim run`; the plots are redrawn."""
    with served(gearsim, PAIR) as url, opened(browser, url, **LAPTOP) as page:
        assert shown(page) == run(gearsim, PAIR, folder / "first")["state"]
        last = "panels[0].canvas.data[0].y.at(-1)"
        before = page.evaluate(last)
        latencies = [after(page, slide, page, "parameters.zeta", 300 + 20 * i) for i in range(12)]
        print(f"  from input to redraw: median {statistics.median(latencies):.0f} ms, least {min(latencies):.0f} ms")
        zeta = f"parameters.zeta={value_of(page, 'parameters.zeta')}"
        assert shown(page) == run(gearsim, PAIR, folder / "slid", zeta)["state"]
        # The first plot has the speed of the driving gear. Its points are from a column with five digits, the last one a little before
        # the end.
        run(gearsim, PAIR, folder / "plotted", zeta, "output.csv=true")
        with open(folder / "plotted" / "trajectory.csv", newline="") as file:
            *_, end = csv.DictReader(file)
        rpm = 30 / math.pi * float(end["rotor_speed_1 [rad/s]"])
        assert page.evaluate(last) != before and abs(page.evaluate(last) / rpm - 1) < 1e-3

        after(page, page.get_by_label("speed", exact=True).fill, "450")
        sets = [zeta, "start.speed=450 rpm"]
        assert shown(page) == run(gearsim, PAIR, folder / "typed", *sets)["state"]

        after(page, page.get_by_role("checkbox", name="damping").uncheck)
        sets.append('effects=["stiffness_step", "torques"]')
        assert shown(page) == run(gearsim, PAIR, folder / "undamped", *sets)["state"]

        after(page, page.locator("#menu").select_option, "dop853")
        sets.append("run.method=dop853")
        assert shown(page) == run(gearsim, PAIR, folder / "by_steps", *sets)["state"]

        after(page, page.locator("#reset").click)
        assert shown(page) == run(gearsim, PAIR, folder / "first")["state"]


def a_long_run_first_shows_its_beginning(browser, gearsim, folder):
    """The curves of a long run begin on axes of its whole length before it ends, also while a slider moves; at rest it is shown whole."""
    with served(gearsim, PAIR) as url, opened(browser, url, **LAPTOP) as page:
        begun = "body.begun[data-latency]:not([data-shown='1'])"
        page.get_by_label("t_end", exact=True).fill("5")
        page.wait_for_selector(begun)
        first, axis = page.evaluate("[panels[0].canvas.data[0].x.at(-1), panels[0].canvas.layout.xaxis.range]")
        assert 0 < first < 4.9 and axis == [0, 5], (first, axis)
        for place in (300, 320, 340):
            page.evaluate("delete document.body.dataset.latency")
            slide(page, "parameters.zeta", place)
            page.wait_for_selector(begun)
        after(page, slide, page, "parameters.zeta", 360)
        assert page.locator("body.begun").count() == 0 and page.evaluate("document.body.dataset.shown") == "1"
        sets = [f"parameters.zeta={value_of(page, 'parameters.zeta')}", "run.t_end=5 s"]
        assert shown(page) == run(gearsim, PAIR, folder / "long", *sets)["state"]
        # The last point is the highest or the lowest of the last pixel.
        last, pixels = page.evaluate("[panels[0].canvas.data[0].x.at(-1), panels[0].pixels()]")
        assert 5 - 5 / pixels <= last <= 5, (last, pixels)


def mistakes_stand_beside_their_controls(browser, gearsim, folder):
    """A value out of range and an effect that needs another are said where they are; the last good plots stay."""
    with served(gearsim, PAIR) as url, opened(browser, url, **LAPTOP) as page:
        before = shown(page)
        zeta = page.get_by_label("zeta", exact=True)
        after(page, zeta.fill, "-1")
        said = page.locator("#" + zeta.get_attribute("aria-describedby"))
        assert "must not be negative, but is -1" in said.text_content(), said.text_content()
        assert zeta.get_attribute("aria-invalid") == "true"
        assert shown(page) == before and page.locator("figure.plot .main-svg").first.is_visible()
        after(page, zeta.fill, "0.1")
        assert said.is_hidden() and shown(page) == before
        after(page, page.get_by_role("checkbox", name="rigid_kinematics").check)
        after(page, page.get_by_role("checkbox", name="frozen_phase").check)
        assert "contradict each other" in page.locator("#wrong-effects").text_content()


def cost_and_advice_are_shown(browser, gearsim, folder):
    """The error, the time and the digits of a choice, and which effects matter to it."""
    with served(gearsim, PAIR) as url, opened(browser, url, **LAPTOP) as page:
        page.wait_for_selector("body[data-judged]")
        assert float(page.locator("#error").text_content()) < 1e-12
        assert page.locator("#ratio").text_content() == "exact cells"
        after(page, page.locator("#menu").select_option, "dopri5")
        after(page, page.locator("#tolerance").fill, "1e-5")
        page.wait_for_selector("body[data-judged]")
        assert 1e-9 < float(page.locator("#error").text_content()) < 1e-1
        assert page.locator("#ratio").text_content().endswith(" x exact cells")
        assert page.locator("#digits").text_content().isdigit()
        # The advice appears without being asked for, and again after a change.
        page.wait_for_selector("body:not(.unadvised) #advised table")
        page.locator("#tolerance").fill("1e-6")
        assert page.locator("body.unadvised").count() == 1
        page.wait_for_selector("body:not(.unadvised) #advised table")
        verdict = page.locator("#effects label", has_text="damping").locator(".verdict")
        assert verdict.text_content() in ("needed", "negligible")


def other_equilibria_are_named(browser, gearsim, folder):
    """The remark on a static start that is one of several equilibria comes with what is not seen: the search takes longer than a short run."""
    with served(gearsim, SCENES / "crank_drive.toml") as url, opened(browser, url, **LAPTOP) as page:
        page.wait_for_selector("body[data-whole]")
        assert page.locator("#remarks", has_text="one of several equilibria").count() == 1


def a_saved_scene_runs_to_the_same_bytes(browser, gearsim, folder):
    """Save as scene, run by the command line twice: what the page showed, and one file of the same bytes each time."""
    with served(gearsim, PAIR) as url, opened(browser, url, **LAPTOP) as page:
        after(page, slide, page, "parameters.T0", 731)
        after(page, page.get_by_role("checkbox", name="backlash", exact=True).check)
        with page.expect_download() as download:
            page.locator("#save").click()
        assert download.value.suggested_filename == "energy_300rpm_explored.toml"
        scene = folder / download.value.suggested_filename
        download.value.save_as(scene)
        assert "# the paper prints 2.89 kg mm^2" in scene.read_text()
        assert shown(page) == run(gearsim, scene, folder / "saved")["state"]
        # The page's provenance is that of the file.
        again = run(gearsim, scene, folder / "again")
        assert page.locator("#provenance").text_content().count(again["provenance"]["scene_sha256"]) == 1
        assert (folder / "saved" / "trajectory.parquet").read_bytes() == (folder / "again" / "trajectory.parquet").read_bytes()


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


def another_page_gets_nothing(browser, gearsim, folder):
    """A page on another port knows even the token: it can neither read an answer, nor start a run, nor put the page into a frame."""
    with served(gearsim, PAIR) as url:
        other = folder / "other"
        other.mkdir()
        (other / "index.html").write_text("<!DOCTYPE html><title>other</title>")
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(other)))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        page = browser.new_page()
        statuses = []
        page.on("response", lambda response: statuses.append((response.status, response.url)))
        page.goto(f"http://127.0.0.1:{server.server_address[1]}/")
        reach = """async ([url, what, settings]) => {
            try { return (await fetch(url + what, settings)).type; } catch (error) { return "refused"; }
        }"""
        asked = {"method": "POST", "headers": {"Content-Type": "application/json"}, "body": "{}"}
        for what, settings in [("", {}), ("run", asked), ("run", {"method": "POST", "body": "{}"})]:
            assert page.evaluate(reach, [url, what, settings]) == "refused", (what, settings)
        # With no-cors the browser sends the request, but shows no answer to the page. The server refuses it.
        assert page.evaluate(reach, [url, "run", {"method": "POST", "mode": "no-cors", "body": "{}"}]) in ("opaque", "refused")
        assert all(status in (403, 405) for status, address in statuses if address.startswith(url) and address != url), statuses
        page.evaluate("(url) => { const frame = document.createElement('iframe'); frame.src = url; document.body.append(frame); }", url)
        page.wait_for_timeout(1000)
        # Where a frame is refused, the browser shows its own error page.
        assert not any(frame.url.startswith(url) and frame.locator("#controls").count() for frame in page.frames[1:])
        page.close()
        server.shutdown()


def works_with_keys_and_on_a_phone(browser, gearsim, folder):
    """A slider obeys the arrow keys; on a phone the controls open from below, and nothing is wider than the screen."""
    with served(gearsim, PAIR) as url:
        with opened(browser, url, color_scheme="dark", **LAPTOP) as page:
            # The first Tab reaches the link that skips the controls.
            page.keyboard.press("Tab")
            page.keyboard.press("Enter")
            page.keyboard.press("Tab")
            assert page.evaluate("document.activeElement.closest('main')?.id") == "sections"
            page.get_by_label("zeta, slider").focus()
            after(page, page.keyboard.press, "ArrowRight")
            assert float(value_of(page, "parameters.zeta")) > 0.1
        with opened(browser, url, **PHONE) as page:
            assert page.evaluate("document.documentElement.scrollWidth") <= 390
            assert page.locator("#save").is_hidden()
            page.locator("#side > summary").click()
            assert page.locator("#save").is_visible()
            after(page, slide, page, "parameters.zeta", 600)
            assert page.evaluate("document.documentElement.scrollWidth") <= 390


def curves_move_to_where_plotly_draws_them(browser, gearsim, folder):
    """While a slider moves, the curves are drawn without plotly.js: lines and markers are where it draws them, and its axes stay."""
    draws = """(id) => {
        const panel = panels.find((panel) => panel.drawn && onScreen(panel) && document.getElementById(id).contains(panel.figure));
        const numbers = (text) => (text.match(/-?[0-9.]+(e-?[0-9]+)?/g) ?? []).map(Number);
        const pairs = (flat) => flat.flatMap((x, i) => i % 2 ? [] : [[x, flat[i + 1]]]);
        const lines = () => [...panel.canvas.querySelectorAll(".scatterlayer path.js-line")];
        const points = () => [...panel.canvas.querySelectorAll(".scatterlayer .points path.point")];
        const read = () => [lines().map((line) => pairs(numbers(line.getAttribute("d")))), points().map((point) => numbers(point.getAttribute("transform")))];
        const own = Panel.sketch, did = [];
        Panel.sketch = (...all) => did[did.push(own(...all)) - 1];
        Panel.part = COARSE;
        panel.look = undefined;
        panel.draw();
        const theirs = read();
        lines().forEach((line) => line.setAttribute("d", "M0,0"));
        points().forEach((point) => point.setAttribute("transform", "translate(0,0)"));
        panel.draw();
        const { xaxis, yaxis } = panel.canvas._fullLayout;
        Panel.sketch = own;
        return [did, theirs, read(), [xaxis._length, yaxis._length]];
    }"""
    for scene, section in ((PAIR, "motion"), (SCENES / "train_turbine.toml", "orders"), (SCENES / "planetary_3.toml", "spectra")):
        with served(gearsim, scene) as url, opened(browser, url, **LAPTOP) as page:
            page.wait_for_selector("body[data-judged]")
            page.evaluate("(id) => document.getElementById(id).scrollIntoView()", section)
            common.wait_until(page, "panels.filter(onScreen).every(({ drawn, frame }) => drawn || frame.hidden)")
            did, (lines, points), (own_lines, own_points), (width, height) = page.evaluate(draws, section)
            assert did == [True], (section, did)
            assert len(lines) == len(own_lines) > 0 and len(points) == len(own_points)
            for theirs, own in zip([*lines, points], [*own_lines, own_points]):
                seen = [(x, y) for x, y in own if 1 < x < width - 1 and 1 < y < height - 1]
                far = [place for place in seen if min(math.dist(place, other) for other in theirs) > 0.2]
                assert not far, (section, far[:5])
            assert sum(len(own) for own in own_lines) > 100


def gears_are_drawn(browser, gearsim, folder):
    """The gears of a run are drawn when they are in sight, and other gears after a change."""
    with served(gearsim, SCENES / "gear_pair_teeth.toml") as url, opened(browser, url, **LAPTOP) as page:
        drawn = []
        for place in (500, 800):
            after(page, slide, page, "parameters.T0", place)
            gears.shown(page)
            gears.scrub(page, 0.5)
            drawn.append(gears.pixels(page))
        assert all(part > 0.05 for part, _ in drawn) and drawn[0] != drawn[1], drawn


def hostile_texts_stay_text(browser, gearsim, folder):
    """HTML in the name and in the text of a scene is shown, and not executed."""
    lines = [line for line in PAIR.read_text().splitlines() if not line.startswith("about")]
    about = "</script><script>document.body.dataset.hurt=2</script><b>bold</b>"
    scene = folder / "<img src=x onerror=document.body.dataset.hurt=1>.toml"
    scene.write_text("\n".join([f'about = "{about}"', "# --> </title></style>", *lines]))
    with served(gearsim, scene) as url, opened(browser, url, **LAPTOP) as page:
        assert page.locator("h1").text_content() == scene.stem
        assert page.locator("#about").text_content() == about
        assert page.locator("img, b").count() == 0 and page.evaluate("document.body.dataset.hurt") is None


TESTS = [
    a_slider_gives_what_the_command_line_gives,
    a_long_run_first_shows_its_beginning,
    mistakes_stand_beside_their_controls,
    cost_and_advice_are_shown,
    other_equilibria_are_named,
    a_saved_scene_runs_to_the_same_bytes,
    another_page_gets_nothing,
    works_with_keys_and_on_a_phone,
    curves_move_to_where_plotly_draws_them,
    gears_are_drawn,
    hostile_texts_stay_text,
]


def tests(gearsim, folder, pictures):
    for test in TESTS:
        own = folder / test.__name__
        own.mkdir()
        yield test, (gearsim, own), ""


if __name__ == "__main__":
    common.run_tests(tests)
