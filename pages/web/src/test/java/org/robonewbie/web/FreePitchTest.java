package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.pagejvm.Program;

class FreePitchTest {

    private static final int CYCLES = 500;

    private final PageRecording recording = new PageRecording();
    private final StudentRun run = new StudentRun();

    @Test
    void fourShippedAgentsPlayAgainstEachOther() {
        FreePitch pitch = four(recording);

        assertThat(names(pitch)).containsExactly("RoboNewbie 1", "Guests 1", "RoboNewbie 2", "Guests 2");
        assertThat(snapshot(pitch).robots()).allMatch(robot -> robot.body().isStanding());
    }

    @Test
    void fourAgentsMakeTheSameRecordingTwice() {
        PageRecording other = new PageRecording();

        played(four(recording));
        played(four(other));

        assertThat(bytes(other)).isEqualTo(bytes(recording));
    }

    @Test
    void programPlaysBesideShippedAgents() {
        FreePitch pitch = pitch(recording).with(program(raising(30)), run).with(new Agent_BetterSoccer());

        played(pitch);

        assertThat(names(pitch)).containsExactly("RoboNewbie 1", "Guests 1");
        assertThat(arm(pitch)).isBetween(29.0, 33.0);
        assertThat(run.isRunning()).isTrue();
    }

    @Test
    void severalRobotsOfOneProgramEnter() {
        FreePitch pitch = pitch(recording).with(program("""
                import org.robonewbie.agent.Agent;
                public class Two extends Agent {
                    public static void main(String[] args) {
                        Agent.runTogether(args, new Two(), new Two());
                    }
                    protected void think() {
                        nao.say("hello");
                    }
                }
                """), run);

        played(pitch);

        assertThat(run.text()).startsWith("RUNNING");
        assertThat(names(pitch)).containsExactly("RoboNewbie 1", "RoboNewbie 2");
    }

    @Test
    void programIsReplacedWhileTheWorldIsKept() {
        FreePitch pitch =
                played(pitch(recording).with(program(raising(30)), run).with(new Agent_SimpleSoccer()));
        WorldSnapshot before = snapshot(pitch);
        long cycle = pitch.cycles();
        StudentRun next = new StudentRun();

        pitch.swap(run, program(raising(60)), next);

        WorldSnapshot after = snapshot(pitch);
        assertThat(places(after)).isEqualTo(places(before));
        assertThat(after.ballPosition()).isEqualTo(before.ballPosition());
        assertThat(pitch.cycles()).isGreaterThanOrEqualTo(cycle);
        assertThat(run.text()).startsWith("STOPPED");
        played(pitch);
        assertThat(arm(pitch)).isBetween(59.0, 63.0);
        assertThat(next.text()).isEqualTo("RUNNING\t0\t");
    }

    @Test
    void programWithNaoIsReplacedToo() {
        FreePitch pitch = played(pitch(recording).with(program(raising(30)), run));
        List<Pose> before = places(snapshot(pitch));

        pitch.swap(run, program("""
                import org.robonewbie.agent.Nao;
                public class Walker {
                    public static void main(String[] args) {
                        try (Nao nao = Nao.connect(args)) {
                            nao.perform("wave");
                            System.out.println("waved");
                        }
                    }
                }
                """), new StudentRun());

        assertThat(places(snapshot(pitch))).isEqualTo(before);
    }

    private static byte[] bytes(PageRecording recording) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        recording.give((bytes, first) -> all.writeBytes(bytes));
        return all.toByteArray();
    }

    @Test
    void recordingIsGivenAwayPieceByPiece() {
        FreePitch pitch = pitch(recording).with(new Agent_SimpleSoccer());
        List<Boolean> firsts = new ArrayList<>();

        pitch.cycle();
        recording.give((bytes, first) -> firsts.add(first));
        recording.give((bytes, first) -> firsts.add(first));
        pitch.cycle();
        recording.give((bytes, first) -> firsts.add(first));

        assertThat(firsts).containsExactly(true, false);
    }

    private static FreePitch four(PageRecording recording) {
        return pitch(recording)
                .with(new Agent_BetterSoccer())
                .with(new Agent_SimpleSoccer())
                .with(new Agent_BetterSoccer())
                .with(new Agent_SimpleSoccer());
    }

    private static FreePitch pitch(PageRecording recording) {
        List<FreePitch> made = new ArrayList<>();
        new PacedWorld(new SilentPage(), feed -> {
            made.add(new FreePitch(1, feed, recording));
            return made.get(0);
        });
        return made.get(0);
    }

    private static FreePitch played(FreePitch pitch) {
        for (int i = 0; i < CYCLES; i++) {
            pitch.cycle();
        }
        return pitch;
    }

    private static Program program(String text) {
        String name = text.replaceFirst("(?s).*?public class (\\w+).*", "$1");
        return new Program(JavaSource.compile(name, text).values());
    }

    private static String raising(int degrees) {
        return """
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;
                public class Raising extends Agent {
                    protected void think() {
                        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, angle < %d ? 60 : 0);
                    }
                }
                """.formatted(degrees);
    }

    private static double arm(FreePitch pitch) {
        return snapshot(pitch).robots().stream()
                .filter(robot -> robot.team().equals("RoboNewbie"))
                .findFirst()
                .orElseThrow()
                .body()
                .degrees(Joint.LEFT_SHOULDER_PITCH);
    }

    private static List<String> names(FreePitch pitch) {
        return snapshot(pitch).robots().stream()
                .map(robot -> robot.team() + " " + robot.number())
                .toList();
    }

    private static List<Pose> places(WorldSnapshot snapshot) {
        return snapshot.robots().stream().map(robot -> robot.body().torso()).toList();
    }

    private static WorldSnapshot snapshot(FreePitch pitch) {
        return pitch.snapshot(false, 1);
    }
}
