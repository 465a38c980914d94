package org.robonewbie.agent.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.MotionFiles;

/** What a robot does by itself between motions: stop, make a first step, get up. */
class MotionSequenceTest {

    private static final String ZEROS = " 0".repeat(21);

    @TempDir
    private Path folder;

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final IdealRobot robot = new IdealRobot(Posture.ZERO);
    private final Diagnostics diagnostics = new Diagnostics(new PrintStream(OutputStream.nullOutputStream()));
    private BodyPosition bodyPosition = BodyPosition.UPRIGHT;

    @Test
    void stopsWalkingBeforeItTurns() throws IOException {
        file("walk", "// start: stance or the end of walk\n// end: walking, left foot behind\n100 1" + ZEROS);
        file("stop-walking", "// start: the end of walk\n// end: stance\n100 2" + ZEROS);
        file("turn", "// start: stance\n// end: stance\n100 3" + ZEROS);
        file("stand", "// start: standing\n// end: stance\n100 0" + ZEROS);
        MotionSequencer motions = motions();

        List<String> played = play(motions, "walk", "walk", "turn", "turn");

        assertThat(played).containsExactly("stand", "walk", "stop-walking", "turn");
    }

    @Test
    void makesAFirstStepBeforeItWalksAndStopsBeforeItTurns() throws IOException {
        file("walk", "// start: walking\n// end: walking\n100 1" + ZEROS);
        file("start-walking", "// start: stance\n// end: walking\n100 2" + ZEROS);
        file("turn", "// start: stance\n// end: stance\n100 3" + ZEROS);
        file("lie", "// start: lying on back\n// end: stance\n100 4" + ZEROS);
        MotionSequencer motions = motions();

        List<String> played = play(motions, "walk", "walk", "turn", "lie");

        assertThat(played).containsExactly("stand", "start-walking", "walk", "stop-walking", "turn", "lie");
    }

    @Test
    void choosesTheWayToGetUpByTheSideOnWhichTheRobotLies() throws IOException {
        file("stand-up-from-front", "100 1" + ZEROS);
        MotionSequencer motions = motions();

        boolean upright = motions.startGetUp();
        bodyPosition = BodyPosition.LYING_ON_FRONT;
        boolean lying = motions.startGetUp();
        cycles(motions, 1);

        assertThat(upright).isFalse();
        assertThat(lying).isTrue();
        assertThat(motions.current()).contains("stand-up-from-front");
    }

    @Test
    void getsUpByItselfBeforeAMotionThatStartsOnTheFeet() throws IOException {
        file("stand-up-from-front", "// start: lying on front\n// end: stance\n100 10" + ZEROS);
        file("hop", "// start: stance\n// end: stance\n100 20" + ZEROS);
        MotionSequencer motions = motions();
        bodyPosition = BodyPosition.LYING_ON_FRONT;

        motions.start("hop");
        cycles(motions, 3);
        String first = motions.current().orElse("");
        bodyPosition = BodyPosition.UPRIGHT;
        cycles(motions, 4);

        assertThat(first).isEqualTo("stand-up-from-front");
        assertThat(motions.current()).contains("hop");
    }

    @Test
    void getsUpInTheMiddleOfALoopedWalkAndWalksOn() throws IOException {
        file("stand-up-from-back", "// start: lying on back\n// end: stance\n100 10" + ZEROS);
        file("hop", "// start: standing\n// end: stance\n100 20" + ZEROS);
        MotionSequencer motions = motions();
        motions.loop("hop");
        cycles(motions, 3);

        bodyPosition = BodyPosition.LYING_ON_BACK;
        cycles(motions, 3);
        String fallen = motions.current().orElse("");
        bodyPosition = BodyPosition.UPRIGHT;
        cycles(motions, 20);

        assertThat(fallen).isEqualTo("stand-up-from-back");
        assertThat(motions.current()).contains("hop");
    }

    @Test
    void playsAMotionAsTheRobotLiesIfItSaysNothingAboutItsStart() throws IOException {
        file("own-way-up", "100 10" + ZEROS);
        MotionSequencer motions = motions();
        bodyPosition = BodyPosition.LYING_ON_FRONT;

        motions.start("own-way-up");
        cycles(motions, 2);

        assertThat(motions.current()).contains("own-way-up");
    }

    @Test
    void makesAFirstStepAgainAfterGettingUp() throws IOException {
        file("stand-up-from-back", "// start: lying on back\n// end: stance\n40 10" + ZEROS);
        file("start-walking", "// start: stance\n// end: walking\n40 2" + ZEROS);
        file("walk", "// start: walking\n// end: walking\n40 1" + ZEROS);
        MotionSequencer motions = motions();
        bodyPosition = BodyPosition.LYING_ON_BACK;

        motions.start("walk");
        cycles(motions, 1);
        String first = motions.current().orElse("");
        bodyPosition = BodyPosition.UPRIGHT;
        cycles(motions, 2);
        String second = motions.current().orElse("");
        cycles(motions, 2);

        assertThat(List.of(first, second)).containsExactly("stand-up-from-back", "start-walking");
        assertThat(motions.current()).contains("walk");
    }

    @Test
    void leavesAFallenRobotAloneIfTold() throws IOException {
        file("hop", "// start: stance\n// end: stance\n100 20" + ZEROS);
        MotionSequencer motions = motions();
        motions.setAutomaticGetUp(false);
        bodyPosition = BodyPosition.LYING_ON_FRONT;

        motions.start("hop");
        cycles(motions, 2);

        assertThat(motions.current()).contains("hop");
    }

    private MotionSequencer motions() {
        return new MotionSequencer(
                motors, MotionFiles.library(folder.resolve("motions")), diagnostics, () -> bodyPosition);
    }

    private void file(String name, String text) throws IOException {
        Files.createDirectories(folder.resolve("motions"));
        Files.writeString(folder.resolve("motions").resolve(name + ".txt"), text);
    }

    /** Plays motions to their ends and lists what is seen one after the other. */
    private List<String> play(MotionSequencer motions, String... names) {
        List<String> played = new ArrayList<>();
        for (String name : names) {
            motions.start(name);
            while (!motions.isFinished()) {
                cycles(motions, 1);
                motions.current()
                        .filter(now -> played.isEmpty() || !now.equals(played.get(played.size() - 1)))
                        .ifPresent(played::add);
            }
        }
        return played;
    }

    private void cycles(MotionSequencer motions, int count) {
        for (int i = 0; i < count; i++) {
            robot.sense(joints);
            motions.update();
            robot.act(motors);
        }
    }
}
