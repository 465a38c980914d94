package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robonewbie.nao.Cycle;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Writes the recording of a run and collects the results for its report. Not thread-safe. Only the most recent results
 * are kept for robots that have left, which bounds the memory used by a long-running server.
 */
public final class RunRecorder implements AutoCloseable {

    private static final int MAX_LEFT_ROBOTS = 1000;

    private final SoccerWorld world;
    private final RecordingWriter writer;
    private final BallStatistics ball;
    private final Map<Integer, Entry> entries = new LinkedHashMap<>();
    private final List<RunReport.Goal> goals = new ArrayList<>();
    private List<Participant> present = List.of();
    private long cycles;

    private RunRecorder(SoccerWorld world, RecordingWriter writer) {
        this.world = world;
        this.writer = writer;
        this.ball = new BallStatistics(world.field());
    }

    /**
     * Starts recording.
     *
     * @param world the world of the run
     * @param target receives the recording
     * @param header {@code name=value} lines that describe the run
     * @return the recorder
     */
    public static RunRecorder begin(SoccerWorld world, RecordingTarget target, List<String> header) {
        return new RunRecorder(world, RecordingWriter.open(target, header));
    }

    /**
     * Stores the state before the physics step.
     *
     * @param participants all robots in the order in which they connected
     */
    public void beforeStep(List<Participant> participants) {
        present = participants;
        ball.beforeStep(world.ball().position());
        for (Participant participant : participants) {
            entry(participant).statistics().beforeStep(participant.robot());
        }
    }

    /** Measures the effects of the physics step. Call before the referee acts. */
    public void afterStep() {
        ball.afterStep(world.ball().position());
        for (Participant participant : present) {
            entry(participant).statistics().afterStep(participant.robot());
        }
    }

    /**
     * Records the end of a cycle.
     *
     * @param cycle number of the cycle
     * @param match the game
     * @param participants all robots in the order in which they connected
     */
    public void cycleEnded(long cycle, Match match, List<Participant> participants) {
        cycles = cycle;
        ball.cycleEnded(world.ball().position());
        for (Participant participant : participants) {
            Entry entry = entry(participant);
            entry.statistics().cycleEnded(participant.robot());
            if (!entry.isOf(participant)) {
                entries.put(participant.id(), Entry.of(entry.statistics(), participant));
            }
        }
        forgetOldest(participants);
        for (MatchEvent event : match.events()) {
            if (event instanceof MatchEvent.GoalScored goal) {
                goals.add(new RunReport.Goal(match.state().playSeconds(), goal.team()));
            }
        }
        writer.write(
                Snapshots.of(cycle, match, world, participants),
                match.events().isEmpty()
                        ? List.of()
                        : match.events().stream().map(MatchEvent::text).toList(),
                robot -> participants.get(robot).commands());
    }

    private void forgetOldest(List<Participant> participants) {
        int surplus = entries.size() - participants.size() - MAX_LEFT_ROBOTS;
        if (surplus > 0) {
            Set<Integer> connected = participants.stream().map(Participant::id).collect(Collectors.toSet());
            List<Integer> oldest = entries.keySet().stream()
                    .filter(id -> !connected.contains(id))
                    .limit(surplus)
                    .toList();
            oldest.forEach(entries::remove);
        }
    }

    /**
     * Returns the results so far.
     *
     * @param seed the seed of the run
     * @param wallSeconds real duration of the run in seconds
     * @param missedCycles number of cycles by which the run fell behind real time
     * @return the report
     */
    public RunReport report(long seed, double wallSeconds, long missedCycles) {
        return new RunReport(
                seed,
                cycles * Cycle.SECONDS,
                wallSeconds,
                missedCycles,
                entries.values().stream().map(RunRecorder::robot).toList(),
                new RunReport.Ball(ball.position(), ball.metresMoved(), ball.leastDistanceToGoal()),
                goals,
                writer.sha256());
    }

    @Override
    public void close() {
        writer.close();
    }

    /** The results for a robot. */
    private record Entry(RobotStatistics statistics, String team, int number, long unansweredMessages) {

        static Entry of(RobotStatistics statistics, Participant participant) {
            Optional<Player> player = participant.player();
            return new Entry(
                    statistics,
                    player.map(member -> member.team().name()).orElse(""),
                    player.map(Player::number).orElse(0),
                    participant.unansweredMessages());
        }

        /** Returns whether the entry is up to date for a participant. */
        boolean isOf(Participant participant) {
            Optional<Player> player = participant.player();
            boolean samePlayer = player.isEmpty()
                    ? team.isEmpty() && number == 0
                    : number == player.get().number()
                            && team.equals(player.get().team().name());
            return samePlayer && unansweredMessages == participant.unansweredMessages();
        }
    }

    private Entry entry(Participant participant) {
        Entry known = entries.get(participant.id());
        if (known != null) {
            return known;
        }
        Entry entry = Entry.of(new RobotStatistics(participant.robot().model()), participant);
        entries.put(participant.id(), entry);
        return entry;
    }

    private static RunReport.RobotResult robot(Entry entry) {
        RobotStatistics statistics = entry.statistics();
        return new RunReport.RobotResult(
                entry.team(),
                entry.number(),
                statistics.falls(),
                statistics.metresWalked(),
                statistics.position(),
                statistics.headingDegrees(),
                statistics.isUpright(),
                entry.unansweredMessages(),
                RunReport.joints(statistics.model(), statistics.jointDegrees()));
    }
}
