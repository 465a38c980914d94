package org.robonewbie.learning.dataset;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;

/**
 * Tables of one run, written by observing the simulation. Call {@link #finish} when the simulation has ended; otherwise,
 * {@link #close} discards the tables.
 */
public final class RunTables implements SimulationObserver, AutoCloseable {

    private final int run;
    private final long seed;
    private final CycleTable table;
    private final TableFile cycles;
    private final TableFile events;
    private final Map<Integer, RobotMessages> robots = new HashMap<>();
    private final List<MatchEvent> newEvents = new ArrayList<>();
    private long lastCycle = -1;
    private long rows;
    private int scoreLeft;
    private int scoreRight;
    private volatile @Nullable IOException failure;

    RunTables(int run, long seed, CycleTable table, TableFile cycles, TableFile events) {
        this.run = run;
        this.seed = seed;
        this.table = table;
        this.cycles = cycles;
        this.events = events;
    }

    static List<Column> eventColumns() {
        return List.of(
                Column.whole("run", "", "number of the run, from 1"),
                Column.whole("cycle", "", "number of the cycle of the event"),
                Column.text("event", "playmode NAME, goal SIDE TEAM, or foul TYPE SIDE NUMBER"));
    }

    @Override
    public boolean wantsMessagesOf(int robot) {
        return true;
    }

    @Override
    public void messagesExchanged(AgentMessages messages) {
        RobotMessages known = robots.get(messages.robot());
        if (known == null) {
            robots.put(messages.robot(), new RobotMessages(messages));
        } else {
            known.update(messages);
        }
    }

    @Override
    public void happened(MatchEvent event) {
        newEvents.add(event);
    }

    @Override
    public void cycleEnded(WorldSnapshot world) {
        if (world.cycle() == lastCycle) {
            return;
        }
        lastCycle = world.cycle();
        newEvents.forEach(event -> add(events, List.of((long) run, world.cycle(), event.text())));
        newEvents.clear();
        scoreLeft = world.scoreLeft();
        scoreRight = world.scoreRight();
        for (RobotSnapshot robot : world.robots()) {
            RobotMessages messages = robots.get(robot.id());
            if (robot.number() > 0 && messages != null && messages.cycle() == world.cycle()) {
                add(cycles, table.row(run, world, robot, messages));
                rows++;
            }
        }
    }

    /** Adds a row. After a write error, the simulation continues without tables, and {@link #finish} reports the error. */
    private void add(TableFile file, List<Object> row) {
        if (failure == null) {
            try {
                file.add(row);
            } catch (IOException first) {
                failure = first;
            }
        }
    }

    /**
     * Completes the tables.
     *
     * @return the result of the run
     * @throws IOException if the tables cannot be written
     */
    public RunResult finish() throws IOException {
        if (failure != null) {
            throw new IOException("Run " + run + " cannot be written. " + failure.getMessage(), failure);
        }
        cycles.finish();
        events.finish();
        return new RunResult(run, seed, lastCycle, rows, scoreLeft, scoreRight, "");
    }

    @Override
    public void close() throws IOException {
        cycles.close();
        events.close();
    }
}
