"""What tests of animations share: making them, opening them, going to a time."""

import os
import subprocess

SETTLED = "await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));"
STATE = SETTLED + "return pedzone.state();"
SET_TIME = ("const slider = document.getElementById('time'); slider.value = arguments[0];"
            "slider.dispatchEvent(new Event('input'));" + STATE)


def call(*words, folder):
    environment = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
    return subprocess.run(list(map(str, words)), cwd=folder, check=True, capture_output=True,
                          timeout=600, env=environment, stdin=subprocess.DEVNULL)


def enter(case, context):
    """unittest has it as enterClassContext from Python 3.12 on."""
    entered = context.__enter__()
    case.addClassCleanup(context.__exit__, None, None, None)
    return entered


def open_page(browser, path, width=1280, height=800, mobile=False):
    browser.resize(width, height, mobile)
    browser.open(path)
    return browser.run(
        "while (!window.pedzone) await new Promise((done) => setTimeout(done, 20));" + STATE)
