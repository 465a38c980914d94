package org.robonewbie.competition.team;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.nao.file.SubmittedFolder;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.Fingerprint;
import org.robonewbie.programs.SourceFolder;
import org.robonewbie.programs.process.CompilerProcess;
import org.robonewbie.programs.process.Sandbox;

/**
 * Finds and prepares the programs of teams.
 *
 * @param folder folder to which paths are relative
 * @param buildFolder folder for copies of the teams' files and for compiled classes
 * @param examples full class names of the examples, by simple name
 * @param sandbox sandbox for the compiler
 */
public record TeamPrograms(Path folder, Path buildFolder, Map<String, String> examples, Sandbox sandbox) {

    private static final int MAX_NOTES = 5;

    /** Makes the build folder absolute. */
    public TeamPrograms {
        buildFolder = TeamFolder.absolute(buildFolder);
    }

    /**
     * Returns the folders of the teams.
     *
     * @param teams the teams
     * @return absolute paths of the programs that are folders
     */
    public List<Path> folders(List<TeamEntry> teams) {
        return teams.stream()
                .flatMap(team -> existing(team.program()).stream())
                .filter(Files::isDirectory)
                .toList();
    }

    /**
     * Prepares a team's program.
     *
     * @param team the team
     * @param foreign folders to ignore inside its folder: the results and the folders of other teams
     * @return the program, which may be {@link TeamProgram.Broken}
     * @throws IOException if files cannot be written
     * @throws CalledWronglyException if there is no such program; the message says what to write
     */
    public TeamProgram find(TeamEntry team, Collection<Path> foreign) throws IOException {
        try {
            return prepare(team, foreign.stream().map(TeamFolder::absolute).toList());
        } catch (UnreadableFileException refused) {
            String complaint = String.valueOf(refused.getMessage());
            return new TeamProgram.Broken(
                    Ending.REFUSED, complaint, new Fingerprint().add(complaint).text());
        }
    }

    private TeamProgram prepare(TeamEntry team, Collection<Path> foreign) throws IOException {
        Optional<Path> place = existing(team.program());
        if (place.isPresent() && Files.isDirectory(place.get())) {
            return ofFolder(team, TeamFolder.of(place.get(), foreign));
        }
        if (place.isPresent() && team.program().endsWith(".java")) {
            return ofFile(team, place.get(), foreign);
        }
        if (place.isPresent() && team.program().endsWith(".jar")) {
            return ofJar(team, place.get());
        }
        Optional<String> example = Optional.ofNullable(examples.get(team.program()))
                .or(() -> Optional.of(team.program()).filter(TeamPrograms::isClass));
        if (example.isPresent()) {
            return ofClass(team, example.get());
        }
        if (place.isEmpty() && !team.program().contains(" ")) {
            throw new CalledWronglyException(
                    "Team " + team.name() + ": there is no folder, jar, Java file, example or command \""
                            + team.program() + "\" (in the folder " + folder.toAbsolutePath() + ").");
        }
        return ofCommand(team, foreign);
    }

    private TeamProgram ofFolder(TeamEntry team, SubmittedFolder submitted) throws IOException {
        SourceFolder sources = new SourceFolder(copy(team, submitted), true);
        if (!sources.hasSources()) {
            throw new CalledWronglyException(
                    "Team " + team.name() + ": the folder " + submitted.root() + " contains no Java files.");
        }
        return compiled(team, sources, submitted.root(), new Fingerprint());
    }

    /** Compiles a file together with the other files in its folder, but not those in subfolders. */
    private TeamProgram ofFile(TeamEntry team, Path file, Collection<Path> foreign) throws IOException {
        Path own = Objects.requireNonNull(file.getParent());
        String main = Objects.requireNonNull(file.getFileName()).toString().replaceFirst("\\.java$", "");
        Map<String, String> settings = new HashMap<>(team.settings());
        settings.putIfAbsent(Role.MAIN.key(), main);
        TeamEntry named = new TeamEntry(team.name(), team.program(), settings);
        SourceFolder sources = new SourceFolder(copy(team, TeamFolder.of(own, foreign)), false);
        return compiled(named, sources, own, new Fingerprint().add(main));
    }

    /** Copies a submission, so that the compiler, the fingerprint and all trials use the same files. */
    private Path copy(TeamEntry team, SubmittedFolder submitted) throws IOException {
        Path copy = buildFolder.resolve(team.name()).resolve("program");
        TemporaryFolder.delete(copy);
        submitted.copyTo(copy);
        return copy;
    }

    private TeamProgram compiled(TeamEntry team, SourceFolder sources, Path submitted, Fingerprint fingerprint)
            throws IOException {
        String text = fingerprint
                .add(TeamFolder.of(sources.folder(), List.of()))
                .add(settingsOf(team))
                .text();
        Path classes = buildFolder.resolve(team.name()).resolve("classes");
        CompilerProcess.Answer answer = new CompilerProcess(sandbox).compile(sources, classes);
        if (!answer.isCorrect()) {
            String complaint = String.join("\n", answer.lines());
            return new TeamProgram.Broken(
                    Ending.NOT_COMPILED, complaint.replace(sources.folder().toString(), submitted.toString()), text);
        }
        answer.lines().stream()
                .limit(MAX_NOTES)
                .map(note -> note.replace(sources.folder().toString(), submitted.toString()))
                .forEach(System.err::println);
        return new TeamProgram.OfJava(
                sources.classPath(classes),
                choose(team, answer.classes()),
                Optional.of(sources.folder()),
                Optional.of(submitted),
                team.isTogether(),
                text);
    }

    private TeamProgram ofJar(TeamEntry team, Path jar) throws IOException {
        String fingerprint = new Fingerprint()
                .add(TeamFolder.of(jar, List.of()))
                .add(settingsOf(team))
                .text();
        String manifestMain;
        try (JarFile file = new JarFile(jar.toFile())) {
            manifestMain = Optional.ofNullable(file.getManifest())
                    .map(manifest -> manifest.getMainAttributes().getValue(Attributes.Name.MAIN_CLASS))
                    .orElse("");
        }
        if (manifestMain.isEmpty() && team.mainClass(Role.MAIN).isEmpty()) {
            throw new CalledWronglyException("Team " + team.name() + ": the jar " + jar
                    + " does not name its main class. Write: " + team.name() + ".main = my.team.MyAgent");
        }
        return ofClasses(team, List.of(jar), manifestMain, fingerprint);
    }

    private TeamProgram ofClass(TeamEntry team, String className) throws IOException {
        Fingerprint fingerprint = new Fingerprint().add(className).add(settingsOf(team));
        String file = className.replace('.', '/') + ".class";
        try (InputStream bytes = TeamPrograms.class.getClassLoader().getResourceAsStream(file)) {
            if (bytes != null) {
                fingerprint.add(bytes);
            }
        }
        return ofClasses(team, List.of(), className, fingerprint.text());
    }

    private TeamProgram ofClasses(TeamEntry team, List<Path> classPath, String mainClass, String fingerprint) {
        Map<Role, String> mainClasses = forEachRole(role -> {
            String name = team.mainClass(role).orElse(mainClass);
            return examples.getOrDefault(name, name);
        });
        return new TeamProgram.OfJava(
                classPath, mainClasses, Optional.empty(), Optional.empty(), team.isTogether(), fingerprint);
    }

    private TeamProgram ofCommand(TeamEntry team, Collection<Path> foreign) throws IOException {
        List<String> words = Arrays.stream(team.program().split("\\s+", -1))
                .map(word -> existing(word).map(Path::toString).orElse(word))
                .toList();
        Optional<Path> own =
                Optional.ofNullable(team.settings().get(TeamList.FOLDER)).map(this::existingFolder);
        if (!canBeStarted(words.get(0), own)) {
            throw new CalledWronglyException("Team " + team.name() + ": \"" + words.get(0)
                    + "\" is not an executable program, and \"" + team.program()
                    + "\" is not a folder or file. Is the line written as NAME = PROGRAM?");
        }
        Fingerprint fingerprint = new Fingerprint().add(team.program()).add(settingsOf(team));
        Optional<Path> copy = Optional.empty();
        if (own.isPresent()) {
            copy = Optional.of(copy(team, TeamFolder.of(own.get(), foreign)));
            fingerprint.add(TeamFolder.of(copy.get(), List.of()));
        }
        for (String word : words) {
            Optional<Path> file = existing(word).filter(Files::isRegularFile);
            if (file.isPresent()) {
                addScript(file.get().toRealPath(), file.get(), fingerprint);
            }
        }
        return new TeamProgram.OfCommand(words, copy, own, team.isTogether(), fingerprint.text());
    }

    /**
     * Adds a script to the fingerprint. A symbolic link may point into its own folder or to a system folder, but not to another
     * team's script.
     */
    private static void addScript(Path real, Path file, Fingerprint fingerprint) throws IOException {
        Path own = Objects.requireNonNull(file.getParent()).toRealPath();
        boolean isOwn = real.startsWith(own) || Sandbox.isOfTheSystem(real);
        if (Files.size(real) < 1_000_000) {
            fingerprint.add(TeamFolder.of(isOwn ? real : file, List.of()));
        }
    }

    private static Map<Role, String> forEachRole(Function<Role, String> mainClass) {
        Map<Role, String> mainClasses = new EnumMap<>(Role.class);
        for (Role role : Role.values()) {
            mainClasses.put(role, mainClass.apply(role));
        }
        return mainClasses;
    }

    private Path existingFolder(String name) {
        return existing(name)
                .filter(Files::isDirectory)
                .orElseThrow(() -> new CalledWronglyException("There is no folder " + folder.resolve(name) + "."));
    }

    /** Returns whether a command can be found in the team's folder, relative to the base folder, or on the system's path. */
    private boolean canBeStarted(String word, Optional<Path> own) {
        Stream<Path> places = word.contains("/") || word.contains(File.separator)
                ? Stream.concat(own.stream(), Stream.of(folder))
                : Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1))
                        .map(Path::of);
        return places.flatMap(place -> Stream.of("", ".exe", ".cmd", ".bat").map(end -> place.resolve(word + end)))
                .anyMatch(file -> Files.isRegularFile(file) && Files.isExecutable(file));
    }

    /** Returns a file if it exists. Backslashes are accepted as separators on all systems. */
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
            Class.forName(name, false, TeamPrograms.class.getClassLoader());
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

    /** Chooses a class for each role: the one specified by the team, or else the only class with a main method. */
    private static Map<Role, String> choose(TeamEntry team, List<String> candidates) {
        return forEachRole(role -> team.mainClass(role)
                .map(name -> existing(team, name, candidates))
                .orElseGet(() -> single(team, candidates)));
    }

    private static String existing(TeamEntry team, String name, List<String> candidates) {
        return candidates.stream()
                .filter(candidate -> candidate.equals(name) || candidate.endsWith("." + name))
                .findFirst()
                .orElseThrow(() -> new CalledWronglyException("Team " + team.name() + " has no class " + name
                        + " with a main method. It has: " + list(candidates) + "."));
    }

    private static String single(TeamEntry team, List<String> candidates) {
        if (candidates.size() == 1) {
            return candidates.get(0);
        }
        throw new CalledWronglyException(
                candidates.isEmpty()
                        ? "Team " + team.name() + " (" + team.program()
                                + ") has no class with a main method. Add to its agent:"
                                + " public static void main(String[] args) { new MyAgent().run(args); }"
                        : "Team " + team.name() + " has several classes with a main method: " + list(candidates)
                                + ". Choose one: " + team.name() + ".main = " + candidates.get(0));
    }

    private static String list(List<String> names) {
        return names.isEmpty() ? "none" : String.join(", ", names);
    }
}
