# SPDX-License-Identifier: MIT
"""A progress bar on a terminal's stderr; elsewhere nothing."""

import sys

WIDTH = 24


class Progress:
    """Counts steps up to `total`."""

    def __init__(self, total, stream=sys.stderr):
        self.total = total
        self.done = 0
        self.stream = stream if stream.isatty() else None

    def show(self, what):
        """Say what is under way."""
        if self.stream:
            filled = WIDTH * self.done // max(self.total, 1)
            bar = "#" * filled + "." * (WIDTH - filled)
            self.stream.write(f"\r\033[K[{bar}] {self.done}/{self.total} {what}")
            self.stream.flush()

    def step(self):
        """One step is done."""
        self.done += 1

    def clear(self):
        """Take the bar away, for other text."""
        if self.stream:
            self.stream.write("\r\033[K")
            self.stream.flush()
