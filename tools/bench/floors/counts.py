"""Counts instructions of the loops over pairs and bodies, in the machine code of a build with debug information, from
which each instruction tells the functions that it is inlined from."""
import collections
import dataclasses
import json
import pathlib
import re
import shlex
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = ROOT / "build/release"

# Of instructions without the leading v. A class that is not named counts as `any` alone.
CLASSES = {
    "multiply": r"mul[ps]d|fn?m(add|sub)|div|sqrt|cmp",  # and what may share their units, see rates.cpp
    "add": r"(add|sub|max|min)[ps]d|ps[rl][al]",
    "cross": r"perm2|permp|permt2|permi2|shuf[fi]64|insert|extract",
    "shuffle": r"p?unpck|shufp|permil|movddup|broadcast|palignr",
}


@dataclasses.dataclass
class Instruction:
    address: int
    text: str
    functions: str  # that it is inlined from, innermost first
    mnemonic: str = ""
    operands: str = ""

    def __post_init__(self):
        self.mnemonic, _, rest = self.text.partition(" ")
        self.operands = rest.split("#")[0].split("<")[0].strip()

    def is_vector(self):
        return "mm" in self.operands

    def width(self):
        return 512 if "zmm" in self.operands else 256

    def classes(self):
        """Resources that it takes."""
        if not self.is_vector():
            return []
        source, _, last = self.operands.rpartition(",")
        stores, loads = "(" in self.operands and last.endswith(")"), "(" in source
        name = self.mnemonic[1:]
        if stores:
            return ["store"]
        found = ["load"] if loads else []
        if re.match(r"mov[aud]|movq|lddqu|zeroupper|broadcasts", name) and (loads or "k" not in last and "{" not in last):
            return found
        for kind, pattern in CLASSES.items():
            if re.match(pattern, name):
                # With a part from memory they need no unit for shuffles.
                return found + ["any"] + ([] if loads and kind in ("cross", "shuffle") else [kind])
        return found + ["any"]


def compiled(source, level, folder):
    """Object file of a source as the release build compiles it for a level, with debug information."""
    commands = json.loads((BUILD / "compile_commands.json").read_text())
    own = [c for c in commands if c["file"].endswith(source) and f"v{level}" in c["command"]]
    other = [c for c in commands if "scree_framework.dir" in c["command"]]
    command = (own or other)[0]
    words = [word for word in shlex.split(command["command"]) if not word.endswith("ccache")]
    result = folder / (pathlib.Path(source).stem + ".o")
    words[words.index("-o") + 1], words[words.index("-c") + 1] = str(result), str(ROOT / source)
    subprocess.run([*words, "-g"], cwd=command["directory"], check=True)
    return result


def instructions(object_file, symbol):
    """Of the function whose name matches a pattern."""
    names = subprocess.run(["nm", object_file], check=True, capture_output=True, text=True).stdout.split()
    found = [name for name in names if re.search(symbol, name)]
    if len(found) != 1:
        raise SystemExit(f"floors: {len(found)} functions match '{symbol}' in {object_file.name}; adapt the pattern")
    listing = subprocess.run(["objdump", "-dl", "--inlines", "--no-show-raw-insn", f"--disassemble={found[0]}", object_file],
                             check=True, capture_output=True, text=True).stdout
    result, functions, fresh = [], [], True
    for line in listing.splitlines():
        if code := re.match(r"^\s*([0-9a-f]+):\s+(\S.*)$", line):
            result.append(Instruction(int(code[1], 16), code[2], "\n".join(functions)))
            fresh = True
            continue
        if fresh:  # what follows belongs to the next instructions
            functions, fresh = [], False
        if place := re.match(r"^(\S.*)\(\):$|^inlined by .*\((.*)\)$", line):
            functions.append(place[1] or place[2])
    return result


def innermost_loops(code):
    index = {instruction.address: n for n, instruction in enumerate(code)}
    loops = set()
    for n, instruction in enumerate(code):
        jump = re.match(r"j\w+\s+([0-9a-f]+)", instruction.text)
        if jump and index.get(int(jump[1], 16), n + 1) <= n:
            loops.add((index[int(jump[1], 16)], n))
    return [code[a:b + 1] for a, b in loops if not any((a, b) != (c, d) and a <= c and d <= b for c, d in loops)]


def loop(code, inlined_from):
    """The innermost loop with most vector instructions from a function; of several, the shortest: others prefetch.
    None if the compiler has unrolled it completely."""
    def share(body):
        return sum(bool(re.search(inlined_from, i.functions)) for i in body if i.is_vector())
    loops = [body for body in innermost_loops(code) if share(body) > 8]
    if not loops:
        return None
    widest = max(i.width() for body in loops for i in body if i.is_vector())
    loops = [body for body in loops if any(i.is_vector() and i.width() == widest for i in body)]
    most = max(share(body) for body in loops)
    return min((body for body in loops if share(body) >= 0.9 * most), key=len)


def counts(body):
    """Number of instructions by class and width, and of all (`issue`)."""
    number = collections.Counter(issue=len(body))
    for instruction in body:
        for kind in instruction.classes():
            number[f"{kind}_{instruction.width()}"] += 1
    return number


def per_item(code, inlined_from, items=None, block=48):
    """Counts for one pair or body. items: of an iteration, if not as many as a register has numbers. block: items of a
    loop that is unrolled completely."""
    body = loop(code, inlined_from)
    if not body:
        body, items = [i for i in code if re.search(inlined_from, i.functions)], block
    if not any(i.is_vector() for i in body):
        raise SystemExit(f"floors: no loop from '{inlined_from}'; adapt the pattern")
    items = items or max(i.width() for i in body if i.is_vector()) // 64
    return {kind: number / items for kind, number in counts(body).items()}
