package org.robonewbie.app.command;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.log.Spelling;
import org.robonewbie.app.course.GradingProcess;
import org.robonewbie.app.program.AgentFinder;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.app.program.ExampleCatalogue;
import org.robonewbie.app.program.StudentJava;
import org.robonewbie.app.program.StudentsAgents;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grader;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Grades a solution of an exercise, lists the exercises, or hands out what to begin with. */
@Command(
        name = StudentJava.COMMAND,
        description = "Grade your solution of an exercise. Without arguments it lists the exercises.",
        footer = {
            "",
            "Examples:",
            "  robonewbie grade                          list the exercises",
            "  robonewbie grade arm-by-side --start      write ArmBySide.java, the program to begin with",
            "  robonewbie grade arm-by-side ArmBySide.java",
            "  robonewbie grade 3 ArmBySide.java --seeds 10 --json grade.json",
            "  robonewbie grade kick Kick.java --watch     and look at the first trial in the studio",
            "  robonewbie grade kick Kick.java --record kick.rec   then: robonewbie studio kick.rec",
            "",
            "Exit code: 0 passed, 1 not yet passed, 2 called wrongly."
        })
final class GradeCommand implements Callable<Integer> {

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

    @Option(names = "--start", description = "Write the program to begin with into the current folder.")
    private boolean start;

    @Option(names = "--seeds", paramLabel = "N", defaultValue = "3", description = "How many trials (default: 3).")
    private int seeds;

    @Option(names = "--json", paramLabel = "FILE", description = "Write the grade as JSON too.")
    private Optional<Path> json = Optional.empty();

    @Option(names = "--record", paramLabel = "FILE", description = "Record the first trial, to be seen in the studio.")
    private Optional<Path> recording = Optional.empty();

    @Option(names = "--watch", description = "Show the first trial in the studio afterwards, as it was judged.")
    private boolean watched;

    @Option(names = "--no-browser", description = "With --watch: print the studio's address and open no browser.")
    private boolean withoutBrowser;

    @Option(
            names = {"-cp", "--class-path"},
            paramLabel = "PATH",
            description = "Folders and jars with your own classes (default: the current folder).")
    private String classPath = "";

    @Option(names = GradingProcess.INSIDE, hidden = true)
    private Optional<Path> inside = Optional.empty();

    @Option(names = StudentJava.AT_DOOR, hidden = true)
    private Optional<Integer> door = Optional.empty();

    @Override
    public Integer call() throws IOException {
        if (exerciseName.isEmpty()) {
            System.out.print(list());
            return ExitCode.OK;
        }
        Exercise exercise = Exercises.find(exerciseName.get()).orElseThrow(() -> unknown(exerciseName.get()));
        if (start) {
            return handOut(exercise);
        }
        String program = solution.orElseThrow(() -> withoutSolution(exercise));
        if (door.isPresent()) {
            agents(program).get().run("--port", door.get().toString(), "--headless", "--team", "Students");
            return ExitCode.OK;
        }
        if (seeds < 1) {
            throw new CalledWronglyException("--seeds " + seeds + ": give a number of trials of at least 1.");
        }
        if (inside.isPresent()) {
            return gradeHere(exercise, program, inside.get());
        }
        if (watched && recording.isEmpty()) {
            recording =
                    Optional.of(Files.createTempDirectory("robonewbie-grade").resolve(exercise.name() + ".rec"));
        }
        GradingProcess process = new GradingProcess(exercise, program, seeds, classPath, recording);
        int exitCode = process.run().map(this::tell).orElseGet(process::exitCode);
        if (watched) {
            recording.filter(Files::isRegularFile).ifPresent(this::show);
        }
        return exitCode;
    }

    /** Opens the studio, which stays until it is ended. */
    private void show(Path file) {
        List<String> words = new ArrayList<>(List.of(StudioCommand.NAME, file.toString(), "--agent-port", "0"));
        if (withoutBrowser) {
            words.add("--no-browser");
        }
        RoboNewbieCommand.run(words.toArray(String[]::new));
    }

    private int tell(Grade grade) {
        System.out.print(grade);
        json.ifPresent(file -> GradingProcess.write(file, grade.json()));
        return grade.passed() ? ExitCode.OK : ExitCode.SOFTWARE;
    }

    /** Does the work within the process that may die of the student's program. */
    private int gradeHere(Exercise exercise, String program, Path result) {
        Supplier<Agent> agents = agents(program);
        GradingProcess.write(result, GradingProcess.STARTED);
        List<Long> all = LongStream.rangeClosed(1, seeds).boxed().toList();
        Grade grade = new Grader().grade(exercise, agents, all, recording);
        GradingProcess.write(result, grade.json());
        Runtime.getRuntime().halt(ExitCode.OK); // the student's threads and hooks have no word in this
        return ExitCode.OK;
    }

    private Supplier<Agent> agents(String program) {
        List<Path> folders = Arrays.stream(classPath.split(File.pathSeparator, -1))
                .map(Path::of)
                .toList();
        return StudentsAgents.of(new AgentFinder(ExampleCatalogue.load(), folders).findClass(program));
    }

    private static int handOut(Exercise exercise) throws IOException {
        Path file = Path.of(exercise.className() + ".java");
        if (Files.exists(file)) {
            throw new CalledWronglyException(
                    "There is a file " + file + " already, and it is kept. Rename it to start over.");
        }
        Files.writeString(file, exercise.startCode());
        System.out.println("Written: " + file + System.lineSeparator() + exercise.goal() + System.lineSeparator()
                + "Change it, watch it with: robonewbie run " + file + System.lineSeparator()
                + "and grade it with: robonewbie grade " + exercise.name() + " " + file);
        return ExitCode.OK;
    }

    private static String list() {
        List<String> lines = new ArrayList<>();
        lines.add("The exercises are:");
        for (Exercise exercise : Exercises.all()) {
            lines.add(String.format("  %-20s %s", exercise.fullName(), exercise.goal()));
        }
        lines.add("Begin with: robonewbie grade raise-arms --start");
        return lines.stream().map(line -> line + System.lineSeparator()).collect(Collectors.joining());
    }

    static CalledWronglyException unknown(String name) {
        List<String> names = Exercises.all().stream().map(Exercise::name).toList();
        String question = Spelling.nearest(name, names)
                .map(nearest -> " Did you mean " + nearest + "?")
                .orElse("");
        return new CalledWronglyException(
                "There is no exercise \"" + name + "\"." + question + " \"robonewbie grade\" lists all exercises.");
    }

    private static CalledWronglyException withoutSolution(Exercise exercise) {
        return new CalledWronglyException("Which program solves " + exercise.name() + "? Write: robonewbie grade "
                + exercise.name() + " " + exercise.className() + ".java" + System.lineSeparator()
                + "There is none yet? This writes the program to begin with: robonewbie grade " + exercise.name()
                + " --start");
    }
}
