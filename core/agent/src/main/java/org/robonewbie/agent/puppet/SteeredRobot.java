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

/** A robot that is steered by hand, whoever turns its cycle. It gets up by itself after a fall. */
public abstract class SteeredRobot implements Puppet {

    private static final double HAND_DEGREES_PER_SECOND = 180;
    private static final double HEAD_DEGREES_PER_SECOND = 120;

    private final List<Consumer<Nao>> wishes = new ArrayList<>();
    private final Map<Joint, Double> held = new EnumMap<>(Joint.class);

    /** Creates a robot of which nobody wants anything yet. */
    protected SteeredRobot() {}

    /**
     * Says who a robot is.
     *
     * @param team name of its team
     * @param number its number; 0 takes any free one
     * @param type its robot type, 0 to 4
     * @return how it enters the game
     */
    public static Options options(String team, int number, int type) {
        return Options.none()
                .with("team", team)
                .with("number", Integer.toString(number))
                .with("type", Integer.toString(type));
    }

    /**
     * Prepares a robot that has just entered.
     *
     * @param nao the robot
     */
    protected final void begin(Nao nao) {
        nao.motions().setAutomaticGetUp(false);
    }

    /**
     * Sets what the robot does in this cycle, after it has sensed and before it acts.
     *
     * @param nao the robot
     */
    protected final void move(Nao nao) {
        wishes().forEach(wish -> wish.accept(nao));
        if (held.isEmpty() && nao.isFallen() && nao.motions().isFinished()) {
            nao.motions().startGetUp();
        }
        held.forEach((joint, degrees) -> nao.setJointAngle(joint, degrees, HAND_DEGREES_PER_SECOND));
    }

    private List<Consumer<Nao>> wishes() {
        synchronized (wishes) {
            List<Consumer<Nao>> all = List.copyOf(wishes);
            wishes.clear();
            return all;
        }
    }

    private void wish(Consumer<Nao> wish) {
        synchronized (wishes) {
            wishes.add(wish);
        }
    }

    @Override
    public final void walk(double forward, double left, double turn) {
        wish(nao -> {
            held.clear();
            nao.walk()
                    .towards(part(forward) * Walk.MAX_FORWARD, part(left) * Walk.MAX_LEFT, part(turn) * Walk.MAX_TURN);
        });
    }

    @Override
    public final void perform(String motion) {
        wish(nao -> {
            held.clear();
            nao.motions().start(motion);
        });
    }

    @Override
    public final void look(double yawDegrees, double pitchDegrees) {
        wish(nao -> {
            nao.setJointAngle(Joint.NECK_YAW, yawDegrees, HEAD_DEGREES_PER_SECOND);
            nao.setJointAngle(Joint.NECK_PITCH, pitchDegrees, HEAD_DEGREES_PER_SECOND);
        });
    }

    @Override
    public final void hold(Joint joint, double degrees) {
        wish(nao -> {
            nao.walk().stop();
            nao.motions().stop();
            held.put(joint, degrees);
        });
    }

    @Override
    public final void stand() {
        perform("stand");
    }

    private static double part(double value) {
        return Double.isFinite(value) ? Math.max(-1, Math.min(1, value)) : 0;
    }
}
