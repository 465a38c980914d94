"""Policies that treat left and right alike: the mirrored observation gives the mirrored action."""

import numpy as np
import torch
from stable_baselines3.common.running_mean_std import RunningMeanStd

from robonewbie.critic import TwoViewsPolicy


class SymmetricHead(torch.nn.Module):
    """Mean of the action for the observation and the mirrored action for the mirrored observation."""

    def __init__(self, linear, action_mirror):
        super().__init__()
        self.linear = linear
        self.indices, self.signs = (torch.as_tensor(part) for part in action_mirror)

    def forward(self, latent):
        own, mirrored = (self.linear(half) for half in latent.chunk(2, dim=-1))
        return (own + mirrored[..., self.indices] * self.signs) / 2


class SymmetricPolicy(TwoViewsPolicy):
    """Actor and critic with different inputs; the actor is symmetric.

    ``mirrors`` are those of the actor's inputs and of its actions, as from :func:`robonewbie.mirror.mirror_of`.
    """

    def __init__(self, *spaces_and_rate, mirrors, **settings):
        self.mirrors = mirrors
        super().__init__(*spaces_and_rate, **settings)

    def _build_mlp_extractor(self):
        super()._build_mlp_extractor()
        extractor = self.mlp_extractor
        indices, signs = (torch.as_tensor(part) for part in self.mirrors[0])
        actor = extractor.policy_net

        def both(features):
            inputs = features[:, self._views["actor"]]
            return torch.cat([actor(inputs), actor(inputs[:, indices] * signs)], dim=-1)

        extractor.forward_actor = both

    def _build(self, lr_schedule):
        super()._build(lr_schedule)
        self.action_net = SymmetricHead(self.action_net, self.mirrors[1])
        self.optimizer = self.optimizer_class(self.parameters(), lr=lr_schedule(1), **self.optimizer_kwargs)

    def _get_constructor_parameters(self):
        return {**super()._get_constructor_parameters(), "mirrors": self.mirrors}


class SymmetricMoments(RunningMeanStd):
    """Mean and variance of observations and their mirror images, so that normalised observations have a mirror image too."""

    def __init__(self, indices, signs):
        super().__init__(shape=(len(indices),))
        self._indices, self._signs = indices, signs

    def update(self, arr):
        super().update(np.concatenate([arr, arr[:, self._indices] * self._signs]))
