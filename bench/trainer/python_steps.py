#!/usr/bin/python3
"""python_steps.py BATCH WIDTH HEIGHT STEPS THREADS: for each line on stdin, trains ResNet-18 of torchvision's shape
(one channel in, eight numbers out) for so many steps on one batch in memory, and prints the seconds they took, wall and CPU:
forward, mean squared error, backward, gradient clip, AdamW."""
import sys
import time

import torch
from torch import nn


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


def resnet18():
    layers = [nn.Conv2d(1, 64, 7, 2, 3, bias=False), nn.BatchNorm2d(64), nn.ReLU(inplace=True), nn.MaxPool2d(3, 2, 1)]
    channels_in = 64
    for channels, stride in ((64, 1), (128, 2), (256, 2), (512, 2)):
        layers += [Block(channels_in, channels, stride), Block(channels, channels, 1)]
        channels_in = channels
    return nn.Sequential(*layers, nn.AdaptiveAvgPool2d(1), nn.Flatten(), nn.Linear(512, 8))


def main():
    batch, width, height, steps, threads = map(int, sys.argv[1:6])
    torch.set_num_threads(threads)
    network = resnet18().train()
    optimizer = torch.optim.AdamW(network.parameters(), lr=1e-3, weight_decay=.01)
    loss_of = nn.MSELoss()
    images, targets = torch.randn(batch, 1, height, width), torch.randn(batch, 8)
    for _ in sys.stdin:
        start, cpu = time.monotonic(), time.process_time()
        for _ in range(steps):
            optimizer.zero_grad()
            loss = loss_of(network(images), targets)
            loss.backward()
            nn.utils.clip_grad_norm_(network.parameters(), 1.)
            optimizer.step()
            loss.item()
        print(time.monotonic() - start, time.process_time() - cpu, flush=True)


main()
