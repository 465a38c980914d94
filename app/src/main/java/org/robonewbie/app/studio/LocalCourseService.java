package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressTable;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.progress.ExerciseProgress;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.progress.Worksheet;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.studio.ShownSimulation;
import org.robonewbie.studio.course.Attempt;
import org.robonewbie.studio.course.CourseService;
import org.robonewbie.studio.course.Help;
import org.robonewbie.studio.course.Lesson;
import org.robonewbie.studio.course.Standings;

/** The exercises of the studio. An attempt is shown in place of the free pitch. */
public final class LocalCourseService implements CourseService, AutoCloseable {

    /** Preferred port for students' own agents. */
    static final int DEFAULT_PORT = 3110;

    private static final String JAVA = ".java";

    private final Path folder;
    private final SimulationControl freePitch;
    private final ShownSimulation shown;
    private final ProgressService coach;
    private Optional<CourseAttempt> current = Optional.empty();
    private long attempts;
    private Language language = Language.ENGLISH;

    /**
     * Creates the service.
     *
     * @param folder folder of students' programs
     * @param freePitch simulation that is shown without an attempt
     * @param shown the displayed simulation
     * @param coach stores the progress and opens hints
     */
    public LocalCourseService(Path folder, SimulationControl freePitch, ShownSimulation shown, ProgressService coach) {
        this.folder = folder;
        this.freePitch = freePitch;
        this.shown = shown;
        this.coach = coach;
    }

    /**
     * Sets the language of worksheets and hints; the default is English.
     *
     * @param wanted the language
     */
    public synchronized void speak(Language wanted) {
        language = wanted;
    }

    private synchronized Language spoken() {
        return language;
    }

    @Override
    public String language() {
        return spoken().code();
    }

    @Override
    public void speak(String code) {
        speak(Language.of(code).orElseThrow(() -> new IllegalArgumentException("Unknown language \"" + code + "\".")));
    }

    @Override
    public List<Lesson> lessons() {
        Progress progress = coach.progress();
        Language spoken = spoken();
        return Exercises.all().stream()
                .map(exercise -> lesson(exercise, progress.of(exercise), spoken))
                .toList();
    }

    private static Lesson lesson(Exercise exercise, ExerciseProgress state, Language spoken) {
        return new Lesson(
                exercise.number(),
                exercise.name(),
                Worksheet.of(exercise, spoken).title(),
                spoken.translated(exercise.goal()),
                spoken.translated(exercise.level()),
                exercise.minutes(),
                Score.MOST_POINTS,
                "docs/exercises/" + spoken.worksheet(exercise) + ".html",
                exercise.className() + JAVA,
                new Lesson.Standing(
                        state.tries(),
                        state.bestPoints(),
                        state.passed(),
                        TimeUnit.SECONDS.toMinutes(state.seconds())));
    }

    @Override
    public Standings standings() {
        ProgressTable table = new ProgressTable(coach.progress());
        return new Standings(table.sum(), table.badges(), table.csv(System.getProperty("user.name", "")));
    }

    @Override
    public Help help(String exercise) {
        return help(find(exercise), coach.hints(find(exercise), spoken()));
    }

    @Override
    public Help nextHint(String exercise) {
        return help(find(exercise), coach.nextHint(find(exercise), spoken()));
    }

    private Help help(Exercise exercise, ProgressService.Hints hints) {
        return new Help(hints.open(), hints.all(), coach.offersSolution(exercise), coach.triesBeforeSolution(exercise));
    }

    @Override
    public String solution(String exercise) {
        SolutionRepository.Answer answer = coach.solution(find(exercise));
        if (!answer.open()) {
            throw new IllegalArgumentException(answer.text());
        }
        return answer.text();
    }

    @Override
    public List<String> programs() {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(JAVA))
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            return List.of();
        }
    }

    @Override
    public String handOut(String exercise) throws IOException {
        Exercise found = find(exercise);
        Path file = folder.resolve(found.className() + JAVA);
        if (Files.exists(file)) {
            throw new IllegalArgumentException(
                    "The file " + file.getFileName() + " already exists and is kept. Rename it to start over.");
        }
        AtomicFile.write(file, found.startCode());
        coach.begun(found);
        return String.valueOf(file.getFileName());
    }

    @Override
    public synchronized void begin(String exercise, String program, int trials) throws IOException {
        Exercise found = find(exercise);
        current.ifPresent(CourseAttempt::close);
        attempts++;
        current = Optional.of(CourseAttempt.begin(
                attempts,
                found,
                program,
                trials,
                folder,
                shown::show,
                result -> coach.graded(found, result.points(), result.passed(), spoken())));
    }

    @Override
    public synchronized void leave() {
        current.ifPresent(CourseAttempt::close);
        current = Optional.empty();
        shown.show(freePitch);
    }

    @Override
    public synchronized Attempt attempt() {
        return current.map(CourseAttempt::state).orElse(Attempt.NONE).inWords(language::translated);
    }

    /** Waits until the current attempt has ended. */
    Attempt awaitEnd() throws InterruptedException {
        CourseAttempt attempt = now().orElseThrow();
        attempt.awaitEnd();
        return attempt.state();
    }

    private synchronized Optional<CourseAttempt> now() {
        return current;
    }

    @Override
    public synchronized void close() {
        current.ifPresent(CourseAttempt::close);
    }

    private static Exercise find(String name) {
        return Exercises.find(name)
                .orElseThrow(() -> new IllegalArgumentException(
                        "There is no exercise named \"" + name + "\". Load the page again."));
    }
}
