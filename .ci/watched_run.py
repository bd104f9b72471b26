"""One run of a built drillgap in folders of its own, and what no run may do. Shared by hostile_decks.py and fuzz.py."""
import hashlib
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile

TIME_LIMIT = 120.0           # s, a hundred times what the slowest listed deck takes with sanitizers
MEMORY_LIMIT = 1_000_000     # kB; not asked of programs with sanitizers, which keep what has been given back
MARKS = ("Backtrace", "Fortran runtime", "AddressSanitizer", "runtime error", "libgfortran", "HDF5-DIAG", "Error termination",
         "terminate called", "OpenBLAS blas", "OpenBLAS :", "OpenBLAS warning", "SIGSEGV")
# A line of a refusal: FILE:LINE: ..., FILE: ..., the program's own name, a continued line, or how it is used.
REFUSAL = re.compile(r"^(\S*[./]\S*.*?: |drillgap: |  |usage: |or: |exit status: |$)")


class Run:
    """One run of the program. `files` lie below a folder of its own, in which it runs; HOME and TMPDIR are fresh, too."""
    bounded = False      # in memory

    def __init__(self, program, files, arguments=(), before=None, shell_limits=None, stdout=None, home=None, cwd=".",
                 seconds=TIME_LIMIT, out="out", deck="deck.nml"):
        self.home = home or pathlib.Path(tempfile.mkdtemp(prefix="hostile_"))
        self.out, self.deck = self.home / out, self.home / deck
        for name, text in files.items():
            path = self.home / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text if isinstance(text, bytes) else text.encode("latin-1", "replace"))
        surroundings = {}
        for variable in ("HOME", "TMPDIR"):
            surroundings[variable] = str(self.home / f".{variable.lower()}")
            os.makedirs(surroundings[variable], exist_ok=True)
        (self.home / cwd).mkdir(exist_ok=True)
        if before:
            before(self.home)
        self.held = held = self.contents()

        def limits():
            if Run.bounded:
                memory_bound()
            if shell_limits:
                shell_limits()

        arguments = list(arguments) or ["deck.nml", "--output", "out"]
        environment = {k: v for k, v in os.environ.items() if not k.startswith(("DRILLGAP", "XDG_", "GNUPLOT", "OMP_", "OPENBLAS_"))}
        with tempfile.TemporaryFile() as errors, tempfile.TemporaryFile() as tables:
            process = subprocess.Popen([program, *arguments], cwd=self.home / cwd, stdout=stdout or tables, stderr=errors,
                                       stdin=subprocess.DEVNULL, preexec_fn=limits, env=environment | surroundings)
            timer = signal.signal(signal.SIGALRM, lambda *_: process.kill())
            signal.setitimer(signal.ITIMER_REAL, seconds)
            _, status, usage = os.wait4(process.pid, 0)
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, timer)
            process.returncode = 0
            self.killed = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
            self.status = os.WEXITSTATUS(status) if os.WIFEXITED(status) else -self.killed
            self.memory = usage.ru_maxrss
            self.seconds = usage.ru_utime + usage.ru_stime
            errors.seek(0)
            tables.seek(0)
            self.stderr = errors.read().decode("latin-1")
            self.stdout = tables.read().decode("latin-1")
        self.now = now = self.contents()
        inside = self.out.relative_to(self.home).as_posix()
        self.touched = sorted(p for p in set(held) | set(now) if held.get(p) != now.get(p))      # made, changed or removed
        self.strangers = [p for p in self.touched if p != inside and not p.startswith(inside + "/")
                          and not (inside + "/").startswith(p + "/")]
        self.had_out = inside in held

    def contents(self):
        """What lies in the folder: the digest of a file, the target of a link."""
        found = {}
        for place, folders, names in os.walk(self.home):
            for name in folders + names:
                path = os.path.join(place, name)
                key = os.path.relpath(path, self.home)
                if os.path.islink(path):
                    found[key] = "-> " + os.readlink(path)
                elif os.path.isfile(path):
                    with open(path, "rb") as file:
                        found[key] = hashlib.sha1(file.read()).hexdigest()
                else:
                    found[key] = "folder"
        return found

    def faults(self):
        """What this run did that no run may do; its results are judged by run_results.py."""
        found = []
        if self.killed:
            found.append(f"ended by signal {self.killed}" + (" (time limit?)" if self.killed == signal.SIGKILL else ""))
        elif self.status not in (0, 1, 2, 3):
            found.append(f"exit status {self.status}")
        for mark in MARKS:
            if mark in self.stderr:
                found.append(mark + ": " + self.stderr[max(0, self.stderr.find(mark) - 200):][:600].strip())
                break
        if self.strangers:
            found.append(f"touched outside the output folder: {self.strangers[:5]}")
        if Run.bounded and self.memory > MEMORY_LIMIT:
            found.append(f"{self.memory} kB of memory")
        if any(path.endswith(".unfinished") and path not in self.held for path in self.now):
            found.append("unfinished files left")
        if self.status in (1, 2) and not self.stderr.strip():
            found.append(f"exit status {self.status} without a message")
        if self.status == 2:
            if self.out.exists() and not self.had_out:
                found.append("refused, yet an output folder")
            elif self.touched:
                found.append(f"refused, yet touched {self.touched[:5]}")
            strange = [line for line in self.stderr.split("\n") if not REFUSAL.match(line)]
            if strange:
                found.append("no file in the message: " + repr(strange[0][:200]))
        return found

    def tidy(self):
        shutil.rmtree(self.home, ignore_errors=True)


def memory_bound():
    """No run may take the machine down. Programs with sanitizers reserve terabytes that they never use: not for those."""
    resource.setrlimit(resource.RLIMIT_AS, (4_000_000_000, 4_000_000_000))


def bound_memory_of(program):
    """Memory is bounded for programs that run under such a bound at all."""
    Run.bounded = subprocess.run([program, "--version"], preexec_fn=memory_bound, capture_output=True).returncode == 0
