"""A browser without a window, driven over its own pipe: Chromium's DevTools protocol, by Python's
standard library."""
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--remote-debugging-pipe"]
CONSOLE = """globalThis.$ ??= (what) => document.querySelector(what);
  globalThis.$$ ??= (what) => [...document.querySelectorAll(what)];
"""


class Fault(Exception):
    """What a page or the browser did wrong."""


def installed():
    for name in ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                 "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"):
        if shutil.which(name):
            return shutil.which(name)
    return None


def typed_paths(usage, count, needed=lambda *_: Path()):
    """The first words of the command line. Ends with the usage; or with status 77 where there is no
    browser, or not the file that is needed."""
    if len(sys.argv) <= count:
        sys.exit(usage.strip())
    paths = [Path(word).resolve() for word in sys.argv[1:count + 1]]
    if not installed() or not needed(*paths).exists():
        print("skipped: no browser (chromium or google-chrome) is installed, or ./course "
              "playground has made nothing")
        sys.exit(77)
    return paths


class Browser:
    """One page in one browser. `log` has what the console shows: errors and warnings."""

    def __init__(self, *flags):
        self.home = tempfile.mkdtemp()
        to_browser, self.out = os.pipe()
        self.inward, from_browser = os.pipe()

        def pipes():  # the browser reads from 3 and writes to 4
            os.dup2(to_browser, 10)
            os.dup2(from_browser, 11)
            os.dup2(10, 3)
            os.dup2(11, 4)

        self.process = subprocess.Popen([installed(), *FLAGS, *flags,
                                         f"--user-data-dir={self.home}", "about:blank"],
                                        preexec_fn=pipes, close_fds=False, stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.rest = b""
        self.number = 0
        self.session = None
        self.log = []
        self.answers = {}
        self.events = []
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(one["targetId"] for one in targets if one["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "DOM"):
            self.call(domain + ".enable")

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.out)
        os.close(self.inward)
        shutil.rmtree(self.home, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def listen(self, until):
        """Reads messages until `until()` is true. After two minutes: Fault."""
        end = time.monotonic() + 120
        while not until():
            if not select.select([self.inward], [], [], max(0, end - time.monotonic()))[0]:
                raise Fault("the browser does not answer")
            data = os.read(self.inward, 1 << 20)
            if not data:
                raise Fault("the browser is gone")
            *messages, self.rest = (self.rest + data).split(b"\0")
            for message in map(json.loads, messages):
                self.hear(message)

    def hear(self, message):
        if "id" in message:
            self.answers[message["id"]] = message
            return
        params = message.get("params", {})
        self.events.append(message["method"])
        if message["method"] == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.log.append(details.get("exception", {}).get("description") or details["text"])
        elif message["method"] == "Runtime.consoleAPICalled" and params["type"] in (
            "error", "warning", "assert"):
            self.log.append(" ".join(str(one.get("value", one.get("description")))
                                     for one in params["args"]))
        elif message["method"] == "Log.entryAdded" and params["entry"]["level"] in (
            "error", "warning"):
            self.log.append(params["entry"]["text"] + " " + params["entry"].get("url", ""))

    def call(self, method, **params):
        self.number += 1
        number = self.number
        message = {"id": number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.out, data):]
        self.listen(lambda: number in self.answers)
        answer = self.answers.pop(number)
        if "error" in answer:
            raise Fault(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def open(self, url):
        self.events.clear()
        self.call("Page.navigate", url=url)
        self.listen(lambda: "Page.loadEventFired" in self.events)

    def run(self, script):
        """The value of an expression, or what its promise gives; $ and $$ are as on a console."""
        answer = self.call("Runtime.evaluate", expression=CONSOLE + script, awaitPromise=True,
                           returnByValue=True)
        if "exceptionDetails" in answer:
            raise Fault(answer["exceptionDetails"].get("exception", {}).get("description", "")
                        + " in " + script[:200])
        return answer["result"].get("value")

    def wait(self, script, seconds=60):
        """Waits until an expression is true."""
        def holds():
            try:
                return self.run(script)
            except Fault as fault:
                if "navigated" in str(fault):  # the page goes away while it is asked
                    return False
                raise

        end = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > end:
                raise Fault(f"after {seconds} s still not true: {script}")
            time.sleep(0.03)

    def size(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)

    def media(self, **features):
        """media(prefers_color_scheme="dark")"""
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": name.replace("_", "-"), "value": value}
                            for name, value in features.items()])

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def key(self, key):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                      windowsVirtualKeyCode={"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39,
                                             "ArrowDown": 40, "Escape": 27, "Tab": 9,
                                           "PageUp": 33, "PageDown": 34, "End": 35,
                                             "Home": 36}.get(key, 0))

    def choose_file(self, selector, path):
        root = self.call("DOM.getDocument")["root"]["nodeId"]
        node = self.call("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.call("DOM.setFileInputFiles", nodeId=node, files=[path])


def without_live(page, without_module, *more):
    """Opens a page where JavaScript, WebAssembly, DecompressionStream or more is missing, or its
    module's file: yields what is missing, the browser, and what its console should not have."""
    for lacks in ("", "delete window.WebAssembly", "delete window.DecompressionStream", *more,
                  "no module"):
        with Browser() as browser:
            no_module = lacks == "no module"
            browser.call("Emulation.setScriptExecutionDisabled", value=lacks == "")
            browser.call("Page.addScriptToEvaluateOnNewDocument", source="" if no_module else lacks)
            browser.open(without_module() if no_module else page)
            time.sleep(1)
            browser.call("Emulation.setScriptExecutionDisabled", value=False)
            # where the file is missing, the browser itself says so
            yield lacks, browser, [] if no_module else browser.log


def run_checks(checks, *given, prepare=lambda browser: None, flags=()):
    """Runs checks of pages, each in a browser of its own with these flags. What they yield and what
    the console logs are faults; says how many."""
    count = 0
    for check in checks:
        began = time.monotonic()
        print(f"{check.__name__}: {check.__doc__.strip()}", flush=True)
        faults = []
        with Browser(*flags) as browser:
            try:
                prepare(browser)
                faults.extend(check(*given, browser))
            except Fault as fault:
                faults.append(str(fault))
            faults += browser.log
        for fault in faults:
            print(f"  FAIL: {fault}"[:400])
        count += len(faults)
        print(f"  {time.monotonic() - began:.0f} s", flush=True)
    return count
