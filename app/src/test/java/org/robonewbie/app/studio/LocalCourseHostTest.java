package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Project;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.progress.LocalProgress;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.service.CourseService;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.JavaCommand;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.ProgramOutput;
import org.robonewbie.studio.ShownSimulation;
import org.robonewbie.trial.watch.WatchedTrial;

/** The exercises as requested by the studio's page, with students' programs in separate processes. */
@Timeout(300)
class LocalCourseHostTest {

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

    private Optional<CourseAttempt> begun = Optional.empty();
    private CourseService service = service(Path.of(""));

    @BeforeEach
    void open() {
        service = service(folder);
    }

    private CourseService service(Path place) {
        Optional<ProgressFile> progress = Optional.of(new ProgressFile(place.resolve("progress.json")));
        return new CourseService(
                new ProgressService(new LocalProgress(progress), SolutionRepository.ofUser(Optional.of(Project.ROOT))),
                new LocalCourseHost(place, freePitch, shown) {

                    @Override
                    public CourseAttempt begin(
                            Exercise exercise, long id, String program, int trials, Consumer<Grade> judged)
                            throws IOException {
                        CourseAttempt attempt = super.begin(exercise, id, program, trials, judged);
                        begun = Optional.of(attempt);
                        return attempt;
                    }
                },
                "Ann");
    }

    @AfterEach
    void close() {
        service.close();
    }

    private String ask(String method, String... path) throws IOException {
        return service.answer(method, List.of(path), name -> "");
    }

    private JsonObject overview() throws IOException {
        return JsonParser.parseString(ask("GET")).getAsJsonObject();
    }

    private JsonObject help(String method, String wish) throws IOException {
        return JsonParser.parseString(ask(method, "raise-arms", wish)).getAsJsonObject();
    }

    private JsonObject begin(String exercise, String program, int trials) throws IOException {
        Map<String, String> parameters = Map.of("program", program, "trials", Integer.toString(trials));
        return JsonParser.parseString(service.answer("POST", List.of(exercise), parameters::get))
                .getAsJsonObject();
    }

    /** The attempt after its last trial. */
    private JsonObject end() throws IOException, InterruptedException {
        begun.orElseThrow().awaitEnd();
        return JsonParser.parseString(ask("GET", "attempt")).getAsJsonObject();
    }

    private static JsonObject trial(JsonObject attempt, int index) {
        return attempt.getAsJsonArray("judged").get(index).getAsJsonObject();
    }

    @Test
    void lessonsMatchTheirWorksheets() throws Exception {
        for (JsonElement each : overview().getAsJsonArray("lessons")) {
            JsonObject lesson = each.getAsJsonObject();
            String sheet = Files.readString(
                    Project.ROOT.resolve(lesson.get("worksheet").getAsString().replace(".html", ".md")));

            assertThat(sheet)
                    .contains("# Exercise " + lesson.get("number") + ": "
                            + lesson.get("title").getAsString() + "\n");
        }
    }

    @Tag("slow")
    @Test
    void programOfAFileIsJudgedWithEachSeed() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS);

        begin("raise-arms", "RaiseArms.java", 2);
        JsonObject attempt = end();

        assertThat(attempt.get("state").getAsString()).isEqualTo("OVER");
        assertThat(trial(attempt, 0).get("seed").getAsInt()).isEqualTo(1);
        assertThat(trial(attempt, 1).get("seed").getAsInt()).isEqualTo(2);
        assertThat(attempt.get("passed").getAsBoolean()).as(attempt.toString()).isTrue();
        assertThat(attempt.get("points").getAsDouble()).isEqualTo(10);
        assertThat(overview().getAsJsonArray("lessons"))
                .extracting(lesson -> lesson.getAsJsonObject().get("standing").toString())
                .startsWith(
                        "{\"tries\":1,\"best\":10.0,\"passed\":true,\"minutes\":0}",
                        "{\"tries\":0,\"best\":0.0,\"passed\":false,\"minutes\":0}");
        JsonObject standings = overview().getAsJsonObject("standings");
        assertThat(standings.get("sum").getAsString()).startsWith("1 of ").contains(", 10.0 of ");
        assertThat(standings.get("csv").getAsString()).contains("Ann,01-raise-arms,yes,10.0,1,0,0,no,");
    }

    @Test
    void hintsOpenOneByOneAndTheSolutionIsLockedForThreeTries() throws Exception {
        assertThat(help("GET", "help").get("allHints").getAsInt()).isPositive();
        assertThat(help("GET", "help").getAsJsonArray("hints")).isEmpty();
        assertThat(help("POST", "hint").getAsJsonArray("hints")).hasSize(1);
        assertThat(help("GET", "help").get("triesLeft").getAsInt()).isEqualTo(3);
        assertThatThrownBy(() -> help("POST", "solution")).hasMessageContaining("after 3 graded attempts: 3 more");
    }

    @Tag("slow")
    @Test
    void starterProgramIsWrittenOnceAndFailsWithAHint() throws Exception {
        assertThat(ask("PUT", "raise-arms")).isEqualTo("\"RaiseArms.java\"");
        begin("raise-arms", "RaiseArms.java", 1);
        JsonObject attempt = end();

        assertThat(overview().get("programs").toString()).isEqualTo("[\"RaiseArms.java\"]");
        assertThat(attempt.get("passed").getAsBoolean()).isFalse();
        assertThat(trial(attempt, 0).get("hint").getAsString()).isNotEmpty();
        assertThatThrownBy(() -> ask("PUT", "raise-arms"))
                .hasMessage("The file RaiseArms.java already exists and is kept. Rename it to start over.");
    }

    @Tag("slow")
    @Test
    void programThatExitsFailsOnlyItsTrial() throws Exception {
        Files.writeString(
                folder.resolve("RaiseArms.java"),
                RAISE_ARMS.replace("hold(Joint.LEFT_SHOULDER_PITCH, 60);", "System.exit(7);"));

        begin("raise-arms", "RaiseArms.java", 1);

        assertThat(trial(end(), 0).get("finding").getAsString())
                .startsWith("The program ended the whole process (exit code 7)");
    }

    @Test
    void programWithAnErrorIsShownWithTheDiagnostics() throws Exception {
        Files.writeString(folder.resolve("RaiseArms.java"), RAISE_ARMS.replace("60);", "60)"));

        begin("raise-arms", "RaiseArms.java", 1);
        JsonObject attempt = end();

        assertThat(trial(attempt, 0).get("finding").getAsString())
                .isEqualTo("The program ended before it asked for a robot.");
        assertThat(attempt.get("output").getAsString()).contains("';' expected");
    }

    @Tag("slow")
    @Test
    void agentThatTheStudentStartsIsJudgedTheSameWay() throws Exception {
        int port = begin("raise-arms", "", 1).get("port").getAsInt();
        Files.writeString(
                folder.resolve("RaiseArms.java"), RAISE_ARMS.replace("    @Override", MAIN + "    @Override"));
        try (ChildProcess student = ChildProcess.start(
                JavaCommand.ofCommand(List.of(
                        "run", "RaiseArms.java", "--port", Integer.toString(port), "--headless", "--team", "Students")),
                folder,
                false,
                ProgramOutput.of(line -> {}, answer -> {}),
                Limits.NONE)) {
            JsonObject attempt = end();

            assertThat(attempt.get("passed").getAsBoolean())
                    .as(attempt + student.output().end())
                    .isTrue();
        }
    }

    @Test
    void attemptThatIsLeftEndsAtOnce() throws Exception {
        begin("raise-arms", "", 1);

        assertThat(ask("DELETE", "attempt")).contains("\"state\":\"NONE\"");
        assertThatThrownBy(() -> begin("nonsense", "", 1))
                .hasMessage("There is no exercise named \"nonsense\". Reload the page.");
    }
}
