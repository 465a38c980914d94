package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.service.CourseService;
import org.robonewbie.programs.ExampleSources;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.HostProgram;
import org.robonewbie.studio.FullStudio;
import org.robonewbie.studio.ShownSimulation;
import org.robonewbie.studio.StudioServer;
import org.robonewbie.studio.StudioViewer;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.program.FirstProgram;
import org.robonewbie.studio.service.PageService;

/** The studio with exercises and with the programs in a folder of this computer. */
public final class LocalStudio implements FullStudio {

    private static final String ENDING = ".java";
    private static final int MAX_DEPTH = 12;

    /** The program that this process was started to run, followed by its options; empty if its class was started directly. */
    private static volatile List<String> started = List.of();

    /** Creates the provider. */
    public LocalStudio() {}

    /**
     * Sets the program that this process runs and that its studio opens.
     *
     * @param program a Java file, a class or an example
     * @param options its options for the robot
     */
    public static void setProgram(String program, List<String> options) {
        started = Stream.concat(Stream.of(program), options.stream()).toList();
    }

    @Override
    public StudioServer open(SimulationControl simulation, int port, HostProgram program) throws IOException {
        String name = started.isEmpty() ? program.name() : started.get(0);
        List<String> options =
                started.isEmpty() ? List.of("--robot", program.robot()) : started.subList(1, started.size());
        OpenedFile opened = OpenedFile.of(Optional.of(name)
                .filter(given -> given.endsWith(ENDING))
                .map(Path::of)
                .or(() -> sourceOf(name)));
        Optional<FirstProgram> first = opened.program()
                .map(path -> new FirstProgram(path, "", program))
                .or(() -> copyOf(name, opened.programs()).map(path -> new FirstProgram(path, name, program)));
        Language language = Optional.ofNullable(System.getenv(Language.VARIABLE))
                .flatMap(Language::of)
                .orElse(Language.ENGLISH);
        return open(simulation, port, opened, language, options, first);
    }

    /**
     * Opens the studio. Without an agent port for this computer's programs, it cannot run any; in a simulation of another process, it
     * has no exercises.
     *
     * @param simulation the simulation to show
     * @param port TCP port on 127.0.0.1; 0 for the default port, or for any free port if that one is in use
     * @param opened the file to open, and the folders that the pages may access
     * @param language language of the exercises
     * @param options options for the robots of all programs
     * @param first the program that is running, if there is one
     * @return the open studio
     * @throws IOException if the port cannot be opened
     */
    public static StudioServer open(
            SimulationControl simulation,
            int port,
            OpenedFile opened,
            Language language,
            List<String> options,
            Optional<FirstProgram> first)
            throws IOException {
        ShownSimulation shown = new ShownSimulation(simulation);
        Optional<PageService> course = Optional.empty();
        if (simulation.hasClock()) {
            course = Optional.of(course(new LocalCourseHost(opened.programs(), simulation, shown), language));
        }
        Optional<CompilerService> workshop = Optional.empty();
        if (simulation.agentPort().isPresent()) {
            workshop = Optional.of(workshop(opened.programs(), options, first));
        }
        return StudioViewer.open(shown, port, opened.folders(), course, workshop);
    }

    private static PageService course(LocalCourseHost host, Language language) {
        CourseService course = new CourseService(ProgressService.ofUser(), host, System.getProperty("user.name", ""));
        course.setLanguage(language.code());
        Runtime.getRuntime().addShutdownHook(new Thread(course::close, "end-of-exercise"));
        return course::answer;
    }

    private static CompilerService workshop(Path folder, List<String> options, Optional<FirstProgram> first) {
        ProcessCompilerService workshop = new ProcessCompilerService(folder, options, first);
        Runtime.getRuntime().addShutdownHook(new Thread(workshop::close, "end-of-programs"));
        return workshop;
    }

    /** Returns the source file of a class in the working directory or its Maven project. */
    private static Optional<Path> sourceOf(String className) {
        String file = className.replace('.', '/') + ENDING;
        Path sources = Path.of("src/main/java");
        if (className.isEmpty() || Files.isRegularFile(Path.of(file)) || !Files.isDirectory(sources)) {
            return Optional.of(Path.of(file)).filter(Files::isRegularFile);
        }
        try (Stream<Path> files = Files.walk(sources, MAX_DEPTH)) {
            return files.filter(each -> each.endsWith(file)).findFirst();
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    /** Returns the path for a copy of an example; empty if there is no such example. */
    private static Optional<String> copyOf(String name, Path folder) {
        return new ExampleSources().names().contains(name)
                ? Optional.of(freeName("My" + name.replaceFirst("^Agent_", ""), folder))
                : Optional.empty();
    }

    /** Returns a file name that is not used by any program or draft in the folder. */
    private static String freeName(String stem, Path folder) {
        String name = stem + ENDING;
        for (int number = 2; isTaken(name, folder); number++) {
            name = stem + number + ENDING;
        }
        return name;
    }

    private static boolean isTaken(String name, Path folder) {
        return Files.exists(folder.resolve(name))
                || Files.exists(folder.resolve(".studio/programs").resolve(name));
    }
}
