package org.robonewbie.simulator.fidelity;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.protocol.monitor.MonitorLink;
import org.robonewbie.protocol.monitor.MonitoredRobot;
import org.robonewbie.protocol.monitor.PlayerNumber;
import org.robonewbie.protocol.monitor.TrainerCommand;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.physics.Rotation;

/** Listens at a monitor port in a thread of its own and keeps where the torso of one robot was, message by message. */
final class MonitorFeed implements AutoCloseable {

    /** Said of a server that runs on without its agents. */
    static final String DOES_NOT_WAIT = "The server has not waited for the agent. Let it run in sync mode:"
            + " $agentSyncMode = true in spark.rb, or robonewbie simulator --sync.";

    private static final String FULL_SCENE = "(RSG";
    private static final long LOOKING_NANOSECONDS = 500_000;
    private static final long QUIET_NANOSECONDS = 300_000_000;
    private static final long LATE_NANOSECONDS = 50_000_000;
    private static final long NANOSECONDS_UNTIL_QUIET = 5_000_000_000L;
    private static final long NANOSECONDS_UNTIL_NEXT = 3_000_000_000L;

    private final MonitorLink link;
    private final List<Optional<Pose>> torsos = new ArrayList<>();
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

    /** Waits until a number of messages have come in all; tells whether they have within some seconds. */
    boolean await(int messages) {
        return await(messages, NANOSECONDS_UNTIL_NEXT);
    }

    /**
     * Waits for the moment when a server that repeats its message while it waits has just done so, since the next one is then
     * far enough; tells how many messages have come.
     */
    int awaitRepetition() {
        await(count() + 1, QUIET_NANOSECONDS);
        return count();
    }

    /** Tells whether more messages come than were expected. */
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
        link.send(new TrainerCommand.RequestFullState());
    }

    /** Tells how many messages have come. */
    synchronized int count() {
        return torsos.size();
    }

    /** Gives the torso's pose in one message, counted from 0. */
    synchronized Optional<Pose> torso(int index) {
        return index >= 0 && index < torsos.size() ? torsos.get(index) : Optional.empty();
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
                add(
                        isRepeated,
                        watched.flatMap(link.world()::robot)
                                .flatMap(MonitorFeed::torsoOf)
                                .filter(torso -> link.world().isCurrent() && lastText.contains(FULL_SCENE)));
            }
        } catch (IOException e) {
            // The session ends when the agent's connection breaks too.
        }
    }

    private synchronized void add(boolean isRepeated, Optional<Pose> torso) {
        lastChange = isRepeated ? lastChange : System.nanoTime();
        torsos.add(torso);
    }

    private static Optional<Pose> torsoOf(MonitoredRobot robot) {
        return robot.link(NaoModel.TORSO).map(MonitorFeed::pose);
    }

    private static Pose pose(TransformNode node) {
        return new Pose(
                node.position(),
                new Rotation(
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
