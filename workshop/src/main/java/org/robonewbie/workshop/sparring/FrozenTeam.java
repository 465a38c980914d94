package org.robonewbie.workshop.sparring;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.file.TemporaryFolder;

/**
 * The example team at a fixed commit, compiled against the current framework and loaded beside the current team. So both play
 * in one process, and the older one keeps its play. The classes are compiled once into a cache folder.
 *
 * <p>A framework change that affects every robot, such as a better walk engine, affects this team too.
 */
final class FrozenTeam {

    /** The commit of the team that is frozen. */
    static final String COMMIT = "efba2916";

    private static final String SOURCES = "course/team/src/main/java";
    private static final String TEAM = "org.robonewbie.team.";
    private static final String PLAYER = SparringPlayer.class.getName();

    private final ClassLoader loader;

    private FrozenTeam(ClassLoader loader) {
        this.loader = loader;
    }

    /**
     * Loads the team; compiles it first if the cache does not contain it.
     *
     * @param cache folder for the compiled classes
     * @param repository a folder inside the Git repository
     * @throws IOException if the folders cannot be read or written
     * @throws IllegalArgumentException if the commit or a Java compiler is missing; the message says which
     */
    static FrozenTeam load(Path cache, Path repository) throws IOException {
        Path classes = cache.resolve("team-" + COMMIT);
        if (!Files.isDirectory(classes)) {
            Files.createDirectories(cache);
            try (TemporaryFolder unfinished = new TemporaryFolder(Files.createTempDirectory(cache, "unfinished"))) {
                Path compiled = unfinished.path().resolve("classes");
                compile(sources(repository, unfinished.path().resolve("sources")), compiled);
                publish(compiled, classes);
            }
        }
        return new FrozenTeam(new TeamFirst(classes.toUri().toURL(), place(SparringPlayer.class)));
    }

    /** Moves the classes into the cache, unless another process has been faster. */
    private static void publish(Path compiled, Path classes) throws IOException {
        try {
            Files.move(compiled, classes, StandardCopyOption.ATOMIC_MOVE);
        } catch (FileSystemException occupied) {
            if (!Files.isDirectory(classes)) {
                throw occupied;
            }
        }
    }

    /** Creates a player of the frozen team. */
    Agent player(int number) {
        return create(TEAM + "Agent_Team", new Class<?>[] {int.class}, number);
    }

    /** Creates a sparring partner that uses the frozen team's skills. */
    Agent partner(int number, SparringPlayer.Idea idea) {
        return create(PLAYER, new Class<?>[] {int.class, String.class}, number, idea.name());
    }

    private Agent create(String name, Class<?>[] types, Object... values) {
        try {
            Constructor<?> constructor = loader.loadClass(name).getConstructor(types);
            return (Agent) constructor.newInstance(values);
        } catch (ReflectiveOperationException changed) {
            throw new IllegalStateException("The team of " + COMMIT + " does not run with this framework.", changed);
        }
    }

    /** Extracts the team's sources from the repository. */
    private static List<Path> sources(Path repository, Path folder) throws IOException {
        Process git = new ProcessBuilder("git", "archive", "--format=zip", COMMIT + ":" + SOURCES)
                .directory(repository.toFile())
                .start();
        List<Path> files = new ArrayList<>();
        try (ZipInputStream archive = new ZipInputStream(git.getInputStream())) {
            for (ZipEntry entry = archive.getNextEntry(); entry != null; entry = archive.getNextEntry()) {
                Path file = folder.resolve(entry.getName()).normalize();
                if (entry.getName().endsWith(".java") && !entry.getName().endsWith("package-info.java")) {
                    Files.createDirectories(file.getParent());
                    Files.copy(archive, file);
                    files.add(file);
                }
            }
        }
        if (files.isEmpty()) {
            throw new IllegalArgumentException("Commit " + COMMIT + " was not found in " + repository
                    + ". Run this command in a full clone of the repository." + message(git));
        }
        return files;
    }

    private static String message(Process git) throws IOException {
        try (InputStream errors = git.getErrorStream()) {
            String text = new String(errors.readAllBytes(), StandardCharsets.UTF_8).strip();
            return text.isEmpty() ? "" : "\ngit: " + text;
        }
    }

    private static void compile(List<Path> sources, Path classes) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            throw new IllegalArgumentException(
                    "This Java has no compiler. Use a JDK to compile the team of " + COMMIT + ".");
        }
        StringWriter messages = new StringWriter();
        List<String> options = List.of("-proc:none", "-nowarn", "--release", "17", "-d", classes.toString());
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            Files.createDirectories(classes);
            boolean compiled = compiler.getTask(
                            messages, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
                    .call();
            if (!compiled) {
                throw new IllegalArgumentException(
                        "The team of " + COMMIT + " does not compile with this framework:\n" + messages);
            }
        }
    }

    /** Returns the folder or JAR file that contains a class. */
    private static URL place(Class<?> type) {
        try {
            URI place = type.getProtectionDomain().getCodeSource().getLocation().toURI();
            return place.toURL();
        } catch (URISyntaxException | IOException impossible) {
            throw new UncheckedIOException(new IOException(impossible));
        }
    }

    /** Class loader that takes the team and the sparring partners from its own places, and all other classes from its parent. */
    private static final class TeamFirst extends URLClassLoader {

        TeamFirst(URL... places) {
            super(places, FrozenTeam.class.getClassLoader());
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            if (!name.startsWith(TEAM) && !name.startsWith(PLAYER)) {
                return super.loadClass(name, resolve);
            }
            synchronized (getClassLoadingLock(name)) {
                Class<?> loaded = findLoadedClass(name);
                return loaded == null ? findClass(name) : loaded;
            }
        }
    }
}
