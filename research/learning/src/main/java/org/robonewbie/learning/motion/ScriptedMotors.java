package org.robonewbie.learning.motion;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.PostureFollower;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;

/**
 * Robot with a motion player and a walk engine. It takes less processor time than an agent and supports any walk,
 * learned or not.
 */
public final class ScriptedMotors implements ScriptedRobot {

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final PostureFollower follower = new PostureFollower(motors);
    private final WalkEngine engine;
    private MotionPlayer player = new MotionPlayer(new Motion("hold", List.of()), Interpolation.LINEAR);
    private boolean walking;

    /**
     * Creates a robot at rest.
     *
     * @param walk the walk
     */
    public ScriptedMotors(PolicyWalk walk) {
        engine = new WalkEngine(walk.style(), walk.reflex());
    }

    @Override
    public Controller controller() {
        return Controller.ofPolicy(this::degreesPerSecond);
    }

    @Override
    public void play(Motion motion) {
        player = new MotionPlayer(motion, Interpolation.LINEAR);
    }

    @Override
    public void walk(WalkVelocity velocity) {
        engine.towards(velocity);
    }

    @Override
    public boolean isBusy() {
        return !engine.isStanding() || !player.isFinished();
    }

    private double[] degreesPerSecond(SensorReadings readings) {
        readings.sense(joints);
        engine.update(
                new TorsoMotion(SimSparkFrame.toBody(readings.gyro()), SimSparkFrame.toBody(readings.acceleration())));
        engine.update(pressure(readings.feet().left()), pressure(readings.feet().right()));
        if (engine.isStanding()) {
            walking = false;
            player.step(motors);
        } else {
            step();
        }
        motors.endCycle();
        return motors.sentDegreesPerSecond();
    }

    private void step() {
        if (!walking) {
            walking = true;
            follower.begin();
        }
        follower.follow(engine.next());
    }

    private static FootPressure pressure(Optional<FootForce> foot) {
        return foot.map(contact ->
                        new FootPressure(SimSparkFrame.toBody(contact.point()), SimSparkFrame.toBody(contact.force())))
                .orElse(FootPressure.NONE);
    }
}
