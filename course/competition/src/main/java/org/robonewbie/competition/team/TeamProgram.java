package org.robonewbie.competition.team;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.JavaCommand;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.ProgramMain;
import org.robonewbie.programs.process.ProgramOutput;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.programs.process.SandboxPolicy;

/** A team's program, prepared so that it can be started. */
public sealed interface TeamProgram {

    /** {@return the checksum of the program; results with a different checksum are not reused} */
    String fingerprint();

    /** {@return the team's files, which are copied into the working directory of each trial} */
    default Optional<Path> folder() {
        return Optional.empty();
    }

    /** {@return the program's files and folders, which are hidden from the other teams} */
    default List<Path> places() {
        return List.of();
    }

    /** {@return whether one process runs all players} */
    default boolean together() {
        return false;
    }

    /** {@return the class path of the program, without RoboNewbie} */
    default List<Path> classPath() {
        return List.of();
    }

    /**
     * Returns the arguments for {@link ProgramMain}.
     *
     * @param start start arguments of the program
     * @return the arguments
     */
    List<String> words(Start start);

    /**
     * Returns the files that the program may read in addition to system files and its own folder.
     *
     * @param hidden files and folders that are hidden from the program
     * @return files and folders
     */
    default List<Path> readable(Collection<Path> hidden) {
        return List.of();
    }

    /**
     * Starts the program in a separate process.
     *
     * @param start start arguments of the program
     * @param limits resource limits of the program
     * @param surroundings sandbox of the program
     * @param work working directory, which is created
     * @param log file for the program's output
     * @return the running program
     * @throws IOException if it cannot be started
     */
    default ChildProcess start(Start start, Limits limits, Surroundings surroundings, Path work, Path log)
            throws IOException {
        TemporaryFolder.delete(work);
        Files.createDirectories(work);
        boolean isEnclosed = surroundings.door().isPresent();
        if (!isEnclosed && folder().isPresent()) {
            TeamFolder.of(folder().get(), List.of()).copyTo(work);
        }
        ClassPath classes = ClassPath.ofThisProgram().with(classPath());
        List<String> command = JavaCommand.ofProgram(
                limits.memoryMegabytes(),
                List.of(
                        JavaCommand.QUICK_START,
                        "-Djava.awt.headless=true",
                        "-Djava.io.tmpdir=" + (isEnclosed ? "/tmp" : work.toAbsolutePath())),
                classes,
                words(isEnclosed ? start.withPort(Sandbox.PORT) : start));
        return ChildProcess.start(
                isEnclosed ? surroundings.enclose(command, this, classes) : command,
                work,
                true,
                ProgramOutput.into(log),
                limits);
    }

    /**
     * Sandbox in which a program runs, and its socket to the simulator.
     *
     * @param sandbox the sandbox, which may be absent
     * @param door the simulator's socket for this team; empty without a sandbox
     * @param hidden files and folders that are hidden from the program: other programs and the results
     */
    record Surroundings(Sandbox sandbox, Optional<Path> door, Collection<Path> hidden) {

        private List<String> enclose(List<String> command, TeamProgram program, ClassPath classes) {
            List<Path> readable = new ArrayList<>(JavaCommand.readable(classes));
            readable.addAll(program.readable(hidden));
            return sandbox.enclose(
                    command, new SandboxPolicy(readable, hidden, program.folder(), door, Optional.empty()));
        }
    }

    /**
     * A program written in Java.
     *
     * @param classPath its classes and resources
     * @param mainClasses the main class for each role
     * @param folder the team's files, which are copied into the working directory of each trial
     * @param submitted the submission from which the files were copied
     * @param together whether one process runs all players
     * @param fingerprint checksum of the program
     */
    record OfJava(
            List<Path> classPath,
            Map<Role, String> mainClasses,
            Optional<Path> folder,
            Optional<Path> submitted,
            boolean together,
            String fingerprint)
            implements TeamProgram {

        /** Stores unmodifiable copies of the collections. */
        public OfJava {
            classPath = List.copyOf(classPath);
            mainClasses = Map.copyOf(mainClasses);
        }

        @Override
        public List<String> words(Start start) {
            List<String> words =
                    new ArrayList<>(List.of(ProgramMain.CLASS, mainClasses.getOrDefault(start.role(), "")));
            words.addAll(start.options(together));
            words.add("--no-browser"); // not --headless, with which the agent would stop infinite loops itself
            return words;
        }

        @Override
        public List<Path> readable(Collection<Path> hidden) {
            return Stream.concat(classPath.stream(), folder.stream())
                    .map(TeamFolder::absolute)
                    .toList();
        }

        @Override
        public List<Path> places() {
            return Stream.concat(
                            readable(List.of()).stream(), submitted.stream().map(TeamFolder::absolute))
                    .toList();
        }
    }

    /**
     * A program written in any language.
     *
     * @param words program and arguments, with placeholders such as {@code {port}}
     * @param folder the team's files, which are copied into the working directory of each trial
     * @param submitted the submission from which the files were copied
     * @param together whether one process runs all players
     * @param fingerprint checksum of the program
     */
    record OfCommand(
            List<String> words, Optional<Path> folder, Optional<Path> submitted, boolean together, String fingerprint)
            implements TeamProgram {

        /** Makes the list unmodifiable. */
        public OfCommand {
            words = List.copyOf(words);
        }

        @Override
        public List<Path> places() {
            return Stream.of(files().stream(), folder.stream(), submitted.stream())
                    .flatMap(paths -> paths)
                    .map(TeamFolder::absolute)
                    .toList();
        }

        @Override
        public List<String> words(Start start) {
            return Stream.concat(Stream.of(ProgramMain.COMMAND), start.fill(words, together).stream())
                    .toList();
        }

        @Override
        public List<Path> readable(Collection<Path> hidden) {
            return files().stream().map(file -> besides(file, hidden)).toList();
        }

        /**
         * Returns a script's folder, or just the script if the folder contains other teams or is the user's home
         * folder.
         */
        private static Path besides(Path file, Collection<Path> hidden) {
            Path folder = Objects.requireNonNullElse(file.getParent(), file);
            boolean foreign = hidden.stream().anyMatch(other -> other.startsWith(folder))
                    || Path.of(System.getProperty("user.home")).startsWith(folder);
            return Files.isDirectory(file) || foreign ? file : folder;
        }

        /** Returns those arguments that are files. */
        private List<Path> files() {
            return words.stream()
                    .filter(word -> word.startsWith("/"))
                    .map(Path::of)
                    .filter(Files::exists)
                    .toList();
        }
    }

    /**
     * A program that cannot be started.
     *
     * @param ending the outcome of all trials of the program
     * @param complaint the compiler errors, or the name of the refused file
     * @param fingerprint checksum of the program
     */
    record Broken(Ending ending, String complaint, String fingerprint) implements TeamProgram {

        @Override
        public List<String> words(Start start) {
            throw new IllegalStateException(complaint);
        }
    }
}
