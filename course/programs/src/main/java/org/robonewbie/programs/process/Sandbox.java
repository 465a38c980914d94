package org.robonewbie.programs.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.robonewbie.nao.file.TemporaryFiles;

/**
 * Sandbox that uses <a href="https://github.com/containers/bubblewrap">bubblewrap</a> (Linux). Programs see read-only system
 * folders, their own files, an empty home folder, an empty temporary folder and no other processes. Their only connection is
 * a socket to the simulator.
 */
public final class Sandbox {

    /** TCP port in the sandbox that is relayed to the simulator through the socket. */
    public static final int PORT = 3100;

    /** Working directory in the sandbox. */
    static final Path HOME = Path.of("/home/robot");

    /** Folder in the sandbox that contains the program's files. */
    static final Path FILES = Path.of("/team");

    /** Socket in the sandbox that is connected to the simulator, or a folder of such sockets. */
    static final Path DOOR = Path.of("/run/robonewbie/door");

    private static final String BUBBLEWRAP = "bwrap";
    private static final long MAX_SECONDS = 10;
    private static final String HOME_BYTES = Long.toString(224L << 20);
    private static final String TEMPORARY_BYTES = Long.toString(64L << 20);
    private static final String SHARED_BYTES = Long.toString(32L << 20);

    /**
     * Shell script that opens its first argument, the file with the system call filter, and executes its other
     * arguments as a command.
     */
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

    private Sandbox(String absence, Optional<Path> filter) {
        this.absence = absence;
        this.filter = filter;
    }

    /** {@return the sandbox, which may be unavailable on this computer} */
    public static Sandbox find() {
        if (!System.getProperty("os.name").equals("Linux")) {
            return none("bubblewrap is available on Linux only");
        }
        Sandbox sandbox;
        try {
            sandbox = new Sandbox("", writtenFilter());
        } catch (IOException unwritable) {
            return none(String.valueOf(unwritable.getMessage()));
        }
        try {
            List<String> trial = sandbox.closed(walls(), List.of(), List.of("/bin/sh", "-c", "true"));
            Process process =
                    new ProcessBuilder(trial).redirectErrorStream(true).start();
            process.getOutputStream().close();
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            boolean works = process.waitFor(MAX_SECONDS, TimeUnit.SECONDS) && process.exitValue() == 0;
            return works ? sandbox : none("bubblewrap does not work here: " + output.strip());
        } catch (IOException missing) {
            return none("bubblewrap is not installed");
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return none("the test of bubblewrap was interrupted");
        }
    }

    private static Optional<Path> writtenFilter() throws IOException {
        Optional<SystemCallFilter> filter = SystemCallFilter.ofThisProcessor();
        if (filter.isEmpty()) {
            return Optional.empty();
        }
        Path file = TemporaryFiles.file("sandbox", ".bpf");
        file.toFile().deleteOnExit();
        return Optional.of(Files.write(file, filter.get().toBytes()));
    }

    /**
     * Returns an unavailable sandbox.
     *
     * @param reason the reason, as a sentence fragment
     * @return an unavailable sandbox
     */
    public static Sandbox none(String reason) {
        return new Sandbox(reason, Optional.empty());
    }

    /** {@return whether the sandbox is available} */
    public boolean isUp() {
        return absence.isEmpty();
    }

    /** {@return why there is no sandbox, as a sentence fragment; empty if there is one} */
    public String absence() {
        return absence;
    }

    /**
     * Wraps a command so that it runs in the sandbox.
     *
     * @param command the command
     * @param policy permissions of the command
     * @return the wrapped command
     */
    public List<String> enclose(List<String> command, SandboxPolicy policy) {
        List<String> words = new ArrayList<>(walls());
        Map<Path, Boolean> places =
                new TreeMap<>(Comparator.comparingInt(Path::getNameCount).thenComparing(Comparator.naturalOrder()));
        policy.hidden().stream()
                .filter(path ->
                        policy.readable().stream().anyMatch(shown -> path.startsWith(shown) && !path.equals(shown)))
                .forEach(path -> places.put(path, false));
        policy.readable().stream().filter(Files::exists).forEach(path -> places.put(path, true));
        List<Path> covers = new ArrayList<>();
        places.forEach((path, shown) -> words.addAll(shown ? readOnly(path, path) : covered(path, path, covers)));
        policy.files().ifPresent(own -> {
            words.addAll(readOnly(own, FILES));
            policy.hidden().stream()
                    .filter(path -> path.startsWith(own) && !path.equals(own))
                    .forEach(path -> words.addAll(covered(path, FILES.resolve(own.relativize(path)), covers)));
        });
        policy.door().ifPresent(door -> words.addAll(readOnly(door, DOOR)));
        policy.written().ifPresent(folder -> words.addAll(List.of("--bind", folder.toString(), folder.toString())));
        return closed(words, covers, command);
    }

    /**
     * Completes the command line. The mount points are remounted read-only last, because they are file systems without a size
     * limit.
     */
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

    /** {@return whether a file is in one of the system folders, which all programs can read} */
    public static boolean isOfTheSystem(Path file) {
        return SYSTEM.stream().anyMatch(file::startsWith);
    }

    /** Returns the settings in {@code /etc} that programs need. Files with accounts and passwords are not included. */
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
