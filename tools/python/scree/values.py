"""Values of keys, as TOML for the command line and in scenarios."""
import json
import numbers
import os
import re
import tomllib

from .errors import Error

PART = re.compile(r"([^.\[\]]+)|\[(\d+)\]")


def toml(value, key="set"):
    """A number, string, boolean, path, list, dict or array of numpy, as TOML in one line."""
    if hasattr(value, "tolist"):  # numbers and arrays of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, dict):
        names = (name if re.fullmatch("[A-Za-z0-9_-]+", name) else toml(name) for name in value)
        pairs = (f"{name} = {toml(part, key)}" for name, part in zip(names, value.values()))
        return "{ " + ", ".join(pairs) + " }" if value else "{}"
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(toml(part, key) for part in value) + "]"
    kind = type(value).__name__
    raise Error(f"{key}: a value of the type {kind} has no form in TOML; give a number, string, boolean, list or dict")


def assignments(values):
    """The words --set KEY=VALUE for a dict."""
    return [word for key, value in (values or {}).items() for word in ("--set", f"{key}={toml(value, key)}")]


def overrides(words):
    """The values of words KEY=VALUE by their keys; what is no TOML is a string, as for --set."""
    values = {}
    for word in words:
        key, sign, value = word.partition("=")
        if not sign:
            raise Error(f"{word}: not KEY=VALUE; give a key of the scenario and its value")
        try:
            values |= tomllib.loads(f'"{key}" = {value}')
        except tomllib.TOMLDecodeError:
            values[key] = value
    return values


def value_at(scenario, key):
    """The value of a key such as "contact.glass.friction" or "stage[0].duration"; KeyError if it is not there."""
    value = scenario
    for name, index in PART.findall(key):
        if index:
            value = dict(enumerate(value))[int(index)]
            continue
        if isinstance(value, list):
            tables = [table for table in value if name in (table.get("name"), table.get("plugin"))]
            if len(tables) == 1:
                value = tables[0]
                continue
            if len(value) != 1:
                raise KeyError(key)
            value = value[0]
        if not isinstance(value, dict):
            raise KeyError(key)
        value = value[name]
    return value
