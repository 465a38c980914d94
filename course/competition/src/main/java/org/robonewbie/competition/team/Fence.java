package org.robonewbie.competition.team;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Fences programs in with <a href="https://github.com/containers/bubblewrap">bubblewrap</a>, where Linux has it: they see a
 * read-only system, their own files, an empty home and temporary folder, no other process, and no network but a door that leads to
 * their port of the simulator.
 */
public final class Fence {

    /** The port of the simulator within the fence; it leads through the door. */
    static final int PORT = 3100;

    /** Where programs work within the fence. */
    static final Path HOME = Path.of("/home/robot");

    /** Where the files of the team are within the fence, to be copied into its home. */
    static final Path TEAM = Path.of("/team");

    /** The file of the door within the fence. */
    static final Path DOOR = Path.of("/run/robonewbie/door");

    private static final String BUBBLEWRAP = "bwrap";
    private static final long PATIENCE_SECONDS = 10;
    private static final String HOME_BYTES = Long.toString(224L << 20);
    private static final String TEMPORARY_BYTES = Long.toString(64L << 20);
    private static final String SHARED_BYTES = Long.toString(32L << 20);

    /** Opens the filter of system calls, the first argument, and becomes the command that follows. */
    private static final String WITH_FILTER = "exec 9<\"$1\"; shift; exec \"$@\"";

    private static final List<String> SYSTEM =
            List.of("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/nix/store");
    private static final List<String> SETTINGS = List.of(
            "alternatives",
            "ld.so.cache",
            "ld.so.conf",
            "ld.so.conf.d",
            "localtime",
            "fonts",
            "ssl",
            "ca-certificates");

    private final String absence;
    private final Optional<Path> filter;

    private Fence(String absence, Optional<Path> filter) {
        this.absence = absence;
        this.filter = filter;
    }

    /** {@return the fence, if this computer has one} */
    public static Fence find() {
        if (!System.getProperty("os.name").equals("Linux")) {
            return none("fences exist on Linux only");
        }
        try {
            Fence fence = new Fence("", writtenFilter());
            List<String> trial = fence.closed(walls(), List.of(), List.of("/bin/sh", "-c", "true"));
            Process process =
                    new ProcessBuilder(trial).redirectErrorStream(true).start();
            process.getOutputStream().close();
            String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            boolean stands = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS) && process.exitValue() == 0;
            return stands ? fence : none("bubblewrap does not work here: " + told.strip());
        } catch (IOException missing) {
            return none("bubblewrap is not installed");
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return none("bubblewrap has not been tried");
        }
    }

    private static Optional<Path> writtenFilter() throws IOException {
        Optional<SystemCallFilter> filter = SystemCallFilter.ofThisProcessor();
        if (filter.isEmpty()) {
            return Optional.empty();
        }
        Path file = Files.createTempFile("fence", ".bpf");
        file.toFile().deleteOnExit();
        return Optional.of(Files.write(file, filter.get().toBytes()));
    }

    /**
     * Does without a fence.
     *
     * @param reason why, as part of a sentence
     * @return no fence
     */
    public static Fence none(String reason) {
        return new Fence(reason, Optional.empty());
    }

    /** {@return whether programs are fenced in} */
    public boolean isUp() {
        return absence.isEmpty();
    }

    /** {@return why there is no fence, as part of a sentence; empty if there is one} */
    public String absence() {
        return absence;
    }

    /**
     * Puts a command behind the fence.
     *
     * @param command what is to run there
     * @param readable what it may read beside the system, at its usual place
     * @param hidden what it must not see, even within something readable
     * @param folder the team's folder, shown at {@link #TEAM}
     * @param door the socket at which the simulator listens
     * @return the command with the fence around it
     */
    List<String> enclose(
            List<String> command,
            Collection<Path> readable,
            Collection<Path> hidden,
            Optional<Path> folder,
            Path door) {
        List<String> words = new ArrayList<>(walls());
        Map<Path, Boolean> places =
                new TreeMap<>(Comparator.comparingInt(Path::getNameCount).thenComparing(Comparator.naturalOrder()));
        hidden.stream()
                .filter(path -> readable.stream().anyMatch(shown -> path.startsWith(shown) && !path.equals(shown)))
                .forEach(path -> places.put(path, false));
        readable.stream().filter(Files::exists).forEach(path -> places.put(path, true));
        List<Path> covers = new ArrayList<>();
        places.forEach((path, shown) -> words.addAll(shown ? shown(path) : covered(path, path, covers)));
        folder.ifPresent(own -> words.addAll(readOnly(own, TEAM)));
        if (folder.isPresent()) {
            hidden.stream()
                    .filter(path -> path.startsWith(folder.get()) && !path.equals(folder.get()))
                    .forEach(path ->
                            words.addAll(covered(path, TEAM.resolve(folder.get().relativize(path)), covers)));
        }
        words.addAll(List.of("--bind", door.toString(), DOOR.toString()));
        return closed(words, covers, command);
    }

    /**
     * Puts a command behind the fence that speaks with no simulator.
     *
     * @param command what is to run there
     * @param readable what it may read beside the system, at its usual place
     * @param written the folder in which it may write
     * @return the command with the fence around it
     */
    List<String> enclose(List<String> command, Collection<Path> readable, Path written) {
        List<String> words = new ArrayList<>(walls());
        readable.stream().filter(Files::exists).sorted().forEach(path -> words.addAll(shown(path)));
        words.addAll(List.of("--bind", written.toString(), written.toString()));
        return closed(words, List.of(), command);
    }

    /** Closes the walls when everything is within: what holds the rest together would else be a file system without limit. */
    private List<String> closed(List<String> words, List<Path> covers, List<String> command) {
        List<String> all = new ArrayList<>();
        filter.ifPresent(file -> all.addAll(List.of("/bin/sh", "-c", WITH_FILTER, "sh", file.toString())));
        all.addAll(words);
        covers.forEach(path -> all.addAll(List.of("--remount-ro", path.toString())));
        all.addAll(List.of("--remount-ro", "/", "--chdir", HOME.toString()));
        if (filter.isPresent()) {
            all.addAll(List.of("--seccomp", "9"));
        }
        all.add("--");
        all.addAll(command);
        return all;
    }

    private static List<String> shown(Path path) {
        return readOnly(path, path);
    }

    private static List<String> readOnly(Path from, Path to) {
        return List.of("--ro-bind", from.toString(), to.toString());
    }

    private static List<String> covered(Path real, Path seen, List<Path> covers) {
        if (Files.isDirectory(real)) {
            covers.add(seen);
            return List.of("--perms", "0555", "--tmpfs", seen.toString());
        }
        return Files.exists(real) ? List.of("--ro-bind", "/dev/null", seen.toString()) : List.of();
    }

    /** What is the same for all programs. */
    private static List<String> walls() {
        List<String> words = new ArrayList<>(List.of(
                BUBBLEWRAP,
                "--unshare-all",
                "--unshare-user",
                "--disable-userns",
                "--uid",
                "1000",
                "--gid",
                "1000",
                "--die-with-parent",
                "--new-session",
                "--clearenv"));
        Map.of("PATH", "/usr/local/bin:/usr/bin:/bin", "HOME", HOME.toString(), "LANG", "C.UTF-8", "TMPDIR", "/tmp")
                .forEach((name, value) -> words.addAll(List.of("--setenv", name, value)));
        SYSTEM.forEach(path -> words.addAll(List.of("--ro-bind-try", path, path)));
        settings().forEach(path -> words.addAll(List.of("--ro-bind-try", path, path)));
        words.addAll(List.of("--proc", "/proc", "--dev", "/dev"));
        words.addAll(List.of("--size", SHARED_BYTES, "--tmpfs", "/dev/shm", "--remount-ro", "/dev"));
        words.addAll(List.of("--size", TEMPORARY_BYTES, "--tmpfs", "/tmp"));
        words.addAll(List.of("--size", HOME_BYTES, "--tmpfs", HOME.toString()));
        return words;
    }

    /** Whether a file belongs to the system that each program sees. */
    static boolean isOfTheSystem(Path file) {
        return SYSTEM.stream().anyMatch(file::startsWith);
    }

    /** Settings of the system that programs need, and no others: accounts and passwords stay outside. */
    private static List<String> settings() {
        List<String> all = new ArrayList<>();
        SETTINGS.forEach(name -> all.add("/etc/" + name));
        try (Stream<Path> files = Files.list(Path.of("/etc"))) {
            files.filter(file -> String.valueOf(file.getFileName()).matches("(java|jvm|python).*"))
                    .forEach(file -> all.add(file.toString()));
        } catch (IOException unreadable) {
            return all;
        }
        return all;
    }
}
