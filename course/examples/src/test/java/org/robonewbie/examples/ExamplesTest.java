package org.robonewbie.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.KeyframeInterval;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/** Runs each example in the simulator, as fast as it can, and looks at the true results. */
class ExamplesTest {

    @TempDir
    private Path folder;

    @Test
    void basicStructureRaisesTheLeftArmTo30Degrees() throws Exception {
        Agent_BasicStructure.main(fast("12"));

        assertThat(reported("LEFT_SHOULDER_PITCH")).isCloseTo(30, within(2.5));
        assertThat(reported("simulatedSeconds")).isEqualTo(12);
    }

    @Test
    void waveEndsByItselfWithTheRobotOnItsFeet() throws Exception {
        Agent_Wave.main(fast("60"));

        assertThat(reported("simulatedSeconds")).isBetween(2.0, 10.0);
        assertThat(reported("falls")).isZero();
    }

    @Tag("slow")
    @Test
    void simpleSoccerReachesTheBallAndPushesIt() throws Exception {
        Agent_SimpleSoccer.main(fast("240"));

        assertThat(reported("metresMoved")).isGreaterThan(0.3);
    }

    @Tag("slow")
    @Test
    void betterSoccerScoresWithinTwoMinutes() throws Exception {
        Agent_BetterSoccer.main(fast("120"));

        assertThat(Files.readString(report())).containsPattern("\"goals\": \\[\\s*\\{");
    }

    @Tag("slow")
    @Test
    void simpleWalkToBallStopsAtTheBallWithoutTouchingIt() throws Exception {
        Agent_SimpleWalkToBall.main(fast("60", "--pose", "-1.5,1,120"));

        double robot = Math.hypot(reported("x") - reportedOfBall("x"), reported("y") - reportedOfBall("y"));
        assertThat(robot).isBetween(0.15, 0.6);
        assertThat(reported("metresMoved")).isZero();
        assertThat(reported("falls")).isZero();
    }

    @Test
    void danceKeepsTheRobotOnItsFeet() throws Exception {
        Agent_Dance.main(fast("20"));

        assertThat(reported("falls")).isZero();
    }

    @Test
    void smoothDanceKeepsTheRobotOnItsFeetToo() throws Exception {
        Agent_SmoothDance.main(fast("20"));

        assertThat(reported("falls")).isZero();
    }

    @Test
    void splineGoesThroughTheKeyframesWithoutACorner() {
        Motion motion = new Motion(
                "swing",
                List.of(
                        new Keyframe(200, Posture.ZERO.with(Joint.NECK_YAW, 30)),
                        new Keyframe(400, Posture.ZERO.with(Joint.NECK_YAW, 90))));
        Agent_SmoothDance.Spline spline = new Agent_SmoothDance.Spline();
        KeyframeInterval first = new KeyframeInterval(Posture.ZERO, motion, 0);
        KeyframeInterval second = new KeyframeInterval(Posture.ZERO, motion, 1);

        double end = spline.degrees(first, Joint.NECK_YAW, 1);
        double speedBefore = (end - spline.degrees(first, Joint.NECK_YAW, 0.999)) / (0.001 * 200);
        double speedAfter = (spline.degrees(second, Joint.NECK_YAW, 0.001) - end) / (0.001 * 400);

        assertThat(end).isEqualTo(30);
        assertThat(spline.degrees(second, Joint.NECK_YAW, 1)).isEqualTo(90);
        assertThat(speedBefore).isCloseTo(90.0 / 600, within(0.001));
        assertThat(speedAfter).isCloseTo(90.0 / 600, within(0.001));
    }

    @Tag("slow")
    @Test
    void penaltyAttackerKicksTheBallAtTheGoalkeeper() throws Exception {
        Agent.runTogether(fast("30"), new Agent_PenaltyAttacker(), new Agent_PenaltyGoalkeeper());

        assertThat(reported("metresMoved")).isGreaterThan(2);
        assertThat(Files.readString(report())).contains("Attackers").contains("Keepers");
    }

    @Test
    void dummyStandsAndTalks() throws Exception {
        Agent_Dummy.main(fast("10"));

        assertThat(reported("falls")).isZero();
        assertThat(reported("simulatedSeconds")).isEqualTo(10);
    }

    @Tag("slow")
    @Test
    void soccerTeamStartsItsPlayersWithOneCommand() throws Exception {
        Agent_SoccerTeam.main(
                Stream.concat(Stream.of("2"), Stream.of(fast("20"))).toArray(String[]::new));

        String report = Files.readString(report());
        assertThat(report).contains("\"number\": 1").contains("\"number\": 2");
        assertThat(Pattern.compile("\"metresWalked\": ([\\d.]+)")
                        .matcher(report)
                        .results()
                        .map(metres -> Double.valueOf(metres.group(1))))
                .hasSize(2)
                .anyMatch(metres -> metres > 0.1);
    }

    @Test
    void twoPlayersOfOneProgramPlayTheSameGameAgain() throws Exception {
        String[] args = Stream.concat(Stream.of("2"), Stream.of(fast("10"))).toArray(String[]::new);
        Agent_SoccerTeam.main(args);
        String first = recordingHash();
        Agent_SoccerTeam.main(args);
        String second = recordingHash();

        assertThat(first).hasSize(64).isEqualTo(second);
    }

    @Test
    void reactiveTurnsItsHeadToTheBall() throws Exception {
        Agent_Reactive.main(fast("5", "--pose", "-1,-0.7,0"));

        assertThat(reported("NECK_YAW")).isCloseTo(35, within(5.0));
    }

    @Test
    void ownWorldModelPlaysItsTimeAndDrawsWithoutAMistake() {
        Agent_OwnWorldModel.main(fast("6"));
    }

    @Test
    void twoBehavioursMoveHeadAndArmAtTheSameTime() throws Exception {
        Agent_TwoBehaviours.main(fast("4.5"));

        assertThat(Math.abs(reported("NECK_YAW"))).isGreaterThan(1);
        assertThat(Math.abs(reported("LEFT_SHOULDER_PITCH"))).isGreaterThan(1);
    }

    @Test
    void testPerceptorInputPrintsAllKindsOfPerceptors() throws Exception {
        String printed = printedBy(() -> Agent_TestPerceptorInput.main(fast("1")));

        assertThat(printed)
                .contains("message: (time (now ")
                .contains("game: KICK_OFF_LEFT at")
                .contains("me: number 1 of teamA, side LEFT")
                .contains("joints (degrees): NECK_YAW")
                .contains("gyro (degrees per second)")
                .contains("acceleration (m/s2)")
                .contains("force on the left foot (newton)")
                .contains("camera: FLAG_2_LEFT at");
    }

    @Test
    void testLocalFieldViewPrintsWhatItRemembers() throws Exception {
        String printed = printedBy(() -> Agent_TestLocalFieldView.main(fast("5")));

        assertThat(printed)
                .contains("ball 1.")
                .contains("visible now")
                .contains("GOAL_POST_1_RIGHT")
                .contains("line from");
    }

    @Test
    void testLocalFieldViewComparesItsBeliefWithTheTruth() throws Exception {
        String simple = printedBy(() -> Agent_TestLocalFieldView.main(fast("5")));
        String exact = printedBy(() -> Agent_TestLocalFieldView.main(
                Stream.concat(Stream.of("exact"), Stream.of(fast("5"))).toArray(String[]::new)));

        assertThat(lastNumber("largest ([0-9.]+) m", simple)).isBetween(0.1, 0.6);
        assertThat(lastNumber("largest ([0-9.]+) m", exact)).isLessThan(0.03);
    }

    @Test
    void testSelfLocalisationKnowsItsPlaceWhileItWalks() throws Exception {
        String printed = printedBy(() -> Agent_TestSelfLocalisation.main(fast("60")));

        assertThat(lastNumber("mean error ([0-9.]+) m", printed)).isBetween(0.001, 0.2);
        assertThat(lastNumber("largest ([0-9.]+) m", printed)).isLessThan(0.7);
    }

    private static double lastNumber(String pattern, String text) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        double last = Double.NaN;
        while (matcher.find()) {
            last = Double.parseDouble(matcher.group(1));
        }
        return last;
    }

    private static String printedBy(ThrowingRunnable program) throws Exception {
        PrintStream usual = System.out;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        try {
            program.run();
        } finally {
            System.setOut(usual);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }

    /** A program that may fail. */
    private interface ThrowingRunnable {
        void run() throws Exception;
    }

    private String[] fast(String seconds, String... more) {
        return Stream.concat(Stream.of(fast(seconds)), Stream.of(more)).toArray(String[]::new);
    }

    private String[] fast(String seconds) {
        return new String[] {
            "--headless", "--fast", "--seed", "1", "--seconds", seconds, "--report", report().toString()
        };
    }

    private double reported(String name) throws IOException {
        return number(name, Files.readString(report()));
    }

    private static double number(String name, String report) {
        Matcher matcher = Pattern.compile("\"" + name + "\": *(-?[0-9.Ee-]+)").matcher(report);
        assertThat(matcher.find()).as("the report has " + name).isTrue();
        return Double.parseDouble(matcher.group(1));
    }

    private double reportedOfBall(String name) throws IOException {
        String text = Files.readString(report());
        return number(name, text.substring(text.indexOf("\"ball\"")));
    }

    private String recordingHash() throws IOException {
        Matcher matcher = Pattern.compile("\"recordingSha256\": *\"(\\w+)\"").matcher(Files.readString(report()));
        assertThat(matcher.find()).isTrue();
        return matcher.group(1);
    }

    private Path report() {
        return folder.resolve("report.json");
    }
}
