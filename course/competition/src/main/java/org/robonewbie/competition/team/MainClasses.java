package org.robonewbie.competition.team;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.competition.contest.Role;

/** Finds the class with which a team's program starts, without running any line of the team. */
final class MainClasses {

    private MainClasses() {}

    /**
     * Chooses a class for each role: the one that the team has named, else the only one that can be started.
     *
     * @throws WrongEntryException if it is not clear which
     */
    static Map<Role, String> choose(TeamEntry team, List<String> candidates) {
        Map<Role, String> chosen = new EnumMap<>(Role.class);
        for (Role role : Role.values()) {
            chosen.put(
                    role,
                    team.mainClass(role)
                            .map(name -> existing(team, name, candidates))
                            .orElseGet(() -> single(team, candidates)));
        }
        return chosen;
    }

    /** The classes of a folder that have a main method. */
    static List<String> in(Path classes, List<Path> classPath) throws IOException {
        List<URL> urls = new ArrayList<>();
        for (Path place : classPath) {
            urls.add(place.toUri().toURL());
        }
        List<String> names = new ArrayList<>();
        try (URLClassLoader loader = new URLClassLoader(urls.toArray(URL[]::new), MainClasses.class.getClassLoader())) {
            for (Path file : TeamFolder.filesOf(classes)) {
                className(classes, file).filter(name -> hasMain(loader, name)).ifPresent(names::add);
            }
        }
        return names;
    }

    private static Optional<String> className(Path classes, Path file) {
        String path = classes.relativize(file).toString().replace('\\', '/');
        boolean isClass = path.endsWith(".class") && !path.contains("$") && !path.endsWith("-info.class");
        return isClass
                ? Optional.of(
                        path.substring(0, path.length() - ".class".length()).replace('/', '.'))
                : Optional.empty();
    }

    private static boolean hasMain(ClassLoader loader, String name) {
        try {
            return MainMethod.of(Class.forName(name, false, loader)).isPresent();
        } catch (ReflectiveOperationException | LinkageError none) {
            return false;
        }
    }

    private static String existing(TeamEntry team, String name, List<String> candidates) {
        return candidates.stream()
                .filter(candidate -> candidate.equals(name) || candidate.endsWith("." + name))
                .findFirst()
                .orElseThrow(() -> new WrongEntryException("Team " + team.name() + " has no class " + name
                        + " with a main method. It has: " + list(candidates) + "."));
    }

    private static String single(TeamEntry team, List<String> candidates) {
        if (candidates.size() == 1) {
            return candidates.get(0);
        }
        throw new WrongEntryException(
                candidates.isEmpty()
                        ? "Team " + team.name() + " (" + team.program()
                                + ") has no class with a main method. Add to its agent:"
                                + " public static void main(String[] args) { new MyAgent().run(args); }"
                        : "Team " + team.name() + " has several classes that can be started: " + list(candidates)
                                + ". Say which one: " + team.name() + ".main = " + candidates.get(0));
    }

    private static String list(List<String> names) {
        return names.isEmpty() ? "none" : String.join(", ", names);
    }
}
