package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_Dance;
import org.robonewbie.examples.Agent_SimpleWalkToBall;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.team.Agent_Team;

/** Programs that do not do what an exercise asks for pass none of them, and earn little. */
class WrongProgramsTest {

    private static final List<Long> SEEDS = List.of(1L, 2L);
    private static final double MAX_POINTS = 6;

    private static final Map<String, Supplier<Agent>> PROGRAMS = Map.ofEntries(
            program("do nothing", robot -> {}),
            program("walk ahead at full speed", robot -> robot.walk().towards(1, 0, 0)),
            program("march on the spot", robot -> robot.walk().towards(0.001, 0, 0)),
            program("turn left for ever", robot -> robot.walk().towards(0, 0, 30)),
            program("walk aside", robot -> robot.walk().towards(0, 0.2, 0)),
            program("walk in a circle", robot -> robot.walk().towards(0, 0.2, -12)),
            program("look around", robot -> robot.look()),
            program("wave", robot -> robot.play("wave")),
            program("dance as the framework does", robot -> robot.play("dance")),
            program("lie down", robot -> robot.play("fall-back")),
            program("kick as the framework does", robot -> robot.play("kick-left")),
            program("dive to the left at once", robot -> robot.play("dive-left")),
            program("get up as the framework does", robot -> robot.getUp()),
            program("swing both arms once in two seconds", WrongProgramsTest::swing),
            program("say everything", WrongProgramsTest::talk));

    /** What each exercise is not to be solved by, though the framework or an example gives it away. */
    private static final Map<String, Supplier<Agent>> ONE_LINERS = Map.ofEntries(
            Map.entry("ball-direction", supplier(Robot::sayTheExactBearing)),
            Map.entry("get-up", supplier(Robot::getUp)),
            Map.entry("dance", Agent_Dance::new),
            Map.entry("kick", supplier(robot -> robot.play("kick-left"))),
            Map.entry("goalkeeper", supplier(robot -> robot.play("dive-left"))),
            Map.entry("faster-walk", supplier(robot -> robot.walk().towards(1, 0, 0))),
            Map.entry("score-a-goal", Agent_BetterSoccer::new),
            Map.entry("go-to-ball", Agent_SimpleWalkToBall::new),
            Map.entry("unseen-ball", supplier(Robot::turnAndSayWhatIsRemembered)),
            Map.entry("rolling-ball", supplier(Robot::sayWhereTheBallWas)),
            Map.entry("better-pass", Agent_Team::new),
            Map.entry("formation", Agent_Team::new),
            Map.entry("dribble-past", Agent_Team::new));

    static Stream<Arguments> allForEachExercise() {
        return Exercises.all().stream()
                .flatMap(exercise -> PROGRAMS.entrySet().stream()
                        .map(program -> Arguments.of(exercise.name(), program.getKey(), program.getValue())));
    }

    static Stream<Arguments> oneLiners() {
        return ONE_LINERS.entrySet().stream()
                .map(line -> Arguments.of(line.getKey(), "what is given", line.getValue()));
    }

    @Tag("slow")
    @ParameterizedTest(name = "{0}: {1}")
    @MethodSource("allForEachExercise")
    void noneOfFifteenProgramsThatDoNotDoTheTaskPasses(String exercise, String name, Supplier<Agent> program) {
        checkFailure(exercise, program);
    }

    @ParameterizedTest(name = "{0}: {1}")
    @MethodSource("oneLiners")
    void whatTheFrameworkGivesAwayIsNotEnough(String exercise, String name, Supplier<Agent> program) {
        checkFailure(exercise, program);
    }

    private static void checkFailure(String exercise, Supplier<Agent> program) {
        Grade grade = new Grader().grade(Exercises.find(exercise).orElseThrow(), program, SEEDS, Optional.empty());

        assertThat(grade.passed()).as(grade.toString()).isFalse();
        assertThat(grade.points()).as(grade.toString()).isLessThan(MAX_POINTS);
        assertThat(grade.toString())
                .doesNotContain("NaN", "Infinity", "The program ended with")
                .doesNotContainPattern("-0\\.0+(?!\\d)");
    }

    private static void swing(Robot robot) {
        double degrees = 45 * Math.sin(Math.PI * robot.seconds());
        robot.move(Joint.LEFT_SHOULDER_PITCH, degrees);
        robot.move(Joint.RIGHT_SHOULDER_PITCH, degrees);
    }

    private static void talk(Robot robot) {
        List<String> words =
                List.of("back", "front", "up", "ball:0.0", "at:0.00:0.00", "ball:1.00:0.50", "left", "right");
        robot.say(words.get((int) (robot.seconds() * 50) % words.size()));
    }

    private static Map.Entry<String, Supplier<Agent>> program(String name, Consumer<Robot> think) {
        return Map.entry(name, supplier(think));
    }

    private static Supplier<Agent> supplier(Consumer<Robot> think) {
        return () -> new Robot(think);
    }

    /** A robot whose decisions are one function. */
    private static final class Robot extends Agent {
        private final Consumer<Robot> decide;

        Robot(Consumer<Robot> decide) {
            this.decide = decide;
        }

        @Override
        protected void think() {
            decide.accept(this);
        }

        org.robonewbie.agent.walk.Walk walk() {
            return walk;
        }

        double seconds() {
            return nao.getTime();
        }

        void look() {
            lookAround.look();
        }

        void play(String motion) {
            motions.start(motion);
        }

        void getUp() {
            motions.startGetUp();
        }

        void say(String text) {
            nao.say(text);
        }

        void move(Joint joint, double degrees) {
            nao.setJointAngle(joint, degrees);
        }

        void turnAndSayWhatIsRemembered() {
            walk.towards(0, 0, 30);
            if (fieldView.ball().isKnown()) {
                say(String.format(
                        java.util.Locale.ROOT, "ball:%.1f", fieldView.ball().bearing()));
            }
        }

        void sayWhereTheBallWas() {
            if (fieldView.ball().isKnown()) {
                Vector3 ball = fieldView.ball().position();
                say(String.format(java.util.Locale.ROOT, "ball:%.2f:%.2f", ball.x(), ball.y()));
            }
        }

        void sayTheExactBearing() {
            fieldView.setTransformation(CameraTransformation.KINEMATICS);
            look();
            if (fieldView.ball().isVisible()) {
                say(String.format(
                        java.util.Locale.ROOT, "ball:%.1f", fieldView.ball().bearing()));
            }
        }
    }
}
