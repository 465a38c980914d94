package org.robonewbie.simulator.fidelity;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** Plays recordings again in worlds of ours, each run in a fresh one, and compares every row. */
final class Replay {

    private Replay() {}

    /**
     * Replays one recording.
     *
     * @param recording the recording
     * @return how closely it was followed
     * @throws IOException if a run shows neither a robot's torso nor a ball that was started in a known way
     */
    static RecordingFidelity of(Recording recording) throws IOException {
        Comparison comparison = new Comparison(Limits.STANDARD);
        for (RecordedRun run : recording.runs()) {
            RecordedRow first = run.rows().get(0);
            comparison.startRun(first);
            if (first.torso().isPresent()) {
                replayRobot(run, first.torso().get(), comparison);
            } else if (first.ball().isPresent()) {
                replayBall(run, comparison);
            } else {
                throw new IOException(
                        "The recording " + recording.name() + " shows neither torso nor ball. It needs one of them.");
            }
            comparison.endRun(run.rows().get(run.rows().size() - 1));
        }
        return comparison.result(recording.name());
    }

    private static void replayRobot(RecordedRun run, Pose start, Comparison comparison) {
        SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
        Robot robot = world.addRobot(RobotType.TYPE_0);
        new RobotStart(world, robot, run).reach(start);
        RecordedAnswer answer = new RecordedAnswer(robot);
        List<RecordedRow> rows = run.rows();
        for (int i = 0; i < rows.size(); i++) {
            comparison.compare(rows.get(i), robot);
            Optional<Pose> next = i + 1 < rows.size() ? rows.get(i + 1).torso() : Optional.empty();
            answer.apply(rows.get(i).sent(), next);
            world.step();
        }
    }

    private static void replayBall(RecordedRun run, Comparison comparison) throws IOException {
        SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
        Ball ball = world.ball();
        BallStart start = BallStart.of(run.name(), ball.properties().radius());
        ball.moveTo(start.position());
        ball.setVelocity(start.velocity());
        for (RecordedRow row : run.rows()) {
            world.step();
            comparison.compare(row, ball);
            if (row.playMode().equals(PlayMode.BEFORE_KICK_OFF.simSparkName())) {
                ball.place(new Vector3(0, 0, ball.properties().radius()));
            }
        }
    }
}
