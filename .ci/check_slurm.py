#!/usr/bin/env python3
"""A sweep as a job array of a real Slurm that loses members: what is run again and joined is what one run gives.

Usage: check_slurm.py PROGRAM FOLDER [DECK]
       check_slurm.py --try FOLDER            only starts Slurm and ends it

Starts Slurm on this machine alone (slurmctld, slurmd, munged by hand as root, bound to 127.0.0.1, one node, no cgroups), submits
input/sweep_slurm.sh, kills two members of the array and holds up a third until it runs out of time. The merge must name these
three; run again as it says, with a merge that waits for them, the sweep must be the same bytes as that of one run.
Packages: slurmctld slurmd slurm-client munge.
"""
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import time

PARTS = 6
KILLED, LATE = (2, 5), 4            # members of the array
PATIENCE = 120                      # seconds for anything that Slurm is waited for
START = 20                          # seconds for its daemons
NEEDED = ("slurmctld", "slurmd", "sbatch", "scancel", "squeue", "munged", "mungekey")
CONF = """ClusterName=drillgap
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={home}/munge.socket
CryptoType=crypto/munge
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmctldPort={port}
SlurmdPort={other}
StateSaveLocation={home}/state
SlurmdSpoolDir={home}/spool
SlurmctldPidFile={home}/slurmctld.pid
SlurmdPidFile={home}/slurmd.pid
SlurmctldLogFile={home}/slurmctld.log
SlurmdLogFile={home}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000
ReturnToService=2
JobRequeue=0
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def wait_for(what, found, patience=PATIENCE):
    start = time.monotonic()
    while time.monotonic() - start < patience:
        result = found()
        if result:
            return result
        time.sleep(0.05)
    raise SystemExit(f"FAULT waited {patience} s in vain: {what}")


def free_ports():
    sockets = [socket.socket() for _ in range(2)]
    for item in sockets:
        item.bind(("127.0.0.1", 0))
    ports = [item.getsockname()[1] for item in sockets]
    for item in sockets:
        item.close()
    return ports


class Cluster:
    """One node of Slurm, its daemons children of this process."""

    def __init__(self, home, program):
        self.home, self.daemons = home, []
        try:
            self.begin(home, program)
        except BaseException:
            self.stop()
            raise

    def begin(self, home, program):
        for name in ("state", "spool", "bin"):
            (home / name).mkdir(parents=True)
        home.chmod(0o755)
        (home / "bin/drillgap").symlink_to(program)
        port, other = free_ports()
        host = socket.gethostname().split(".")[0]
        (home / "slurm.conf").write_text(CONF.format(home=home, host=host, port=port, other=other), encoding="utf-8")
        self.environment = dict(os.environ, SLURM_CONF=str(home / "slurm.conf"), PATH=f"{home}/bin:{os.environ['PATH']}",
                                SBATCH_EXPORT="ALL")
        self.run("mungekey", "--create", "--bits=1024", f"--keyfile={home}/munge.key")
        self.start("munged", "--foreground", "--force", f"--key-file={home}/munge.key", f"--socket={home}/munge.socket",
                   f"--pid-file={home}/munge.pid", f"--log-file={home}/munge.log", f"--seed-file={home}/munge.seed")
        wait_for("munged", (home / "munge.socket").exists, START)
        self.start("slurmctld", "-D", "-i")
        self.start("slurmd", "-D", "-N", host)
        wait_for("an idle node", lambda: "idle" in self.run("sinfo", "--noheader", "--format=%t", check=False).split(), START)

    def start(self, *command):
        with open(self.home / f"{command[0]}.out", "wb") as out:
            self.daemons.append(subprocess.Popen(command, env=self.environment, stdout=out, stderr=out, start_new_session=True))

    def run(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, cwd=self.home, check=False)
        if check and done.returncode != 0:
            raise SystemExit(f"FAULT {' '.join(map(str, command))}: {done.stdout}{done.stderr}")
        return done.stdout

    def ended(self, job):
        wait_for(f"the end of job {job}", lambda: not self.run("squeue", "--noheader", "--states=all", f"--jobs={job}",
                 "--format=%T", check=False).replace("COMPLETED", "").replace("FAILED", "").replace("TIMEOUT", "")
                 .replace("CANCELLED", "").replace("NODE_FAIL", "").split())

    def stop(self):
        if len(self.daemons) == 3:
            self.run("scancel", "--user=root", check=False)
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()


def member(part):
    """Process of a part, by its command line."""
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = path.read_bytes().decode(errors="replace").split("\0")
        except OSError:
            continue
        if words[0].endswith("drillgap") and f"{part}/{PARTS}" in words:
            return int(path.parent.name)
    return 0


def main():
    path = "/usr/sbin:/sbin:" + os.environ["PATH"]
    lacking = [name for name in NEEDED if not shutil.which(name, path=path)]
    if lacking or os.geteuid() != 0:
        print("FAULT not here:", *lacking, "root" if os.geteuid() else "")
        return 1
    os.environ["PATH"] = path
    home = pathlib.Path(sys.argv[2]).resolve()
    if sys.argv[1] == "--try":
        Cluster(home, pathlib.Path("/bin/false")).stop()
        return 0
    program = pathlib.Path(sys.argv[1]).resolve()
    root = pathlib.Path(__file__).resolve().parent.parent
    deck = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else root / "input/sweep_gp1.nml").resolve()
    script = str(root / "input/sweep_slurm.sh")
    whole, parts = home/"whole", home/"parts"
    subprocess.run([program, deck, "--output", whole, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    csv = next(whole.glob("sweep_*.csv")).name
    record = str(parts / csv.replace(".csv", ".part_{}_of_" + str(PARTS)))
    cluster = Cluster(home/"slurm", program)
    try:
        return campaign(cluster, program, deck, script, parts, record) or \
            int((whole/csv).read_bytes() != (parts/csv).read_bytes() and bool(print("FAULT the merged sweep is not that of one run") or 1))
    finally:
        cluster.stop()


def numbers(text):
    """The parts of a list as in 3,7-9."""
    ends = [list(map(int, item.split("-"))) for item in text.split(",")]
    return {number for item in ends for number in range(item[0], item[-1] + 1)}


def campaign(cluster, program, deck, script, parts, record):
    job = cluster.run("sbatch", "--parsable", f"--array=1-{PARTS}%3", "--time=1", script, deck, str(PARTS), "--output", parts, "--quiet").strip()
    held = {}
    for part in sorted((*KILLED, LATE)):
        wait_for(f"results of part {part}", pathlib.Path(record.format(part)).exists)
        held[part] = member(part)
        os.kill(held[part], signal.SIGSTOP)
    os.kill(held[KILLED[0]], signal.SIGKILL)                              # as the kernel does that lacks memory
    cluster.run("scancel", "--full", "--signal=KILL", f"{job}_{KILLED[1]}")
    start = time.monotonic()
    cluster.ended(job)                                                    # Slurm lets a stopped process go on to be ended
    print(f"job {job}: parts {KILLED[0]} and {KILLED[1]} killed, part {LATE} at its time limit after {time.monotonic() - start:.0f} s")
    log = (cluster.home / f"drillgap_{job}_{LATE}.log").read_text(encoding="utf-8")
    if "ended by SIGTERM" not in log:
        print("FAULT the late part does not tell how it ended:", log)
        return 1
    merged = subprocess.run([program, deck, "--output", parts, "--merge", str(PARTS)], capture_output=True, text=True, check=False)
    told = re.search(r"--part (\S+)/" + str(PARTS) + " runs them", merged.stderr)
    if merged.returncode == 0 or not told or numbers(told.group(1)) != {*KILLED, LATE}:
        print(f"FAULT the merge names other parts than {KILLED} and {LATE}: {merged.stderr}")
        return 1
    print(merged.stderr.strip())
    again = cluster.run("sbatch", "--parsable", f"--array={told.group(1)}", script, deck, str(PARTS), "--output", parts, "--quiet").strip()
    last = cluster.run("sbatch", "--parsable", f"--dependency=afterany:{again}", script, deck, str(PARTS), "--merge",
                       "--output", parts).strip()
    cluster.ended(again)
    cluster.ended(last)
    print(f"jobs {again} and {last}: run again and joined")
    return 0


if __name__ == "__main__":
    sys.exit(main())
