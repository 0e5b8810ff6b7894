#!/usr/bin/python3
"""Images per second of a training step, ours and Python's, asked in turns in one run so that noise falls on both alike:
    bench/trainer/compare_with_python.py [--build build/release] [--repeats 20] [--steps 4] [--threads N] [--size BxWxH ...]
`cps` is what `cps train` does to a batch in memory, its loader included (train_epoch), with the
allocator's settings that cps-train gives itself; `bare` the same
network's forward, backward, clip and step through LibTorch; `python` those in Python (python_steps.py, Debian's
python3-torch, which calls the same libtorch). The ratio is taken within each turn; above 1: faster than Python."""
import argparse
import os
import statistics
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
TUNABLES = "glibc.malloc.hugetlb=1:glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=17179869184"  # cps-train sets them


class Trainer:
    """A process that trains when it is asked to."""

    def __init__(self, command, **environment):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                        env={**os.environ, "OMP_WAIT_POLICY": "passive", **environment})

    def seconds(self):
        """Wall and CPU."""
        self.process.stdin.write("go\n")
        self.process.stdin.flush()
        return [float(word) for word in self.process.stdout.readline().split()]

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def compare(size, options):
    batch, width, height = map(int, size.split("x"))
    numbers = [str(n) for n in (batch, width, height, options.steps, options.threads)]
    ours = str(options.build / "bin" / "train_on_request")
    trainers = {"cps": Trainer([ours, *numbers], GLIBC_TUNABLES=TUNABLES), "bare": Trainer([ours, *numbers, "step"]),
                "python": Trainer(["/usr/bin/python3", HERE / "python_steps.py", *numbers])}
    for trainer in trainers.values():  # the first steps allocate
        trainer.seconds()
    names, seconds = list(trainers), {name: [] for name in trainers}
    for turn in range(options.repeats):
        for i in range(len(names)):  # each comes first, second, last equally often
            name = names[(turn + i) % len(names)]
            seconds[name].append(trainers[name].seconds())
    for trainer in trainers.values():
        trainer.close()

    images = batch * options.steps
    print(f"{batch} images of {width}x{height}, {options.threads} threads, "
          f"{options.repeats} turns of {options.steps} steps; load {os.getloadavg()[0]:.1f}")
    for kind, what in enumerate(("wall", "CPU")):
        for name in names:
            taken = [s[kind] for s in seconds[name]]
            line = f"  {name:7} {images / statistics.median(taken):7.2f} images per {what} second, best {images / min(taken):7.2f}"
            if name != "python":
                ratios = sorted(p[kind] / s[kind] for s, p in zip(seconds[name], seconds["python"]))
                line += f"; to Python's: median {statistics.median(ratios):.3f}, least {ratios[0]:.3f}, most {ratios[-1]:.3f}"
            print(line, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--repeats", type=int, default=21)
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--size", nargs="+", default=["16x174x64", "8x480x270"], help="batch x width x height")
    options = parser.parse_args()
    for size in options.size:
        compare(size, options)


main()
