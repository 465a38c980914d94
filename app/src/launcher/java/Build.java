import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Builds RoboNewbie if it is missing or outdated. The launchers run this source file directly: {@code java Build.java HOME}.
 * With {@code start} and further arguments it also starts the program.
 */
final class Build {

    private static final boolean WINDOWS =
            System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("win");
    private static final List<String> ENDINGS_OF_BUILD = List.of("Download", "[INFO]");

    private final Path home;
    private final Path launch;
    private final Path log;

    private Build(Path home) {
        this.home = home;
        launch = home.resolve("app/target/launch");
        log = launch.resolve("build.log");
    }

    public static void main(String[] arguments) throws Exception {
        Build build = new Build(Path.of(arguments[0]));
        int result = build.ifNeeded();
        if (result == 0 && arguments.length > 1) {
            result = build.start(List.of(arguments).subList(2, arguments.length));
        }
        System.exit(result);
    }

    /** Builds the program unless it is newer than all sources. A file lock lets one process build while others wait. */
    private int ifNeeded() throws Exception {
        if (isFresh()) {
            return 0;
        }
        try {
            Files.createDirectories(launch);
            try (FileChannel channel = FileChannel.open(
                    launch.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
                FileLock lock = channel.tryLock();
                if (lock == null) {
                    System.err.println("RoboNewbie is being built in another window; waiting ...");
                    channel.lock();
                }
                return isFresh() ? 0 : buildAlone();
            }
        } catch (java.nio.file.FileSystemException unwritable) {
            System.err.println("robonewbie: cannot write to " + launch + ".");
            System.err.println("  RoboNewbie must be built once. Copy its folder to a writable place, for example"
                    + " your home folder.");
            return 1;
        }
    }

    /** Returns the newest program file. On Windows, which locks a running program, each build has its own file name. */
    private Optional<Path> program() throws IOException {
        if (!Files.isDirectory(launch)) {
            return Optional.empty();
        }
        try (Stream<Path> files = Files.list(launch)) {
            return files.filter(file -> file.toString().endsWith(".jar")).max(Comparator.naturalOrder());
        }
    }

    private boolean isFresh() throws IOException {
        Optional<Path> program = program();
        if (program.isEmpty()) {
            return false;
        }
        FileTime built = Files.getLastModifiedTime(program.get());
        for (Path place : sources()) {
            try (Stream<Path> files = Files.walk(place)) {
                for (Path file : files.toList()) {
                    if (Files.getLastModifiedTime(file).compareTo(built) > 0) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private List<Path> sources() throws IOException {
        List<Path> places = new ArrayList<>();
        try (Stream<Path> builds = Files.find(home, 3, (file, attributes) -> file.endsWith("pom.xml"))) {
            builds.forEach(build -> places.addAll(List.of(build, build.resolveSibling("src/main"))));
        }
        List.of("docs", "LICENSE", "NOTICE").forEach(name -> places.add(home.resolve(name)));
        places.removeIf(place -> !Files.exists(place));
        return places;
    }

    private int buildAlone() throws Exception {
        String title = program().isPresent()
                ? "Sources have changed: building RoboNewbie, about 20 s ..."
                : "Building RoboNewbie for the first time (downloads Maven and libraries, 1 to 3 minutes) ...";
        Instant started = Instant.now();
        if (runMaven(title) != 0) {
            explainFailure();
            return 1;
        }
        keepProgram(started);
        System.err.println("RoboNewbie is built.");
        return 0;
    }

    private int runMaven(String title) throws Exception {
        List<String> command = new ArrayList<>(WINDOWS ? List.of("cmd", "/c", "mvnw.cmd") : List.of("sh", "./mvnw"));
        command.addAll(List.of("-B", "-P-lint", "-Dmaven.test.skip=true", "-pl", "app", "-am", "package"));
        ProcessBuilder builder = new ProcessBuilder(command).directory(home.toFile());
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Thread stop = new Thread(Build::stop);
        Runtime.getRuntime().addShutdownHook(stop);
        boolean terminal = System.console() != null;
        if (!terminal) {
            System.err.println(title);
        }
        Process maven = builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
        maven.getOutputStream().close();
        showProgress(maven, title, terminal);
        int result = maven.exitValue();
        Runtime.getRuntime().removeShutdownHook(stop);
        return result;
    }

    private static void stop() {
        ProcessHandle.current().descendants().forEach(ProcessHandle::destroy);
        System.err.println(System.lineSeparator() + "The build was stopped. It will be repeated at the next start.");
    }

    /** Prints a progress line and updates it during the build; without a terminal, prints it only once. */
    private void showProgress(Process maven, String title, boolean terminal) throws Exception {
        for (int seconds = 1; !maven.waitFor(1, TimeUnit.SECONDS); seconds++) {
            if (terminal) {
                System.err.printf("\r%s %3d s  %-50.50s", title, seconds, step());
            }
        }
        if (terminal) {
            System.err.print("\r" + " ".repeat(title.length() + 60) + "\r");
        }
    }

    private String step() throws IOException {
        return lines().filter(line -> line.contains("Building RoboNewbie ::") || line.startsWith("Downloading from"))
                .map(line -> line.startsWith("Down")
                        ? "downloading " + line.substring(line.lastIndexOf('/') + 1)
                        : "compiling " + line.replaceAll(".*:: (\\w+).*", "$1"))
                .reduce("", (earlier, later) -> later);
    }

    private Stream<String> lines() throws IOException {
        return Files.readString(log, java.nio.charset.StandardCharsets.ISO_8859_1).lines();
    }

    private void explainFailure() throws IOException {
        PrintStream err = System.err;
        String all = String.join("\n", lines().toList());
        int error = all.indexOf("[ERROR]");
        err.println("The build of RoboNewbie failed:" + System.lineSeparator());
        (error < 0 ? all : all.substring(error))
                .lines()
                .filter(line -> ENDINGS_OF_BUILD.stream().noneMatch(line::startsWith))
                .forEach(err::println);
        err.println();
        String lower = all.toLowerCase(Locale.ROOT);
        if (all.contains("COMPILATION ERROR")) {
            err.println("What to do: correct the Java file at the line given in the first ERROR. \"git diff\" shows your"
                    + " changes.");
        } else if (Stream.of("could not transfer", "unknown host", "failed to fetch", "connect", "could not resolve")
                .anyMatch(lower::contains)) {
            err.println("What to do: the first build needs the internet; later builds do not. Check the connection (and the"
                    + " proxy) and try again.");
        } else {
            err.println("What to do: read the first ERROR above. Running \"./mvnw clean\" and starting again often helps.");
        }
        err.println("The full output is in " + log);
    }

    /** Installs the new program. A running program keeps its old file, because the rename is atomic. */
    private void keepProgram(Instant started) throws IOException {
        String name = WINDOWS ? "robonewbie-" + started.getEpochSecond() + ".jar" : "robonewbie.jar";
        Path copy = launch.resolve(name + ".new");
        Files.copy(home.resolve("app/target/robonewbie.jar"), copy, StandardCopyOption.REPLACE_EXISTING);
        Files.setLastModifiedTime(copy, FileTime.from(started));
        Files.move(copy, launch.resolve(name), StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private int start(List<String> arguments) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:+DisableAttachMechanism",
                "-Drobonewbie.home=" + home,
                "-Drobonewbie.terminal=true",
                "-jar",
                program().orElseThrow().toString()));
        command.addAll(arguments);
        return new ProcessBuilder(command).inheritIO().start().waitFor();
    }
}
