package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.SoccerWorld;

/** Watches a run on the simulation's thread: writes its recording and gathers what its report tells. */
public final class RunRecorder implements AutoCloseable {

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
     * Begins to watch.
     *
     * @param world the world of the run
     * @param target where the recording goes, beside its checksum
     * @param header lines of the form {@code name=value} that describe the run
     * @return the recorder
     */
    public static RunRecorder begin(SoccerWorld world, RecordingTarget target, List<String> header) {
        return new RunRecorder(world, RecordingWriter.open(target, header));
    }

    /**
     * Looks at the world before it moves.
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

    /** Looks at the world after it has moved and before the referee judges. */
    public void afterStep() {
        ball.afterStep(world.ball().position());
        for (Participant participant : present) {
            entry(participant).statistics().afterStep(participant.robot());
        }
    }

    /**
     * Looks at the world at the end of a cycle.
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
            entries.put(participant.id(), new Entry(entry.statistics(), participant));
        }
        for (MatchEvent event : match.events()) {
            if (event instanceof MatchEvent.GoalScored goal) {
                goals.add(new RunReport.Goal(match.state().playSeconds(), goal.team()));
            }
        }
        writer.write(
                Snapshots.of(cycle, match, world.ball(), participants),
                match.events().stream().map(MatchEvent::text).toList(),
                commands(participants));
    }

    private static Map<Integer, List<EffectorCommand>> commands(List<Participant> participants) {
        Map<Integer, List<EffectorCommand>> commands = new HashMap<>();
        participants.forEach(participant -> commands.put(participant.id(), participant.commands()));
        return commands;
    }

    /**
     * Returns the true results so far.
     *
     * @param seed the seed of the run
     * @param wallSeconds real seconds that it took
     * @param missedCycles cycles by which the world fell behind real time
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

    /** Ends the recording. */
    @Override
    public void close() {
        writer.close();
    }

    private record Entry(RobotStatistics statistics, Participant participant) {}

    private Entry entry(Participant participant) {
        return entries.computeIfAbsent(
                participant.id(),
                id -> new Entry(new RobotStatistics(participant.robot().model()), participant));
    }

    private static RunReport.RobotResult robot(Entry entry) {
        RobotStatistics statistics = entry.statistics();
        Optional<Player> player = entry.participant().player();
        return new RunReport.RobotResult(
                player.map(member -> member.team().name()).orElse(""),
                player.map(Player::number).orElse(0),
                statistics.falls(),
                statistics.metresWalked(),
                statistics.position(),
                statistics.headingDegrees(),
                statistics.isUpright(),
                entry.participant().unansweredMessages(),
                RunReport.joints(statistics.model(), statistics.jointDegrees()));
    }
}
