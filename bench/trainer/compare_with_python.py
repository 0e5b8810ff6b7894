#!/usr/bin/python3
"""Images per second of a training step, ours and Python's, asked in turns in one run so that noise falls on both alike:
    bench/trainer/compare_with_python.py [--build build/release] [--repeats 20] [--steps 4] [--threads N] [--size BxWxH ...]
        [--arch resnet18] [--precision float32|bfloat16|auto] [--channels-last]
`cps` is what `cps train` does to a batch in memory, its loader included (train_epoch), with the
allocator's settings that cps-train gives itself; `bare` the same
network's forward, backward, clip and step through LibTorch; `python` those in Python (python_steps.py, Debian's
python3-torch, which calls the same libtorch) as torch does them by default: float32, channels first. The ratio is taken within
each turn; above 1: faster than Python. --precision is that of `cps` and `bare` (auto: bfloat16 where the processor computes it);
--channels-last gives `bare` that layout in float32, too, as it has in bfloat16 anyway. With either, `python tuned`, which has the
same precision and layout, runs beside the others."""
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
    what = [*(str(n) for n in (batch, width, height, options.steps, options.threads)), options.arch]
    layout = ["channels-last"] if options.channels_last else []
    ours, python = [str(options.build / "bin" / "train_on_request")], ["/usr/bin/python3", HERE / "python_steps.py"]
    trainers = {"cps": Trainer([*ours, *what, options.precision], GLIBC_TUNABLES=TUNABLES),
                "bare": Trainer([*ours, *what, options.precision, "bare", *layout]),
                "python": Trainer([*python, *what, "float32"])}
    if options.precision == "bfloat16" or layout:
        trainers["python tuned"] = Trainer([*python, *what, options.precision, "channels-last"])
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
    print(f"{options.arch} in {options.precision}, {batch} images of {width}x{height}, {options.threads} threads, "
          f"{options.repeats} turns of {options.steps} steps; load {os.getloadavg()[0]:.1f}")
    for kind, time in enumerate(("wall", "CPU")):
        for name in names:
            taken = [s[kind] for s in seconds[name]]
            line = f"  {name:12} {images / statistics.median(taken):7.2f} images per {time} second, best {images / min(taken):7.2f}"
            for other in [n for n in names if n.startswith("python") and n != name]:
                ratios = sorted(p[kind] / s[kind] for s, p in zip(seconds[name], seconds[other]))
                line += f"; to {other}: median {statistics.median(ratios):.3f}, least {ratios[0]:.3f}, most {ratios[-1]:.3f}"
            print(line, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--repeats", type=int, default=21)
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--size", nargs="+", default=["16x174x64", "8x480x270"], help="batch x width x height")
    parser.add_argument("--arch", default="resnet18", choices=("resnet18", "resnet18-32", "resnet18-16", "resnet10-32"))
    parser.add_argument("--precision", choices=("float32", "bfloat16", "auto"), default="float32")
    parser.add_argument("--channels-last", action="store_true")
    options = parser.parse_args()
    if options.precision == "auto":
        computes = {"avx512_bf16", "amx_bf16"} & set(Path("/proc/cpuinfo").read_text().split())
        options.precision = "bfloat16" if computes else "float32"
    for size in options.size:
        compare(size, options)


main()
