"""A policy that treats left and right alike: the mirrored observation gives the mirrored action."""

import torch

from ..critic import TwoViewsPolicy
from . import mirror


class SymmetricHead(torch.nn.Module):
    """Mean of the action for the observation and the mirrored action for the mirrored observation."""

    def __init__(self, linear):
        super().__init__()
        self.linear = linear
        indices, signs = mirror.mirror_of_action()
        self.indices, self.signs = torch.as_tensor(indices), torch.as_tensor(signs)

    def forward(self, latent):
        own, mirrored = (self.linear(half) for half in latent.chunk(2, dim=-1))
        return (own + mirrored[..., self.indices] * self.signs) / 2


class SymmetricPolicy(TwoViewsPolicy):
    """Actor and critic with different inputs; the actor is symmetric."""

    def _build_mlp_extractor(self):
        super()._build_mlp_extractor()
        extractor = self.mlp_extractor
        indices, signs = (torch.as_tensor(part) for part in mirror.mirror_of_observation())
        actor = extractor.forward_actor

        def both(features):
            return torch.cat([actor(features), actor(features[:, indices] * signs)], dim=-1)

        extractor.forward_actor = both

    def _build(self, lr_schedule):
        super()._build(lr_schedule)
        self.action_net = SymmetricHead(self.action_net)
        self.optimizer = self.optimizer_class(self.parameters(), lr=lr_schedule(1), **self.optimizer_kwargs)
