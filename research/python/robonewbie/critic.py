"""Asymmetric actor-critic for Stable-Baselines3: the critic observes the elapsed time and may have different inputs from the policy.

Without the time, a critic attributes differences between early and late steps of an episode to the actions. The critic is used only in
training, so its inputs need not be available to the policy.
"""

import numpy as np
from gymnasium import spaces
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.torch_layers import MlpExtractor
from stable_baselines3.common.vec_env import VecEnvWrapper


class Timed(VecEnvWrapper):
    """Appends the elapsed fraction of the maximum episode length to the observation."""

    def __init__(self, venv, longest):
        space = venv.observation_space
        low, high = (np.append(numbers, last).astype(space.dtype) for numbers, last in ((space.low, 0), (space.high, 1)))
        super().__init__(venv, observation_space=spaces.Box(low, high, dtype=space.dtype))
        self._longest = longest
        self._actions = np.zeros(venv.num_envs)

    def reset(self):
        self._actions[:] = 0
        return self._timed(self.venv.reset())

    def step_wait(self):
        observation, reward, done, infos = self.venv.step_wait()
        self._actions += 1
        for i in np.flatnonzero(done):
            infos[i]["terminal_observation"] = np.append(infos[i]["terminal_observation"], np.float32(self._actions[i] / self._longest))
        self._actions[done] = 0
        return self._timed(observation), reward, done, infos

    def _timed(self, observation):
        return np.column_stack([observation, self._actions / self._longest]).astype(np.float32)


class _Networks(MlpExtractor):
    """Networks of actor and critic, each with a subset of the features."""

    def __init__(self, actor, critic, **settings):
        super().__init__(len(critic), **settings)
        self._actor, self._critic = actor, critic
        actor_extractor = MlpExtractor(len(actor), **settings)
        self.policy_net, self.latent_dim_pi = actor_extractor.policy_net, actor_extractor.latent_dim_pi

    def forward_actor(self, features):
        return super().forward_actor(features[:, self._actor])

    def forward_critic(self, features):
        return super().forward_critic(features[:, self._critic])


class TwoViewsPolicy(ActorCriticPolicy):
    """Policy whose actor and critic have different inputs, given by their indices in the observation."""

    def __init__(self, *spaces_and_rate, actor, critic, **settings):
        self._views = {"actor": actor, "critic": critic}
        super().__init__(*spaces_and_rate, **settings)

    def _build_mlp_extractor(self):
        self.mlp_extractor = _Networks(
            **self._views, net_arch=self.net_arch, activation_fn=self.activation_fn, device=self.device
        )

    def _get_constructor_parameters(self):
        return {**super()._get_constructor_parameters(), **self._views}
