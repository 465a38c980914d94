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
import org.robonewbie.programs.ExampleCatalogue;
import org.robonewbie.programs.Program;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.programs.SourceFolder;
import org.robonewbie.programs.StudentsAgents;

/** The first class in the process of a program: it prepares its surroundings, then starts what the first argument says. */
public final class ProgramMain {

    /** Starts a class; its name and arguments follow. */
    public static final String CLASS = "class";

    /** Starts a command, which follows. */
    public static final String COMMAND = "command";

    /** Brings robots for a {@link RobotProcess}; program and class path follow. */
    static final String ROBOTS = "robots";

    /** Waits for the call of a {@link WaitingProcess}. */
    static final String CALL = "call";

    /** Runs a program for each call of a {@link WorkerPool}; program and class path follow. */
    static final String REPEAT = "repeat";

    /** Compiles for a {@link CompilerProcess}; the folder of the sources, whether it is deep, and that of the classes follow. */
    static final String COMPILE = "compile";

    private static final String GIVEN_TEAM = "org.robonewbie.team.";

    private ProgramMain() {}

    /**
     * Starts a program.
     *
     * @param arguments one of the words above, and what follows it
     * @throws IOException if files cannot be read or written
     * @throws InterruptedException never in practice
     * @throws ClassNotFoundException if there is no such class
     */
    public static void main(String[] arguments) throws IOException, InterruptedException, ClassNotFoundException {
        ParentProcess parent = ParentProcess.take();
        moveIn();
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
     * In a sandbox, brings the program's files into the empty home and opens the port that leads to the simulator. A program that is
     * graded has many simulators, and its files stay where they are.
     */
    private static void moveIn() throws IOException {
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
        return new ProgramFinder(ExampleCatalogue.load(), ClassPath.read(classPath));
    }

    private static Supplier<Agent> agents(ProgramFinder finder, String program) {
        Supplier<Class<?>> types = finder.findClass(program);
        refuseTheGivenTeam(types.get());
        return StudentsAgents.of(types);
    }

    /** The example team would solve exercises in which students try ideas of their own. */
    private static void refuseTheGivenTeam(Class<?> program) {
        for (Class<?> type = program; type != null; type = type.getSuperclass()) {
            if (type.getName().startsWith(GIVEN_TEAM)) {
                throw new CalledWronglyException(program.getSimpleName() + " plays as " + type.getSimpleName()
                        + " does, which is given and earns no points. Write \"extends Agent\", and your own think().");
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
