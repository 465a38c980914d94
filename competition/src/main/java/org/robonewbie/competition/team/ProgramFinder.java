package org.robonewbie.competition.team;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Role;

/** Finds out what the program of a team is, and prepares it. */
public final class ProgramFinder {

    private final Path folder;
    private final Path buildFolder;
    private final Map<String, String> examples;

    /**
     * Creates a finder.
     *
     * @param folder where relative paths begin
     * @param buildFolder where compiled classes may be put
     * @param examples classes that are known by a short name
     */
    public ProgramFinder(Path folder, Path buildFolder, Map<String, String> examples) {
        this.folder = folder;
        this.buildFolder = buildFolder;
        this.examples = examples;
    }

    /**
     * Prepares a team's program.
     *
     * @param team the team
     * @return the program, which may have mistakes
     * @throws IOException if files cannot be read or written
     * @throws WrongEntryException if there is no such program; the message says what to write
     */
    public TeamProgram find(TeamEntry team) throws IOException {
        Optional<Path> place = existing(team.program());
        if (place.isPresent() && Files.isDirectory(place.get())) {
            return ofFolder(team, place.get());
        }
        if (place.isPresent() && team.program().endsWith(".java")) {
            return ofFile(team, place.get());
        }
        if (place.isPresent() && team.program().endsWith(".jar")) {
            return ofJar(team, place.get());
        }
        Optional<String> example = Optional.ofNullable(examples.get(team.program()))
                .or(() -> Optional.of(team.program()).filter(ProgramFinder::isClass));
        if (example.isPresent()) {
            return ofClass(team, example.get());
        }
        if (place.isEmpty() && !team.program().contains(" ")) {
            throw new WrongEntryException(
                    "Team " + team.name() + ": there is no folder, jar, Java file, example or command \""
                            + team.program() + "\" (in the folder " + folder.toAbsolutePath() + ").");
        }
        return ofCommand(team);
    }

    private TeamProgram ofFolder(TeamEntry team, Path place) throws IOException {
        SourceFolder sources = new SourceFolder(place, true);
        if (!sources.hasSources()) {
            throw new WrongEntryException("Team " + team.name() + ": the folder " + place + " has no Java files.");
        }
        return compiled(team, sources, place, new Fingerprint().add(place));
    }

    /** A single file is compiled together with the other files of its folder; folders beside it do not matter. */
    private TeamProgram ofFile(TeamEntry team, Path file) throws IOException {
        Path own = Objects.requireNonNull(file.getParent());
        String main = Objects.requireNonNull(file.getFileName()).toString().replaceFirst("\\.java$", "");
        Map<String, String> settings = new HashMap<>(team.settings());
        settings.putIfAbsent(Role.MAIN.key(), main);
        TeamEntry named = new TeamEntry(team.name(), team.program(), settings);
        return compiled(
                named,
                new SourceFolder(own, false),
                own,
                new Fingerprint().add(own).add(main));
    }

    private TeamProgram compiled(TeamEntry team, SourceFolder sources, Path place, Fingerprint fingerprint)
            throws IOException {
        String text = fingerprint.add(settingsOf(team)).text();
        Path classes = buildFolder.resolve(team.name());
        SourceFolder.Compiled result = sources.compile(classes);
        if (result.complaint().isPresent()) {
            return new TeamProgram.Broken(result.complaint().get(), text);
        }
        List<String> candidates = MainClasses.in(classes, result.classPath());
        return new TeamProgram.OfJava(
                result.classPath(), MainClasses.choose(team, candidates), Optional.of(place), team.isTogether(), text);
    }

    private TeamProgram ofJar(TeamEntry team, Path jar) throws IOException {
        String manifestMain;
        try (JarFile file = new JarFile(jar.toFile())) {
            manifestMain = Optional.ofNullable(file.getManifest())
                    .map(manifest -> manifest.getMainAttributes().getValue(Attributes.Name.MAIN_CLASS))
                    .orElse("");
        }
        if (manifestMain.isEmpty() && team.mainClass(Role.MAIN).isEmpty()) {
            throw new WrongEntryException("Team " + team.name() + ": the jar " + jar
                    + " does not say which class to start. Write: " + team.name() + ".main = my.team.MyAgent");
        }
        return new TeamProgram.OfJava(
                List.of(jar),
                forAllRoles(team, manifestMain),
                Optional.empty(),
                team.isTogether(),
                new Fingerprint().add(jar).add(settingsOf(team)).text());
    }

    private TeamProgram ofClass(TeamEntry team, String className) throws IOException {
        Fingerprint fingerprint = new Fingerprint().add(className).add(settingsOf(team));
        String file = className.replace('.', '/') + ".class";
        try (InputStream bytes = ProgramFinder.class.getClassLoader().getResourceAsStream(file)) {
            if (bytes != null) {
                fingerprint.add(bytes);
            }
        }
        return new TeamProgram.OfJava(
                List.of(), forAllRoles(team, className), Optional.empty(), team.isTogether(), fingerprint.text());
    }

    private TeamProgram ofCommand(TeamEntry team) throws IOException {
        List<String> words = Arrays.stream(team.program().split("\\s+", -1))
                .map(word -> existing(word).map(Path::toString).orElse(word))
                .toList();
        Optional<Path> own =
                Optional.ofNullable(team.settings().get(TeamList.FOLDER)).map(this::existingFolder);
        if (!canBeStarted(words.get(0), own)) {
            throw new WrongEntryException("Team " + team.name() + ": \"" + words.get(0)
                    + "\" is no program that can be started, and \"" + team.program()
                    + "\" no folder or file. Is the line written as NAME = PROGRAM?");
        }
        Fingerprint fingerprint = new Fingerprint().add(team.program()).add(settingsOf(team));
        if (own.isPresent()) {
            fingerprint.add(own.get());
        }
        for (String word : words) {
            Optional<Path> file = existing(word).filter(Files::isRegularFile);
            if (file.isPresent() && Files.size(file.get()) < 1_000_000) {
                fingerprint.add(file.get());
            }
        }
        return new TeamProgram.OfCommand(words, own, team.isTogether(), fingerprint.text());
    }

    private Map<Role, String> forAllRoles(TeamEntry team, String usual) {
        Map<Role, String> chosen = new EnumMap<>(Role.class);
        for (Role role : Role.values()) {
            String name = team.mainClass(role).orElse(usual);
            chosen.put(role, examples.getOrDefault(name, name));
        }
        return chosen;
    }

    private Path existingFolder(String name) {
        return existing(name)
                .filter(Files::isDirectory)
                .orElseThrow(() -> new WrongEntryException("There is no folder " + folder.resolve(name) + "."));
    }

    /** Whether the first word of a command is a program: in the team's own folder, at its place, or in the system's path. */
    private boolean canBeStarted(String word, Optional<Path> own) {
        Stream<Path> places = word.contains("/") || word.contains(File.separator)
                ? Stream.concat(own.stream(), Stream.of(folder))
                : Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1))
                        .map(Path::of);
        return places.flatMap(place -> Stream.of("", ".exe", ".cmd", ".bat").map(end -> place.resolve(word + end)))
                .anyMatch(file -> Files.isRegularFile(file) && Files.isExecutable(file));
    }

    /** Looks for a file; a path of Windows is understood on other systems too. */
    private Optional<Path> existing(String name) {
        try {
            return Stream.of(name, name.replace('\\', '/'))
                    .map(path -> folder.resolve(path).toAbsolutePath().normalize())
                    .filter(Files::exists)
                    .findFirst();
        } catch (InvalidPathException noPath) {
            return Optional.empty();
        }
    }

    private static boolean isClass(String name) {
        try {
            Class.forName(name, false, ProgramFinder.class.getClassLoader());
            return true;
        } catch (ClassNotFoundException | LinkageError none) {
            return false;
        }
    }

    private static String settingsOf(TeamEntry team) {
        return List.of("main", "attacker", "goalkeeper", TeamList.TOGETHER, TeamList.SEED).stream()
                .map(key -> key + "=" + team.settings().getOrDefault(key, ""))
                .toList()
                .toString();
    }
}
