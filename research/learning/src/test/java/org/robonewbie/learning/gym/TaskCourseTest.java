package org.robonewbie.learning.gym;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.learning.policy.Course;
import org.robonewbie.learning.policy.EvolutionStrategy;
import org.robonewbie.learning.policy.Exam;
import org.robonewbie.learning.policy.LessonFigures;
import org.robonewbie.learning.policy.PolicyTraining;
import org.robonewbie.learning.policy.TrainingPlan;
import org.robonewbie.nao.Joint;
import org.robonewbie.trial.WorldState;

class TaskCourseTest {

    private static final ClassLoader CLASSES = TaskCourseTest.class.getClassLoader();

    @TempDir
    private Path folder;

    @Test
    void firstGuessDoesNothing() {
        Course stand = course("Stand");

        LessonFigures figures = Exam.of(stand, plan(1), 1, stand.policy(List.of(), stand.start(3)));

        assertThat(figures.falls()).isEqualTo(1);
        assertThat(figures.seconds()).isGreaterThan(3);
    }

    @Test
    void learnsWhatPays() throws IOException {
        Course salute = course(Salute.class.getName());
        PolicyTraining training = training(salute, plan(40));
        Policy before = salute.policy(List.of(), salute.start(1));

        Policy learned = training.run(training.begin(), line -> {});

        LessonFigures figures = Exam.of(salute, plan(40), 5, learned);
        assertThat(Exam.of(salute, plan(40), 5, before).done()).isZero();
        assertThat(figures.done()).isEqualTo(5);
        assertThat(figures.toString()).startsWith("done 5 of 5, 0 falls, reward ");
        assertThat(Files.readAllLines(training.curve()))
                .hasSize(41)
                .first()
                .isEqualTo("generation,lessons,cycles,reward,falls,speedError,turnError,done");
    }

    @Test
    void goesOnWithAPolicyOfItsOwn() throws IOException {
        Course salute = course(Salute.class.getName());
        PolicyTraining training = training(salute, plan(1));
        Policy learned = training.run(training.begin(), line -> {});

        Policy again = salute.policy(learned.about(), salute.start(PolicyFile.read(training.output())));

        assertThat(PolicyText.format(again)).isEqualTo(PolicyText.format(learned));
        assertThat(learned.about())
                .containsExactly("learned by: robonewbie learn " + Salute.class.getName()
                        + " --seed 1 --pairs 4 --spread 0.02 --rate 0.02 --option noise=0.1 --generations 1");
    }

    @Test
    void policyCarriesTheMotionThatItCorrects() {
        Course kick = course("KickTo");

        Policy policy = kick.policy(List.of(), kick.start(1));

        assertThat(policy.numbers()).containsOnlyKeys("motion", "range-degrees");
        assertThat(policy.inputs()).extracting("name").contains("motion.sine-1", "command.distance", "gyro.left");
    }

    @Test
    void policyKeepsAnActionAsLongAsWhileItWasLearned() throws IOException {
        Course stand = course("Stand");
        TrainingPlan slow = new TrainingPlan(1, 1, 4, 0.5, 0.5, 9, 6, List.of("cycles=5"), 2);
        TrainingPlan usual = new TrainingPlan(1, 1, 4, 0.5, 0.5, 9, 6, List.of(), 2);
        PolicyTraining training = training(stand, slow);

        Policy learned = training.run(training.begin(), line -> {});

        assertThat(learned.cyclesPerAction()).isEqualTo(5);
        assertThat(Exam.of(stand, usual, 4, learned).toString())
                .isEqualTo(Exam.of(stand, slow, 4, learned).toString());
    }

    @Test
    void refusesWhatCannotBeLearned() {
        assertThatThrownBy(() -> course("Match1v1"))
                .hasMessage("In Match1v1 several robots learn; choose a task for one.");
        assertThatThrownBy(() -> course("Stnd"))
                .hasMessageStartingWith("There is no task \"Stnd\". Did you mean Stand? There are: ");
        assertThatThrownBy(() -> TaskCourse.of("Stand", "wing.*", 16, CLASSES))
                .hasMessage("Nothing that is observed in Stand has a name like wing.*.");
        assertThatThrownBy(() -> course("Stand").start(PolicyFile.shipped("walk")))
                .hasMessageContaining("Is it for another task?");
        assertThatThrownBy(() -> Exam.of(course("Stand"), plan(1), 1, PolicyFile.shipped("walk")))
                .hasStackTraceContaining("step.sine-of-2-pi-phase in 1, which is not observed in Stand.");
    }

    @Test
    void shippedKickComesNearerToWhatIsWantedThanTheMotionAlone() {
        Course kick = TaskCourse.of("KickTo", "command.*", 0, CLASSES);

        LessonFigures learned = Exam.of(kick, plan(1), 20, PolicyFile.shipped("kick-to"));
        LessonFigures alone = Exam.of(kick, plan(1), 20, kick.policy(List.of(), kick.start(1)));

        assertThat(learned.falls()).isZero();
        assertThat(learned.reward()).isGreaterThan(alone.reward() + 0.15);
    }

    @Test
    void shippedStandBearsHarderPushesThanTheStanceAlone() {
        Course stand = TaskCourse.of("Stand", "gyro\\.(forward|left)", 0, CLASSES);

        LessonFigures learned = Exam.of(stand, plan(1), 40, PolicyFile.shipped("stand"));
        LessonFigures alone = Exam.of(stand, plan(1), 40, stand.policy(List.of(), stand.start(1)));

        assertThat(learned.seconds()).isGreaterThan(alone.seconds() + 40 * 0.2);
        assertThat(learned.done()).isGreaterThan(alone.done() + 8);
    }

    @Test
    void shippedGetUpStandsUpMoreOftenThanTheMotionAloneWhereFeetHoldLessOrMore() {
        Course getUp = TaskCourse.of("QuickGetUp", "motion.*|gyro.left|accelerometer.(forward|up)", 0, CLASSES);
        TrainingPlan anyGround =
                new TrainingPlan(1, 1, 4, 0.02, 0.02, 9, 6, List.of("friction=0.5..2", "mass=0.9..1.1"), 2);

        LessonFigures learned = Exam.of(getUp, anyGround, 40, PolicyFile.shipped("get-up"));
        LessonFigures alone = Exam.of(getUp, anyGround, 40, getUp.policy(List.of(), getUp.start(1)));

        assertThat(learned.done()).isGreaterThan(alone.done() + 8);
        assertThat(learned.reward()).isGreaterThan(alone.reward() + 0.7);
    }

    @Test
    void trainingGoesOnFromTheShippedKick() throws IOException {
        Course kick = TaskCourse.of("KickTo", "command.*", 0, CLASSES);
        PolicyTraining training = training(kick, plan(1));
        EvolutionStrategy.State start = training.begin(PolicyFile.shipped("kick-to"));

        Policy next = training.run(start, line -> {});

        assertThat(start.mean()).hasSameSizeAs(kick.start(1));
        assertThat(next.network().numbers()).isNotEqualTo(start.mean());
    }

    private PolicyTraining training(Course course, TrainingPlan plan) {
        return new PolicyTraining(course, plan, folder.resolve("task.policy"), List.of());
    }

    private static TrainingPlan plan(int generations) {
        return new TrainingPlan(1, generations, 4, 0.02, 0.02, 9, 6, List.of("noise=0.1"), 2);
    }

    private static Course course(String task) {
        return TaskCourse.of(task, TaskCourse.USUAL_INPUTS, TaskCourse.USUAL_HIDDEN, CLASSES);
    }

    /** Raises the left arm by some degrees and holds it there. */
    public static final class Salute extends GymTask {

        private static final double WAY = 20;

        private double away;

        /** Creates the task. */
        public Salute() {}

        @Override
        public List<Joint> joints() {
            return List.of(Joint.LEFT_SHOULDER_PITCH);
        }

        @Override
        public double rangeDegrees() {
            return 30;
        }

        @Override
        public int longestCycles() {
            return 20;
        }

        @Override
        protected void see(WorldState first, WorldState now) {
            double moved = now.robot().joints().degrees(Joint.LEFT_SHOULDER_PITCH)
                    - first.robot().joints().degrees(Joint.LEFT_SHOULDER_PITCH);
            away = Math.abs(moved - WAY);
        }

        @Override
        public boolean isDone() {
            return away < WAY / 2;
        }

        @Override
        public double value() {
            return -away;
        }
    }
}
