package org.robonewbie.simulator.recording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Watches a run on the simulation's thread: writes its recording and gathers what its report tells. Of robots that have left only figures are
 * kept, and those of the last ones only, so that a server on which agents come and go for days does not fill its memory.
 */
public final class RunRecorder implements AutoCloseable {

    private static final int MAX_GONE = 1000;

    private final SoccerWorld world;
    private final RecordingWriter writer;
    private final BallStatistics ball;
    private final Map<Integer, Entry> entries = new LinkedHashMap<>();
    private final List<RunReport.Goal> goals = new ArrayList<>();
    private final Map<Integer, List<EffectorCommand>> commands = new HashMap<>();
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
                commands(participants));
    }

    private void forgetOldest(List<Participant> here) {
        int surplus = entries.size() - here.size() - MAX_GONE;
        if (surplus > 0) {
            Set<Integer> staying = here.stream().map(Participant::id).collect(Collectors.toSet());
            List<Integer> gone = entries.keySet().stream()
                    .filter(id -> !staying.contains(id))
                    .limit(surplus)
                    .toList();
            gone.forEach(entries::remove);
        }
    }

    private Map<Integer, List<EffectorCommand>> commands(List<Participant> participants) {
        if (commands.size() > participants.size()) {
            commands.clear();
        }
        for (Participant participant : participants) {
            commands.put(participant.id(), participant.commands());
        }
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

    /** What is known of a robot, without its body. */
    private record Entry(RobotStatistics statistics, String team, int number, long unansweredMessages) {

        static Entry of(RobotStatistics statistics, Participant participant) {
            Optional<Player> player = participant.player();
            return new Entry(
                    statistics,
                    player.map(member -> member.team().name()).orElse(""),
                    player.map(Player::number).orElse(0),
                    participant.unansweredMessages());
        }

        /** Whether it still says what is known of a participant, as it nearly always does. */
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
