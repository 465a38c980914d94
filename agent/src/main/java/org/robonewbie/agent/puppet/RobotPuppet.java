package org.robonewbie.agent.puppet;

import java.util.EnumMap;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.StartUpException;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.frame.AgentLink;

/** A robot that runs its own cycle in a thread and is steered by hand. It gets up by itself after a fall. */
final class RobotPuppet implements Puppet {

    private static final double HAND_DEGREES_PER_SECOND = 180;
    private static final double HEAD_DEGREES_PER_SECOND = 120;

    private final Queue<Consumer<Nao>> wishes = new ConcurrentLinkedQueue<>();
    private final Map<Joint, Double> held = new EnumMap<>(Joint.class);
    private final AgentLink link;
    private final Options options;

    private RobotPuppet(AgentLink link, Options options) {
        this.link = link;
        this.options = options;
    }

    static RobotPuppet start(AgentLink link, Options options) {
        RobotPuppet puppet = new RobotPuppet(link, options);
        Thread thread = new Thread(puppet::live, "puppet");
        thread.setDaemon(true);
        thread.start();
        return puppet;
    }

    private void live() {
        try (Nao nao = AgentDriver.connect(link, options)) {
            nao.motions().setAutomaticGetUp(false);
            while (nao.sense()) {
                for (Consumer<Nao> wish = wishes.poll(); wish != null; wish = wishes.poll()) {
                    wish.accept(nao);
                }
                if (held.isEmpty() && nao.isFallen() && nao.motions().isFinished()) {
                    nao.motions().startGetUp();
                }
                held.forEach((joint, degrees) -> nao.setJointAngle(joint, degrees, HAND_DEGREES_PER_SECOND));
                nao.act();
            }
        } catch (StartUpException refused) {
            link.close();
        }
    }

    @Override
    public void walk(double forward, double left, double turn) {
        wishes.add(nao -> {
            held.clear();
            nao.walk()
                    .towards(
                            part(forward) * Walk.MOST_FORWARD,
                            part(left) * Walk.MOST_LEFT,
                            part(turn) * Walk.MOST_TURN);
        });
    }

    @Override
    public void perform(String motion) {
        wishes.add(nao -> {
            held.clear();
            nao.motions().start(motion);
        });
    }

    @Override
    public void look(double yawDegrees, double pitchDegrees) {
        wishes.add(nao -> {
            nao.setJointAngle(Joint.NECK_YAW, yawDegrees, HEAD_DEGREES_PER_SECOND);
            nao.setJointAngle(Joint.NECK_PITCH, pitchDegrees, HEAD_DEGREES_PER_SECOND);
        });
    }

    @Override
    public void hold(Joint joint, double degrees) {
        wishes.add(nao -> {
            nao.walk().stop();
            nao.motions().stop();
            held.put(joint, degrees);
        });
    }

    @Override
    public void stand() {
        perform("stand");
    }

    @Override
    public void close() {
        link.close();
    }

    private static double part(double value) {
        return Double.isFinite(value) ? Math.max(-1, Math.min(1, value)) : 0;
    }
}
