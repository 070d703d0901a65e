"""A real Slurm on this machine, of two nodes, for as long as a `with` block lasts.

Debian's slurmctld, slurmd and munged, started without systemd, with keys, folders and ports of
their own, on the loopback interface only: clusters can run beside each other. Needs root.
"""

import os
import random
import secrets
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

NODES = ("node1", "node2")

CONFIG = """ClusterName=pedzone
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1
ReturnToService=2
SlurmdTimeout=6
MinJobAge=2
KillWait=5
{nodes}
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(number):
    """So many ports in a row, below those that the kernel hands out to clients."""
    while True:
        first = random.randrange(10000, 32000)
        sockets = []
        try:
            for port in range(first, first + number):
                sockets.append(socket.socket())
                sockets[-1].bind(("127.0.0.1", port))
            return first
        except OSError:
            pass
        finally:
            for opened in sockets:
                opened.close()


def slurm_version():
    """The first number of "slurm-wlm 22.05.8"."""
    text = subprocess.run(["slurmd", "-V"], check=True, capture_output=True, text=True).stdout
    return int(text.split()[1].split(".")[0])


def kill(process):
    try:
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it has ended by itself


class SlurmCluster:
    """`environment` is what a client of the cluster needs, `folder` holds the daemons' logs."""

    def __init__(self):
        self._temporary = tempfile.TemporaryDirectory(prefix="slurm-", ignore_cleanup_errors=True)
        self.folder = Path(self._temporary.name)
        self.config = self.folder / "slurm.conf"
        self.environment = {**os.environ, "SLURM_CONF": str(self.config)}
        self._daemons = {}

    def __enter__(self):
        try:
            self._start_munge()
            self._write_config()
            self._start("slurmctld", ["slurmctld", "-D", "-f", self.config])
            for node in NODES:
                self.start_node(node)
            self.wait_until(lambda: self.node_states() == {node: "idle" for node in NODES})
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        while left := self.processes():  # jobs and their daemons, too: those survive slurmd
            for process in left:
                kill(process)
            for daemon in self._daemons.values():
                daemon.wait()
        self._temporary.cleanup()

    # What a test does to the cluster.

    def run(self, *command, **more):
        """A client's command, e.g. squeue."""
        return subprocess.run([str(word) for word in command], env=self.environment, text=True,
                              capture_output=True, timeout=120, **more)

    def start_node(self, node):
        self._start(node, ["slurmd", "-D", "-f", self.config, "-N", node])

    def kill_node(self, node):
        """SIGKILL for the node's daemon; its jobs' processes live on."""
        self._kill(node)

    def processes(self, mark="SLURM_CONF="):
        """Ids of this cluster's processes: they know its configuration. `mark`: how a variable of
        their environment begins; "SLURM_JOB_ID=" leaves what jobs have started, and
        "SLURM_ARRAY_TASK_ID=" what tasks of arrays have."""
        found = []
        for process in Path("/proc").iterdir():
            if not process.name.isdigit():
                continue
            try:
                words = (process / "environ").read_bytes().split(b"\0")
            except OSError:
                continue  # it has ended
            if (f"SLURM_CONF={self.config}".encode() in words
                    and any(word.startswith(mark.encode()) for word in words)):
                found.append(int(process.name))
        return found

    def jobs(self):
        """(job, state) of all array tasks and jobs that are queued or running."""
        listed = self.run("squeue", "--noheader", "--array", "--format=%i %T")
        return [tuple(line.split()) for line in listed.stdout.splitlines()]

    def node_states(self):
        listed = self.run("sinfo", "--noheader", "--Node", "--format=%N %t")
        return dict(line.split() for line in listed.stdout.splitlines())

    def wait_until(self, condition, limit=60.0):
        """Polls; a cluster tells nobody when its state changes. `limit` in s."""
        deadline = time.monotonic() + limit
        while not condition():
            dead = [name for name, daemon in self._daemons.items() if daemon.poll() is not None]
            if dead or time.monotonic() > deadline:
                raise RuntimeError(f"cluster: ended {dead}, nodes {self.node_states()}, jobs "
                                   f"{self.jobs()}\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        return "\n".join(f"--- {log.name}\n" + "\n".join(log.read_text().splitlines()[-40:])
                         for log in sorted(self.folder.glob("*.log")))

    # Daemons.

    def _start(self, name, command):
        with open(self.folder / f"{name}.out", "ab") as out:
            self._daemons[name] = subprocess.Popen([str(word) for word in command], stdout=out,
                                                   stderr=out, stdin=subprocess.DEVNULL,
                                                   env=self.environment)

    def _kill(self, name):
        daemon = self._daemons.pop(name)
        daemon.kill()
        daemon.wait()

    def _start_munge(self):
        munge = self.folder / "munge"
        munge.mkdir(mode=0o711)
        (munge / "key").touch(mode=0o600)
        (munge / "key").write_bytes(secrets.token_bytes(128))
        self._start("munged", ["munged", "--foreground", "--force", "--num-threads=2",
                               f"--key-file={munge}/key", f"--socket={munge}/socket",
                               f"--pid-file={munge}/pid", f"--seed-file={munge}/seed",
                               f"--log-file={munge}/log"])
        self.wait_until((munge / "socket").exists)

    def _write_config(self):
        self.folder.chmod(0o755)  # slurmd refuses spool folders that others cannot enter
        host = socket.gethostname().split(".")[0]
        port = free_ports(1 + len(NODES))
        nodes = "\n".join(
            f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port + 1 + index} "
            "CPUs=1 State=UNKNOWN" for index, node in enumerate(NODES))
        # Debian 13's Slurm would manage control groups, which need a mounted tree of them or systemd.
        # Debian 12's (22.05) does not by itself, and does not know the word that tells it not to.
        if slurm_version() >= 23:
            (self.folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        self.config.write_text(CONFIG.format(host=host, port=port, folder=self.folder,
                                             nodes=nodes))
