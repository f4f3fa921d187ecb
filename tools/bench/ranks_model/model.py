"""Computing times, and the analytic model: copies, halo that is not hidden, slowest rank, vote."""
import math
import random
import statistics

import cluster

PAIRS = 3.14  # listed pairs a body of beads-4096
PAIR_SHARE = 0.77  # of a step; the rest is for bodies: PERFORMANCE.md, "Where the time of beads-4096 goes"
# A body and step where bodies fit into the caches, and where they do not: PERFORMANCE.md, "Larger scenes".
CACHED_NS, CACHED_BODIES, BODY_NS = 65, 16000, 82
SENT_NS, RECEIVED_NS, ADDED_NS = 30, 12, 10  # record copied to a message, from one, load added: copies.cpp
RECORD_BYTES, LOAD_BYTES = 120, 48
VOTE_BYTES = 20000
# Rabenseifner's Allreduce, which Open MPI's rules, as SMPI has them, choose for 20 kB and 256 or 1024 ranks.
# For 64 ranks they choose recursive doubling (0.04 ms, not 0.02), for 128 a ring (0.26 ms, not 0.03).
ALLREDUCE = "rab_rdb"
SUM_NS = 0.5  # a number of eight bytes in the vote
BEFORE = 0.25  # of the pairs inside tiles, while records are on their way; as many while loads are


def settings(bodies, changed):
    """What `step` and the model read."""
    body_ns = changed.get("body_ns", CACHED_NS if bodies <= CACHED_BODIES else BODY_NS)
    return {"steps": 1, "body": (1 - PAIR_SHARE) * body_ns, "pair": PAIR_SHARE * body_ns / PAIRS,
            "sent": SENT_NS, "received": RECEIVED_NS, "added": ADDED_NS,
            "vote": VOTE_BYTES, "allreduce": ALLREDUCE, "before": BEFORE, "unevenness": 0, **changed}


def read(path):
    """Of each rank: bodies, pairs inside tiles, between tiles, and partners (rank, records, loads)."""
    with open(path) as lines:
        for line in lines:
            numbers = [int(word) for word in line.split()]
            yield *numbers[:3], list(zip(numbers[3::3], numbers[4::3], numbers[5::3]))


def from_higher(rank, partners):
    """Records and loads of the pairs of a rank with bodies of others."""
    return (sum(records for other, records, _ in partners if other > rank),
            sum(loads for other, _, loads in partners if other > rank))


def summary(path):
    """Records of others by own bodies, mean and largest; loads by pairs; partners; largest work by mean."""
    ranks = list(read(path))
    halos = [from_higher(k, partners) for k, (*_, partners) in enumerate(ranks)]
    bodies, pairs = sum(r[0] for r in ranks), sum(r[1] + r[2] for r in ranks)
    work = [(1 - PAIR_SHARE) * r[0] + PAIR_SHARE / PAIRS * (r[1] + r[2]) for r in ranks]
    return (sum(h[0] for h in halos) / bodies, max(h[0] for h in halos) * len(ranks) / bodies,
            sum(h[1] for h in halos) / pairs, statistics.mean(len(r[3]) for r in ranks),
            max(work) / statistics.mean(work))


def exchange_time(ranks, own_bytes, to_lower, link):
    """Time (s) of all messages: of the busiest link of a node, or of the longest message inside one."""
    out, into, longest = {}, {}, 0
    for k, (*_, partners) in enumerate(ranks):
        for other, *numbers in partners:
            if (other < k) != to_lower:
                continue
            size, node, target = own_bytes(numbers), k // cluster.NODE_RANKS, other // cluster.NODE_RANKS
            longest = max(longest, size)
            if node != target:
                out[node] = out.get(node, 0) + size
                into[target] = into.get(target, 0) + size
    busiest = max([0, *out.values(), *into.values()])
    data = max(longest / (1e9 * cluster.MEMORY_GB_S), busiest / (1e9 * link)) / cluster.PAYLOAD
    return data + 6 * cluster.LINK_LATENCY


def vote_time(ranks, size, algorithm, link):
    """Time (s) of an Allreduce, nearest ranks first: by recursive doubling (rdb) ranks exchange all of it in
    each round, by Rabenseifner a half, a quarter and so on, and then the sums."""
    inside = math.log2(min(ranks, cluster.NODE_RANKS))
    across = max(0, math.log2(ranks / cluster.NODE_RANKS))
    rounds = inside * (cluster.MEMORY_LATENCY + 2 * cluster.OVERHEAD)
    rounds += across * (2 * cluster.LINK_LATENCY + 2 * cluster.OVERHEAD)
    data, sums = 1e-9 * size / cluster.PAYLOAD, 1e-9 * SUM_NS * size / 8
    if algorithm == "rdb":
        across_data = across * cluster.NODE_RANKS / link  # all ranks of a node at once
        return rounds + data * (inside / cluster.MEMORY_GB_S + across_data) + (inside + across) * sums
    # Between nodes each rank has a share of its own, so that a node sends all of it.
    return 2 * rounds + 2 * data * (1 / cluster.MEMORY_GB_S + (across > 0) / link) + sums


def predict(path, s, link):
    """Efficiency: mean computing time over the step of the slowest rank with what nothing hides."""
    ranks = list(read(path))
    if len(ranks) == 1:
        return 1
    work, busy = [], []
    for k, (bodies, inner, cross, partners) in enumerate(ranks):
        records, loads = from_higher(k, partners)
        sent, added = (sum(p[i] for p in partners) - total for i, total in ((1, records), (2, loads)))
        copies = s["sent"] * sent + s["received"] * records + s["added"] * added
        work.append(1e-9 * (s["body"] * bodies + s["pair"] * (inner + cross)))
        busy.append(work[-1] + 1e-9 * copies + 2 * cluster.OVERHEAD * len(partners))
    hidden = 1e-9 * s["pair"] * statistics.mean(r[1] for r in ranks)
    before, after = (0, 0) if s["before"] < 0 else (s["before"] * hidden, s["before"] * hidden)
    records = exchange_time(ranks, lambda numbers: RECORD_BYTES * numbers[0], True, link)
    loads = exchange_time(ranks, lambda numbers: LOAD_BYTES * numbers[1], False, link)
    random_numbers = random.Random(1)
    slowest = statistics.mean(max(time + s["unevenness"] * own * random_numbers.gauss(0, 1)
                                  for time, own in zip(busy, work)) for _ in range(20))
    waits = max(0, records - before) + max(0, loads - after)
    vote = vote_time(len(ranks), s["vote"], s["allreduce"], link)
    return statistics.mean(work) / (slowest + waits + vote)
