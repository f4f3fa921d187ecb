"""The simulated cluster: nodes of 64 ranks, each node with one link to a switch that does not limit them."""
import math
import pathlib
import subprocess
import tempfile

NODE_RANKS = 64
LINK_LATENCY = 0.75e-6  # (s) of a link; a message between nodes passes two
MEMORY_GB_S, MEMORY_LATENCY = 5, 0.5e-6  # a message inside a node, however many there are
OVERHEAD = 0.4e-6  # (s) of the processor for a message that is sent or received
EAGER = 65536  # bytes: longer messages first ask the receiver, which costs two more latencies
PAYLOAD = 0.95  # share of the rate of a link

PLATFORM = """<?xml version='1.0'?>
<!DOCTYPE platform SYSTEM "https://simgrid.org/simgrid.dtd">
<platform version="4.1">
  <cluster id="cluster" prefix="node" suffix="" radical="0-{last}" speed="1Gf" core="{cores}"
           bw="{link}GBps" lat="{latency}s" sharing_policy="SPLITDUPLEX"
           loopback_bw="{memory}GBps" loopback_lat="{memory_latency}s"/>
</platform>
"""
OPTIONS = {"smpi/simulate-computation": "no", "smpi/host-speed": "1Gf", "smpi/coll-selector": "ompi",
           "smpi/lat-factor": f"0:1;{EAGER}:3", "smpi/bw-factor": f"0:{PAYLOAD}",
           "smpi/os": f"0:{OVERHEAD}:0", "smpi/ois": f"0:{OVERHEAD}:0", "smpi/or": f"0:{OVERHEAD}:0",
           "smpi/async-small-thresh": EAGER, "smpi/send-is-detached-thresh": EAGER}
# Of step.cpp, in its order.
ARGUMENTS = ("steps", "body", "pair", "sent", "received", "added", "vote", "before", "unevenness")


def nodes(ranks):
    return math.ceil(ranks / NODE_RANKS)


def simulate(folder, messages, ranks, settings, link):
    """Times (us) of a step: means over ranks, and (mean, longest) waits for messages."""
    with tempfile.TemporaryDirectory(dir=folder) as name:
        own = pathlib.Path(name)
        (own / "platform.xml").write_text(PLATFORM.format(
            last=nodes(ranks) - 1, cores=NODE_RANKS, link=link, latency=LINK_LATENCY, memory=MEMORY_GB_S,
            memory_latency=MEMORY_LATENCY))
        (own / "hosts").write_text("".join(f"node{k}:{NODE_RANKS}\n" for k in range(nodes(ranks))))
        words = [settings[key] for key in ARGUMENTS]
        options = {**OPTIONS, "smpi/allreduce": settings["allreduce"]}
        flags = [f"--cfg={key}:{value}" for key, value in options.items()]
        # Ranks may share one copy of the program, which has no variables of its own.
        done = subprocess.run(
            ["smpirun", "-no-privatize", "-platform", "platform.xml", "-hostfile", "hosts", "-np", str(ranks),
             folder / "step", messages, *map(str, words), "--log=root.thres:error", *flags],
            cwd=own, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"smpirun: {done.stderr[-2000:]}")
    *phases, longest_records, longest_loads, vote = map(float, done.stdout.split())
    computing, copies, records, loads, voting = phases
    return {"computing": computing, "copies": copies, "records": (records, longest_records),
            "loads": (loads, longest_loads), "slowest rank": voting - vote, "vote": vote, "step": sum(phases)}
