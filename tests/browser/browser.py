"""Debian's Chromium without a display, driven over WebDriver's HTTP."""

import base64
import json
import os
import re
import signal
import subprocess
import tempfile
import threading
import urllib.error
import urllib.request
from pathlib import Path

_START = 120  # [s] the browser must be up by then, on a loaded machine too
_ANSWER = 300  # [s] so long an answer may take
_ARGUMENTS = (
    "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-dev-shm-usage", "--disable-extensions", "--no-default-browser-check",
    "--host-resolver-rules=MAP * ~NOTFOUND", "--window-size=1280,800")
_ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # by the WebDriver standard


class BrowserError(Exception):
    pass


class Browser:
    """A browser of its own folder, gone with it: use it in `with`."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.driver = self.session = self.address = None
        try:
            self._start_driver()
            self._start_session()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        try:
            if self.session:
                self._call("DELETE", "")
        except (OSError, BrowserError):
            pass  # it is ended below all the same
        finally:
            if self.driver:
                try:
                    os.killpg(self.driver.pid, signal.SIGKILL)  # a group of its own
                except ProcessLookupError:
                    pass
                self.driver.wait()
                self.driver.stdout.close()
            self.folder.cleanup()

    def _start_driver(self):
        environment = {**os.environ, "HOME": self.folder.name, "TMPDIR": self.folder.name}
        for name in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"):
            environment.pop(name, None)
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, env=environment, cwd=self.folder.name,
            start_new_session=True)
        # It says which free port it has taken, or ends.
        timer = threading.Timer(_START, self.driver.kill)
        timer.start()
        said = []
        for line in self.driver.stdout:
            said.append(line)
            if found := re.search(r"started successfully on port (\d+)", line):
                self.root = f"http://127.0.0.1:{found[1]}"
                break
        else:
            raise BrowserError("chromedriver did not start: " + "".join(said))
        timer.cancel()
        threading.Thread(target=self.driver.stdout.read, daemon=True).start()

    def _start_session(self):
        profile = f"--user-data-dir={self.folder.name}/profile"
        answer = self._request("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome",
            "timeouts": {"script": _ANSWER * 1000},
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
            "goog:chromeOptions": {"binary": "/usr/bin/chromium",
                                   "args": [*_ARGUMENTS, profile]}}}})
        self.session = answer["sessionId"]

    def _request(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.root + path, data, method=method,
                                         headers={"Content-Type": "application/json"})
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=_ANSWER) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise BrowserError(error.read().decode(errors="replace")) from error

    def _call(self, method, path, body=None):
        return self._request(method, f"/session/{self.session}{path}", body)

    def command(self, name, **parameters):
        """A command of Chromium's own protocol."""
        return self._call("POST", "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def resize(self, width, height, mobile=False, ratio=1):
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height,
                     deviceScaleFactor=ratio, mobile=mobile)

    def prefer(self, scheme):
        self.command("Emulation.setEmulatedMedia",
                     features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, path):
        """Opens a file and waits until it is loaded."""
        self.messages(), self.requests()  # those of the page before
        self.address = Path(path).resolve().as_uri()
        self._call("POST", "/url", {"url": self.address})

    def run(self, script, *arguments):
        """What the script, the body of an async function, returns."""
        wrapped = ("const done = arguments[arguments.length - 1];"
                   f"(async function() {{ {script} }}).apply(null, [...arguments].slice(0, -1))"
                   ".then((value) => done({value}), (error) => done({error: String(error)}));")
        answer = self._call("POST", "/execute/async", {"script": wrapped, "args": arguments})
        if "error" in answer:
            raise BrowserError(answer["error"])
        return answer.get("value")

    def element(self, selector):
        found = self._call("POST", "/element", {"using": "css selector", "value": selector})
        return found[_ELEMENT]

    def click(self, selector):
        self._call("POST", f"/element/{self.element(selector)}/click", {})

    def pointer(self, *steps, kind="mouse"):
        """Real input at places of the window: ("move", x, y), ("down",), ("up",)."""
        actions = []
        for name, *place in steps:
            if name == "move":
                actions.append({"type": "pointerMove", "duration": 0, "x": round(place[0]),
                                "y": round(place[1]), "origin": "viewport"})
            else:
                actions.append({"type": f"pointer{name.capitalize()}", "button": 0})
        self._call("POST", "/actions", {"actions": [{
            "type": "pointer", "id": kind, "parameters": {"pointerType": kind},
            "actions": actions}]})

    def click_at(self, x, y):
        self.pointer(("move", x, y), ("down",), ("up",))

    def wheel(self, x, y, delta):
        self._call("POST", "/actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "x": round(x), "y": round(y), "deltaX": 0, "deltaY": delta,
             "origin": "viewport", "duration": 0}]}]})

    def press(self, *keys):
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self._call("POST", "/actions", {"actions": [{"type": "key", "id": "keys",
                                                     "actions": actions}]})

    def messages(self):
        """What the page has written to the console, errors of the browser included."""
        return [f"{entry['level']}: {entry['message']}"
                for entry in self._call("POST", "/se/log", {"type": "browser"})]

    def requests(self):
        """Addresses of all that the page has asked for since the last call, itself included."""
        found = []
        for entry in self._call("POST", "/se/log", {"type": "performance"}):
            event = json.loads(entry["message"])["message"]
            if (event["method"] == "Network.requestWillBeSent"
                    and event["params"]["documentURL"] == self.address):
                found.append(event["params"]["request"]["url"])
        return found

    def enter_frame(self, selector):
        self._call("POST", "/frame", {"id": {_ELEMENT: self.element(selector)}})

    def leave_frame(self):
        self._call("POST", "/frame", {"id": None})

    def print_page(self, path):
        """As a PDF file: A4, with the margins and backgrounds of the page itself."""
        Path(path).write_bytes(base64.b64decode(self._call("POST", "/print", {
            "background": True, "page": {"width": 21.0, "height": 29.7}, "shrinkToFit": False})))

    def screenshot(self, path):
        Path(path).write_bytes(base64.b64decode(self._call("GET", "/screenshot")))
