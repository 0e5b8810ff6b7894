#!/usr/bin/python3
"""python_steps.py BATCH WIDTH HEIGHT STEPS THREADS ARCH PRECISION [channels-last]: for each line on stdin, trains a ResNet
of torchvision's shape (basic blocks, one channel in, eight numbers out) for so many steps on one batch in memory, and prints the
seconds they took, wall and CPU: forward, mean squared error, backward, gradient clip, AdamW. With bfloat16, the forward pass is
in torch's autocast. With channels-last, network and images have that memory format."""
import sys
import time

import torch
from torch import nn

NETWORKS = {"resnet18": (2, 64), "resnet18-32": (2, 32), "resnet18-16": (2, 16), "resnet10-32": (1, 32)}  # blocks, width


class Block(nn.Module):
    def __init__(self, channels_in, channels, stride):
        super().__init__()
        self.conv1 = nn.Conv2d(channels_in, channels, 3, stride, 1, bias=False)
        self.bn1 = nn.BatchNorm2d(channels)
        self.relu = nn.ReLU(inplace=True)
        self.conv2 = nn.Conv2d(channels, channels, 3, 1, 1, bias=False)
        self.bn2 = nn.BatchNorm2d(channels)
        self.downsample = None
        if stride != 1 or channels_in != channels:
            self.downsample = nn.Sequential(nn.Conv2d(channels_in, channels, 1, stride, bias=False),
                                            nn.BatchNorm2d(channels))

    def forward(self, x):
        identity = x if self.downsample is None else self.downsample(x)
        out = self.bn2(self.conv2(self.relu(self.bn1(self.conv1(x)))))
        out += identity
        return self.relu(out)


def resnet(blocks, width):
    layers = [nn.Conv2d(1, width, 7, 2, 3, bias=False), nn.BatchNorm2d(width), nn.ReLU(inplace=True), nn.MaxPool2d(3, 2, 1)]
    channels_in = width
    for stage in range(4):
        channels = width << stage
        for block in range(blocks):
            layers.append(Block(channels_in, channels, 2 if stage > 0 and block == 0 else 1))
            channels_in = channels
    return nn.Sequential(*layers, nn.AdaptiveAvgPool2d(1), nn.Flatten(), nn.Linear(channels_in, 8))


def main():
    batch, width, height, steps, threads = map(int, sys.argv[1:6])
    architecture, precision = sys.argv[6:8]
    layout = torch.channels_last if "channels-last" in sys.argv[8:] else torch.contiguous_format
    torch.set_num_threads(threads)
    network = resnet(*NETWORKS[architecture]).to(memory_format=layout).train()
    optimizer = torch.optim.AdamW(network.parameters(), lr=1e-3, weight_decay=.01)
    loss_of = nn.MSELoss()
    images = torch.randn(batch, 1, height, width).to(memory_format=layout)
    targets = torch.randn(batch, 8)
    for _ in sys.stdin:
        start, cpu = time.monotonic(), time.process_time()
        for _ in range(steps):
            optimizer.zero_grad()
            with torch.autocast("cpu", torch.bfloat16, enabled=precision == "bfloat16"):
                predicted = network(images)
            loss = loss_of(predicted.float(), targets)
            loss.backward()
            nn.utils.clip_grad_norm_(network.parameters(), 1.)
            optimizer.step()
            loss.item()
        print(time.monotonic() - start, time.process_time() - cpu, flush=True)


main()
