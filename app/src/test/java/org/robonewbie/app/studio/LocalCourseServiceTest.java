package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Project;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.JavaCommand;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.ProgramOutput;
import org.robonewbie.studio.ShownSimulation;
import org.robonewbie.studio.course.Attempt;
import org.robonewbie.studio.course.Attempt.State;
import org.robonewbie.studio.course.Lesson;
import org.robonewbie.trial.watch.WatchedTrial;

/** The exercises as requested by the studio's page, with students' programs in separate processes. */
@Timeout(300)
class LocalCourseServiceTest {

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

    private static final String MAIN =
            "    public static void main(String[] arguments) {\n        new RaiseArms().run(arguments);\n    }\n\n";

    @TempDir
    private Path folder;

    private final WatchedTrial freePitch = new WatchedTrial();
    private final ShownSimulation shown = new ShownSimulation(freePitch);

    private LocalCourseService service = service(Path.of(""));

    @BeforeEach
    void open() {
        service = service(folder);
    }

    private LocalCourseService service(Path place) {
        Optional<ProgressFile> progress = Optional.of(new ProgressFile(place.resolve("progress.json")));
        return new LocalCourseService(
                place,
                freePitch,
                shown,
                new ProgressService(progress, SolutionRepository.ofUser(Optional.of(Project.ROOT)), Clock.systemUTC()));
    }

    @AfterEach
    void close() {
        service.close();
    }

    @Test
    void lessonsMatchTheirWorksheets() throws Exception {
        for (Lesson lesson : service.lessons()) {
            String sheet =
                    Files.readString(Project.ROOT.resolve(lesson.worksheet().replace(".html", ".md")));

            assertThat(sheet)
                    .contains("# Exercise " + lesson.number() + ": " + lesson.title() + "\n")
                    .contains("about " + lesson.minutes() + " minutes");
        }
    }

    @Tag("slow")
    @Test
    void programOfAFileIsJudgedWithEachSeed() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS);

        service.begin("raise-arms", "RaiseArms.java", 2);
        Attempt attempt = service.awaitEnd();

        assertThat(attempt.state()).isEqualTo(State.OVER);
        assertThat(attempt.judged()).extracting(Attempt.Judged::seed).containsExactly(1L, 2L);
        assertThat(attempt.passed()).as(attempt.toString()).isTrue();
        assertThat(attempt.points()).isEqualTo(10);
        assertThat(service.lessons().get(0).standing()).isEqualTo(new Lesson.Standing(1, 10, true, 0));
        assertThat(service.lessons().get(1).standing()).isEqualTo(Lesson.Standing.NONE);
        assertThat(service.standings().sum()).startsWith("1 of ").contains(", 10.0 of ");
    }

    @Test
    void hintsOpenOneByOneAndTheSolutionIsLockedForThreeTries() {
        int all = service.help("raise-arms").allHints();

        assertThat(all).isPositive();
        assertThat(service.help("raise-arms").hints()).isEmpty();
        assertThat(service.nextHint("raise-arms").hints()).hasSize(1);
        assertThat(service.help("raise-arms").triesLeft()).isEqualTo(3);
        assertThatThrownBy(() -> service.solution("raise-arms")).hasMessageContaining("after 3 graded tries: 3 more");
    }

    @Test
    void starterProgramIsWrittenOnceAndFailsWithAHint() throws Exception {
        String file = service.handOut("raise-arms");
        service.begin("raise-arms", file, 1);
        Attempt attempt = service.awaitEnd();

        assertThat(service.programs()).containsExactly("RaiseArms.java");
        assertThat(attempt.passed()).isFalse();
        assertThat(attempt.judged().get(0).hint()).isNotEmpty();
        assertThatThrownBy(() -> service.handOut("raise-arms"))
                .hasMessage("The file RaiseArms.java already exists and is kept. Rename it to start over.");
    }

    @Test
    void programThatExitsFailsOnlyItsTrial() throws Exception {
        Files.writeString(
                folder.resolve("RaiseArms.java"),
                RAISE_ARMS.replace("hold(Joint.LEFT_SHOULDER_PITCH, 60);", "System.exit(7);"));

        service.begin("raise-arms", "RaiseArms.java", 1);
        Attempt attempt = service.awaitEnd();

        assertThat(attempt.judged().get(0).finding()).startsWith("The program ended the whole process (exit code 7)");
    }

    @Test
    void programWithAnErrorIsShownWithTheDiagnostics() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS.replace("60);", "60)"));

        service.begin("raise-arms", "RaiseArms.java", 1);
        Attempt attempt = service.awaitEnd();

        assertThat(attempt.judged().get(0).finding()).isEqualTo("The program ended before it asked for a robot.");
        assertThat(attempt.output()).contains("';' expected");
    }

    @Tag("slow")
    @Test
    void agentThatTheStudentStartsIsJudgedTheSameWay() throws Exception {
        service.begin("raise-arms", "", 1);
        int port = service.attempt().port();
        Files.writeString(
                folder.resolve("RaiseArms.java"), RAISE_ARMS.replace("    @Override", MAIN + "    @Override"));
        try (ChildProcess student = ChildProcess.start(
                JavaCommand.ofCommand(List.of(
                        "run", "RaiseArms.java", "--port", Integer.toString(port), "--headless", "--team", "Students")),
                folder,
                false,
                ProgramOutput.of(line -> {}, answer -> {}),
                Limits.NONE)) {
            Attempt attempt = service.awaitEnd();

            assertThat(attempt.passed()).as(attempt + student.output().end()).isTrue();
        }
    }

    @Test
    void attemptThatIsLeftEndsAtOnce() throws Exception {
        service.begin("raise-arms", "", 1);

        service.leave();

        assertThat(service.attempt()).isEqualTo(Attempt.NONE);
        assertThatThrownBy(() -> service.begin("nonsense", "", 1))
                .hasMessage("There is no exercise named \"nonsense\". Load the page again.");
    }
}
