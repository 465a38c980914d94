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

/** A program that is ready to be started. */
public sealed interface TeamProgram {

    /** {@return a checksum of the program; while it stays the same, earlier results of the team are valid} */
    String fingerprint();

    /** {@return the files of the team, of which each trial gets a copy to work in} */
    Optional<Path> folder();

    /** {@return where its files are, which no other team may see} */
    List<Path> places();

    /** {@return whether one process brings all players} */
    boolean together();

    /** {@return the class path of the program, without RoboNewbie} */
    List<Path> classPath();

    /**
     * Returns what starts it, for {@link ProgramMain}.
     *
     * @param start what it receives
     * @return the words
     */
    List<String> words(Start start);

    /**
     * Returns what it must be able to read beside its classes and its folder.
     *
     * @param hidden what it must not see
     * @return files and folders
     */
    List<Path> readable(Collection<Path> hidden);

    /**
     * Starts the program in a separate process.
     *
     * @param start what it receives
     * @param limits its limits
     * @param surroundings what encloses it
     * @param work working folder, made now
     * @param log file for what it prints
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
        List<String> options = new ArrayList<>(JavaCommand.withMemory(limits.memoryMegabytes()));
        options.add(JavaCommand.QUICK_START);
        options.add("-Djava.awt.headless=true");
        options.add("-Djava.io.tmpdir=" + (isEnclosed ? "/tmp" : work.toAbsolutePath()));
        List<String> command = JavaCommand.of(
                options,
                classes,
                ProgramMain.class.getName(),
                words(isEnclosed ? start.withPort(Sandbox.PORT) : start));
        return ChildProcess.start(
                isEnclosed ? surroundings.enclose(command, this, classes) : command,
                work,
                true,
                ProgramOutput.into(log),
                limits);
    }

    /**
     * What encloses the process of a program: a sandbox with a door, or nothing.
     *
     * @param sandbox the sandbox, which may be missing
     * @param door the file of the socket at which the simulator waits for the team; empty without sandbox
     * @param hidden what no process in the sandbox sees: the programs of others, the results
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
     * A program in Java.
     *
     * @param classPath where its classes and files are
     * @param mainClasses the class to start for each role
     * @param folder the files of the team, of which each trial gets a copy to work in
     * @param submitted what the team handed in, from which they have been copied
     * @param together whether one process brings all players
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

        /** Makes list and map unmodifiable. */
        public OfJava {
            classPath = List.copyOf(classPath);
            mainClasses = Map.copyOf(mainClasses);
        }

        @Override
        public List<String> words(Start start) {
            List<String> words =
                    new ArrayList<>(List.of(ProgramMain.CLASS, mainClasses.getOrDefault(start.role(), "")));
            words.addAll(start.options(together));
            words.add("--no-browser"); // and not headless: the limits decide about endless loops, not the agent
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
     * A program in any language.
     *
     * @param words program and arguments, with places such as {@code {port}} to be filled in
     * @param folder the files of the team, of which each trial gets a copy to work in
     * @param submitted the folder that the team handed in, from which they have been copied
     * @param together whether one process brings all players
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
        public List<Path> classPath() {
            return List.of();
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

        /** A script may need its neighbours; but not if these are other teams, or the whole home of a user. */
        private static Path besides(Path file, Collection<Path> hidden) {
            Path folder = Objects.requireNonNullElse(file.getParent(), file);
            boolean foreign = hidden.stream().anyMatch(other -> other.startsWith(folder))
                    || Path.of(System.getProperty("user.home")).startsWith(folder);
            return Files.isDirectory(file) || foreign ? file : folder;
        }

        /** The files that its words name. */
        private List<Path> files() {
            return words.stream()
                    .filter(word -> word.startsWith("/"))
                    .map(Path::of)
                    .filter(Files::exists)
                    .toList();
        }
    }

    /**
     * A program that cannot play.
     *
     * @param ending how all of its trials end
     * @param complaint what the compiler says, or which file was refused
     * @param fingerprint checksum of the program
     */
    record Broken(Ending ending, String complaint, String fingerprint) implements TeamProgram {

        @Override
        public Optional<Path> folder() {
            return Optional.empty();
        }

        @Override
        public List<Path> places() {
            return List.of();
        }

        @Override
        public boolean together() {
            return false;
        }

        @Override
        public List<Path> classPath() {
            return List.of();
        }

        @Override
        public List<String> words(Start start) {
            throw new IllegalStateException(complaint);
        }

        @Override
        public List<Path> readable(Collection<Path> hidden) {
            return List.of();
        }
    }
}
