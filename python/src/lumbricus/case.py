# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input of a run: a parameter file, and what is changed of it."""
from __future__ import annotations

import dataclasses
import difflib
import itertools
import json
import os
import pathlib
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from .errors import InputError, error_of
from .program import call, find_program, message_of, settings_as_options

if TYPE_CHECKING:
    from .results import Run

Value = bool | int | float | str


@dataclasses.dataclass(frozen=True)
class Parameter:
    """A parameter of a run, as the program describes it.

    Attributes:
        path: "Section/Subsection/Name".
        value: a number, or True and False, where the program takes nothing else; all
            others, formulas and lists too, are texts as in a parameter file.
        default: the value that it has where nobody sets it.
        unit: in the units of the input; "" where there is none.
        meaning: one sentence or two.
    """

    path: str
    value: Value
    default: Value
    unit: str
    meaning: str


def parameters_from(entries: list[dict[str, Any]]) -> dict[str, Parameter]:
    """Those of run.json, by path."""
    return {entry["path"]: Parameter(**entry) for entry in entries}


def text_of(value: object) -> str:
    """As a parameter file has it; numbers to their last digit.

    >>> text_of(0.1), text_of(True), text_of([1, 2.5]), text_of("1 - 0.2*t")
    ('0.1', 'true', '1, 2.5', '1 - 0.2*t')
    """
    if isinstance(value, str):
        return value
    if isinstance(value, (bool,)) or type(value).__name__ == "bool":
        return "true" if value else "false"
    if isinstance(value, (list, tuple)) or hasattr(value, "tolist"):
        items = value.tolist() if hasattr(value, "tolist") else value
        if isinstance(items, (list, tuple)):
            return ", ".join(text_of(item) for item in items)
        return text_of(items)
    return repr(value)


class Case(Mapping[str, Value]):
    """What a parameter file asks for, with changes, all of it looked at by the program.

    A case is a mapping from the paths of all its parameters to their values:

        case = Case("parameters/antagonism/case.prm")
        case["Muscles/circular/wave/Amplitude"] = 0.3
        case["Time/End"]                # 2.0
        case.parameter("Time/End")      # with default, unit and meaning

    A change is checked as ``lumbricus --check`` does it, which takes the time of a
    mesh; ``update()`` makes several at once. Parameters that another choice would have
    are unknown until it is made.

    Args:
        file: a .prm or .json file.
        settings: changes from the beginning on.
        program: that is to check and to run it; find_program() by default.

    Raises InputError, with the program's own message, for whatever is wrong.
    """

    def __init__(self, file: str | os.PathLike[str],
                 settings: Mapping[str, object] | None = None,
                 program: str | os.PathLike[str] | None = None) -> None:
        self.file = pathlib.Path(file)
        self.program = pathlib.Path(program) if program else find_program()
        self.settings: dict[str, str] = {}
        self.parameters: dict[str, Parameter] = {}
        self.update(settings or {})

    def update(self, settings: Mapping[str, object]) -> None:
        """Change several parameters at once; none of them where one is wrong."""
        changed = {**self.settings,
                   **{name: text_of(value) for name, value in settings.items()}}
        for name in settings:
            # As the program finds it: so one setting does not follow another.
            if name.strip() != name or "=" in name:
                raise InputError(f"'{name}' is no path of a parameter.", 1)
        self.parameters = self._asked(changed)
        self.settings = changed

    def _asked(self, settings: Mapping[str, str]) -> dict[str, Parameter]:
        said = call(self.program, [str(self.file), "--values",
                                   *settings_as_options(settings.items())])
        if said.returncode != 0:
            raise error_of(said.returncode, message_of(said.stderr))
        return parameters_from(json.loads(said.stdout))

    def changed(self, settings: Mapping[str, object]) -> Case:
        """Another case, with these changes; this one stays as it is."""
        return Case(self.file, {**self.settings, **settings}, self.program)

    def parameter(self, name: str) -> Parameter:
        """With default, unit and meaning. Raises KeyError, with what is like it."""
        try:
            return self.parameters[name]
        except KeyError:
            near = difflib.get_close_matches(name, self.parameters, 1)
            raise KeyError(
                f"The case has no parameter '{name}'."
                + (f" Did you mean '{near[0]}'?" if near else "")) from None

    def __getitem__(self, name: str) -> Value:
        return self.parameter(name).value

    def __setitem__(self, name: str, value: object) -> None:
        self.update({name: value})

    def __iter__(self) -> Iterator[str]:
        return iter(self.parameters)

    def __len__(self) -> int:
        return len(self.parameters)

    def __repr__(self) -> str:
        changes = f", {self.settings!r}" if self.settings else ""
        return f"Case({str(self.file)!r}{changes})"

    def text(self) -> str:
        """The parameters that differ from their defaults, as a parameter file. Names of
        files stay relative to the working directory."""
        lines: list[str] = []
        open_sections: list[str] = []
        for parameter in self.parameters.values():
            if parameter.value == parameter.default:
                continue
            *sections, name = parameter.path.split("/")
            same = sum(1 for _ in itertools.takewhile(
                lambda pair: pair[0] == pair[1],
                zip(sections, open_sections, strict=False)))
            for depth in range(len(open_sections), same, -1):
                lines.append("  " * (depth - 1) + "end")
            for depth in range(same, len(sections)):
                lines.append("  " * depth + f"subsection {sections[depth]}")
            open_sections = sections
            lines.append("  " * len(sections)
                         + f"set {name} = {text_of(parameter.value)}")
        for depth in range(len(open_sections), 0, -1):
            lines.append("  " * (depth - 1) + "end")
        return "\n".join(lines) + "\n"

    def write(self, file: str | os.PathLike[str]) -> pathlib.Path:
        """Write text() to a .prm file, which does without the first one."""
        path = pathlib.Path(file)
        path.write_text(self.text(), encoding="utf-8")
        return path

    def run(self, folder: str | os.PathLike[str], ranks: int = 1,
            progress: bool | Callable[[float, float], None] | None = None) -> Run:
        """Compute it: see running.run()."""
        from .running import run
        return run(self, folder, ranks=ranks, progress=progress)
