package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Project;
import org.robonewbie.app.program.GuestProcess;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.studio.ShownSimulation;
import org.robonewbie.studio.course.Attempt;
import org.robonewbie.studio.course.Attempt.State;
import org.robonewbie.studio.course.Lesson;
import org.robonewbie.trial.watch.WatchedTrial;

/** The exercises as the studio's page asks for them, with students' programs in processes of their own. */
@Timeout(300)
class CourseDeskTest {

    private static final String RAISE_ARMS = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class RaiseArms extends Agent {
                @Override
                protected void think() {
                    hold(Joint.LEFT_SHOULDER_PITCH, 60);
                    hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                }

                private void hold(Joint joint, double degrees) {
                    nao.setJointSpeed(joint, 4 * (degrees - nao.getJointAngle(joint)));
                }
            }
            """;

    @TempDir
    private Path folder;

    private final WatchedTrial freePitch = new WatchedTrial();
    private final ShownSimulation shown = new ShownSimulation(freePitch);

    private CourseDesk desk = new CourseDesk(Path.of(""), freePitch, shown);

    @BeforeEach
    void open() {
        desk = new CourseDesk(folder, freePitch, shown);
    }

    @AfterEach
    void close() {
        desk.close();
    }

    @Test
    void lessonsSayWhatTheirWorksheetsSay() throws Exception {
        for (Lesson lesson : desk.lessons()) {
            String sheet =
                    Files.readString(Project.ROOT.resolve(lesson.worksheet().replace(".html", ".md")));

            assertThat(sheet)
                    .contains("# Exercise " + lesson.number() + ": " + lesson.title() + "\n")
                    .contains("about " + lesson.minutes() + " minutes");
        }
    }

    @Test
    void programOfAFileIsJudgedWithEachSeed() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS);

        desk.begin("raise-arms", "RaiseArms.java", 2);
        Attempt attempt = desk.awaitEnd();

        assertThat(attempt.state()).isEqualTo(State.OVER);
        assertThat(attempt.judged()).extracting(Attempt.Judged::seed).containsExactly(1L, 2L);
        assertThat(attempt.passed()).as(attempt.toString()).isTrue();
        assertThat(attempt.points()).isEqualTo(10);
    }

    @Test
    void programToBeginWithIsHandedOutOnceAndFailsWithAHint() throws Exception {
        String file = desk.handOut("raise-arms");
        desk.begin("raise-arms", file, 1);
        Attempt attempt = desk.awaitEnd();

        assertThat(desk.programs()).containsExactly("RaiseArms.java");
        assertThat(attempt.passed()).isFalse();
        assertThat(attempt.judged().get(0).hint()).isNotEmpty();
        assertThatThrownBy(() -> desk.handOut("raise-arms"))
                .hasMessage("There is a file RaiseArms.java already, and it is kept. Rename it to start over.");
    }

    @Test
    void programThatEndsItsProcessFailsItsTrialAndNothingElse() throws Exception {
        Files.writeString(
                folder.resolve("RaiseArms.java"),
                RAISE_ARMS.replace("hold(Joint.LEFT_SHOULDER_PITCH, 60);", "System.exit(7);"));

        desk.begin("raise-arms", "RaiseArms.java", 1);
        Attempt attempt = desk.awaitEnd();

        assertThat(attempt.judged().get(0).finding()).startsWith("The program has");
    }

    @Test
    void programWithAMistakeIsShownWithWhatTheCompilerSays() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS.replace("60);", "60)"));

        desk.begin("raise-arms", "RaiseArms.java", 1);
        Attempt attempt = desk.awaitEnd();

        assertThat(attempt.judged().get(0).finding()).isEqualTo("The program ended before it asked for a robot.");
        assertThat(attempt.output()).contains("';' expected");
    }

    @Test
    void agentThatTheStudentStartsIsJudgedTheSameWay() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS);
        desk.begin("raise-arms", "", 1);
        int port = desk.attempt().port();
        try (GuestProcess student =
                GuestProcess.start(Exercises.find("raise-arms").orElseThrow(), "RaiseArms.java", port, folder)) {
            Attempt attempt = desk.awaitEnd();

            assertThat(attempt.passed()).as(attempt + student.output()).isTrue();
        }
    }

    @Test
    void attemptThatIsLeftEndsAtOnce() throws Exception {
        desk.begin("raise-arms", "", 1);

        desk.leave();

        assertThat(desk.attempt()).isEqualTo(Attempt.NONE);
        assertThatThrownBy(() -> desk.begin("nonsense", "", 1))
                .hasMessage("There is no exercise \"nonsense\". Load the page again.");
    }
}
