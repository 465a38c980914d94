package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredRobot;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * Listens at a monitor port in a background thread and stores the positions of the ball and one robot's torso, message by
 * message.
 */
final class MonitorFeed implements AutoCloseable {

    /** Said of a server that runs on without its agents. */
    static final String DOES_NOT_WAIT = "The server has not waited for the agent. Let it run in sync mode:"
            + " $agentSyncMode = true in spark.rb, or robonewbie simulator --sync.";

    /**
     * What one message showed.
     *
     * @param torso of the watched robot
     * @param ball centre of the ball
     * @param game state of the game
     */
    record Sight(Optional<BodyPose> torso, Optional<Vector3> ball, MonitoredGame game) {}

    private static final String FULL_SCENE = "(RSG";
    private static final long LOOKING_NANOSECONDS = 500_000;
    private static final long QUIET_NANOSECONDS = 300_000_000;
    private static final long LATE_NANOSECONDS = 50_000_000;
    private static final long NANOSECONDS_UNTIL_QUIET = 5_000_000_000L;
    private static final long NANOSECONDS_UNTIL_NEXT = 3_000_000_000L;

    private final MonitorLink link;
    private final List<Sight> sights = new ArrayList<>();
    private volatile Optional<PlayerNumber> watched = Optional.empty();
    private String lastText = "";
    private volatile long lastChange;

    private MonitorFeed(MonitorLink link) {
        this.link = link;
    }

    static MonitorFeed connect(String host, int port) throws IOException {
        MonitorFeed feed = new MonitorFeed(MonitorLink.connect(host, port));
        Thread thread = new Thread(feed::listen, "monitor");
        thread.setDaemon(true);
        thread.start();
        return feed;
    }

    void watch(PlayerNumber player) {
        watched = Optional.of(player);
    }

    /**
     * Waits until nothing moves any more, since the server waits. A server may go on sending the same message meanwhile.
     */
    void awaitQuiet() throws IOException {
        long start = System.nanoTime();
        while (System.nanoTime() - Math.max(start, lastChange) < QUIET_NANOSECONDS) {
            if (System.nanoTime() - start > NANOSECONDS_UNTIL_QUIET) {
                throw new IOException(DOES_NOT_WAIT);
            }
            LockSupport.parkNanos(LOOKING_NANOSECONDS);
        }
    }

    /** Waits until a number of messages have come in all; returns whether they have within some seconds. */
    boolean await(int messages) {
        return await(messages, NANOSECONDS_UNTIL_NEXT);
    }

    /**
     * Waits for the moment when a server that repeats its message while it waits has just done so, since the next one is then
     * far enough; returns how many messages have come.
     */
    int awaitRepetition() {
        await(count() + 1, QUIET_NANOSECONDS);
        return count();
    }

    /** Whether more messages arrive than expected. */
    boolean hasMoreThan(int messages) {
        return await(messages + 1, LATE_NANOSECONDS);
    }

    private boolean await(int messages, long nanoseconds) {
        long end = System.nanoTime() + nanoseconds;
        while (count() < messages && System.nanoTime() < end) {
            LockSupport.parkNanos(LOOKING_NANOSECONDS);
        }
        return count() >= messages;
    }

    /** Asks for exact numbers in the next message; otherwise small movements are left out. */
    void requestFullState() throws IOException {
        send(new Order.RequestFullState());
    }

    /** Sends orders of a trainer. */
    void send(Order.Trainer... orders) throws IOException {
        link.send(orders);
    }

    /** The number of messages that have arrived. */
    synchronized int count() {
        return sights.size();
    }

    /** The torso's pose in one message, counted from 0. */
    synchronized Optional<BodyPose> torso(int index) {
        return index >= 0 && index < sights.size() ? sights.get(index).torso() : Optional.empty();
    }

    /** The torso's pose in the latest message that has it exactly. */
    synchronized Optional<BodyPose> lastTorso() {
        for (int i = sights.size() - 1; i >= 0; i--) {
            if (sights.get(i).torso().isPresent()) {
                return sights.get(i).torso();
            }
        }
        return Optional.empty();
    }

    /** All messages from one on, counted from 0. */
    synchronized List<Sight> sightsFrom(int index) {
        return List.copyOf(sights.subList(index, sights.size()));
    }

    @Override
    public void close() {
        link.close();
    }

    private void listen() {
        try {
            while (link.receive()) {
                boolean isRepeated = link.lastMessage().toString().equals(lastText);
                lastText = link.lastMessage().toString();
                add(isRepeated, sight());
            }
        } catch (IOException e) {
            // The session ends when the agent's connection breaks too.
        }
    }

    /** Only whole scenes have exact numbers. */
    private Sight sight() {
        MonitoredWorld world = link.world();
        boolean exact = world.isCurrent() && lastText.contains(FULL_SCENE);
        return new Sight(
                watched.flatMap(world::robot).flatMap(MonitorFeed::torsoOf).filter(torso -> exact),
                world.ball().map(TransformNode::position).filter(ball -> exact),
                world.gameState());
    }

    private synchronized void add(boolean isRepeated, Sight sight) {
        lastChange = isRepeated ? lastChange : System.nanoTime();
        sights.add(sight);
    }

    private static Optional<BodyPose> torsoOf(MonitoredRobot robot) {
        return robot.link(NaoModel.TORSO).map(MonitorFeed::pose);
    }

    private static BodyPose pose(TransformNode node) {
        return new BodyPose(
                node.position(),
                new RotationMatrix(
                        node.element(0),
                        node.element(4),
                        node.element(8),
                        node.element(1),
                        node.element(5),
                        node.element(9),
                        node.element(2),
                        node.element(6),
                        node.element(10)));
    }
}
