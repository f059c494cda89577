"""Campaigns of releases, from a file or empty; every key is an attribute.

A campaign is stored as the tables and keys of its file, and is read by the reader of the program from
TOML text: the text of the file if nothing was changed, else text written from the tables. Keys, ranges
and refusals are therefore those of the program, results contain the campaign that made them, and a
campaign made in a notebook can be saved and run without Python.
"""

from __future__ import annotations

import copy
import difflib
import json
import numbers
import os
import re
from collections.abc import Mapping, MutableMapping, MutableSequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clast import _core
from clast._core import InputError
from clast._results import Results

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from clast._blocks import PathLike, Progress

_KEYS: dict[str, list[str]] = _core.campaign_tables
_TABLES = [name for name in _KEYS if "." not in name]
_LISTS = ("block_group", "mass", "barrier")  # written [[name]]
_FREE = {"ground": "ground"}  # tables by names of the user's: zones
_INNER = {
    ("blocks", "vary"): "blocks.vary",
    ("contact", "blocks"): "contact.blocks",
    ("block_group", "ground"): None,
}


def _toml(value: Any, where: str) -> str:
    """A value as TOML has it."""
    if isinstance(value, (bool,)) or type(value).__name__ == "bool_":
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        items = (f"{_key(k)} = {_toml(v, f'{where}.{k}')}" for k, v in value.items())
        return "{ " + ", ".join(items) + " }"
    if hasattr(value, "tolist"):
        return _toml(value.tolist(), where)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(item, where) for item in value) + "]"
    raise TypeError(f"{where}: a {type(value).__name__} can't stand in a campaign")


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else _toml(name, name)


def _lines(title: str, table: Mapping[str, Any], where: str) -> list[str]:
    lines = [f"\n{title}"]
    for key, value in table.items():
        if value is None or (isinstance(value, Mapping) and not value):
            continue
        lines.append(f"{_key(key)} = {_toml(value, f'{where}.{key}')}")
    return lines


def _text(tables: Mapping[str, Any]) -> str:
    """The tables as a campaign file."""
    lines: list[str] = []
    order = [name for name in _TABLES if name in tables]
    for name in order + [name for name in tables if name not in _TABLES]:
        value = tables[name]
        if isinstance(value, list):
            for item in value:
                if not isinstance(item, Mapping):
                    lines.insert(0, f"{_key(name)} = {_toml(value, name)}")
                    break
                lines += _lines(f"[[{_key(name)}]]", item, name)
        elif not isinstance(value, Mapping):
            lines.insert(0, f"{_key(name)} = {_toml(value, name)}")
        elif name in _FREE and all(isinstance(zone, Mapping) for zone in value.values()):
            for zone, keys in value.items():
                lines += _lines(f"[{_key(name)}.{_key(zone)}]", keys, f"{name}.{zone}")
        elif value:
            lines += _lines(f"[{_key(name)}]", value, name)
    return "\n".join(lines).lstrip("\n") + "\n"


def _plain(value: Any) -> Any:
    """Tables and mappings as dicts, all else as it is."""
    if isinstance(value, CampaignTable):
        return copy.deepcopy(value._values)
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items() if item is not None}
    if isinstance(value, CampaignTables):
        return copy.deepcopy(value._items)
    if isinstance(value, list) and any(isinstance(i, (Mapping, CampaignTable)) for i in value):
        return [_plain(item) for item in value]
    return value


class CampaignTable(MutableMapping):
    """A table of a campaign. Its keys are attributes, `None` if they are not given.

    Keys that are not valid attribute names, and names such as those of ground zones, are items:
    `campaign.ground["scree"].friction`, `barrier["from"]` or `barrier.from_`.
    """

    __slots__ = ("_name", "_keys", "_values")

    def __init__(self, name: str, keys: list[str] | None, values: dict[str, Any]) -> None:
        object.__setattr__(self, "_name", name)
        object.__setattr__(self, "_keys", keys)
        object.__setattr__(self, "_values", values)

    def _known(self, name: str) -> str:
        keys = self._keys
        key = name[:-1] if name.endswith("_") else name
        if keys is None or key in keys:
            return key
        near = difflib.get_close_matches(key, keys, 1)
        hint = f"; did you mean {near[0]}?" if near else f"; its keys are {', '.join(keys)}"
        raise AttributeError(f"[{self._name}] has no key {key}{hint}")

    def __getitem__(self, key: str) -> Any:
        value = self._values[key]
        if isinstance(value, dict):
            return self._inner(key, value)
        return value

    def _inner(self, key: str, value: dict[str, Any]) -> CampaignTable:
        name = f"{self._name}.{key}"
        if self._name in ("ground", "block_group.ground"):
            return CampaignTable(name, _KEYS["ground"], value)
        table = _INNER.get((self._name, key))
        return CampaignTable(name, _KEYS[table] if table else None, value)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        key = self._known(name)
        if (self._name, key) in _INNER and key not in self._values:
            self._values[key] = {}
        return self[key] if key in self._values else None

    def __setitem__(self, key: str, value: Any) -> None:
        if value is None:
            self._values.pop(key, None)
        else:
            self._values[key] = _plain(value)

    def __setattr__(self, name: str, value: Any) -> None:
        self[self._known(name)] = value

    def __delitem__(self, key: str) -> None:
        del self._values[key]

    def __delattr__(self, name: str) -> None:
        self._values.pop(self._known(name), None)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __dir__(self) -> Iterable[str]:
        return sorted({*super().__dir__(), *(self._keys or [])})

    def __repr__(self) -> str:
        return "\n".join(_lines(f"[{self._name}]", self._values, self._name)).lstrip()


class CampaignTables(MutableSequence):
    """Tables of one name, such as the barriers: a list of `CampaignTable`."""

    __slots__ = ("_name", "_items")

    def __init__(self, name: str, items: list[Any]) -> None:
        self._name = name
        self._items = items

    def __getitem__(self, index: Any) -> Any:
        item = self._items[index]
        if isinstance(index, slice) or not isinstance(item, dict):
            return item
        return CampaignTable(self._name, _KEYS[self._name], item)

    def __setitem__(self, index: Any, value: Any) -> None:
        self._items[index] = _plain(value)

    def __delitem__(self, index: Any) -> None:
        del self._items[index]

    def __len__(self) -> int:
        return len(self._items)

    def insert(self, index: int, value: Any) -> None:
        """A table, or a dict with its keys."""
        self._items.insert(index, _plain(value))

    def add(self, **keys: Any) -> CampaignTable:
        """Adds a table with these keys, `from_` for from, and returns it."""
        table = CampaignTable(self._name, _KEYS[self._name], {})
        for name, value in keys.items():
            setattr(table, name, value)
        self._items.append(table._values)
        return table

    def __repr__(self) -> str:
        return repr([self[i] for i in range(len(self))])


class _Run(CampaignTable):
    """The table [run]; calling it runs the campaign."""

    __slots__ = ("_campaign",)

    def __init__(self, campaign: Campaign, values: dict[str, Any]) -> None:
        super().__init__("run", _KEYS["run"], values)
        object.__setattr__(self, "_campaign", campaign)

    def __call__(
        self,
        output: PathLike = "results.h5",
        *,
        threads: int = 0,
        resume: bool = False,
        replace: bool = False,
        checkpoint_interval: float = 300.0,
        shard: tuple[int, int] | None = None,
        progress: Progress | None = None,
    ) -> Results:
        """Runs the campaign, and returns its results.

        Ctrl-C stops after the runs in progress, which are kept; with persistent blocks it stops at once,
        after writing checkpoints. `resume=True` continues.

        Args:
            output: results file; a shard has ".2of4" before its extension.
            threads: number of threads, 0: one for each core; results do not depend on it.
            resume: continue an interrupted campaign.
            replace: replace existing results.
            checkpoint_interval: seconds between checkpoints of a realisation of persistent blocks,
                from which `resume=True` continues after a crash; 0: only on Ctrl-C.
            shard: (i, n): simulate only every n-th run, from the i-th; `merge_results` joins shards.
            progress: called repeatedly with a dict: done, total, before, what.
        """
        text, place = self._campaign._source()
        options = dict(
            threads=threads,
            resume=resume,
            replace=replace,
            checkpoint_interval=checkpoint_interval,
            shard=shard,
        )
        return Results(_core.campaign_run(text, place, os.path.abspath(output), options, progress))


class Campaign:
    """A campaign of releases.

        >>> campaign = clast.Campaign("campaign.toml")
        >>> campaign.ground["scree"].friction = 0.55
        >>> campaign.run.max_time_s = 30
        >>> results = campaign.run(threads=2)

    Its attributes are the tables of a campaign file (docs/formats.md): blocks, block_group, terrain,
    ground, ensemble, release, mass, contact, barrier, run. Paths start from the folder of the file;
    without a file, from the working directory.

    Args:
        file: a campaign file; without, an empty campaign.
        tables: tables that replace those of the file, as dicts.
    """

    def __init__(self, file: PathLike | None = None, **tables: Any) -> None:
        self.__dict__["file"] = None if file is None else Path(file)
        self.__dict__["_original"] = None
        self.__dict__["_tables"] = {}
        if file is not None:
            text, values = _core.campaign_read(file)
            self.__dict__["_tables"] = values
            self.__dict__["_original"] = (text, _text(values))
        for name, value in tables.items():
            setattr(self, name, value)

    def _known(self, name: str) -> str:
        if name in _TABLES:
            return name
        near = difflib.get_close_matches(name, _TABLES, 1)
        hint = f"; did you mean {near[0]}?" if near else f"; its tables are {', '.join(_TABLES)}"
        raise AttributeError(f"a campaign has no table {name}{hint}")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        self._known(name)
        if name not in self._tables:
            self._tables[name] = [] if name in _LISTS else {}
        value = self._tables[name]
        if name in _LISTS and isinstance(value, dict):
            value = self._tables[name] = [value]
        if isinstance(value, list):
            return CampaignTables(name, value)
        if not isinstance(value, dict):
            return value
        if name == "run":
            return _Run(self, value)
        return CampaignTable(name, None if name in _FREE else _KEYS[name], value)

    def __setattr__(self, name: str, value: Any) -> None:
        self._known(name)
        if value is None:
            self._tables.pop(name, None)
            return
        if name in _LISTS and isinstance(value, Mapping):
            value = [value]
        elif isinstance(value, Mapping) and name not in _FREE:
            table = CampaignTable(name, _KEYS[name], {})
            for key in value:
                table._known(key)  # an unknown key is refused at once
        self._tables[name] = _plain(value)

    def __delattr__(self, name: str) -> None:
        self._tables.pop(self._known(name), None)

    def __dir__(self) -> Iterable[str]:
        return sorted({*super().__dir__(), *_TABLES})

    @property
    def text(self) -> str:
        """The campaign as TOML: the text of the file if nothing was changed."""
        made = _text(self._tables)
        if self._original is not None and made == self._original[1]:
            return self._original[0]
        return made

    def _source(self) -> tuple[str, str]:
        """Its text, and the file that the text is in or could be in."""
        text = self.text
        if self.file is None:
            return text, os.path.join(os.getcwd(), "campaign")
        changed = text != self._original[0]
        return text, f"{self.file} (changed)" if changed else str(self.file)

    def write(self, output: PathLike, *, replace: bool = False) -> None:
        """Writes the campaign to a file; its paths then start from the folder of that file."""
        _core.campaign_write(output, self.text, replace)

    def check(self) -> list[str]:
        """All errors, in sentences; empty if the campaign can be run."""
        return _core.campaign_check(*self._source())[0]

    def plan(self) -> dict[str, Any]:
        """The planned runs, as in `clast check --json`.

        Raises:
            InputError: the campaign has errors; the message lists them.
        """
        findings, plan = _core.campaign_check(*self._source())
        if findings:
            raise InputError("\n".join(findings))
        return plan

    def dry_run(
        self,
        map: PathLike | None = None,  # noqa: A002
        *,
        threads: int = 0,
        shard: tuple[int, int] | None = None,
        margin: float | None = None,
    ) -> dict[str, Any]:
        """The planned runs and the estimated time, as in `clast simulate --dry-run --json`.

        Args:
            map: file for a map (svg).
            margin: difference in runout that matters, m: estimates the number of runs to detect it.
        """
        options = dict(map=map, threads=threads, shard=shard, margin=margin)
        return _core.campaign_dry_run(*self._source(), options)

    def export(
        self,
        folder: PathLike = "export",
        *,
        to: str = "rockable",
        runs: Iterable[int] | None = None,
        replace: bool = False,
    ) -> tuple[list[str], list[str]]:
        """Writes scenes for another engine.

        Args:
            to: "rockable" or "exadem".
            runs: numbers of runs, or of realisations of a mass; default: all.
            replace: replace existing scenes in the folder.

        Returns:
            The folders, one for each scene, and the features that the other engine cannot express.
        """
        options = dict(to=to, runs=None if runs is None else list(runs), replace=replace)
        return _core.campaign_export(*self._source(), folder, options)

    def __repr__(self) -> str:
        return f"<clast.Campaign {self.file or 'without a file'}>"

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self.text)}</pre>"


def campaign_schema() -> dict[str, Any]:
    """The JSON Schema of campaign files, as `clast check --schema` prints it."""
    return _core.campaign_schema()


def new_campaign(
    library: PathLike,
    terrain: PathLike | Iterable[PathLike],
    output: PathLike = "campaign.toml",
    *,
    replace: bool = False,
) -> tuple[Campaign, list[str]]:
    """Write a complete, commented campaign from a library and a terrain.

    Returns:
        The campaign, and notes on its assumptions, in sentences.
    """
    doubts = _core.new_campaign(library, terrain, output, replace)
    return Campaign(output), doubts
