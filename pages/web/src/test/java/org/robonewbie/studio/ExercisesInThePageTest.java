package org.robonewbie.studio;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.progress.Badge;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.web.Solutions;

/** Exercises in the static page: compiled and judged in the browser, with the same results as on the command line. */
@InBrowser
@Timeout(600)
class ExercisesInThePageTest {

    private static final String SHOWN = "document.querySelector('#program-room').innerText";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private StaticServer server;

    ExercisesInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void serve() throws IOException {
        server = new StaticServer(folder, Path.of("target", "web").toAbsolutePath());
    }

    @AfterEach
    void end() {
        server.close();
    }

    static List<Exercise> exercises() {
        return Exercises.all();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void solutionEarnsTheSameInThePageAndOnTheCommandLine(Exercise exercise) {
        assertSameVerdicts(exercise, List.of(1L));
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("exercises")
    void solutionEarnsTheSameWithMoreSeeds(Exercise exercise) {
        assertSameVerdicts(exercise, List.of(1L, 2L, 3L));
    }

    private void assertSameVerdicts(Exercise exercise, List<Long> seeds) {
        String text = Solutions.text(exercise);
        browser.visit(server.address() + "webassembly-loader.js");
        browser.evaluate(COMPILE + "compile(" + Chromium.quoted(exercise.fileName()) + ", " + Chromium.quoted(text)
                + ").then((classes) => { window.classes = classes; })");

        JsonArray judged = browser.evaluate(
                        JUDGE + "judge(" + Chromium.quoted(exercise.name()) + ", " + seeds.size() + ")")
                .getAsJsonArray();

        assertThat(judged)
                .extracting(JsonElement::getAsJsonObject)
                .extracting(trial -> new Score(
                        trial.get("passed").getAsBoolean(),
                        trial.get("points").getAsInt(),
                        trial.get("finding").getAsString(),
                        trial.get("hint").getAsString()))
                .containsExactlyElementsOf(
                        Solutions.judged(exercise, JavaSource.compile(exercise.className(), text), seeds));
    }

    private static final String COMPILE = """
            window.compile = (path, text) => new Promise((done, fail) => {
              const worker = new Worker('compiler-worker.js', { type: 'module' });
              worker.onmessage = ({ data }) => {
                worker.terminate();
                data.classes?.length ? done(data.classes) : fail(new Error(data.failure ?? data.remarks.join()));
              };
              worker.postMessage({ id: 1, sources: [[path, text]] });
            });
            """;
    private static final String JUDGE = """
            window.judge = (exercise, trials) => new Promise((done, fail) => {
              const worker = new Worker('world-worker.js', { type: 'module', name: 'programs' });
              const request = (method, path) => JSON.stringify({
                method, path, language: 'en', parameters: { program: 'a', trials: String(trials) },
                progress: {}, programs: [], drafts: [], solutions: {},
              });
              worker.onmessage = ({ data }) => {
                const attempt = 'result' in data ? JSON.parse(data.result) : { state: 'NONE' };
                if (attempt.state === 'OVER' || 'failure' in data) {
                  worker.terminate();
                  'failure' in data ? fail(new Error(data.failure)) : done(attempt.judged);
                } else if ('run' in data) {
                  worker.postMessage({ call: { id: 2, name: 'answer', args: ['course', request('GET', ['attempt'])] } });
                }
              };
              worker.postMessage({ exercise: { id: 1, request: request('POST', [exercise]), classes: window.classes } });
              worker.postMessage({ ask: { do: 'speed', factor: 'fastest' } });
            });
            """;

    @Test
    void firstExerciseIsSolvedInTheRoomForPrograms() {
        Exercise first = Exercises.all().get(0);
        open("#program/" + first.name());
        browser.await("studio.rooms.program.files.file?.path === '" + first.fileName() + "'");
        assertThat(browser.evaluate("studio.rooms.program.editor.text").getAsString())
                .isEqualTo(first.startCode());

        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(Solutions.text(first)) + ")");
        browser.fill("#speed", "fastest");
        browser.click("#program-check");
        browser.await(SHOWN + ".includes('Passed: 10.0 of 10 points')");
        browser.click("#program-leave");
        browser.await("studio.state.scene.robots.length === 0 && studio.state.frame.cycle > 10");

        JsonObject course = browser.evaluate("fetch('api/course').then((answer) => answer.json())")
                .getAsJsonObject();
        assertThat(course.getAsJsonArray("lessons")
                        .get(0)
                        .getAsJsonObject()
                        .getAsJsonObject("standing")
                        .get("passed")
                        .getAsBoolean())
                .isTrue();
        JsonObject standings = course.getAsJsonObject("standings");
        assertThat(standings.getAsJsonArray("badges"))
                .extracting(JsonElement::getAsString)
                .containsExactly(Badge.FIRST_SUCCESS.title());
        assertThat(standings.get("csv").getAsString().lines())
                .hasSize(1 + exercises().size())
                .startsWith("name,exercise,passed,best points,tries,minutes,hints,solution seen,last")
                .anyMatch(line -> line.startsWith("," + first.fullName() + ",yes,10.0,1,"));
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void badgesAreThoseOfTheCommandLine() {
        open("");
        browser.evaluate(
                "localStorage.setItem(new URL('.', location.href).pathname + 'robonewbie-page-progress', JSON.stringify(Object.fromEntries("
                        + "["
                        + exercises().stream()
                                .map(each -> Chromium.quoted(each.name()))
                                .collect(joining(","))
                        + "].map((name) => [name, { tries: 10, best: 10, passed: true, milliseconds: 0, hints: 0, seenAt: 0 }]))))");

        assertThat(browser.evaluate(
                                "fetch('api/course').then((answer) => answer.json()).then(({ standings }) => standings.badges)")
                        .getAsJsonArray())
                .extracting(JsonElement::getAsString)
                .containsExactlyElementsOf(
                        Stream.of(Badge.values()).map(Badge::title).toList());
    }

    @Test
    void solutionOfATeacherIsShownAfterThreeTries() throws IOException {
        Exercise first = Exercises.all().get(0);
        open("#field/exercises");
        assertThat(help(first)).contains("\"solution\":false");
        Path solutions = Files.createDirectory(folder.resolve("solutions"));
        String ofTheTeachersZip = Files.readString(Path.of("../../app/src/bundle/locked.txt"));
        Files.writeString(solutions.resolve("locked.txt"), ofTheTeachersZip + "kick\n");
        Files.writeString(
                solutions.resolve(first.fileName()),
                "package org.robonewbie.exercises.solution;\n\n" + Solutions.text(first));

        assertThat(help(first)).contains("\"solution\":true", "\"triesLeft\":3");
        browser.evaluate(
                "localStorage.setItem(new URL('.', location.href).pathname + 'robonewbie-page-progress', JSON.stringify({ "
                        + Chromium.quoted(first.name())
                        + ": { tries: 3, best: 4, passed: false, milliseconds: 0, hints: 0, seenAt: 0 } }))");
        browser.clickElement("document.querySelector('#course [data-exercise=\"" + first.name() + "\"]')");
        browser.await("document.querySelector('#course-show-solution').innerText === 'Show me a solution'");
        browser.click("#course-show-solution");

        browser.await("document.querySelector('#course-solution').innerText.startsWith("
                + Chromium.quoted(Solutions.text(first).strip().substring(0, 20)) + ")");
        Files.writeString(solutions.resolve("locked.txt"), first.number() + "\n");
        assertThat(help(first)).contains("\"solution\":false");
    }

    private String help(Exercise exercise) {
        return browser.evaluate("fetch('api/course/" + exercise.name() + "/help').then((answer) => answer.text())")
                .getAsString();
    }

    @Test
    void starterProgramGetsAHint() {
        open("#program/stop-at-30");
        browser.await("studio.rooms.program.files.file?.path === 'StopAt30.java'");
        browser.fill("#speed", "fastest");
        browser.click("#program-check");

        browser.await(SHOWN + ".includes('Not yet passed')");
        browser.await(SHOWN + ".includes('Hint: ')");
    }

    @Test
    void verdictIsTranslatedToGerman() {
        open("#program/stop-at-30");
        browser.await("studio.rooms.program.files.file?.path === 'StopAt30.java'");
        browser.evaluate("fetch('api/course/language?code=de', { method: 'POST' }).then(() => true)");
        browser.fill("#speed", "fastest");
        browser.click("#program-check");
        browser.await(SHOWN + ".includes('Not yet passed')");

        Exercise exercise = Exercises.find("stop-at-30").orElseThrow();
        Score here = Solutions.judged(
                        exercise, JavaSource.compile(exercise.className(), exercise.startCode()), List.of(1L))
                .get(0)
                .in(Language.GERMAN);
        assertThat(browser.evaluate(SHOWN).getAsString()).contains(here.finding(), here.hint());
    }

    @Test
    void allExercisesAreListedWithTheirWorksheets() {
        open("#field/exercises");
        browser.await("document.querySelectorAll('#course [data-exercise]').length === "
                + exercises().size());

        assertThat(browser.evaluate("fetch('api/course').then((answer) => answer.json())"
                                + ".then(({ lessons }) => Promise.all(lessons.map(({ worksheet }) => fetch(worksheet))))"
                                + ".then((answers) => answers.every((answer) => answer.ok))")
                        .getAsBoolean())
                .isTrue();
    }

    @Test
    void programThatDoesNotCompileIsNotTried() {
        open("#program/raise-arms");
        browser.await("studio.rooms.program.files.file?.path === 'RaiseArms.java'");
        browser.evaluate("studio.rooms.program.editor.replace('public class RaiseArms {')");
        browser.click("#program-check");

        browser.await("document.querySelector('#toast').innerText.includes('RaiseArms.java does not compile')");
    }

    private void open(String place) {
        browser.visit(server.address() + place);
        browser.await("studio.state.frame?.cycle > 0");
    }
}
