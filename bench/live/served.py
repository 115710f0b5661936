# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""A server of our own, started for a measurement and ended after it."""

import pathlib
import re
import signal
import subprocess
import threading

LINK = re.compile(r"http://[\w.:\[\]]*?:(\d+)/#token=([\w-]+)")


class Served:
    """`echoarc serve ARGUMENTS` on a free port of the loopback; a context."""

    def __init__(self, command, *arguments, cwd=None, timeout_s=20):
        self.process = subprocess.Popen([str(command), "serve", *map(str, arguments)], cwd=cwd, stdin=subprocess.DEVNULL,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.lines = []
        self.port = self.token = None
        self._linked = threading.Event()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        if not self._linked.wait(timeout_s) or self.port is None:
            self.process.kill()
            raise RuntimeError("the server printed no link:\n" + "".join(self.lines))

    def _read(self):
        for line in self.process.stdout:
            self.lines.append(line)
            if (match := LINK.search(line)) and self.port is None:
                self.port, self.token = int(match[1]), match[2]
                self._linked.set()
        self._linked.set()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def resident_mb(self):
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+)", status)[1]) / 1024

    def cpu_s(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / 100

    def kill(self):
        self.process.kill()
        self.process.wait()
        self._reader.join(5)
        self.process.stdout.close()

    def end(self, timeout_s=30):
        """Ctrl-C, and waits; the exit status."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(timeout_s)
            except subprocess.TimeoutExpired:
                self.kill()
        if not self.process.stdout.closed:
            self._reader.join(5)
            self.process.stdout.close()
        return self.process.returncode


