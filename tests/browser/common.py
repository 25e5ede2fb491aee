"""What the tests in headless Chromium share: the browser, sizes of screens, and a page that is watched."""

import contextlib
import os
import pathlib
import sys
import tempfile
import time

from playwright.sync_api import TimeoutError, sync_playwright

SCENES = pathlib.Path(__file__).parents[2] / "models" / "scenes"
LAPTOP = {"viewport": {"width": 1280, "height": 800}}
PHONE = {"viewport": {"width": 390, "height": 844}, "is_mobile": True, "has_touch": True}
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update", "--disable-sync"]


def processor():
    """The name of the processor, as Linux gives it."""
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")


def started(playwright):
    """The browser."""
    return playwright.chromium.launch(executable_path=os.environ.get("CHROMIUM", "/usr/bin/chromium"), args=FLAGS)


@contextlib.contextmanager
def opened(browser, url, allowed, **settings):
    """The page at `url` once its first plot is drawn. Console messages, and requests that do not begin as `allowed`, are failures."""
    context = browser.new_context(**settings)
    # A busy machine may take long; no test depends on the time.
    context.set_default_timeout(120_000)
    page, messages, requests = context.new_page(), [], []
    page.on("console", lambda message: messages.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: messages.append(str(error)))
    page.on("request", lambda request: requests.append(request.url))
    page.goto(url)
    page.wait_for_selector("body[data-ready]")
    # Plots are drawn when they are in sight. On a phone the first one begins below the visible part of the page.
    page.locator("figure.plot, figure.map").first.scroll_into_view_if_needed()
    page.wait_for_selector("figure .main-svg")
    yield page
    assert not messages, messages
    assert [other for other in requests if not other.startswith((*allowed, "data:", "blob:"))] == []
    context.close()


def opened_file(browser, path, **settings):
    """The page at `path`, without network."""
    return opened(browser, path.as_uri(), allowed=("file:",), offline=True, **settings)


def run_tests(tests):
    """Runs what `tests(gearsim, folder, pictures)` yields: each a test, its arguments after the browser, and a word about them. The command
    line has the program GEARSIM, and optionally a folder that gets pictures of the pages, for people.

    Chromium sometimes stops drawing frames for good on a busy machine, and then a page waits without end. A test that waited in vain
    on such a page is run once more in a new browser. If the page still draws frames, the test has failed."""
    gearsim = pathlib.Path(sys.argv[1]).resolve()
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = started(playwright)
        for test, arguments, word in tests(gearsim, pathlib.Path(folder), pictures):
            try:
                test(browser, *arguments)
            except TimeoutError as error:
                if draws_frames(browser.contexts[-1].pages[-1]):
                    raise
                print("again, in a new browser:", test.__name__, word, str(error).splitlines()[0], flush=True)
                browser.close()
                browser = started(playwright)
                test(browser, *arguments)
            print("passed:", test.__name__, word, flush=True)
        browser.close()


def screens(fits, path, *more):
    """The test `fits` of a page on a laptop and on a phone, light and dark; `more` are its last arguments."""
    return [(fits, (path, size, scheme, *more), path.parent.name) for size in (LAPTOP, PHONE) for scheme in ("light", "dark")]


def settle(page):
    """Waits for the frames in which the page draws what was asked, in all detail."""
    two_frames(page)
    wait_until(page, "[...groups.values()].every((group) => group.detail === null)")
    two_frames(page)


def two_frames(page, seconds=120):
    """Waits for two frames and the tasks after them, at most `seconds`."""
    page.evaluate("{ window.framed = false; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => { window.framed = true; }))); }")
    wait_until(page, "window.framed", seconds=seconds)


def draws_frames(page):
    """Whether the page draws frames."""
    try:
        two_frames(page, seconds=10)
    except TimeoutError:
        return False
    return True


def wait_until(page, condition, arg=None, seconds=120):
    """Waits at most `seconds` until a JavaScript condition holds. Playwright's `wait_for_function` evaluates strings inside the page,
    which the page's Content-Security-Policy forbids."""
    deadline = time.monotonic() + seconds
    while not page.evaluate(condition, arg):
        if time.monotonic() > deadline:
            raise TimeoutError(f"does not become true: {condition}")
        page.wait_for_timeout(20)
