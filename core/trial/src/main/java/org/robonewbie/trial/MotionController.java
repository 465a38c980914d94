package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.protocol.effector.EffectorCommand;

/** A controller that plays a motion, as an agent would, and then holds all joints still. */
final class MotionController implements Controller {

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final MotionPlayer player;
    private final JointSpeeds speeds = new JointSpeeds();

    MotionController(MotionPlayer player) {
        this.player = player;
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        readings.sense(joints);
        player.step(motors);
        motors.endCycle();
        return speeds.commands(motors);
    }

    @Override
    public boolean readsMessages() {
        return false;
    }

    @Override
    public boolean isFinished() {
        return player.isFinished();
    }
}
