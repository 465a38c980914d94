"""A Booster T1, the robot of today's RoboCup 3D league, learns to walk by velocity command.

    python -m robonewbie.t1 train                                learn from nothing by PPO in MuJoCo; --resume goes on
    python -m robonewbie.t1 evaluate t1-walk.policy              measure it on seeds that training does not use
    python -m robonewbie.t1 play t1-walk.policy --server HOST:PORT    walk on a running RCSSServerMJ

``pip install "robonewbie[sb3,mujoco,league]"`` installs what it needs; ``play`` needs numpy and gymnasium only.

How a policy is played, which :mod:`robonewbie.t1.player` does in 40 lines:

**Each cycle** of 20 ms, with or without a new action:

1. Read joint angles and speeds (``ax``, ``vx`` in degrees and degrees/s), ``torso_gyro`` (degrees/s) and ``torso_acc`` (m/s²; 9.81 upwards at
   rest). x is forward, y left, z up, as the server sends them. The true pose (``torso_pos``, ``torso_quat``) is not used.
2. Update the tilt filter. ``up`` is the direction of up in the torso's frame, at first (0, 0, 1)::

       up += up × (gyro in rad/s) · 0.02                                     (cross product)
       if 5 < |acc| < 20:  up += 0.025 · (acc / |acc| − up)
       up /= |up|

   The filter also runs before the walk begins and while the robot stands.
3. Send for each of the 23 motors ``(name target 0 kp kd 0)`` with the gains of the policy file (``stiffness``, ``damping``). Targets of head, arms
   and waist are those of ``stance-degrees``; the head may turn by ±50° and nod by ±20°, at most 4° per action. Targets of legs are those of the
   last action.

**Every second cycle** (``cycles-per-action``), beginning with the first:

1. Limit the wanted command (forward, left in m/s, turn to the left in degrees/s) as ``WalkVelocity.within`` does, and move the command, (0, 0, 0) at first,
   towards it by at most (0.05, 0.025, 3.75) per action, as ``WalkVelocity.towards`` does.
2. Advance the gait clock, which has a phase n and an amplitude A, both 0 at first::

       if A > 0:  n = (n + 1) modulo actions-per-stride,  else  n = 0
       A = min(1, A + 1/10) while the command is not 0, else max(0, A - 1/10)    (10 = actions-per-stride)

   Its sine and cosine are A · sin(2π n / 10) and A · cos(2π n / 10). The left foot swings while the sine is positive.
3. The 46 inputs, each the quantity divided by the number in its unit; the first layer clips them to ±5:

   ===== ==================================================================== ===============
   0–1   ``up``: forward, left                                                  0.3
   2–4   gyroscope: forward (x), left (y), up (z)                               100 degrees/s
   5–16  angles of ``lle1`` … ``lle6``, ``rle1`` … ``rle6`` minus the stance    30 degrees
   17–28 their speeds                                                           150 degrees/s
   29–40 outputs of the action before; 0 at first                               1
   41–43 command: forward, left, turn                                           0.6 m/s, 0.3 m/s, 45 degrees/s
   44–45 gait clock: sine, cosine                                               1
   ===== ==================================================================== ===============

4. The targets of ``lle1`` … ``lle6`` and ``rle1`` … ``rle6`` are the stance, plus the rhythm, plus the 12 outputs, each from -1 to 1, times the degrees
   of the ``output`` lines. The rhythm lets the robot step in place. With L = ``lift-degrees`` · max(0, side · sine) and
   S = -side · cosine, where side is 1 for the left leg and -1 for the right one, with F, Y, T = the shares of the largest forward, left and turn
   command (0.6 m/s, 0.3 m/s, 45 degrees/s) times ``swing-degrees-forward-left-turn``, and with W = a · sine + b · cosine, where a, b and c are the
   numbers ``sway-degrees-sine-cosine-foot``, it is for the six joints of each leg::

       -L - F S,   Y S + W,   T S,   2 L,   0.7 F S - L,   -Y S - c W

A walk begins from the stance: raise the robot from any posture by moving the targets from the measured angles to the stance within 0.8 s, and
wait 0.7 s more. Motors' delays of 0 to 2 cycles are varied in training.
"""
