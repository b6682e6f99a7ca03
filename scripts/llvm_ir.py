# SPDX-License-Identifier: MIT
"""Reads the text of an LLVM module: functions, their instructions, calls and loops. As much as the lint needs."""

import dataclasses
import re

NAME = r'[@%](?:"[^"]*"|[\w.$-]+)'
_NOT_CODE = re.compile(NAME + r'|"[^"]*"|![\w.]*|;.*')
_DEFINE = re.compile(r"^define\b.*?(" + NAME + r")\(")
_LABEL = re.compile(r'^("[^"]*"|[\w.$-]+):')
_TARGET = re.compile(r"\blabel %(\"[^\"]*\"|[\w.$-]+)")
_CALL = re.compile(r"^\s*(?:" + NAME + r" = )?(?:(?:tail|musttail|notail) )?(?:call|invoke|callbr)\b(.*)")
_CALLEE = re.compile("(" + NAME + r")\(")


@dataclasses.dataclass
class Line:
    """A line of the module: its number, from 1, and its text."""

    number: int
    text: str

    @property
    def code(self):
        """The text without names, strings, metadata and comments."""
        return _NOT_CODE.sub(" ", self.text)


@dataclasses.dataclass
class Call:
    """A call: callee is a function's name without its sign, or None when it is not known before the program runs."""

    line: Line
    callee: str


class Function:
    """A defined function. header is its first line, lines are its body's, in order."""

    def __init__(self, name, header):
        self.name = name
        self.header = header
        self.lines = []
        self._blocks = {}

    def calls(self):
        """Every call in the body; inline assembly counts as a call that nobody knows."""
        for line in self.lines:
            match = _CALL.match(line.text)
            if match:
                callee = _CALLEE.search(match.group(1))
                known = callee and callee.group(1).startswith("@") and " asm " not in match.group(1)
                yield Call(line, callee.group(1)[1:].strip('"') if known else None)

    def loops(self):
        """The lines whose jump closes a loop: edges to a block that is still open in a depth-first walk."""
        blocks = self._split_into_blocks()
        open_blocks, done, back_edges = set(), set(), []
        first = next(iter(blocks))
        walk = [(first, iter(blocks[first]))]
        open_blocks.add(first)
        while walk:
            block, jumps = walk[-1]
            for target, line in jumps:
                if target in open_blocks:
                    back_edges.append(line)
                elif target not in done:
                    open_blocks.add(target)
                    walk.append((target, iter(blocks[target])))
                    break
            else:
                walk.pop()
                open_blocks.discard(block)
                done.add(block)
        return back_edges

    def _split_into_blocks(self):
        """{label: [(label jumped to, line)]}, the entry block first."""
        blocks = {}
        label = None
        for line in self.lines:
            match = _LABEL.match(line.text)
            if match:
                label = match.group(1)
            blocks.setdefault(label, [])
            blocks[label] += [(target, line) for target in _TARGET.findall(line.text)]
        return blocks


def parse(text):
    """{name: Function} of every function that the module defines."""
    functions = {}
    current = None
    for number, content in enumerate(text.splitlines(), 1):
        line = Line(number, content)
        match = _DEFINE.match(content)
        if match:
            current = Function(match.group(1)[1:].strip('"'), line)
            functions[current.name] = current
        elif content == "}":
            current = None
        elif current and content.strip():
            current.lines.append(line)
    return functions
