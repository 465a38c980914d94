package org.robonewbie.programs.process;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.file.SubmittedFolder;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.CompilationFailedException;
import org.robonewbie.programs.Program;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.programs.SourceFolder;
import org.robonewbie.programs.StudentsAgents;

/** Main class of child processes. Prepares the environment and performs the task selected by the first argument. */
public final class ProgramMain {

    /** Task that runs a class. Further arguments: the name of the class and the arguments of its main method. */
    public static final String CLASS = "class";

    /** Task that runs a command. Further arguments: the command. */
    public static final String COMMAND = "command";

    /** Task that provides robots for a {@link RobotProcess}. Further arguments: program and class path. */
    static final String ROBOTS = "robots";

    /** Task that waits for a call from a {@link WaitingProcess}. */
    static final String CALL = "call";

    /** Task that runs a program for each call from a {@link WorkerPool}. Further arguments: program and class path. */
    static final String REPEAT = "repeat";

    /**
     * Task that compiles for a {@link CompilerProcess}. Further arguments: source folder, whether to include subfolders, class
     * folder.
     */
    static final String COMPILE = "compile";

    private static final String EXAMPLE_TEAM = "org.robonewbie.team.";

    private ProgramMain() {}

    /**
     * Performs a task.
     *
     * @param arguments name of the task, followed by its further arguments
     * @throws IOException if files cannot be read or written
     * @throws InterruptedException if this thread is interrupted
     * @throws ClassNotFoundException if there is no such class
     */
    public static void main(String[] arguments) throws IOException, InterruptedException, ClassNotFoundException {
        ParentProcess parent = ParentProcess.take();
        prepare();
        List<String> words = List.of(arguments).subList(1, arguments.length);
        try {
            switch (arguments[0]) {
                case CLASS -> runClass(words);
                case COMMAND -> runCommand(words);
                case ROBOTS -> new RobotHost(parent, agents(finder(words.get(1)), words.get(0))).serve();
                case REPEAT -> runRepeatedly(finder(words.get(1)).findRepeatedly(words.get(0)), parent);
                case CALL -> System.exit(runCalled(parent.nextCall()));
                default -> compile(words, parent);
            }
        } catch (CalledWronglyException wrong) {
            end(wrong, 2);
        } catch (CompilationFailedException mistakes) {
            end(mistakes, 1);
        }
    }

    private static void end(RuntimeException why, int exitCode) {
        System.err.println("robonewbie: " + why.getMessage());
        System.exit(exitCode);
    }

    /**
     * In a sandbox, copies the program's files into the empty home folder and opens a local port that is forwarded to
     * the simulator. For grading, where each trial has a separate port, only links the files.
     */
    private static void prepare() throws IOException {
        if (Files.isDirectory(Sandbox.DOOR)) {
            try (Stream<Path> files = Files.list(Sandbox.FILES)) {
                for (Path file : files.toList()) {
                    Files.createSymbolicLink(Sandbox.HOME.resolve(file.getFileName()), file);
                }
            }
        } else if (Files.exists(Sandbox.DOOR)) {
            if (Files.isDirectory(Sandbox.FILES)) {
                new SubmittedFolder(Sandbox.FILES, place -> false).copyTo(Sandbox.HOME);
            }
            Relay.open(Sandbox.PORT, Sandbox.DOOR);
        }
    }

    private static void runClass(List<String> words) throws ClassNotFoundException {
        int exitCode = Program.ofAny(Class.forName(words.get(0))).run(words.subList(1, words.size()));
        if (exitCode != 0) {
            System.exit(exitCode);
        }
    }

    private static void runCommand(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.INHERIT)
                .start();
        process.getOutputStream().close();
        Runtime.getRuntime().halt(process.waitFor());
    }

    private static int runCalled(String call) {
        List<String> words = Arrays.asList(call.split(WaitingProcess.SEPARATOR, -1));
        return finder(words.get(1)).ofClass(words.get(0)).run(words.subList(2, words.size()));
    }

    private static void runRepeatedly(Supplier<Program> program, ParentProcess parent) throws InterruptedException {
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        while (true) {
            List<String> options = Arrays.asList(parent.nextCall().split(WaitingProcess.SEPARATOR, -1));
            parent.answer(String.valueOf(program.get().run(options)));
        }
    }

    private static ProgramFinder finder(String classPath) {
        return new ProgramFinder(ClassPath.read(classPath));
    }

    private static Supplier<Agent> agents(ProgramFinder finder, String program) {
        Supplier<Class<?>> types = finder.findClass(program);
        rejectExampleTeam(types.get());
        return new StudentsAgents(types);
    }

    /** Rejects programs that extend the example team, which would solve exercises that require students' own ideas. */
    private static void rejectExampleTeam(Class<?> program) {
        for (Class<?> type = program; type != null; type = type.getSuperclass()) {
            if (type.getName().startsWith(EXAMPLE_TEAM)) {
                throw new CalledWronglyException(program.getSimpleName() + " extends " + type.getSimpleName()
                        + " of the example team, which earns no points. Write \"extends Agent\" and your own think().");
            }
        }
    }

    private static void compile(List<String> words, ParentProcess parent) throws IOException {
        Path classes = Path.of(words.get(2));
        new SourceFolder(Path.of(words.get(0)), Boolean.parseBoolean(words.get(1)))
                .compile(classes)
                .forEach(parent::answer);
    }
}
