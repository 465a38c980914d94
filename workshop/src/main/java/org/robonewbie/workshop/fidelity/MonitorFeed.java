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
 * Background thread that receives monitor messages and stores the ball position and the torso pose of one robot for
 * each message.
 */
final class MonitorFeed implements AutoCloseable {

    /** Error message for a server that does not wait for its agents. */
    static final String DOES_NOT_WAIT = "The server did not wait for the agent. Run it in sync mode:"
            + " $agentSyncMode = true in spark.rb, or robonewbie simulator --sync.";

    /**
     * Contents of one message.
     *
     * @param isFull whether the message contains the full scene; positions from a partial scene are inexact
     * @param torso torso pose of the watched robot
     * @param ball centre of the ball
     * @param game game state
     */
    record Sight(boolean isFull, Optional<BodyPose> torso, Optional<Vector3> ball, MonitoredGame game) {}

    private static final String FULL_SCENE = "(RSG";
    private static final long POLL_NANOSECONDS = 500_000;
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
     * Waits until the messages stop changing, which means that the server is waiting for the agent. In the meantime,
     * the server may repeat its last message.
     */
    void awaitQuiet() throws IOException {
        long start = System.nanoTime();
        while (System.nanoTime() - Math.max(start, lastChange) < QUIET_NANOSECONDS) {
            if (System.nanoTime() - start > NANOSECONDS_UNTIL_QUIET) {
                throw new IOException(DOES_NOT_WAIT);
            }
            LockSupport.parkNanos(POLL_NANOSECONDS);
        }
    }

    /** Waits until the given total number of messages has arrived; returns false on timeout. */
    boolean await(int messages) {
        return await(messages, NANOSECONDS_UNTIL_NEXT);
    }

    /**
     * Waits until an idle server has repeated its message, so that a full interval remains until the next repetition. Returns the number of
     * messages so far.
     */
    int awaitRepetition() {
        await(count() + 1, QUIET_NANOSECONDS);
        return count();
    }

    /** Waits briefly and returns whether more than the given total number of messages have arrived. */
    boolean hasMoreThan(int messages) {
        return await(messages + 1, LATE_NANOSECONDS);
    }

    private boolean await(int messages, long nanoseconds) {
        long end = System.nanoTime() + nanoseconds;
        while (count() < messages && System.nanoTime() < end) {
            LockSupport.parkNanos(POLL_NANOSECONDS);
        }
        return count() >= messages;
    }

    /** Requests a full scene as the next message, because partial scenes omit small movements. */
    void requestFullState() throws IOException {
        send(new Order.RequestFullState());
    }

    void send(Order.Trainer... orders) throws IOException {
        link.send(orders);
    }

    synchronized int count() {
        return sights.size();
    }

    /** Returns the torso pose in the message with the given zero-based index if the message contains the full scene. */
    synchronized Optional<BodyPose> torso(int index) {
        return index >= 0 && index < sights.size() && sights.get(index).isFull()
                ? sights.get(index).torso()
                : Optional.empty();
    }

    /** Returns the torso pose in the latest full scene. */
    synchronized Optional<BodyPose> lastTorso() {
        for (int i = sights.size() - 1; i >= 0; i--) {
            Optional<BodyPose> torso = torso(i);
            if (torso.isPresent()) {
                return torso;
            }
        }
        return Optional.empty();
    }

    /** Returns all messages from the given zero-based index onwards. */
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
            // The agent's connection fails as well, which ends the session.
        }
    }

    private Sight sight() {
        MonitoredWorld world = link.world();
        return new Sight(
                world.isCurrent() && lastText.contains(FULL_SCENE),
                watched.flatMap(world::robot).flatMap(MonitorFeed::torsoOf),
                world.ball().map(TransformNode::position),
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
