package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.grading.ProcessGrader;
import org.robonewbie.exercises.marking.ClassMarking;
import org.robonewbie.exercises.progress.ExerciseProgress;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressTable;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.trial.batch.BatchProgress;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Grades solutions of exercises, lists the exercises, and writes starter code. */
@Command(
        name = "grade",
        description = "Grade your solution to an exercise. Without arguments, list the exercises.",
        footer = {
            "",
            "Examples:",
            "  robonewbie grade                          list the exercises",
            "  robonewbie grade arm-by-side --start      write the starter code ArmBySide.java",
            "  robonewbie grade arm-by-side ArmBySide.java",
            "  robonewbie grade 3 ArmBySide.java --seeds 10 --json grade.json",
            "  robonewbie grade kick Kick.java --watch     grade it, and show the first trial in the studio",
            "  robonewbie grade kick Kick.java --language de   findings and hints in German",
            "  robonewbie grade kick Kick.java --record kick.rec   then: robonewbie studio kick.rec",
            "  robonewbie grade kick --hint              reveal the next hint",
            "  robonewbie grade kick --solution          show a solution, after three attempts",
            "  robonewbie grade --progress               passed, best points, attempts, working time, badges",
            "  robonewbie grade --progress --csv anna.csv --name Anna   the table for your teacher",
            "  robonewbie grade --progress anna.json ben.json   the progress of a team",
            "  robonewbie grade --class submissions      grade a class: one folder for each student",
            "  robonewbie grade kick --class submissions --seeds 10   only this exercise",
            "  robonewbie grade --class Anna.robonewbie links.txt     files and links that pupils have sent",
            "",
            "Exit code: 0 passed, 1 not yet passed, 2 called incorrectly."
        })
final class GradeCommand implements Callable<Integer> {

    private static final char TICK = '✓';

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            index = "0",
            arity = "0..1",
            paramLabel = "EXERCISE",
            description = "Name or number of the exercise, such as kick or 12.")
    private Optional<String> exerciseName = Optional.empty();

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "CLASS|FILE.java",
            description = "Your solution: a .java file, or the name of a class that extends Agent.")
    private Optional<String> solution = Optional.empty();

    @Option(names = "--start", description = "Write the starter code into the current folder.")
    private boolean start;

    @Option(names = "--hint", description = "Show the hints revealed so far, and reveal the next one.")
    private boolean hint;

    @Option(
            names = "--solution",
            description =
                    "Show a solution, after three graded attempts, if solutions are installed and your teacher has not"
                            + " locked this one (" + SolutionRepository.SWITCH + ").")
    private boolean solutionWanted;

    @Option(names = "--seeds", paramLabel = "N", defaultValue = "3", description = "Number of trials (default: 3).")
    private int seeds;

    @Option(names = "--json", paramLabel = "FILE", description = "Also write the grade as JSON.")
    private Optional<Path> json = Optional.empty();

    @Option(names = "--record", paramLabel = "FILE", description = "Record the first trial for the studio.")
    private Optional<Path> recording = Optional.empty();

    @Option(names = "--watch", description = "Show the recording of the first trial in the studio.")
    private boolean watched;

    @Option(names = "--no-browser", description = "With --watch: print the studio's address without opening a browser.")
    private boolean withoutBrowser;

    @Option(
            names = "--class",
            paramLabel = "FOLDER|FILE",
            arity = "1..*",
            description = "Grade all programs of a class into one table: a folder with one folder per student, files"
                    + " that students of the web edition have sent, and text files with links from there. Run the"
                    + " command again to resume, or to grade changed programs.")
    private List<Path> classSources = List.of();

    @Option(
            names = "--results",
            paramLabel = "FOLDER",
            description = "With --class: folder for the table and stored grades (default: FOLDER-grades, for"
                    + " several files class-grades).")
    private Optional<Path> results = Optional.empty();

    @Mixin
    private final LanguageOption language = new LanguageOption();

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Mixin
    private final FenceOption fence = new FenceOption();

    @Mixin
    private final ProgressOption progress = new ProgressOption();

    @Override
    public Integer call() throws IOException {
        if (seeds < 1) {
            throw new CalledWronglyException("--seeds must be at least 1, not " + seeds + ".");
        }
        if (progress.isGiven()) {
            return progress.show();
        }
        if (!classSources.isEmpty()) {
            return gradeClass();
        }
        if (exerciseName.isEmpty()) {
            System.out.print(ProgramName.here()
                    .in(list(language.language(), ProgressService.ofUser().progress())));
            return ExitCode.OK;
        }
        Exercise exercise = exercise(exerciseName.get());
        if (start) {
            return writeStartCode(exercise);
        }
        if (hint || solutionWanted) {
            return hint ? revealHint(exercise) : showSolution(exercise);
        }
        String program = solution.orElseThrow(() -> withoutSolution(exercise));
        if (watched && recording.isEmpty()) {
            recording = Optional.of(TemporaryFiles.folder("robonewbie-grade").resolve(exercise.name() + ".rec"));
        }
        language.language(); // rejects an unknown language before the trials
        ProcessGrader.Result result = grade(exercise, program);
        int exitCode =
                result.grade().isPresent() ? report(exercise, result.grade().get()) : result.exitCode();
        if (watched) {
            recording.filter(Files::isRegularFile).ifPresent(this::show);
        }
        return exitCode;
    }

    private ProcessGrader.Result grade(Exercise exercise, String program) throws IOException {
        Path folder = Path.of("").toAbsolutePath();
        try (BatchProgress bar = BatchProgress.of("trials", seeds, 0)) {
            return new ProcessGrader(
                            seeds,
                            Runtime.getRuntime().availableProcessors(),
                            sandbox(),
                            recording,
                            line -> bar.print(System.err::println, line))
                    .grade(
                            exercise,
                            new RobotProcess.Request(program, classPath.folders(), folder, false),
                            (seed, score) -> bar.advance(!score.passed()));
        }
    }

    private Sandbox sandbox() {
        Sandbox sandbox = fence.sandbox();
        if (!sandbox.isUp()) {
            System.err.println("Programs run without a sandbox (" + sandbox.absence() + ").");
        }
        return sandbox;
    }

    private int gradeClass() throws IOException {
        if (solution.isPresent()) {
            throw new CalledWronglyException("\"" + solution.get() + "\" is unexpected: --class grades the programs in "
                    + classSources.get(0) + ".");
        }
        List<Exercise> wanted =
                exerciseName.map(name -> List.of(exercise(name))).orElseGet(Exercises::all);
        Path target = results.orElseGet(() -> {
            Path first = classSources.get(0).toAbsolutePath().normalize();
            return first.resolveSibling((classSources.size() == 1 ? first.getFileName() : "class") + "-grades");
        });
        Path page =
                new ClassMarking(classSources, wanted, seeds, target, version(), sandbox(), System.out::println).run();
        System.out.println("Wrote the table " + page + ", and grades.csv next to it.");
        return ExitCode.OK;
    }

    /** Returns the modification time of the grader's jar, which identifies its version. */
    private static String version() throws IOException {
        Optional<Path> jar = ClassPath.ownJar();
        return jar.isPresent() ? Files.getLastModifiedTime(jar.get()).toString() : "not packaged";
    }

    private static Exercise exercise(String name) {
        return Exercises.find(name).orElseThrow(() -> unknown(name));
    }

    /** Runs the studio until it is closed. */
    private void show(Path file) {
        List<String> words = new ArrayList<>(List.of(StudioCommand.NAME, file.toString(), "--agent-port", "0"));
        if (withoutBrowser) {
            words.add("--no-browser");
        }
        RoboNewbieCommand.run(words.toArray(String[]::new));
    }

    private int revealHint(Exercise exercise) {
        Language spoken = language.language();
        ProgressService.Hints hints = ProgressService.ofUser().nextHint(exercise, spoken);
        for (int i = 0; i < hints.open().size(); i++) {
            String number = spoken.translated("Hint " + (i + 1) + " of " + hints.all());
            System.out.println(number + ": " + hints.open().get(i));
        }
        if (hints.all() == 0) {
            System.out.println(spoken.translated("There are no hints for " + exercise.name() + "."));
        }
        return ExitCode.OK;
    }

    private static int showSolution(Exercise exercise) {
        SolutionRepository.Answer answer = ProgressService.ofUser().solution(exercise);
        (answer.open() ? System.out : System.err).println(answer.text().stripTrailing());
        return answer.open() ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    private int report(Exercise exercise, Grade grade) throws IOException {
        Language spoken = language.language();
        System.out.print(grade.text(spoken));
        ProgressService.ofUser().graded(exercise, grade.points(), grade.passed(), spoken).stream()
                .map(ProgramName.here()::in)
                .forEach(System.out::println);
        if (json.isPresent()) {
            AtomicFile.write(json.get(), grade.json());
        }
        return grade.passed() ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    private int writeStartCode(Exercise exercise) throws IOException {
        Path file = Path.of(exercise.fileName());
        if (Files.exists(file)) {
            throw new CalledWronglyException("The file " + file + " already exists. Rename it to start over.");
        }
        Files.writeString(file, exercise.startCode());
        ProgressService.ofUser().begun(exercise);
        System.out.println(ProgramName.here()
                .in("Written: " + file + System.lineSeparator()
                        + language.language().translated(exercise.goal()) + System.lineSeparator()
                        + "Edit it, then grade it to see the trial, your points and a hint:"
                        + System.lineSeparator() + "robonewbie grade " + exercise.name() + " " + file + " --watch"));
        return ExitCode.OK;
    }

    private static String list(Language spoken, Progress progress) {
        List<String> lines = new ArrayList<>();
        lines.add("The exercises" + (progress.exercises().isEmpty() ? ":" : ", with your best points:"));
        for (Exercise exercise : Exercises.all()) {
            lines.add(String.format(
                    Locale.ROOT,
                    "%s %-20s %s",
                    points(progress.of(exercise)),
                    exercise.fullName(),
                    spoken.translated(exercise.goal())));
        }
        lines.add(
                progress.exercises().isEmpty()
                        ? "Begin with: robonewbie grade raise-arms --start"
                        : new ProgressTable(progress).sum() + ". More: robonewbie grade --progress");
        return lines.stream().map(line -> line + System.lineSeparator()).collect(Collectors.joining());
    }

    /** Returns a tick if the exercise is passed, and the best score; before the first attempt, spaces of the same width. */
    private static String points(ExerciseProgress state) {
        if (state.tries() == 0) {
            return "      ";
        }
        boolean ticks = Charset.defaultCharset().newEncoder().canEncode(TICK);
        String tick = state.passed() ? String.valueOf(ticks ? TICK : '+') : " ";
        return String.format(Locale.ROOT, "%s %4.1f", tick, state.bestPoints());
    }

    static CalledWronglyException unknown(String name) {
        List<String> names = Exercises.all().stream().map(Exercise::name).toList();
        return new CalledWronglyException("There is no exercise \"" + name + "\"." + Spelling.question(name, names)
                + " \"robonewbie grade\" lists all exercises.");
    }

    private static CalledWronglyException withoutSolution(Exercise exercise) {
        return new CalledWronglyException("Name the program to grade, for example: robonewbie grade " + exercise.name()
                + " " + exercise.fileName() + System.lineSeparator()
                + "To write the starter code first: robonewbie grade " + exercise.name()
                + " --start");
    }
}
