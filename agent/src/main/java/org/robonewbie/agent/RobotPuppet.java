package org.robonewbie.agent;

import java.io.IOException;
import java.util.EnumMap;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.embedded.Puppet;

/** A robot that turns its own cycle in a thread and does what people want from it. It gets up by itself after a fall. */
final class RobotPuppet implements Puppet {

    private static final double HAND_DEGREES_PER_SECOND = 180;
    private static final double HEAD_DEGREES_PER_SECOND = 120;

    private final Queue<Consumer<Nao>> wishes = new ConcurrentLinkedQueue<>();
    private final Map<Joint, Double> held = new EnumMap<>(Joint.class);
    private final Home home;
    private final Options options;

    private RobotPuppet(Home home, Options options) {
        this.home = home;
        this.options = options;
    }

    static RobotPuppet start(Home home, Options options) {
        RobotPuppet puppet = new RobotPuppet(home, options);
        Thread thread = new Thread(puppet::live, "puppet");
        thread.setDaemon(true);
        thread.start();
        return puppet;
    }

    private void live() {
        try (Nao nao = Nao.quiet(options, home)) {
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
        } catch (IOException | StartUpException refused) {
            home.close();
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
        home.close();
    }

    private static double part(double value) {
        return Double.isFinite(value) ? Math.max(-1, Math.min(1, value)) : 0;
    }
}
