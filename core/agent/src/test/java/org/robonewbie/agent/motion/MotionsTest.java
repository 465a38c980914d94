package org.robonewbie.agent.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionLibrary;
import org.robonewbie.nao.motion.MotionSource;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.MotionFiles;

class MotionsTest {

    private static final String ZEROS = " 0".repeat(21);

    @TempDir
    private Path folder;

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final IdealRobot robot = new IdealRobot(Posture.ZERO);
    private final Diagnostics diagnostics = new Diagnostics(new PrintStream(OutputStream.nullOutputStream()));

    @Test
    void playsAFileByItsName() throws IOException {
        file("nod", "200 30" + ZEROS);
        MotionSequencer motions = motions();

        boolean started = motions.start("nod");
        cycles(motions, 12);

        assertThat(started).isTrue();
        assertThat(robot.degrees(Joint.NECK_YAW)).isCloseTo(30, within(1e-6));
        assertThat(motions.isFinished()).isTrue();
    }

    @Test
    void namesTheMotionAndKeyframeThatAreRunning() throws IOException {
        file("nod", "40 10" + ZEROS + "\n40 20" + ZEROS);
        MotionSequencer motions = motions();

        motions.start("nod");
        cycles(motions, 3);

        assertThat(motions.current()).contains("nod");
        assertThat(motions.keyframe()).isEqualTo(2);
    }

    @Test
    void runsAMotionToItsEndBeforeAnotherOneStarts() throws IOException {
        file("nod", "200 30" + ZEROS);
        file("shake", "200 -30" + ZEROS);
        MotionSequencer motions = motions();
        motions.start("nod");
        cycles(motions, 5);

        boolean started = motions.start("shake");

        assertThat(started).isFalse();
        assertThat(motions.current()).contains("nod");
    }

    @Test
    void stopsAMotionWhereItIsAndStartsItAgainFromTheBeginning() throws IOException {
        file("nod", "200 30" + ZEROS);
        MotionSequencer motions = motions();
        motions.start("nod");
        cycles(motions, 5);

        motions.stop();
        cycles(motions, 3);
        double stopped = robot.degrees(Joint.NECK_YAW);
        motions.start("nod");
        cycles(motions, 10);

        assertThat(stopped).isBetween(12.0, 18.0);
        assertThat(motions.isFinished()).isTrue();
        assertThat(motions.current()).isEmpty();
    }

    @Test
    void repeatsALoopUntilItIsStopped() throws IOException {
        file("nod", "40 10" + ZEROS + "\n40 0" + ZEROS);
        MotionSequencer motions = motions();

        motions.loop("nod");
        cycles(motions, 100);
        boolean finished = motions.isFinished();
        motions.stop();

        assertThat(finished).isFalse();
        assertThat(motions.isFinished()).isTrue();
    }

    @Test
    void playsTwiceAsFast() throws IOException {
        file("nod", "400 30" + ZEROS);
        MotionSequencer motions = motions();

        motions.setSpeed(2);
        motions.start("nod");
        cycles(motions, 10);

        assertThat(motions.isFinished()).isTrue();
    }

    @Test
    void playsAMotionInTheMirror() throws IOException {
        file("salute", "400 30 0 -80" + " 0".repeat(19));
        MotionSequencer motions = motions();

        motions.startMirrored("salute");
        cycles(motions, 22);

        assertThat(robot.degrees(Joint.NECK_YAW)).isCloseTo(-30, within(1e-6));
        assertThat(robot.degrees(Joint.RIGHT_SHOULDER_PITCH)).isCloseTo(-80, within(1e-6));
        assertThat(robot.degrees(Joint.LEFT_SHOULDER_PITCH)).isZero();
    }

    @Test
    void findsTheOtherSideOfAMotionByItsName() throws IOException {
        file("salute-left", "// end: lying on left side\n200 30" + ZEROS);
        MotionLibrary library = MotionFiles.library(folder.resolve("motions"));

        MotionFile right = library.find("salute-right").orElseThrow();

        assertThat(right.motion().keyframes().get(0).posture().degrees(Joint.NECK_YAW))
                .isEqualTo(-30);
        assertThat(right.property("end")).contains("lying on right side");
        assertThat(library.find("salute")).isEmpty();
    }

    @Test
    void twoRobotsOfOneProgramDoNotShareTheirMotions() throws IOException {
        file("nod", "200 30" + ZEROS);
        MotionSequencer one = motions();
        IdealRobot otherRobot = new IdealRobot(Posture.ZERO);
        JointStates otherJoints = new JointStates();
        Motors otherMotors = new Motors(otherJoints);
        MotionSequencer other = new MotionSequencer(
                otherMotors, MotionFiles.library(folder.resolve("motions")), diagnostics, () -> BodyPosition.UPRIGHT);

        one.start("nod");
        cycles(one, 5);
        other.start("nod");
        for (int i = 0; i < 12; i++) {
            otherRobot.sense(otherJoints);
            other.update();
            otherRobot.act(otherMotors);
        }
        cycles(one, 7);

        assertThat(robot.degrees(Joint.NECK_YAW)).isCloseTo(30, within(1e-6));
        assertThat(otherRobot.degrees(Joint.NECK_YAW)).isCloseTo(30, within(1e-6));
    }

    @Test
    void saysWhichMotionsThereAreWhenOneIsUnknown() throws IOException {
        file("nod", "200 30" + ZEROS);

        boolean started = motions().start("salute");

        assertThat(started).isFalse();
        assertThat(diagnostics.reported())
                .singleElement()
                .asString()
                .startsWith("0.00 s: There is no motion \"salute\". Put a file motions/salute.txt in the working"
                        + " directory, or use one of: ")
                .contains("nod", "walk-forward");
    }

    @Test
    void guessesWhichMotionAMisspeltNameMeans() {
        motions().start("walk-foward");

        assertThat(diagnostics.reported())
                .singleElement()
                .asString()
                .startsWith("0.00 s: There is no motion \"walk-foward\". Did you mean \"walk-forward\"? Put a file ");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\'',
            value = {
                "nod.txt | There is no motion \"nod.txt\". Omit \".txt\": the name is \"nod\".",
                "walk-forward.TXT | There is no motion \"walk-forward.TXT\". Omit \".txt\": the name is \"walk-forward\".",
                "nodd.txt | There is no motion \"nodd.txt\". Did you mean \"nod\"? Put a file motions/nodd.txt in the",
                "NOD | There is no motion \"NOD\". Did you mean \"nod\"? Put a file motions/NOD.txt in the",
                "'nod ' | \"nod \" is not a valid motion name: it ends with a space. Did you mean \"nod\"? Choose another",
                "my/nod | \"my/nod\" is not a valid motion name: it contains \"/\".",
                "n\u200Bod | \"n\u200Bod\" is not a valid motion name: it contains the invisible character U+200B. Did you mean"
            })
    void saysWhatIsWrongWithAName(String name, String message) throws IOException {
        file("nod", "200 30" + ZEROS);

        boolean started = motions().start(name);

        assertThat(started).isFalse();
        assertThat(diagnostics.reported()).singleElement().asString().startsWith("0.00 s: " + message);
    }

    @Test
    void neverProposesTheNameThatWasWritten() {
        MotionSource gone = new MotionSource() {
            @Override
            public Optional<byte[]> read(String name) {
                return Optional.empty();
            }

            @Override
            public SortedSet<String> names() {
                return new TreeSet<>(List.of("nod"));
            }
        };
        MotionSequencer motions =
                new MotionSequencer(motors, new MotionLibrary(gone, gone), diagnostics, () -> BodyPosition.UPRIGHT);

        motions.start("nod");

        assertThat(diagnostics.reported()).singleElement().asString().doesNotContain("Did you mean");
    }

    @ParameterizedTest
    @ValueSource(strings = {"grüßen", "gru\u0308ßen", "приседание", "día", "挥手", "नमस्ते", "سلام", "wave (1)", "👋"})
    void playsMotionsInAnyLanguage(String name) throws IOException {
        file(name, "200 30" + ZEROS);

        assertThat(motions().start(Normalizer.normalize(name, Normalizer.Form.NFC)))
                .isTrue();
        assertThat(motions().start(Normalizer.normalize(name, Normalizer.Form.NFD)))
                .isTrue();
        assertThat(diagnostics.reported()).isEmpty();
    }

    @Test
    void namesTheLineOfABrokenFileAndGoesOn() throws IOException {
        file("nod", "200 30" + ZEROS + "\n200 thirty" + ZEROS);
        MotionSequencer motions = motions();

        boolean started = motions.start("nod");
        cycles(motions, 1);

        assertThat(started).isFalse();
        assertThat(diagnostics.reported())
                .singleElement()
                .asString()
                .contains("The motion nod cannot be played: nod.txt")
                .contains("2")
                .contains("thirty")
                .contains("The robot continues without it.");
    }

    @Test
    void playsTheLastGoodVersionOfAFileThatWasBrokenSince() throws IOException {
        file("nod", "200 30" + ZEROS);
        MotionSequencer motions = motions();
        motions.start("nod");
        cycles(motions, 10);

        file("nod", "200 thirty" + ZEROS);
        boolean started = motions.start("nod");

        assertThat(started).isTrue();
        assertThat(diagnostics.reported().get(0)).contains("thirty").contains("The last valid version is played.");
    }

    @Test
    void readsAFileAgainThatWasMended() throws IOException {
        file("nod", "oops");
        MotionSequencer motions = motions();
        boolean broken = motions.start("nod");

        file("nod", "200 30" + ZEROS);
        boolean mended = motions.start("nod");

        assertThat(broken).isFalse();
        assertThat(mended).isTrue();
    }

    @Test
    void reportsOnceWhatAMotorCannotDoInTime() throws IOException {
        file("nod", "20 90" + ZEROS + "\n500 0" + ZEROS);
        MotionSequencer motions = motions();

        for (int i = 0; i < 3; i++) {
            motions.start("nod");
            cycles(motions, 30);
        }

        assertThat(diagnostics.reported())
                .containsExactly("0.00 s: Motion nod turns NECK_YAW by 90 degrees in 20 ms on the way to keyframe 1,"
                        + " which is faster than its motor allows; plan at least 260 ms.");
    }

    @Test
    void doesNotLetANameLeadOutOfTheFolder() throws IOException {
        Files.writeString(folder.resolve("secret.txt"), "200 30" + ZEROS);

        boolean started = motions().start("../secret");

        assertThat(started).isFalse();
    }

    private MotionSequencer motions() {
        return new MotionSequencer(
                motors, MotionFiles.library(folder.resolve("motions")), diagnostics, () -> BodyPosition.UPRIGHT);
    }

    private void file(String name, String text) throws IOException {
        Files.createDirectories(folder.resolve("motions"));
        Files.writeString(folder.resolve("motions").resolve(name + ".txt"), text);
    }

    private void cycles(MotionSequencer motions, int count) {
        for (int i = 0; i < count; i++) {
            robot.sense(joints);
            motions.update();
            robot.act(motors);
        }
    }
}
