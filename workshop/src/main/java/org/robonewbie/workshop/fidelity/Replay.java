package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.soccer.JoinRefusedException;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.SoccerWorld;

/** Replays recordings, each run in a fresh world, and compares every row. */
final class Replay {

    private static final Comparator<RecordingFidelity> CLOSEST = Comparator.comparingDouble(
                    (RecordingFidelity result) ->
                            -result.firstDivergenceSeconds().orElse(Double.POSITIVE_INFINITY))
            .thenComparingDouble(result -> result.jointMaxDegrees().orElse(0));

    private final Recording recording;
    private final AgentRoute route;
    private final RobotType type;
    private final JoiningWay way;
    private final Comparison comparison = new Comparison(Tolerances.STANDARD);

    private Replay(Recording recording, AgentRoute route, RobotType type, JoiningWay way) {
        this.recording = recording;
        this.route = route;
        this.type = type;
        this.way = way;
    }

    /**
     * Replays one recording. If it does not define the robot type or the start sequence, tries all candidates until one follows
     * the recording exactly.
     *
     * @param recording the recording
     * @param route transport for commands and measurements
     * @return the deviation of the best candidate
     * @throws IOException if a run contains neither a torso nor a ball with a known start
     */
    static RecordingFidelity of(Recording recording, AgentRoute route) throws IOException {
        Optional<RecordingFidelity> best = Optional.empty();
        for (JoiningWay way : JoiningWay.candidates(recording)) {
            for (RobotType type : BuildSearch.candidates(recording)) {
                RecordingFidelity result = new Replay(recording, route, type, way).replay();
                if (best.isEmpty() || CLOSEST.compare(result, best.get()) < 0) {
                    best = Optional.of(result);
                }
                if (best.get().firstDivergenceSeconds().isEmpty()
                        || best.get().torsoMaxMetres().isEmpty()) {
                    return best.get();
                }
            }
        }
        return best.orElseThrow();
    }

    private RecordingFidelity replay() throws IOException {
        for (RecordedRun run : recording.runs()) {
            RecordedRow first = run.rows().get(0);
            comparison.startRun(first);
            if (first.torso().isPresent()) {
                replayRobot(run, first.torso().get());
            } else if (run.rows().stream().anyMatch(row -> row.ball().isPresent())) {
                replayBall(run);
            } else {
                throw new IOException("The recording " + recording.name()
                        + " contains neither torso nor ball positions. It needs one of them.");
            }
            comparison.endRun();
        }
        return comparison.result(recording.name());
    }

    private void replayRobot(RecordedRun run, BodyPose start) throws IOException {
        try (ReplayStage stage = ReplayStage.open(route, type, way)) {
            new RecordedStart(stage, run, way).reach(start);
            RecordedCommands commands = new RecordedCommands(stage.robot().nao());
            List<RecordedRow> rows = run.rows();
            for (int i = 0; i < rows.size(); i++) {
                RecordedRow row = rows.get(i);
                Optional<RecordedRow> next = i + 1 < rows.size() ? Optional.of(rows.get(i + 1)) : Optional.empty();
                BodyPose torso = stage.robot().torso();
                Vector3 ball = stage.ball().position();
                Measurements measured = stage.step(commands.read(row.sent(), next.flatMap(RecordedRow::torso)));
                comparison.compare(row, measured, torso, ball);
                for (int missing = next.map(row::cyclesUntil).orElse(1); missing > 1; missing--) {
                    stage.step(List.of());
                }
            }
        }
    }

    /** Replays a ball. The referee is active: it puts the ball back before the kick-off and whenever the ball has left the pitch. */
    private void replayBall(RecordedRun run) throws IOException {
        SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
        Match match = new Match(world, SoccerParameters.league(), 0);
        Ball ball = world.ball();
        BallStart start = BallStart.of(run.name(), ball.properties().radius());
        join(match, world);
        match.setPlayMode(PlayMode.ofSimSparkName(run.rows().get(0).playMode()).orElse(PlayMode.PLAY_ON));
        ball.moveTo(start.position());
        ball.setVelocity(start.velocity());
        for (RecordedRow row : run.rows()) {
            world.step();
            comparison.compare(row, ball.position());
            match.tick();
        }
    }

    /** Adds a robot, because the clock runs only with at least one player. */
    private static void join(Match match, SoccerWorld world) throws IOException {
        try {
            match.teams().join("Recorded", 1, world.addRobot(RobotType.TYPE_0));
        } catch (JoinRefusedException e) {
            throw new IOException("The trainer's robot cannot join.", e);
        }
    }
}
