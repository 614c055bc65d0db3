"""Faults by name. Each is called with the campaign and returns a line of what it did, or None when
it found nothing to act on."""
import os
import random
import resource
import shutil
import signal
import socket
import sqlite3
import subprocess
import threading
import time

import processes


def _one(campaign, roles):
    found = [process for process in campaign.processes() if process.role in roles]
    return campaign.random.choice(found) if found else None


def _signal(campaign, roles, number):
    process = _one(campaign, roles)
    if process is None:
        return None
    process.send(number)
    return f"{signal.Signals(number).name} to {process}"


def kill_run(campaign):
    return _signal(campaign, ["run"], signal.SIGKILL)


def kill_match(campaign):
    return _signal(campaign, ["match"], signal.SIGKILL)


def kill_guard(campaign):
    return _signal(campaign, ["guard"], signal.SIGKILL)


def kill_keeper(campaign):
    return _signal(campaign, ["keeper"], signal.SIGKILL)


def kill_playmaker(campaign):
    return _signal(campaign, ["playmaker"], signal.SIGKILL)


def kill_any(campaign):
    return _signal(campaign, ["run", "match", "guard", "keeper", "playmaker"], signal.SIGKILL)


def kill_run_and_matches(campaign):
    """In one go, with the guards alive: they clean up."""
    victims = [p for p in campaign.processes() if p.role in ("run", "match")]
    for process in victims:
        process.send(signal.SIGKILL)
    return f"SIGKILL to {victims}" if victims else None


def interrupt_run(campaign):
    number = campaign.random.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT])
    return _signal(campaign, ["run"], number)


def interrupt_twice(campaign):
    process = _one(campaign, ["run"])
    if process is None:
        return None
    process.send(signal.SIGINT)
    time.sleep(campaign.random.uniform(0, 0.3))
    process.send(signal.SIGINT)
    return f"SIGINT twice to {process}"


def terminate_playmaker(campaign):
    return _signal(campaign, ["playmaker"], signal.SIGTERM)


def pause(campaign):
    """Stops a process for up to a second."""
    process = _one(campaign, ["run", "match", "guard", "keeper", "playmaker"])
    if process is None:
        return None
    seconds = campaign.random.uniform(0.05, 1.0)
    process.send(signal.SIGSTOP)
    time.sleep(seconds)
    process.send(signal.SIGCONT)
    return f"stopped {process} for {seconds:.2f} s"


def hang_playmaker(campaign):
    """Stops a Playmaker for longer than the stall limit."""
    process = _one(campaign, ["playmaker"])
    if process is None:
        return None
    process.send(signal.SIGSTOP)
    time.sleep(4.0)
    process.send(signal.SIGCONT)
    return f"stopped {process} for 4 s"


def limit_descriptors(campaign):
    process = _one(campaign, ["run", "match"])
    if process is None:
        return None
    try:
        used = len(os.listdir(f"/proc/{process.pid}/fd"))
        before = resource.prlimit(process.pid, resource.RLIMIT_NOFILE)
        limit = max(3, used + campaign.random.randint(-2, 4))
        resource.prlimit(process.pid, resource.RLIMIT_NOFILE, (limit, before[1]))
        time.sleep(campaign.random.uniform(0.1, 0.6))
        resource.prlimit(process.pid, resource.RLIMIT_NOFILE, before)
    except OSError:
        return None
    return f"{limit} descriptors for {process}, which used {used}"


def limit_memory(campaign):
    process = _one(campaign, ["match"])
    if process is None:
        return None
    try:
        with open(f"/proc/{process.pid}/statm", encoding="ascii") as file:
            pages = int(file.read().split()[0])
        limit = pages * os.sysconf("SC_PAGE_SIZE") + campaign.random.choice([0, 1, 16]) * 2**20
        resource.prlimit(process.pid, resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))
    except OSError:
        return None
    return f"address space of {process} limited to {limit >> 20} MiB"


def limit_file_size(campaign):
    process = _one(campaign, ["match"])
    if process is None:
        return None
    size = campaign.random.choice([0, 512, 4096, 32768])
    try:
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
    except OSError:
        return None
    return f"files of {process} limited to {size} bytes"


def fill_disk(campaign):
    if not campaign.on_small_disk:
        return None
    filler = campaign.folder.parent / "filler"
    try:
        with open(filler, "wb", buffering=0) as file:
            try:
                while True:
                    file.write(bytes(65536))
            except OSError:
                pass
            time.sleep(campaign.random.uniform(0.1, 1.0))
    finally:
        filler.unlink(missing_ok=True)
    return "disk full"


def cut_connections(campaign):
    if not campaign.forwarder.pairs:
        return None
    reset = campaign.random.random() < 0.5
    campaign.forwarder.cut(reset)
    return "connections cut" + (" with a reset" if reset else "")


def flood_ports(campaign):
    """Noise to the listening ports of all Playmakers."""
    ports = [campaign.forwarder.port, campaign.forwarder.target[1]]
    for process in campaign.processes():
        words = process.command.split()
        if process.role == "playmaker" and "--port" in words:
            ports.append(int(words[words.index("--port") + 1]))
    end = time.monotonic() + campaign.random.uniform(0.1, 0.5)
    count = 0
    while time.monotonic() < end:
        try:
            with socket.create_connection(("127.0.0.1", campaign.random.choice(ports)), 0.2) as peer:
                peer.sendall(campaign.random.randbytes(campaign.random.choice([0, 1, 24, 4096])))
            count += 1
        except OSError:
            pass
    return f"{count} connections with noise to {sorted(set(ports))}"


def _udp_ports(pid):
    """Local UDP ports of a process."""
    inodes = set()
    try:
        for name in os.listdir(f"/proc/{pid}/fd"):
            target = os.readlink(f"/proc/{pid}/fd/{name}")
            if target.startswith("socket:["):
                inodes.add(target[8:-1])
    except OSError:
        return []
    ports = []
    for table in ("/proc/net/udp", "/proc/net/udp6"):
        try:
            with open(table, encoding="ascii") as file:
                rows = [line.split() for line in list(file)[1:]]
        except OSError:
            continue
        ports += [int(row[1].rsplit(":", 1)[1], 16) for row in rows if row[9] in inodes]
    return sorted(set(ports))


def intrude(campaign):
    """A stranger joins, reconnects and watches at all ports of a match, and sends players off."""
    process = _one(campaign, ["match"])
    ports = _udp_ports(process.pid) if process else []
    if not ports:
        return None
    wanted = ["(dispinit version 4)", "(dispcard 1 2 red)", "(dispfoul 0 0 1)", "(init T1 (version 18))",
              "(init T3 (version 18))", "(start)", "(bye)"]
    wanted += [f"(reconnect T{team} {number})" for team in (1, 2, 3) for number in range(1, 12)]
    sent = 0
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.settimeout(0.01)
        for _ in range(3):
            campaign.random.shuffle(wanted)
            for message in wanted:
                for port in campaign.random.sample(ports, min(4, len(ports))):
                    stranger.sendto(message.encode() + b"\0", ("127.0.0.1", port))
                    sent += 1
                try:
                    reply = stranger.recv(8192)
                except OSError:
                    continue
                if reply.startswith((b"(reconnect", b"(init l", b"(init r")):
                    campaign.violate(f"a stranger got {reply[:80]!r} from one of {ports}")
    return f"{sent} messages of a stranger to {len(ports)} ports of {process}"


def squat(campaign):
    """Takes ports that others may want next, UDP and TCP."""
    held = []
    for port in campaign.random.sample(range(20000, 32000), 400) + [6000, 6001, 6002]:
        for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
            peer = socket.socket(socket.AF_INET, kind)
            try:
                peer.bind(("127.0.0.1", port))
                held.append(peer)
            except OSError:
                peer.close()
    time.sleep(campaign.random.uniform(0.2, 1.0))
    for peer in held:
        peer.close()
    return f"{len(held)} ports held"


DECOY = "what a planted link points to\n"


def plant_links(campaign):
    """Links under the names of temporary files that could be guessed, to a file of another."""
    campaign.decoy.write_text(DECOY)
    folders = [campaign.folder, *(path for path in campaign.folder.glob("*") if path.is_dir()),
               *campaign.folder.glob("*/*")]
    names = ["events.jsonl", "schedule.jsonl", "plan.toml", "tournament.db", "result.json",
             "manifest.json", "match.rcg.gz", "match.rcl.gz", "standings.csv"]
    for folder in folders:
        if not folder.is_dir():
            continue
        for name in names:
            for link in (folder / (name + ".tmp"), folder / ("." + name + ".tmp")):
                try:
                    link.symlink_to(campaign.decoy)
                    campaign.planted.append(link)
                except OSError:
                    pass
    return f"{len(campaign.planted)} links planted" if campaign.planted else None


def start_second_run(campaign):
    """Two runs in one folder: one of them plays."""
    if not campaign.is_running():
        return None
    done = subprocess.run([campaign.cls, "tournament", "run", campaign.folder, "--quiet"],
                          check=False, capture_output=True, text=True, env=campaign.environment,
                          timeout=120)
    # The first one may have ended meanwhile, or been killed; then this one plays.
    campaign.check_exit(done.returncode, done.stderr, "second run")
    return f"second run: exit {done.returncode}"


def read_reports(campaign):
    command = campaign.random.choice(["status", "report"])
    done = subprocess.run([campaign.cls, "tournament", command, campaign.folder], check=False,
                          capture_output=True, text=True, env=campaign.environment, timeout=60)
    if done.returncode not in (0, 65, 66):
        campaign.violate(f"`tournament {command}` ended with {done.returncode}: {done.stderr}")
    if done.returncode == 65 and not campaign.on_small_disk:
        campaign.violate(f"`tournament {command}` found a corrupt folder: {done.stderr}")
    return f"{command}: exit {done.returncode}"


def play_by_hand(campaign):
    """`tournament work` beside the run, killed in half of the cases."""
    if not (campaign.folder / "schedule.jsonl").exists():
        return None
    index = campaign.random.randint(1, 4)
    work = subprocess.Popen([campaign.cls, "tournament", "work", campaign.folder, "--index",
                             str(index)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                            text=True, env=campaign.environment)
    try:
        work.communicate(timeout=campaign.random.uniform(0.05, 1.5))
        return f"work {index}: exit {work.returncode}"
    except subprocess.TimeoutExpired:
        work.kill()
        work.communicate()
        return f"work {index}: killed"


def corrupt_store(campaign):
    """Between two runs: every command refuses the folder with one line, or is not affected. Then the
    store is put back."""
    if campaign.is_running():
        return None
    store = campaign.folder / "tournament.db"
    if not store.exists():
        return None
    names = [name for name in ("tournament.db", "tournament.db-wal", "plan.toml", "schedule.jsonl")
             if (campaign.folder / name).exists()]
    backup = campaign.folder.parent / "backup"
    backup.mkdir(exist_ok=True)
    for name in names:
        shutil.copy2(campaign.folder / name, backup / name)
    name = campaign.random.choice(["tournament.db", "tournament.db", "plan.toml", "sql"])
    how = _damage_by_sql(campaign, store) if name == "sql" else _damage(campaign, campaign.folder / name)
    for command in ("status", "report"):
        done = subprocess.run([campaign.cls, "tournament", command, campaign.folder], check=False,
                              capture_output=True, text=True, env=campaign.environment, timeout=60)
        lines = [line for line in done.stderr.splitlines() if line]
        if done.returncode not in (0, 65, 66, 74, 78):
            campaign.violate(f"{name} {how}: `{command}` ended with {done.returncode}: {done.stderr}")
        if done.returncode != 0 and (not lines or not lines[0].startswith("cls: ")):
            campaign.violate(f"{name} {how}: `{command}` prints no reason: {done.stderr!r}")
    for name_of_copy in names:
        shutil.copy2(backup / name_of_copy, campaign.folder / name_of_copy)
    for rest in ("tournament.db-wal", "tournament.db-shm"):
        if rest not in names:
            (campaign.folder / rest).unlink(missing_ok=True)
    shutil.rmtree(backup)
    return f"{name} {how}, then put back"


def _damage(campaign, path):
    data = bytearray(path.read_bytes())
    kind = campaign.random.choice(["truncated", "flipped", "emptied", "overwritten"])
    if kind == "truncated":
        del data[campaign.random.randrange(len(data) + 1):]
    elif kind == "emptied":
        data.clear()
    elif kind == "overwritten":
        data[:] = campaign.random.randbytes(len(data))
    else:
        for _ in range(campaign.random.randint(1, 50)):
            if data:
                data[campaign.random.randrange(len(data))] ^= 1 << campaign.random.randrange(8)
    path.write_bytes(data)
    return kind


def _damage_by_sql(campaign, store):
    value = campaign.random.choice([-1, 99, 2**31, -(2**63), "'x'", "NULL"])
    column = campaign.random.choice(["number", "left_team", "right_team", "pairing", "seed", "round",
                                     "state", "outcome", "attempts", "settled"])
    statement = campaign.random.choice([f"UPDATE match SET {column} = {value} WHERE number = 1",
                                        "DELETE FROM match WHERE number = 2",
                                        "DELETE FROM match", "DROP TABLE match",
                                        "PRAGMA user_version = 99"])
    database = sqlite3.connect(store)
    try:
        with database:
            database.execute(statement)
    except sqlite3.Error:
        pass
    database.close()
    return f"after {statement}"


def step_clock(campaign):
    """The host's clock goes wrong by up to a day, and in half of the cases right again. In a third of
    them a Playmaker hangs from then on: the stall limit must still end it."""
    step = campaign.random.choice([-1, 1]) * campaign.random.choice([1, 60, 3600, 86400])
    if campaign.random.random() < 1 / 3:
        _signal(campaign, ["playmaker"], signal.SIGSTOP)
    time.clock_settime(time.CLOCK_REALTIME, time.time() + step)
    if campaign.random.random() < 0.5:
        return f"clock stepped by {step} s"
    time.sleep(campaign.random.uniform(0.1, 1.0))
    time.clock_settime(time.CLOCK_REALTIME, time.time() - step)
    return f"clock stepped by {step} s and back"


def clock_is_ours():
    """True in the kernel that tests/chaos/clock boots: no other process needs its clock."""
    with open("/proc/cpuinfo", encoding="ascii", errors="replace") as file:
        return "User Mode Linux" in file.read()


# By frequency: faults of processes are cheap, and what users meet.
FAULTS = [
    (kill_run, 3), (kill_match, 3), (kill_guard, 2), (kill_keeper, 2), (kill_playmaker, 3),
    (kill_any, 2), (kill_run_and_matches, 2), (interrupt_run, 3), (interrupt_twice, 1),
    (terminate_playmaker, 1), (pause, 3), (hang_playmaker, 0.3), (limit_descriptors, 2),
    (limit_memory, 2), (limit_file_size, 2), (fill_disk, 2), (cut_connections, 3),
    (flood_ports, 1), (start_second_run, 1), (read_reports, 2), (play_by_hand, 1.5),
    (corrupt_store, 2), (intrude, 3), (squat, 1), (plant_links, 1),
]
if clock_is_ours():
    FAULTS.append((step_clock, 3))


def names():
    return [fault.__name__ for fault, _ in FAULTS]


def choose(generator, only):
    known = [(fault, weight) for fault, weight in FAULTS if not only or fault.__name__ in only]
    return generator.choices([fault for fault, _ in known], [weight for _, weight in known])[0]
