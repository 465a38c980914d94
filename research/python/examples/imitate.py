"""Trains a policy by imitation with plain PyTorch in a few seconds: the head turns to the angle that it is told. Imitator.java plays it."""

import torch
from pathlib import Path
from robonewbie.train import policy_text, torch_layers

RANGE = 30  # degrees that an action of 1 means

torch.manual_seed(1)
network = torch.nn.Sequential(torch.nn.Linear(1, 16), torch.nn.ELU(), torch.nn.Linear(16, 1), torch.nn.Tanh())
optimizer = torch.optim.Adam(network.parameters(), lr=0.01)
for _ in range(1500):
    command = torch.rand(256, 1) * 2 - 1  # between -1 and 1
    teacher = 0.8 * torch.sin(1.5 * command)
    loss = torch.nn.functional.mse_loss(network(command), teacher)
    optimizer.zero_grad()
    loss.backward()
    optimizer.step()

text = policy_text("Imitate", ["imitates a sine"], [("command.direction", "1")], ["NECK_YAW"], RANGE, torch_layers(network))
Path("Imitate.policy").write_text(text, encoding="utf-8")
