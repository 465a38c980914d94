package org.robonewbie.agent.puppet;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.embedded.Puppet;

/**
 * A manually controlled robot; subclasses decide how its cycle is run. The robot gets up automatically after a fall.
 */
public abstract class SteeredRobot implements Puppet {

    private static final double HAND_DEGREES_PER_SECOND = 180;
    private static final double HEAD_DEGREES_PER_SECOND = 120;

    private final List<Consumer<Nao>> commands = new ArrayList<>();
    private final Map<Joint, Double> held = new EnumMap<>(Joint.class);

    /** Creates a robot without pending commands. */
    protected SteeredRobot() {}

    /**
     * Returns the options of a manually controlled robot.
     *
     * @param team name of its team
     * @param number its player number; 0 for any free number
     * @param type its robot type, 0 to 4
     * @return its options
     */
    public static Options options(String team, int number, int type) {
        return Options.none()
                .with("team", team)
                .with("number", Integer.toString(number))
                .with("type", Integer.toString(type));
    }

    /**
     * Prepares a robot that has just joined.
     *
     * @param nao the robot
     */
    protected final void begin(Nao nao) {
        nao.motions().setAutomaticGetUp(false);
    }

    /**
     * Sets the commands of this cycle. Call this method after sensing and before acting.
     *
     * @param nao the robot
     */
    protected final void move(Nao nao) {
        takeCommands().forEach(command -> command.accept(nao));
        if (held.isEmpty() && nao.isFallen() && nao.motions().isFinished()) {
            nao.motions().startGetUp();
        }
        held.forEach((joint, degrees) -> nao.setJointAngle(joint, degrees, HAND_DEGREES_PER_SECOND));
    }

    private List<Consumer<Nao>> takeCommands() {
        synchronized (commands) {
            List<Consumer<Nao>> all = List.copyOf(commands);
            commands.clear();
            return all;
        }
    }

    private void enqueue(Consumer<Nao> command) {
        synchronized (commands) {
            commands.add(command);
        }
    }

    @Override
    public final void walk(double forward, double left, double turn) {
        enqueue(nao -> {
            held.clear();
            nao.walk()
                    .towards(
                            clamp(forward) * Walk.MAX_FORWARD,
                            clamp(left) * Walk.MAX_LEFT,
                            clamp(turn) * Walk.MAX_TURN);
        });
    }

    @Override
    public final void perform(String motion) {
        enqueue(nao -> {
            held.clear();
            nao.motions().start(motion);
        });
    }

    @Override
    public final void look(double yawDegrees, double pitchDegrees) {
        enqueue(nao -> {
            nao.setJointAngle(Joint.NECK_YAW, yawDegrees, HEAD_DEGREES_PER_SECOND);
            nao.setJointAngle(Joint.NECK_PITCH, pitchDegrees, HEAD_DEGREES_PER_SECOND);
        });
    }

    @Override
    public final void hold(Joint joint, double degrees) {
        enqueue(nao -> {
            nao.walk().stop();
            nao.motions().stop();
            held.put(joint, degrees);
        });
    }

    @Override
    public final void stand() {
        perform("stand");
    }

    private static double clamp(double value) {
        return Double.isFinite(value) ? Math.max(-1, Math.min(1, value)) : 0;
    }
}
